# 動畫：場景的數值從一端變到另一端。

animation-one-end = `{ $key }` 只有一端的值，起點與終點都應給值
animation-no-number = `{ $key }` 不是數值，應為數字、顏色、點或方向的鍵
animation-infinite = `{ $key }` 變到無限大，兩端應為有限的數字
animation-lengths = `{ $key }` 兩端的數字個數不同，應相同
animation-sign = `{ $key }` 不能以等比變化，兩端應為同號且不為 0 的數字
animation-nothing = 沒有任何變化，終點應有一個鍵的值不同
animation-frames = 應為 2 到 { $most } 個畫格
animation-frame = 第 { $frame } 個畫格：{ $error }
animation-seconds = 這麼多畫格應為 { $least } 到 { $most } 秒

# 視窗的匯出表單。
animation = 動畫
animation-tip = 數值從一端變到另一端；檔案會不斷重複播放
animation-key = 數值
animation-from = 起點
animation-to = 終點
animation-frame-count = 畫格數
animation-duration = 秒數
animation-scale = 步距
animation-linear = 等差
animation-logarithmic = 等比
animation-back = 來回
animation-format = 格式
animation-apng-tip = 保留所有顏色；瀏覽器可以播放
animation-gif-tip = 每個畫格最多 256 色，可能出現色帶；適合投影片與文件
