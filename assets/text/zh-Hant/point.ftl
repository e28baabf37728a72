
# R 與 H 的逐步作圖
point-step-cosine = θ 的餘弦
point-step-projection = L 在 N 上的投影
point-step-across = 從 L 到其投影
point-step-mirror = L 對 N 的反射
point-step-halfway = 半角向量（half vector）
point-check-unit = 驗算：|R| = { $r }，與 N、L 同為單位向量。
point-check-short = 驗算：|R| = { $r }。N 不是單位向量（|N| = { $n }），所以 R 也不是。

# 「點」檢視
point-pixel = 像素 { $x }, { $y }
point-stored-tip = 儲存的顏色：紅、綠、藍，0 到 255
point-place-face = 像素中心處：面 { $face }，深度 { $depth }
point-place-surface = 像素中心處：真實表面，深度 { $depth }
point-background = 探測點落在背景上。請按兩下物體，或將圓圈拖到物體上。
point-vectors = 向量（vectors）
point-vectors-of = 向量（vectors），光源 { $light }
point-no-light = 場景中沒有光源。加入一個光源，才有 L、R 與 H。
point-no-direction = N 或 L 在此處沒有方向。
point-drawing = 從側面看的向量：{ $list }
point-previous-step = 上一步
point-next-step = 下一步
point-all-steps = 全部步驟
point-construction-hint = 逐步作出 R 與 H
point-step = { $number }／{ $count }：{ $title }
point-behind = 光源在表面背後，因此這裡沒有反射。
point-position-short = 點
point-curves = 曲線（curves）
