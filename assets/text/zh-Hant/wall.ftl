# The live class in the lecturer's window, which is on the wall.

wall-about = 學生用手機作答：牆上的 QR 碼帶他們到網頁，只需要教室裡的網路。你提問，全班的答案疊在一起；再問一次、說明，然後繼續。
wall-choose = 選擇單元
wall-teach = 以「{ $title }」上課……
wall-not-started = 課堂沒有開始
wall-file = 上課
    .verb = 開始
    .kind = 課堂的答案
    .sentence = 答案隨時存入這個檔案。檔案已存在時，課堂會接續下去。
wall-code = 網址 { $address } 的 QR 碼
wall-address = 網址
wall-joined = 已加入 { $count } 位學生
wall-note = { $note }。
wall-step = 第 { $step } 步，共 { $count } 步
wall-round = 第 { $round } 輪
wall-answered = { $joined } 人中有 { $answered } 人作答
wall-count = { $count } 個答案
wall-right-of = { $count } 個中答對 { $right } 個
wall-right = 正確答案
wall-students-axis = 學生
wall-students = 學生
wall-names = 姓名
wall-own-pace = 學生依自己的進度
    .tip = 學生可以前往其他步驟作答；你說明之前，手機上不會顯示說明。
wall-elsewhere = { $count } 位學生在其他步驟
wall-unnamed = 沒有姓名：{ $count } · 沒有連線：{ $away }

wall-back = 上一步
wall-show = 顯示答案
wall-again = 再問一次
wall-explain = 說明
wall-next = 下一步
wall-end = 結束
    .tip = 結束課堂。答案都在檔案中；用同一個檔案再開始，就會接續下去。
