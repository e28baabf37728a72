# The page of a class on phones.

phone-no-script = 這個網頁需要 JavaScript。
phone-lost = 沒有連線，會自動重試；你輸入的內容都會保留。
phone-refused = 無法加入課堂，會自動重試。
phone-missing = 無法載入這個步驟，會自動重試。
phone-name = 暱稱（可不填）
phone-name-save = 儲存
phone-name-about = 只有老師看得到。
phone-named = 已儲存。

# The steps, where students go at their own pace.
phone-back = 上一步
phone-next = 下一步
phone-own-step = 第 { $step } 步，共 { $steps } 步
phone-lecturer-step = 第 { $step } 步，共 { $steps } 步（老師在第 { $lecturer } 步）

# A question.
phone-send = 送出
phone-sending = 正在送出……
phone-saved = 已儲存。全班的答案顯示之前都可以更改。
phone-changed = 已更改，尚未送出。
phone-waiting = 尚未送出：沒有連線。連線後會自動送出。
phone-again = 再答一次：先和鄰座討論，再作答。
phone-closed = 課堂已結束。
phone-spread = 正在顯示全班的答案。
phone-right = 正確答案

# The kinds of questions.
phone-number = 請輸入 { $from } 至 { $to } 的數值。
phone-choose = 請選擇一個答案。
phone-formula = 請先打出公式。
phone-point = 在圖片中點選位置。使用鍵盤：方向鍵移動十字。
phone-picture = { $ask } 方向鍵移動十字。
phone-place = 十字在中心的右方 { $x }、下方 { $y }
phone-no-place = 請先在圖片中點選。
phone-curve = 用手指畫出曲線，畫滿整個寬度。
phone-values = 改為輸入數值
phone-values-range = { $from } 至 { $to }；其間以直線相連。
phone-value-at = { $x_name } = { $x } 時的 { $y }
phone-order = 由小到大：用按鈕移動各項，或拖曳。
phone-moved = { $item }：第 { $place } 位
phone-settings = 在實驗室中試試看，再把數值輸入這裡。
phone-match = 在實驗室中找出數值，再輸入這裡。
phone-target = 目標

# The program itself.
phone-lab = 開啟實驗室
phone-no-lab = 無法從這裡開啟實驗室：老師的電腦上沒有本程式網頁的檔案。
phone-no-model = 無法從這裡開啟實驗室：這個步驟的模型是老師電腦上的檔案。
