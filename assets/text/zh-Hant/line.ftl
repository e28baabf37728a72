# The profile
line-drag-ends = 拖曳圖片中線段的兩端。
line-mode-own = 圖片目前的著色模式一律顯示。
line-mode-added = 加入或移除這種著色模式的曲線。
line-perceived-switch = 感知亮度
    .tip = 在亮度曲線旁畫出圖片著色模式的感知亮度。
line-edges-switch = 多邊形邊
    .tip = 標示線段與多邊形邊相交之處。
line-picture-perceived = 以感知亮度顯示圖片
    .tip = 顯示圖片連同眼睛所加上的馬赫帶。
line-viewing = 觀看條件
line-save = 儲存
line-working = 正在計算剖面…
line-plot-intensity = 亮度
line-plot-slope = 斜率
line-plot-added = 感知 − 實際
line-value = { $name }：{ $value }
line-pixels = { $value } 像素
line-model-inhibition = 側抑制
line-model-normalisation = 正規化
line-distance = 距離
    .tip = 眼睛到螢幕的距離，單位為公釐。
line-density = 像素密度
    .tip = 螢幕每公釐的像素數；每英寸 96 像素即 3.78。
line-centre = 中心 σc
    .tip = 感受野中心的寬度，單位為視角的度。
line-surround = 周邊 σs
    .tip = 感受野周邊的寬度，單位為視角的度。
line-strength = 強度 w
    .tip = 抑制的強度。
line-error-surround = 周邊 σs 寬 { $width } 像素，整張圖片最多只能是 { $most }。請減小距離、像素密度或 σs。
line-error-outside = 在圖片之外，應介於 0,0 與 { $width },{ $height } 之間
line-error-no-length = 線段兩端在同一處，應為兩個不同的位置
line-error-no-mode = 沒有著色模式，至少需要一種
line-phong-bands = Phong 著色減弱馬赫帶（Mach bands），但不會消除：斜率仍會跳變，只是幅度較小。

# Its plots
line-intensity = 亮度
line-perceived = 感知亮度
line-mode-title = { $mode }：亮度與感知亮度
line-intensity-title = 亮度（intensity）與感知亮度（perceived brightness）
line-slope-title = 亮度的斜率（slope）
line-slope-note = 斜率跳變之處會出現馬赫帶。
line-jumps-title = 亮度的跳變（jumps）
line-jumps-note = 每個面內亮度固定，斜率為 0；在每條邊上亮度跳變。
line-added-title = 感知減實際（perceived minus actual）
line-added-note = { $model }，σc = { $centre }、σs = { $surround } 像素，w = { $weight }。
line-added-outline = 在輪廓處曲線超出圖表。
line-lateral-inhibition = 側抑制
line-response-normalisation = 反應正規化
line-axis-x = x（像素）
line-axis-distance = 沿線距離（像素）
line-axis-intensity = 線性亮度
line-axis-slope = 斜率（每像素的線性亮度）
line-axis-jump = 跳變（線性亮度）
line-axis-added = 感知 − 實際（線性亮度）
line-edges-crowded = { $count ->
   *[other] { $count } 條多邊形邊，太密而未畫出
}
