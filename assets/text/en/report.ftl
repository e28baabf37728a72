# What all reports have in common, and what analyses are called.

report-from-normal = from N

report-on = on
report-off = off
report-setting = { $name }: { $value }
report-setting-of-light = Light { $light }, { $name }: { $value }
