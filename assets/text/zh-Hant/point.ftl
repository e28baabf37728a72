
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
point-no-normal = N 在此處沒有方向。
point-light-behind = 光源 { $light } 在這裡位於表面背後，因此沒有反射。

# 曲線
point-curves-title = { $scene }，像素 ({ $x }, { $y })
point-plot-attenuation = 隨距離的衰減（attenuation）
point-plot-exponent = 鏡面反射瓣（specular lobe）{ $lobe }
point-plot-reflectance = 反射率（reflectance）W(θ)：{ $substance }
point-plot-lobe = 各方向的反射亮度
point-plot-of-light = { $title }，光源 { $light }
point-now = { $name }（目前）
point-mark-nearest = 最近
point-mark-probe = 探測點
point-mark-farthest = 最遠
point-legend-at-probe = 探測點的 f
point-legend-half-width = 半寬
point-legend-greatest = 最大 I
point-axis-from-viewer = { $symbol }，與觀察者的距離（世界單位）
point-axis-from-light = { $symbol }，與光源的距離（世界單位）
point-axis-theta = θ，入射角（度）
point-axis-phi = φ，{ $a } 與 { $b } 的夾角（度）
point-axis-from-normal = 與 N 的夾角（度）
point-red = 紅
point-green = 綠
point-blue = 藍
point-constant = 常數
point-glass = 玻璃
point-silver = 銀
point-gold = 金
point-custom = 自訂折射率
point-diffuse = 漫反射
point-both-terms = 漫反射 + 鏡面反射
point-note-constant = W = 1：Ks 不隨角度改變。灰線：其他材質（取亮度）。
point-note-fresnel = Fresnel，{ $index }。θ 是 { $vector } 與 L 的夾角。灰線：其他材質（取亮度）。
point-note-lobe = 在 N 與 L 的平面內，θ = { $theta }。朝觀察者的 I = { $intensity }。
point-note-out-of-plane = V 偏離此平面 { $angle }。
point-note-laws = { $law }。灰線：其他定律。
point-note-distribution = { $name }：{ $formula }。灰線：{ $lobe }。
# 兩句之間。
point-sentence-gap = { "" }
point-law = { $law }，d 為與光源的距離
point-law-viewer = f = 1/(r + k)，k = { $k }，r 為與觀察者的距離
point-law-light = f = 1/(r + k)，k = { $k }，r 為與光源的距離
point-law-none = f = 1：此光源不衰減
point-law-directional = f = 1：平行光沒有距離可言
point-error-no-lights = --light { $light }：場景中沒有光源
point-error-no-such-light = --light { $light }：場景中沒有此光源，應為 0 到 { $last }
point-error-no-light = 場景中沒有光源，至少需要一個
point-error-background = 像素 { $x },{ $y } 顯示背景，請指定顯示物體的像素
point-error-behind = 光源 { $light } 在像素 { $x },{ $y } 處位於表面背後，請指定位於正面的光源
