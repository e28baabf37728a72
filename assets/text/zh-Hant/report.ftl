# 所有報告共有的文字，以及各項分析的說明。

report-from-normal = （與 N 的夾角）
