# The picture in the middle
picture-name = 圖片，{ $mode } 著色
picture-drawing = 繪製中…
picture-half-constant = 固定的環境光
picture-half-bounce = 一次反射

# Panes and their captions
picture-reference = 參考
picture-brightest = 最亮 { $value }
picture-brightest-of = 最亮 { $value }（參考 { $truth }）
picture-rms-error = 均方根誤差 { $value }
picture-error-line = 平均 { $mean }   均方根 { $rms }   最大 { $greatest }
picture-caption = 窗格 { $number }：{ $name }
picture-caption-tip = 按一下開啟窗格的選單；拖曳到另一個窗格可改變順序。
picture-make-reference = 設為參考
picture-move-earlier = 往前移
picture-move-later = 往後移
picture-remove-pane = 移除

# The view Compare
picture-view-single = 單張
    .tip = 只顯示場景本身
picture-view-panes = 窗格
    .tip = 並排顯示各窗格，共用相機與探測點
picture-view-wipe = 分割線
    .tip = 以可拖曳的線分隔第一個窗格與參考窗格
picture-view-difference = 差異
    .tip = 顯示第一個窗格減去參考窗格
picture-all-modes = 所有著色方式
    .tip = 並排顯示單一、內插、Gouraud、Phong 與精確著色，以精確著色為參考。
picture-add-pane = 新增窗格
picture-panes-full = 已有 { $count } 個窗格，達到上限。請先移除一個。
picture-compare-empty = 還沒有可比較的窗格。請在上方選擇檢視方式，或新增一個以其他方式顯示場景的窗格。
picture-own-changes = 只改變目前的窗格
    .tip = 否則改變會套用到所有窗格，窗格自己設定的項目除外
picture-reference-pane = 以窗格 { $number } 為參考
picture-pane-menu = 窗格 { $number } 的選單
picture-activate-tip = 在控制面板顯示這個窗格的設定
picture-release-setting = 移除窗格自己的 { $key }，再次跟隨第一個窗格
picture-add-shading = { $name } 著色
picture-add-interpolation = { $name } 內插
picture-add-finer = 兩個方向的多邊形數各乘以四
picture-add-same = 相同
    .tip = 複製一份，之後再修改
picture-add-setting = 其他設定：
picture-add = 新增
picture-against = 與 { $name } 比較
picture-pixel = 像素 { $x }, { $y }
picture-greatest-tip = 把探測點移到 { $name } 差異最大的地方

# The report of a comparison
picture-no-panes = 沒有可比較的窗格，請用 --pane KEY=VALUE 或有窗格的場景
picture-compared = { $scene }，與 { $reference } 比較
picture-linear = 像素中心的線性亮度：1 為白色，1/255 = 0.0039 為一個碼值。
picture-column-pane = 窗格
picture-column-brightest = 最亮
picture-column-mean = 平均
picture-column-greatest = 最大
picture-column-at = 位置
picture-column-region = 所在
picture-region-inside = 內部
picture-region-outline = 輪廓上

# The normals of vertices
picture-vertex-normal = 頂點法向量的來源
picture-no-vertex-seen = 圖片中看不到任何頂點，請用 --vertex 或讓相機看到物體
picture-no-vertices = --vertex { $number }：沒有這個頂點，物體沒有頂點
picture-no-vertex = --vertex { $number }：沒有這個頂點，應為 0 到 { $last }
picture-weighted-equally = 等權
picture-weighted-by-area = 以面積加權
picture-weighted-by-angle = 以角度加權
picture-normal-averaged = { $count } 個面的平均，{ $weights }
picture-normal-mirrored = { $count } 個面及其 x 鏡像的平均，{ $weights }
picture-normal-of-file = 檔案所給
picture-normal-of-surface = 真實表面的
picture-normal-of-face = 面本身的
picture-normal-of-first = 第一個面的：{ $count } 個面的法向量互相抵消
picture-normal-nowhere = 這個頂點的面都沒有面積
picture-vertex = { $scene }：頂點 { $number }，共 { $count } 個，位於 { $at }
picture-normal-sum = Σ 占比·N = { $sum }，長度 { $length }
picture-column-face = 面
picture-column-share = 占比
picture-column-angle = 角度，°
picture-column-area = 面積
picture-column-weight = 權重
picture-column-off = 與 N 夾角，°
picture-column-normal = 法向量
picture-needles-vertices = { $all } 個頂點法向量中的 { $shown } 個
picture-needles-faces = { $all } 個面法向量中的 { $shown } 個
picture-needles-both = { $vertices }，{ $faces }
picture-lit-faces = { $count } 個面
picture-lit-faces-each = { $count } 個面，各 { $share }
picture-lit-faces-range = { $count } 個面，{ $least } 到 { $greatest }
picture-lit-n-file = 檔案的 N
picture-lit-n-surface = 表面的 N

