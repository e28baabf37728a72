# 匯出的各部分，以及無法寫出的情形。
export-c = C
export-vertex-shader = 頂點著色器
export-fragment-shader = 片段著色器
export-too-large = 要寫出 { $triangles } 個三角形，最多 { $most } 個：請改用較粗的網格，或 c-snippet

# OpenGL 或 GLSL 無法表達之處。
export-limit-scale = 除以全圖的最大亮度：要畫完才知道，因此大於 1 的 I 截為 1。
export-limit-shadows = 陰影：每個光源都照得到每一點。
export-limit-transparency = 透明度（Kt）：表面以不透明繪製。
export-limit-vertex-colours = 頂點的顏色：Od 處處為材質的顏色。
export-limit-ground = 地板：只繪製物體。
export-limit-backdrop = 背板：物體後方只有背景顏色。
export-limit-bounce = 其他表面散射的光：Ia 為常數。
export-limit-lengths = 這種大小的長度：OpenGL 以單精度計算平方，請縮放場景。
export-limit-flat-own-normal = 以多邊形自身的 N 做單一著色：GL_FLAT 取一個頂點的顏色，用的是該頂點的 N。設定 object.normals = "facet" 則兩者相同。
export-limit-flat-centre = 在多邊形中心做單一著色：GL_FLAT 取一個頂點的顏色，這裡是第一個頂點。
export-limit-flat-mean = 以各頂點顏色的平均做單一著色：GL_FLAT 取一個頂點的顏色，這裡是第一個頂點。
export-limit-affine = 仿射內插：OpenGL 的內插會做透視校正。
export-limit-scanline = 沿掃描線內插：多邊形分成三角形繪製，以三角形內插。
export-limit-vertex-clamp = 頂點上大於 1 的亮度：OpenGL 在內插之前就截為 1，除非程式呼叫 glClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE)（OpenGL 3.0 相容模式）。
export-limit-phong = Phong 著色：只在頂點計算方程式，再內插亮度（Gouraud 著色）。網格越細越接近。
export-limit-exact = 精確著色：繪製的是多邊形（輪廓也是），且只在頂點計算方程式。
export-limit-exact-pixels = 精確著色：多邊形的每個像素以內插的 N 著色（Phong 著色），輪廓是多邊形的輪廓。
export-limit-pattern = 表面的圖樣：Od 處處為材質的顏色。
export-limit-two-side = backfacing = "flip" 在 N.L < 0 處將 N 轉向各光源；GL_LIGHT_MODEL_TWO_SIDE 則在看到背面的多邊形上反轉 N，與光源無關。光源與眼睛在同一側時兩者相同。
export-limit-lights = 第八個以後的光源：共有 { $shining } 個光源發光，OpenGL 只有 { $most } 個。
export-limit-hatching = I > 1 處的斜線標示：I 截為 1。
export-limit-srgb = sRGB 編碼：儲存值為 255*I。
export-limit-phong-lobe = Phong 的 (R.V)^n：固定功能管線用 Blinn 的 (N.H)^n（reflection.model = "blinn"）；n = { $blinn } 的高光與 Phong 的 n = { $phong } 等寬。
export-limit-microfacets = Cook 與 Torrance 的微面模型：改用 Blinn 的 (N.H)^n，由粗糙度得 n = { $n }。
export-limit-own-law = 場景的自訂公式：固定功能管線不能計算公式，改以場景的係數與 n = { $n } 畫 Kd*Od*(N.L) + Ks*Os*(N.H)^n。
export-limit-shininess = n = { $n }：GL_SHININESS 最大為 128。
export-limit-reflectance = W(theta)，隨入射角變化的反射率：以 0 度時的值乘 Ks。
export-limit-light-area = 光源 { $light }：由 { $points } 點構成的分布光源，改為中心一點。
export-limit-light-soft = 光源 { $light }：光錐的柔邊；GL_SPOT_CUTOFF 是硬邊。
export-limit-light-exponent = 光源 { $light }：指數 { $exponent }；GL_SPOT_EXPONENT 最大為 128。
export-limit-light-viewer = 光源 { $light }：依到觀察者的距離衰減；這裡一律用到相機目標點的距離。
export-limit-light-unclamped = 光源 { $light }：衰減的 f = min(1, ...)；OpenGL 的 f 在光源附近會大於 1。
export-limit-cueing-constant = 各處 s0 相同的深度提示：OpenGL 的霧隨深度變化，因此略過。
export-limit-cueing-beyond = 深度提示：在兩個深度之外，s0 會繼續變化到 1 與 0。
export-limit-cueing-vertices = 在頂點計算的深度提示：OpenGL 的霧在每個像素計算。
export-limit-cueing-colour = 深度提示：OpenGL 將霧的顏色截為 1。
