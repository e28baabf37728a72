# What all reports have in common, and what analyses are called.

report-from-normal = from N

report-on = on
report-off = off
report-setting = { $name }: { $value }
report-setting-of-light = Light { $light }, { $name }: { $value }

report-show-tip = Shows it in the picture
report-stop = Stop
report-stop-tip = Stops and keeps what is known so far
report-again = Measure again
report-try-again = Try again
report-stopped = Stopped: the results are incomplete.
report-stale = The scene has changed since this was measured.
report-save-tip = Save as { $format }
report-copy = Copy text
    .tip = Copies the words and numbers
report-copied = Copied: { $name }
report-nothing-to-save = there is nothing to save
report-unknown-ending = expected a name that ends in .png, .svg, .csv or .json
report-saved = Saved { $path }
