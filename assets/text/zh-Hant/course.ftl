# The course in the window: lessons, questions and answers.

course = 課程
course-start = 開始課程
course-lessons = 單元列表
course-own = 自己的單元
course-none = 這個程式沒有內建單元。
course-open-own = 開啟自己的單元…
course-minutes = { $count } 分鐘
course-begun = 進行中
course-done = （已完成）
course-in-text = 在文字中

course-step = 第 { $number } 步，共 { $count } 步
course-back = 上一步
    .tip = 上一步（Page up）
course-next = 下一步
    .tip = 下一步（Page down）
course-finish = 完成
course-preparing = 正在計算數值……
course-no-step = 單元中沒有這一步。
course-numbers = 顯示數值：{ $view }
course-again = 回到這一步的場景
    .tip = 全部恢復成這一步顯示的樣子
course-hidden = 回答問題之前，數值會先隱藏。
course-to-question = 前往問題
course-left = 目前開啟的是另一個場景。單元停在你離開的地方。
course-return = 回到單元
    .tip = 重新顯示單元這一步的場景
course-locked = 回答問題之前，場景保持不變。
course-after-answer = 作答後開放

course-question = 問題
course-check = 檢查
course-show-answer = 顯示答案
    .tip = 顯示正確答案與理由；這會列入紀錄
course-solving = 正在計算正確答案……
course-number = 一個數
course-answer = 你的答案
course-no-number = 這不是一個數。
course-point = 在圖片中點一下。使用鍵盤：先按 F3，再按方向鍵，最後按 Enter。
    .touch = 在圖片中點一下。
course-point-set = 你的標記已在圖片中。拖曳它或點別處即可移動。
    .touch = 你的標記已在圖片中。拖曳它或點別處即可移動。
course-settings = 使用上方的控制項；檢查時以目前的值評分。
course-order = 由小到大排列。可拖曳，或使用箭頭。
course-up = 上移：{ $item }
course-down = 下移：{ $item }
course-right-order = 正確順序
course-curve = 用滑鼠或方向鍵畫出曲線，按 Enter 檢查。
course-curve-area = { $y } 對 { $x } 的圖
course-curve-whole = 請把曲線畫滿整個寬度。
course-curve-clear = 清除
course-curve-yours = — 你的
course-curve-right = — 正確
course-curve-wrong = — 錯誤模型
course-mark-yours = 你的
course-mark-right = 正確

course-target = 目標
course-yours = 你的
course-warmer = 更接近了
course-colder = 更遠了
course-match-same = 看不出差別
course-match-meter = 與目標的接近程度
course-match-distance = 均方根差 { $rms }
course-match-tries = { $count } 次更改，{ $time }

course-right = 答對了！
course-right-after = 試了 { $count } 次後答對。
course-looked-up = 試了 { $count } 次後看了答案。
course-wrong = 還不對。
course-nearly = 還不對。接近程度：{ $share } %
course-try-again = 修改答案後再檢查，或顯示答案。
course-values = 正確：{ $right } · 你的：{ $own }
course-place = 圖片中的圓圈標出正確位置。
course-places = 圖片中的點標出正確位置。
course-set-it = 套用正確值

course-results = 結果
course-results-none = 你還沒有回答任何問題。
course-results-count = { $count } 題中已作答 { $answered } 題。答對 { $right } 題，其中第一次就答對 { $first } 題；看過答案 { $looked } 題。
course-results-again = 再看一次這些步驟：

course-hand-in = 繳交答案
    .verb = 寫入
    .sentence = 一張圖片，內含場景、單元與你的答案。請寄給老師。
course-hand-in-name = 你的姓名
course-hand-in-nothing = 還沒有答案：請先開啟單元並回答問題。
course-not-handed-in = 答案未寫入
course-handed-in = 答案已寫入 { $path }

course-answers = 繳交的答案
course-answers-void = 這些答案不計分：{ $why }。
course-answers-marking = 正在評分……
course-answers-right = 答對 { $right } 題，共 { $count } 題
course-answers-question = 第 { $number } 題
course-answers-first = 最初的答案
course-answers-given = 答案
course-answers-model = 錯誤模型
course-answers-solution = 正確答案
course-answers-none = 未作答
course-answers-curve = 手繪的曲線
course-answers-wrong = 錯誤
course-answers-close = 接近程度 { $share } %
course-answers-tries = 試了 { $count } 次
course-answers-seconds = { $seconds } 秒

course-target-title = 配對：{ $scene }
course-target-level = 第 { $level } 級
course-target-ask = 找出 { $count } 個數值，使你的圖片與目標相同。
course-target-file = 無法將這個場景設為目標。請先存成場景檔，再開啟該檔。
course-loading = 正在讀取單元…
# 課文中指滑鼠的詞與指手指的詞，順序相同；中文兩者相同。
course-mouse-words = 點選
course-finger-words = 點選
