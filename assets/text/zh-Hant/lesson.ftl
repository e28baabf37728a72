# Lessons: what can be wrong with one, and its questions.

expression-unknown = 沒有「{ $name }」
expression-too-long = 超過 { $most } 個位元組
expression-nested = 巢狀超過 { $most } 層
expression-unexpected = 第 { $place } 個字元出現未預期的「{ $found }」
expression-ends = 太早結束
expression-arguments = 給了「{ $name }」{ $count } 個值，應為 { $expected } 個
expression-list = 是一串數值，應為單一數值
expression-empty = 是空的清單
expression-length = 兩個清單分別有 { $a } 與 { $b } 個數值，應該一樣多
expression-not-finite = 不是有限的數值
expression-no-truth = 既非真也非假：應為比較式，例如 a < b

# 公式：哪裡有錯。
formula-at = 第 { $line } 行第 { $column } 個字元：{ $problem }
formula-expected-value = 數值、名稱或「(」
formula-expected-operator = 運算符號或換行
formula-expected-sign = 「{ $sign }」
formula-expected-name = 名稱
formula-expected-quote = 引號中的文字
formula-unexpected = 出現未預期的「{ $found }」，應為{ $expected }
formula-ends = 公式太早結束，後面應為{ $expected }
formula-unknown = 這裡沒有「{ $name }」{ $meant }
formula-arguments = 「{ $name }」有 { $count } 個值，應為 { $expected } 個
formula-too-long = 有 { $count } 個字元，最多 { $most } 個
formula-nested = 巢狀超過 { $most } 層
formula-operations = 運算超過 { $most } 個
formula-empty = 尚未寫下公式
formula-no-value = 最後一行是結果，前面沒有「名稱 =」
formula-line-without-name = 只有最後一行是結果；之前各行的開頭都是「名稱 =」
formula-name-taken = 「{ $name }」屬於公式的語法，不能當作一行的名稱
formula-result-vector = 結果是向量，應為數值
formula-vector-for-number = 應為數值的地方是向量：「{ $part }」{ $meant }
formula-number-for-vector = 應為向量的地方是數值：「{ $part }」
formula-mixed = 數值與向量不能相加：「{ $part }」
formula-two-vectors = 兩個向量相乘要用「·」（內積）或 cross(a, b)：「{ $part }」
formula-no-truth = 應為比較式，例如 a < b：「{ $part }」

lesson-too-long = 單元檔最多 { $most } MiB
lesson-no-head = 單元檔以兩行 +++ 之間的 TOML 標頭開始
lesson-version = `lesson` 的版本不是本程式認得的：應為 { $version }
lesson-name = `name` 只能用小寫字母、數字與連字號，最多 64 個
lesson-no-steps = 沒有步驟：步驟以標題「## 標題」開始
lesson-many-steps = 步驟超過 { $most } 個
lesson-no-scene = 第一個步驟需要 `scene`
lesson-block-outside = 這個區塊在第一個步驟之前
lesson-block-twice = 這個步驟有第二個 `{ $name }` 區塊
lesson-number = 文中的數值：{ $words }
lesson-number-open = 文中的數值缺少結尾的大括號
lesson-number-digits = 數值的小數位數應為 0 到 9
lesson-key = `{ $key }`：{ $words }
lesson-missing = 缺少 `{ $key }`
lesson-positive = 應為大於 0 的數值
lesson-range = 應為兩個數值，較小的在前，且間距足以繪製
lesson-far = `probe` 與 `line` 以圖片中心為原點、短邊為單位：應在 −8 到 8 之間
lesson-step-too-heavy = 一個步驟連同題目最多可計算照明方程式 { $most } 百萬次，這個步驟超過了
lesson-file-too-heavy = 一個單元最多可計算照明方程式 { $most } 百萬次，這個單元超過了
lesson-many-triangles = 單元的場景最多可有 { $most } 個三角形，這個場景有 { $triangles } 個
lesson-long-settings = 一個步驟的設定最多 { $most } 個字元
lesson-lights = `lights`：最多 { $most } 個
lesson-panes = `panes`：最多 { $most } 個
lesson-no-slider = 「{ $name }」不是有滑桿的單一數值的鍵，例如 { $near }
lesson-unknown-block = 不認得區塊「{ $name }」，應為「step」或「question」；要原樣顯示的 TOML 請寫成區塊「toml」
lesson-no-control = `controls`：沒有「{ $name }」
lesson-options = 選擇題要有 { $least } 到 { $most } 個選項
lesson-items = 可排序的項目要有 { $least } 到 { $most } 個
lesson-option-both = 選項只能有 `holds` 或 `right` 其中之一
lesson-option-neither = 選項由 `holds` 或 `right` 決定對錯，或由題目的 `greatest` 或 `least` 決定
lesson-curve-of = 曲線題需要 `answer` 或 `profile` 其中之一
lesson-goal = 設定題需要 `equals`、`most = true` 或 `least = true` 其中之一
lesson-no-folder = 內建單元只能使用內建場景
lesson-no-line = 這個步驟需要 `line`
lesson-no-probe = 這個步驟需要 `probe`
lesson-probe-outside = 探測點在圖片之外
lesson-probe-misses = 探測點沒有落在物體上
lesson-no-number = `{ $path }` 不是數值
lesson-no-list = `{ $path }` 不是清單
lesson-no-part = 沒有 `{ $path }`
lesson-no-value = 場景沒有 `{ $name }`
lesson-no-object = 圖片中沒有物體
lesson-right-options = { $count ->
    [0] 沒有正確的選項
   *[other] 有 { $count } 個正確的選項
 }，應為一個
lesson-too-near = 有兩個值相差不到 2 %
lesson-value-outside = 答案是 { $value }：答案與容許誤差都必須在 `from` 與 `to` 之間
lesson-curve-outside = 曲線達到 { $value }，超出 `y`
lesson-curve-flat = 畫一條水平線也會算對
lesson-no-zero = 圖片中 `of` 的正負號沒有改變
lesson-point-anywhere = 物體有一半以上都算對
lesson-point-alike = 另一處和正確的位置一樣好
lesson-no-corner = 這條線沒有跨過多邊形之間的邊
lesson-settings-many = { $count ->
    [0] 沒有設定能達成
   *[other] 有 { $count } 個設定能達成
 }，應為一個
lesson-settings-unreachable = 沒有設定夠接近
lesson-settings-alike = 有好幾個設定一樣好
lesson-not-right = 正確答案不算對
lesson-match-same = 目標與起始圖片看起來一樣
lesson-question = 題目：{ $words }
lesson-file = 單元檔

lesson-wrong = 錯誤模型 { $number }：{ $words }
lesson-wrong-keys = 至少要有一個改變答案的鍵：{ $words }
lesson-wrong-choice = 選擇題中，每個錯誤的 [[option]] 各有自己的 `says`
lesson-many-wrong = 一題最多 { $most } 個錯誤模型
lesson-wrong-value-outside = 它的答案是 { $value }，無法輸入：應在 `from` 與 `to` 之間
lesson-wrong-near = 它的答案與正確答案只差容許誤差的 { $apart } 倍，至少應為 { $least } 倍
lesson-wrong-same = 它的答案與錯誤模型 { $other } 相同
lesson-wrong-unfit = 它的答案無法評分
lesson-right-says = 正確的選項不可有 `says`，那是給錯誤選項的
lesson-apart = 錯誤模型 { $number } 與正確答案相差容許誤差的 { $apart } 倍
lesson-no-wrong = 這一題沒有錯誤模型
lesson-at = 以圖片中心為原點、短邊為單位：應在 −8 到 8 之間

lesson-hint-high = 太大了。
lesson-hint-low = 太小了。
lesson-hint-control-high = { $name } 太大了。
lesson-hint-control-low = { $name } 太小了。
lesson-hint-curve = { $span }{ $fault }。
lesson-hint-high-there = 太高
lesson-hint-low-there = 太低
lesson-hint-not-zero = 應為零
lesson-hint-not-level = 應為水平
lesson-hint-steep = 太陡
lesson-hint-shallow = 不夠陡
lesson-hint-bent = 斜率改變的位置不對
lesson-hint-everywhere = 整條曲線
lesson-hint-up-to = 到 { $to } 為止
lesson-hint-beyond = 從 { $from } 起
lesson-hint-between = 從 { $from } 到 { $to }
lesson-hint-left = 太偏左。
lesson-hint-right = 太偏右。
lesson-hint-up = 太偏上。
lesson-hint-down = 太偏下。
lesson-hint-out = 離圖片中心太遠。
lesson-hint-in = 離圖片中心太近。
lesson-hint-share = { $side }該處的量只有最大值的 { $share } 倍。
lesson-hint-beside = 這裡不在物體上。
lesson-hint-early = 「{ $item }」的位置太前面，差 { $places } 個。
lesson-hint-late = 「{ $item }」的位置太後面，差 { $places } 個。
lesson-formula-names = `names`：應為名稱；需要範圍時寫成只有一個名稱的表，例如 {"{"} n = [1, 100] {"}"}
lesson-formula-name = `names`：應為不重複的名稱；範圍不明顯時要寫出範圍：{"{"} { $name } = [0, 1] {"}"}
lesson-formula-many-names = `names`：應為 1 到 { $most } 個名稱
lesson-formula-unused = `names`：答案與錯誤模型都沒有用到「{ $name }」
lesson-formula-undefined = 在各名稱的範圍中，答案有一半以上沒有值
lesson-formula-constant = 答案處處都是同一個值
lesson-formula-no-term = `term`：這一項無法用這些名稱寫成公式
lesson-formula-other-term = `term`：在這個場景中，引擎計算的不是「{ $text }」
lesson-formula-vector-expected = 結果是一個數，應為向量。
lesson-formula-number-expected = 結果是向量，應為一個數。
lesson-formula-no-value = 沒有值
lesson-hint-formula = 當 { $values } 時，你的公式得到 { $given }，應為 { $expected }。
