# What all reports have in common, and what analyses are called.

report-from-normal = from N
