# 所有報告共有的文字，以及各項分析的說明。

report-from-normal = （與 N 的夾角）

report-on = 開
report-off = 關
report-setting = { $name }：{ $value }
report-setting-of-light = 光源 { $light }，{ $name }：{ $value }