# The five defects of interpolated shading
picture-defects-about = 內插造成的五種缺陷，在目前的圖片中量測。
picture-defects-stop = 停止量測，直到場景改變
picture-defects-stopped = 已停止。場景改變後會重新量測。
picture-defects-of = { $scene }；線性亮度，1 為白色
picture-not-here = 未量測：{ $why }。
picture-mark = 標示於圖片中
    .tip = 標出缺陷最大的地方；方向相依性則顯示可轉動圖片的圓環
picture-try = 試試看：{ $what }
picture-example = 開啟範例
picture-example-of = 範例：{ $name }
picture-silhouette = 多邊形輪廓（polygonal silhouette）
    .says = 著色再平滑，輪廓仍由直線邊組成。
    .try = 增加分段數，距離會隨其平方減小。
picture-silhouette-distance = 像素，與真實輪廓的距離，位於 { $at }
picture-perspective = 透視變形（perspective distortion）
    .says = 內插在圖片中進行，圖片中兩頂點的中點並不是空間中的中點。
    .try = 把地板轉開，或把它分成更小的多邊形。
picture-perspective-greatest = { $rule }與透視校正內插的最大差異
picture-perspective-greatest-at = { $rule }與透視校正內插的最大差異，位於 { $at }
picture-perspective-mean = 平均差異
picture-scan-line = 掃描線內插
picture-affine = 仿射內插
picture-orientation = 方向相依性（orientation dependence）
    .says = 沿掃描線內插時，多邊形一轉動，同一點的亮度就改變；三角形的重心座標內插則不會。
    .try = 拖曳圖片外圈圓環上的旋鈕，觀察探測點的值。
picture-orientation-scanline = 探測點的變化，沿掃描線
picture-orientation-barycentric = 用重心座標
picture-shared = 未共用的頂點（vertices not shared）
    .says = 邊的一側有頂點、另一側沒有時，兩側的內插結果不同。
    .try = 沿著邊拖曳光源，或把中間的頂點拖離邊。
picture-shared-edges = { $edges } 條邊
picture-shared-edges-measured = { $edges } 條邊，量測了其中 { $measured } 條
picture-shared-jump = 亮度的最大跳躍，位於 { $at }；{ $edges }
picture-normals = 不具代表性的頂點法向量（unrepresentative vertex normals）
    .says = 在摺痕上取平均後，所有頂點法向量可能都相同：表面看起來是平的。
    .try = 把環數設為 2 以上，摺痕就會出現。
picture-normals-angle = 多邊形法向量與其頂點法向量的最大夾角
picture-normals-contrast = 對比；真實對比為 { $truth }
picture-missing-stopped = 已停止
picture-missing-flat = 單一著色不做內插
picture-missing-exact = 精確著色不做內插
picture-missing-parallel = 平行投影不會變形
picture-missing-background = 探測點落在背景上
picture-missing-own-normals = 這種著色方式使用多邊形本身的法向量
picture-missing-exact-normals = 精確著色使用真實表面的法向量
picture-missing-object = 物體不在圖片中
picture-missing-surface = 物體除了多邊形之外沒有真實表面
picture-missing-outline = 圖片中沒有物體的輪廓
picture-missing-borders = 物體的開放邊太多，無法尋找未共用的頂點
picture-missing-unshared = 每條邊的兩側都共用頂點
picture-missing-edge = 看不到這樣的邊
picture-mark-jump = 跳躍 { $size }
picture-plot-orientation = 圖片轉動時的同一點
picture-curve-scanline = 沿掃描線
picture-curve-barycentric = 重心座標
picture-curve-now = 目前
picture-axis-roll = 轉角
picture-plot-shared = 邊的兩側
picture-curve-with = 有頂點的一側
picture-curve-without = 沒有頂點的一側
picture-curve-vertex = 頂點
picture-axis-edge = 沿著邊

# When flat shading is exact
picture-conditions = 單一著色何時是精確的？
    .about = 單一著色（flat）對每個多邊形只計算一次方程式。以下三個條件都成立時結果是精確的：
picture-conditions-of = { $scene }；單一著色何時是精確的
picture-condition-light = 光源在無窮遠，N·L 固定
    .figures = 在一個多邊形內，L 最多轉 { $degrees }°，N·L 最多改變 { $change }。
    .meet = 把光源移到無窮遠
    .break = 把光源移回來
picture-condition-viewer = 觀察者在無窮遠，N·V 固定
    .figures = 在一個多邊形內，V 最多轉 { $degrees }°，N·V 最多改變 { $change }。
    .meet = 把觀察者移到無窮遠
    .break = 把觀察者移回來
picture-condition-surface = 多邊形就是真實表面
    .figures = 多邊形的法向量與表面的法向量最多相差 { $degrees }°。
    .meet = 畫立方體
    .break = 畫曲面物體
picture-condition-polygons = 頂點法向量就是多邊形本身的法向量
    .meet = 用各多邊形本身的法向量
    .break = 用平均的法向量
picture-holds = 成立：
picture-fails = 不成立：
picture-flat-and-exact = 單一著色減精確著色
picture-flat-greatest = 最大差異

# What is wrong with panes, and why a setting has no effect
picture-idle-one-pane = 只有一個窗格
