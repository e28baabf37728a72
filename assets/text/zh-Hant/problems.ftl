# 場景的錯誤：文字接在反引號中的鍵之後。
problem-value = 是 { $found }，應為：{ $expected }
problem-unknown-key = 未知的鍵 `{ $key }`，{ $expected }
problem-unknown-word = 是 { $found }，{ $expected }
problem-expected = 應為 { $known }
problem-expected-one-of = 應為下列之一：{ $known }
problem-did-you-mean = { $expected }（是否想輸入 { $meant }？）
problem-version = `version` 是 { $found }，應為 { $version }：shading-lab { $program } 讀取第 { $version } 版，較新的版本需要較新的 shading-lab
problem-more = 另有 { $count } 個問題，應該沒有
problem-too-long = 超過 { $limit } MiB，應為場景
problem-toml = TOML 語法錯誤：{ $message }
problem-no-equals = 鍵之後沒有 `=`，應為 KEY=VALUE，例如 material.n=50
problem-single-value = 是單一的值，其後不應有 `{ $part }`
problem-no-element = 沒有第 { $index } 項，應為 { $expected }
problem-depth-cueing = 沒有超過 `depth_cueing.front`，應為更大的深度
problem-eye-target = 與 `camera.target` 是同一點，應為兩個不同的點
problem-up-parallel = 與視線平行，應為與視線相交的方向
problem-path-missing = 沒有指定，因為 `object.kind` 是 "obj"，應為模型的路徑
problem-attenuation-zero = 與 `c2`、`c3` 都是 0，c1、c2、c3 之一應大於 0
problem-shadow-pixels = 的像素太多，無法計算這麼多陰影，應縮小圖片、減少分布光源的取樣點，或關閉陰影
problem-material-unnamed = 是空的，應為模型中一個材質的名稱
problem-material-twice = 與前面的 `[[object.material]]` 同名，應為其他名稱
problem-no-faces = 是空的，因為有 `object.vertices`，應至少有一個多邊形
problem-nothing-to-compare = 沒有可比較的對象，應有 [[compare.pane]]

# 實際的值。
found-date = 日期
found-list = 清單
found-list-of = { $count } 項的清單
found-table = 鍵的表
found-not-a-value = 不是值（{ $message }）
found-empty = 空的
found-samples = 總共 { $count } 個取樣點
found-corners = { $count } 個角
found-vertex-twice = 頂點 { $vertex } 出現兩次的多邊形
found-no-area = 面積為零的多邊形
found-edges-meet = 從頂點 { $first } 到 { $first_end } 與從 { $second } 到 { $second_end } 的邊相交的多邊形

# 應有的值。
expected-number = 數字
expected-number-in-range = 小於 1.8e308 的數字（或 inf）
expected-whole = 0 以上的整數
expected-bool = true 或 false
expected-text = 引號中的文字
expected-path = 引號中的路徑
expected-one-of = { $words } 之一
expected-three = 三個數字的清單
expected-two = 兩個數字的清單
expected-two-whole = 兩個整數的清單
expected-list = 清單
expected-settings = 引號中設定的清單，例如 ["shading.mode=exact"]
expected-coefficient = 數字或 [red, green, blue]
expected-tables = 表的清單
expected-table = 鍵的表
expected-index = 其後有從 0 起算的編號
expected-no-index = 無，因為清單是空的
expected-only-index = 0，只有這一項
expected-file-value = 如場景檔中的值
expected-sides = 邊長 1 到 { $side } 像素
expected-pixels = 總共最多 { $pixels } 像素
expected-unicode-path = 場景檔可儲存的 Unicode 路徑
expected-model-path = 模型的路徑
expected-channels = 各色版為 { $range }
expected-degrees = { $range } 度
expected-coordinates = 不超過 { $greatest } 的座標
expected-direction = 長度至少 { $least } 的方向
expected-panes = 場景之外最多 { $count } 個
expected-pane-key = 窗格可以不同的鍵（相機、圖片與模型為共用）
expected-vertex-normals = { $count } 項，每個頂點一項，或沒有
expected-corners = 3 到 { $most } 個頂點
expected-no-polygon = 沒有多邊形，因為 `object.vertices` 是空的
expected-vertex = 頂點的編號，0 到 { $last }
expected-vertex-once = 每個頂點一次
expected-area = 角點能圍出面積
expected-no-crossing = 不與自身相交或接觸的多邊形

# Wavefront OBJ 模型。
obj-unreadable = 無法讀取：{ $error }
obj-empty = 檔案是空的，應為有 `v` 與 `f` 行的 OBJ 模型
obj-no-face = 沒有具三個不同角點的面，應至少有一行 `f`
obj-too-large = 模型的角點超過 { $most } 個，應較少
obj-line-too-long = 此行超過 { $longest } 位元組，應為 OBJ 模型
obj-not-text = 這不是文字，應為 ASCII 或 UTF-8 的 OBJ 模型
obj-weight-zero = 權重為 0 的頂點在無窮遠處，權重應不為零
obj-not-finite = 座標 { $word } 在單精度中不是有限的數，應為 -3.4e38 到 3.4e38 之間的數字
obj-few-vertices = 面有 { $count } 個頂點，應至少 3 個
obj-malformed = `{ $word }` 不是{ $expected }
obj-few-numbers = { $count } 個數字，應為{ $expected }
obj-coordinate = 座標
obj-three-coordinates = 三個座標 x y z
obj-weight = 權重
obj-normal-component = 法向量的分量
obj-three-components = 法向量的三個分量
obj-corner = 面的角點 v、v/vt、v//vn 或 v/vt/vn（整數）
obj-no-such-vertex = 面使用頂點 { $number }，{ $count ->
    [0] 但此行之前還沒有頂點
    [1] 此行之前只有一個，應為 1 或 -1
   *[other] 此行之前有 { $count } 個，應為 1 到 { $count } 或 -{ $count } 到 -1
 }
obj-no-such-normal = 面使用法向量 { $number }，{ $count ->
    [0] 但此行之前還沒有法向量
    [1] 此行之前只有一個，應為 1 或 -1
   *[other] 此行之前有 { $count } 個，應為 1 到 { $count } 或 -{ $count } 到 -1
 }

# 模型旁的材質庫（MTL）。
obj-vertex-colours = 無法讀取頂點的顏色，應為三個 0 到 1 的數
mtl-name-too-long = 材質名稱超過 { $longest } 個字元；其面使用場景的材質
mtl-too-many = 材質超過 { $most } 種；其餘材質的面使用場景的材質
mtl-not-found = 沒有材質庫定義材質 `{ $name }`；其面使用場景的材質
mtl-halo = 不讀取 `-halo`
mtl-spectral = 以 `{ $word }` 給定的顏色不會讀取，應為紅、綠、藍
mtl-number = 0 到 1000000 的數字

# 內含場景的圖片。
png-damaged = 不是有效的 PNG 圖片（{ $error }），應為 shading-lab 匯出的圖片
png-cut-off = 檔案不完整
png-malformed = 資料有誤
png-too-large = 所需的記憶體過大
png-no-scene = 圖片中沒有場景，應為 shading-lab 匯出的圖片
png-unreadable-text = 無法讀取圖片中的文字（{ $error }），應不超過 { $limit } MiB
