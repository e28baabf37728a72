# The live class: what phones are told, and the lecturer.

# Why a phone's request is refused.
live-no-student = 您尚未加入這個課堂：請重新開啟網頁。
live-not-open = 這個問題目前不能回答。
live-unfit = 這個答案不符合問題。
live-too-fast = 一次要求太多：請稍後再試。
live-full = 課堂已滿。
live-not-yet = 老師還沒有顯示這個內容。
live-nothing = 這裡沒有內容。請確認螢幕上的網址。
live-malformed = 無法讀取要求。
live-too-long = 要求太長。
live-too-slow = 要求花了太久：請再試一次。
live-not-written = 答案無法存到老師的電腦（{ $error }）。請再試一次。
live-over = 課堂已結束。
live-no-lab = 這部電腦上沒有實驗室：老師可以用 --page 指定網頁版的資料夾來開始課堂。

# What the lecturer is told.
live-no-question = 這個步驟沒有問題
live-asks-nothing = 這個單元沒有問題，應為有問題的單元
live-goes-on = 接著進行 { $file } 中的課堂（{ $students ->
    [0] 尚無答案
   *[other] 已有 { $students } 位學生作答
 }）；若要開新的課堂，請用 --output 指定另一個檔案
live-no-network = 沒有網路：手機連不到這部電腦。請連上教室的網路或開啟熱點後重新開始，或用 --url 指定網址
live-lab-missing = 找不到網頁版的檔案，因此手機無法開啟實驗室：請用 --page 指定資料夾。其他功能都能使用
live-record-unwritable = { $file }：無法寫入紀錄（{ $error }）；請用 --output 指定另一個檔案
live-record-no-file = { $file }：不是檔案，應為存放紀錄的檔案；請用 --output 指定另一個
live-record-in-use = { $file } 正由另一個課堂使用：請用 --output 指定另一個檔案
live-record-other = 這是另一個課堂「{ $title }」的紀錄，或是單元另一個版本或語言的
live-record-unsound = { $file }：{ $error }；請用 --output 指定另一個檔案
live-no-port = 從 { $from } 到 { $to } 沒有可用的連接埠：請用 --port 指定一個
live-port-taken = 連接埠 { $port } 已被使用：請用 --port 指定另一個，或不指定
live-port-refused = 無法開啟連接埠 { $port }（{ $error }）：請用 --port 指定另一個
live-no-address = 這部電腦沒有位址 { $address }：請不要用 --bind，或指定它有的位址
live-no-server = 無法啟動伺服器（{ $error }）
live-not-now = 現在不能這麼做
live-no-command = 不認得「{ $word }」，應為 show、again、explain、next、back 或 end
live-rehearsed = 學生 { $number }
