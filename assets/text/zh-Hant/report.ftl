# 所有報告共有的文字，以及各項分析的說明。

report-from-normal = （與 N 的夾角）

report-on = 開
report-off = 關
report-setting = { $name }：{ $value }
report-setting-of-light = 光源 { $light }，{ $name }：{ $value }

report-show-tip = 顯示在圖片中
report-stop = 停止
report-stop-tip = 停止並保留目前的結果
report-again = 重新測量
report-try-again = 再試一次
report-stopped = 已停止，結果不完整。
report-stale = 測量之後場景已經改變。
report-save-tip = 儲存為 { $format }
report-copy = 複製文字
    .tip = 複製文字與數值
report-copied = 已複製：{ $name }
report-nothing-to-save = 沒有可儲存的內容
report-unknown-ending = 檔名必須以 .png、.svg、.csv 或 .json 結尾
report-saved = 已儲存 { $path }
