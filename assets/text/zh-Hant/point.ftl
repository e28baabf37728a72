
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
point-pixel-of-pane = 「{ $pane }」的{ $pixel }
point-stored-tip = 儲存的顏色：紅、綠、藍，0 到 255
point-place-face = 像素中心處：面 { $face }，深度 { $depth }
point-place-surface = 像素中心處：真實表面，深度 { $depth }
point-background = 探測點落在背景上。請點一下物體，或將圓圈拖到物體上。
    .floor = 探測點落在地板上，這裡的數值則是物體的。請點一下物體，或將圓圈拖到物體上。
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
point-legend-at-probe = 探測點
point-legend-half-width = 半寬
point-legend-greatest = 最大 I
point-axis-from-viewer = { $symbol }，與觀察者的距離（世界單位）
point-axis-from-light = { $symbol }，與光源的距離（世界單位）
point-axis-theta = θ，入射角（度）
point-axis-lobe = { $letter }，{ $a } 與 { $b } 的夾角（度）
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
point-own-law = 自訂定律
point-own-law-undefined = 此處有一步運算沒有值（例如除以 0），以 0 計。
point-both-terms = 漫反射 + 鏡面反射
point-plot-own-law = 自訂公式隨觀察方向的變化
point-axis-factor = 公式的值
point-note-constant = W = 1：Ks 不隨角度改變。灰線：其他材質（取輝度）。
point-note-fresnel = Fresnel，{ $index }。θ 是 { $vector } 與 L 的夾角。灰線：其他材質（取輝度）。
point-note-lobe = 在 N 與 L 的平面內，θ = { $theta }。朝觀察者的 I = { $intensity }。
point-note-own-law = 在 N 與 L 的平面內，不含 f·Ip，θ = { $theta }。朝觀察者：{ $value }。
point-note-negative = 負值不畫出。
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
point-error-no-such-light = --light { $light }：場景中沒有此光源，應為 1 到 { $last }
point-error-no-light = 場景中沒有光源，至少需要一個
point-error-background = 像素 { $x },{ $y } 沒有顯示物體，請指定顯示物體的像素
point-error-behind = 光源 { $light } 在像素 { $x },{ $y } 處位於表面背後，請指定位於正面的光源

# 各項與其數值
point-channels = 紅 { $red }，綠 { $green }，藍 { $blue }
point-ambient = 環境光
point-specular = 鏡面反射
point-bounce = 一次反射光
point-bounce-note = 其他表面反射一次的光取代了常數項；常數項原為：
point-transparency = 透明度
point-transmitted = 穿透
point-depth-cueing = 深度提示
point-seen = 顯示
point-light = 光源 { $number }
point-sum = 總和
point-sum-reflected = 反射的 I
point-sum-before-cueing = 深度提示前的 I
point-sum-cued = 深度提示後的 I
point-clamped = 截至 1
point-scaled = 縮放後
point-stored = 儲存值
point-hatched = 有值大於 1：像素以黑白斜線標示。
point-divided = 除以整張圖片的最大值 { $divisor }：
point-refractions = { $refractions } 次折射
point-refractions-and-totals = { $refractions } 次折射，{ $totals } 次全反射
point-snell-in = 司乃耳定律（Snell’s law）：sin { $v } = { $eta } · sin { $t }，即視線、T 與法向量的夾角
point-snell-out = 司乃耳定律（Snell’s law）：{ $eta } · sin { $v } = sin { $t }，即視線、T 與法向量的夾角
point-snell-total = 視線與法向量夾 { $v }，η = { $eta }：全反射，沒有 T
point-cue-at-points = 深度提示在方程式求值處套用；s0 的平均為 { $s0 }。
point-cue-interpolated = s0 = { $s0 }，由頂點內插而得；像素本身的深度則得 { $own }。
point-cue-at-pixel = s0 從深度 { $front } 的 { $front_scale } 到深度 { $back } 的 { $back_scale }；此處 s0 = { $s0 }。
point-cue-left = 深度 { $depth } 處剩 { $percent } %
point-what-position = 位置
point-what-n = 法向量
point-what-v = 朝觀察者
point-what-l = 朝光源
point-what-r = L 對 N 的反射
point-what-h = L 與 V 的中間方向
point-what-t = 穿透方向
point-over-centre = 多邊形中心
point-over-first-vertex = 多邊形的第一個頂點
point-over-vertices = 多邊形的各頂點
point-over-samples = 光源的 { $count } 個點
point-and = 與
point-evaluated = 在{ $over }求值
point-evaluated-mean = 在{ $over }求值。字母上的橫線表示平均。
point-light-adds-nothing = 沒有貢獻：{ $why }。
point-term-adds-nothing = { $term }沒有貢獻：{ $why }。
point-spot-part = ，聚光燈的係數
point-law-clamped = ，截至 1（d = { $d }）
point-points-away = ：{ $vector } 朝向另一側
point-by-viewer = 由與觀察者的距離決定，{ $d } 世界單位
point-by-light = 由與光源的距離決定，{ $d } 世界單位
point-here = 此處為 { $values }。
point-here-mean = 此處為 { $values }，即所有求值的平均。
point-here-product = 此欄的乘積在此處為 { $values }。
point-here-product-mean = 此欄乘積的平均在此處為 { $values }。
point-angle = { $letter }，{ $a } 與 { $b }
point-light-row = 光源
point-in-light = 受光
point-part-in-shadow = { $percent } % 在陰影中
point-at-probe = （探測點）
point-line-at-probe = 探測點的{ $name }：{ $value }
point-share-tip = { $share }，占像素的輝度（Rec. 709）
point-letter-irefl = Irefl：反射光，即各項之和
point-letter-s = s：聚光燈在此方向的係數，0 到 1
point-letter-lit = lit：光未被遮住的部分，0 到 1
point-letter-law = law：場景自訂的反射定律（一條公式）在各色版上給出的因數
point-letter-facets = S：將光反射向觀察者的微平面，π·D·G/(4·(N·V))
point-letter-idc = Idc：亮度淡入的顏色

