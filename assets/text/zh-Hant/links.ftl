# 場景的連結。
link-problem = 連結的第 { $position } 個字元：{ $words }
link-line = 其場景的第 { $line } 行：{ $words }
link-did-you-mean = （是否要找 { $name }？）
link-unknown-key = 不是連結的鍵，應為下列之一：{ $keys }{ $meant }
link-twice = 出現兩次，應只有一次
link-not-encoded = 的 % 之後沒有兩個十六進位數字，或不是 UTF-8，百分號應寫成 %25
link-expected-scene = 內建場景的名稱{ $meant }
link-expected-probe = 兩個數字 x,y，從圖片中心起算，以較短的邊為單位
link-expected-line = 四個數字 x0,y0,x1,y1，從圖片中心起算，以較短的邊為單位
link-expected-controls = 以逗號分隔、最多 { $most } 個由 a-z、0-9、點與連字號組成的詞
link-many-panes = 出現太多次，最多五個窗格
link-too-long = 超過 { $limit } KiB，應為連結
link-query-too-long = 在 ? 與 # 之間超過 { $limit } KiB，設定應更少
link-unknown-fragment = 是未知的，應為 #scene= 與壓縮的場景
link-beside-file = 與 # 之後的完整場景並存，應只有其中之一
link-not-base64 = 不是 base64url，應為 shading-lab 壓縮的場景
link-not-packed = 無法解壓縮，應為 shading-lab 壓縮的場景；連結可能被截斷
link-unpacks-to-more = 解壓縮後超過 { $limit } KiB，應為場景
link-no-file = 要求模型，應沒有模型：連結不能攜帶或開啟檔案
link-scene-too-large = 場景超過 { $limit } KiB，無法放進連結，多邊形應更少；請改寄場景檔
link-no-page = 應為網頁的位址，例如 https://example.org/shading-lab/
link-model-stays = 模型 { $path } 是檔案，不會隨連結傳送；開啟連結的人看到的是茶壺