# 光源沒有貢獻的原因：簡短說法與完整說法。C 是係數的名稱。
point-zero-muted = 已停用
    .why = 此光源已停用
point-zero-not-soloed = 未單獨顯示
    .why = 另一光源設為單獨顯示
point-zero-black = Ip 為 0
    .why = 它的 Ip 為 0
point-zero-not-reflected = 不反射
    .why = { $c } 為 0
    .channel = Ip 與 { $c } 沒有共同的色版
point-zero-behind = 在表面背後
    .why = 光源在表面背後，N·L ≤ 0
point-zero-outside-cone = 在光錐外
    .why = 此點在聚光燈的光錐外
point-zero-in-shadow = 在陰影中
    .why = 光被遮住
point-zero-not-to-viewer = 未朝觀察者
    .why = 高光未朝向觀察者
point-zero-too-faint = 太弱
    .why = 弱到捨入為 0
point-zero-law = 定律給出 0
    .why = 場景自訂的定律在此給出 0
point-zero-one-term = 只有一項
    .why = 場景自訂的定律只有一項
point-zero-nothing = 沒有貢獻
point-zero-both = { $diffuse }，且 { $specular }
point-zero-in-part = 部分因為{ $clause }
# 兩個子句之間。
point-clause-gap = ；

# 文字報告
point-report-background = 像素 ({ $x }, { $y }) 顯示背景
    .floor = 像素 ({ $x }, { $y }) 顯示地板
point-material = 材質 { $name }
point-report-material = 材質 { $name }：{ $numbers }
point-report-face = 像素 ({ $x }, { $y })，面 { $face }，深度 { $depth }
point-report-surface = 像素 ({ $x }, { $y })，深度 { $depth }
point-report-places = 在{ $places }求值。向量則為像素中心處的向量。
point-report-sampling = 整張圖片與 { $samples } 個取樣相比：{ $rms }（均方根），{ $greatest }（最大）
point-report-stored = 總和與儲存值
point-report-fit = 最符合此圖片一次反射光的常數 Ia：{ $r } { $g } { $b }
point-report-light = 光源 { $number }{ $name }，{ $kind }，{ $law }
point-report-share = { $name }，占像素輝度的 { $share }
point-mean-of = { $formula } 的平均
