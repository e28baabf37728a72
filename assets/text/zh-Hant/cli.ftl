# 說明的標題與用語。
cli-usage = 用法：
cli-example = 範例：
cli-examples = 範例：
cli-arguments = 引數：
cli-options = 選項：
cli-heading-scene = 場景：
cli-heading-output = 輸出：
cli-heading-window = 視窗：
cli-heading-general = 一般選項：
cli-group-draw = 繪製：
cli-group-explain = 說明圖片：
cli-group-measure = 量測：
cli-group-teach = 教學：
cli-group-scenes = 場景與檔案：
cli-group-program = 本程式：
cli-default = ［預設：{ $value }］

# 使用說明頁。
cli-manual = 著色實驗室
cli-manual-name = 名稱
cli-manual-synopsis = 用法
cli-manual-examples = 範例
cli-manual-description = 說明
cli-manual-commands = 指令
cli-manual-version = 版本

# 訊息的開頭。
cli-error = 錯誤：{ $message }
cli-note = 注意：{ $message }

# 進度。
cli-working = 計算中
cli-reading = 讀取中
cli-drawing = 繪製中

# 列舉：a、b 或 c。
cli-or = { $others } 或 { $last }
cli-expected = 應為 { $choices }

# 引數的錯誤。
cli-wrong-value = { $argument } 的值「{ $value }」不正確：{ $reason }
cli-missing-value = { $argument } 需要一個值
cli-unknown-argument = 未知的引數 { $argument }{ $meant }；見 --help
cli-missing-arguments = 缺少 { $arguments }；見 --help
cli-conflict = { $argument } 不能與 { $other } 同時使用
cli-no-language = 應為 { $first } 或 { $second }
cli-no-command = 沒有指令「{ $name }」{ $meant }；見 `shading-lab help`
cli-no-material = 沒有這個名稱的材質{ $meant }；見 `shading-lab materials`
cli-no-such-output = --output：{ $name } 不能寫出 .{ $ending }，應為 { $expected }
cli-no-window = 這個版本不含視窗，請給一個指令：見 shading-lab --help
cli-set-without-scene = --set 需要場景；`{ $name }` 請單獨使用
cli-scene-before-command = 場景寫在指令之前，應寫在指令之後：shading-lab COMMAND SCENE
cli-expected-whole = 應為 { $low } 到 { $high } 的整數
cli-expected-count = 應為 0 以上的整數
cli-expected-number = 應為數字
cli-fresh-before-command = --fresh 在指令之前：它只用於視窗
cli-url-before-command = --url 寫在指令之前，應寫在指令之後：shading-lab link SCENE --url BASE
cli-expected-step = 應為 0 以上的整數，或 last
cli-expected-size = 應為以像素計的 寬x高，各 1 到 { $most }，例如 768x512
cli-too-many-pixels = 總共最多 { $most } 個像素
cli-expected-pixel = 應為從左上角起算的整數像素 X,Y，例如 100,80
cli-expected-place = 應為從左上角起算的像素 X,Y，例如 100.5,80.5
cli-expected-vertex = 應為從 0 起算的頂點編號
cli-expected-output = 檔名應以 .json、.png、.svg 或 .csv 結尾
cli-expected-png = 檔名應以 .png 結尾
cli-expected-film = 檔名應以 .png 或 .gif 結尾
cli-expected-qr = 應為以 .png 或 .svg 結尾的檔名
cli-expected-address = 應為本機的位址，例如 127.0.0.1 或 ::
cli-expected-html = 檔名應以 .html 結尾
cli-no-lesson = 沒有單元「{ $name }」{ $meant }；請見 `shading-lab lesson`
cli-scene-is-lesson = 這是單元，應為場景；請用 `shading-lab lesson { $name }`
cli-too-long-for-qr = 連結有 { $length } 個字元，超過 QR 碼的容量，場景應更簡單
cli-outside-range = { $argument } { $value }：應為 { $low } 到 { $high }
cli-outside-picture = { $what }：在圖片之外，應為 0,0 到 { $last }
cli-background = { $what }：這個像素沒有顯示物體，應為顯示物體的像素
cli-surround-too-small = --surround { $surround }：應大於中心的 { $centre }
cli-surround-too-large = --surround { $surround }：寬 { $pixels } 像素，用於 --picture 時最多 { $most }
cli-line-without-profile = --from 與 --to 需要剖面，請加上 --overlay profile
cli-vertex-without-normals = --vertex 需要法向量，請加上 --overlay vertex-normals
cli-probe-without-pixel = probe 缺少像素，應為 probe=X,Y
cli-two-pixels = 給了兩個不同的像素，所有圖層應共用一個
cli-pixel-alone = 只有像素，還要指定畫什麼，例如 vectors,angles,probe=100,80

# 無法完成的工作。
cli-no-threads = 無法啟動執行緒（{ $error }）
cli-input-unreadable = 無法讀取（{ $error }）
cli-picture-on-terminal = 圖片無法顯示在終端機上，應為檔案或管線
cli-output-unwritable = 無法寫出結果（{ $error }）
cli-too-large-for-overlays = 圖片太大，無法加上圖層

# `check` 對正確檔案的回報。
cli-check-sound = { $name }：正確（{ $object }{ $polygons }，{ $lights } 個光源，{ $mode } 著色，{ $size }）
cli-check-polygons = ，{ $count } 個多邊形

# 說明：指令為 cli-help-名稱，其引數為 cli-help-名稱-引數，多個指令共用的引數為 cli-help-shared-引數。
cli-help-program = 局部照明與多邊形著色實驗室。
    .long = 不加指令則開啟視窗。SCENE 是場景檔（.toml）、模型（.obj）、本程式匯出的圖片（.png），內建場景的名稱（`shading-lab scenes`）、單元（.md）、連結（加上引號），或 `-`：從標準輸入讀取場景檔、圖片或連結。寫出檔案時，`-` 為標準輸出。各指令的說明見 `shading-lab help COMMAND`。
cli-help-shared-help = 顯示說明
cli-help-shared-version = 顯示版本
cli-help-shared-language = 文字的語言，取代系統語言
cli-help-shared-source = .toml、.obj 或 .png 檔、內建場景的名稱、連結，或代表標準輸入的 -
cli-help-program-source = .toml、.obj、.png 或 .md 檔、內建場景的名稱、連結，或代表標準輸入的 -
cli-help-shared-set = 覆寫場景的一個鍵，例如 material.n=1005 或 light.0.position=[2,2,3]；鍵中的光源從 0 起算，所以 light.0 是光源 1
cli-help-shared-material = 使用具名材質（見 `materials`）；之後可再用 --set 修改
cli-help-shared-url = 連結開頭的網頁位址，例如 https://example.org/shading-lab/；視窗會記住
cli-help-shared-fresh = 像第一次啟動一樣開啟視窗，並且不儲存任何東西：適合教室的電腦
cli-help-shared-seed = 決定單元題目隨機取值的數字
cli-help-shared-json = 輸出一個 JSON 物件
cli-help-shared-csv = 將表格寫成 CSV；- 為標準輸出
cli-help-shared-output = 將圖形寫成 .png 或 .svg、表格寫成 .csv，或寫出 JSON 物件；- 為標準輸出，有圖形時為 PNG
cli-help-shared-size = 圖片的寬與高（像素），取代場景的設定；用於 curves、profile、scanline 時為圖形的大小
cli-help-shared-dark = 以深色背景、淺色線條繪製圖形
cli-help-shared-pane = 在場景旁加一個窗格，取代場景自己的窗格：寫出不同的設定，例如 shading.mode=exact，以分號隔開。最後一個窗格是比較的基準，除非 compare.reference 另行指定
cli-help-shared-frames = 每次量測的畫格數
cli-help-shared-threads = 執行緒數；預設為每核心一個
cli-help-render = 不開視窗，將場景畫成 PNG 檔
cli-help-render-output = 要寫出的圖片；其中含有場景，可再次開啟
cli-help-render-size = 寬與高（像素），取代場景的設定
cli-help-render-samples = 每像素取樣數
cli-help-render-compare = 窗格的顯示方式：single（只有場景）、panes（並排；用 --pane 時為預設）、wipe（第一個窗格與基準以 compare.wipe 處的線分開）或 difference（第一個窗格減基準，乘以 compare.gain）
cli-help-render-no-captions = 不畫窗格的名稱與數值，以及差異圖的刻度
cli-help-render-overlay = 疊在圖片上的圖層：vectors、angles、construction、lights、lobe、side-view、profile、defects、face-normals、vertex-normals；probe=X,Y 指定所說明的像素，否則取中央附近受光的像素
cli-help-render-from = --overlay profile 的線段起點（像素）；未指定時為水平線，通過探測點或中央
cli-help-render-to = 線段終點
cli-help-render-vertex = --overlay vertex-normals 標示這個頂點的各面及其權重
cli-help-animate = 繪製數值逐格變化的場景
    .long = 任何數字都可以變化，點、方向、係數與顏色的各個數字也可以。畫格邊畫邊寫出。動畫 PNG 保留所有顏色，並含有第一個畫格的場景；GIF 每個畫格最多 256 色，可能出現圖片中沒有的色帶。frame-%03d.png 這樣的檔名會將每個畫格寫成一張圖片，從 1 起算。
cli-help-animate-set-from = 一個鍵與其在第一個畫格的值，例如 material.n=5；可重複
cli-help-animate-set-to = 同一個鍵與其在最後一個畫格的值
cli-help-animate-frames = 從第一個到最後一個的畫格數
cli-help-animate-logarithmic = 畫格之間為等比，而非等差
cli-help-animate-back-and-forth = 再反向回到第一個畫格
cli-help-animate-seconds = 動畫的長度；未指定則每秒 30 個畫格
cli-help-animate-fps = 每秒的畫格數
cli-help-animate-output = 要寫出的動畫，.png（APNG）或 .gif；frame-%03d.png 這樣的名稱則寫出編號的圖片
cli-help-animate-size = 寬與高（像素），取代場景的設定
cli-help-animate-samples = 每像素取樣數
cli-help-probe = 代入一個像素的數值，列出方程式各項
cli-help-probe-pixel = 像素，左上角為 (0,0)
cli-help-profile = 求一條線上的亮度、斜率與感知亮度
    .long = 斜率以像素計；數值皆為捨入前的線性值。未指定檔案時，每個取樣點輸出一列，數值以逗號分隔。
cli-help-profile-from = 線段起點，從左上角起算的像素；像素中心在 +0.5
cli-help-profile-to = 線段終點
cli-help-profile-modes = 要比較的著色法，以逗號分隔
cli-help-profile-picture = 寫出整張圖片的感知結果，使用場景自己的著色法
cli-help-profile-viewing-distance = 眼睛到螢幕的距離（公釐）
cli-help-profile-density = 螢幕每公釐的像素數；每英寸 96 像素即 3.78
cli-help-profile-response = 反應模型：lateral-inhibition（側抑制）或 response-normalisation（反應正規化）
cli-help-profile-centre = 感受野中心的寬度 σ（視角度數）
cli-help-profile-surround = 感受野周邊的寬度 σ，大於中心
cli-help-profile-weight = 抑制強度 w
cli-help-profile-saturation = 反應正規化使增益減半的反應值
cli-help-compare = 量測場景各窗格與其中基準的差異
    .long = 差異以編碼與捨入前的線性亮度計算；顯示有截斷時，大於 1 的值視為 1。`study` 另列未截斷的誤差。
cli-help-normals = 列出頂點法向量來自哪些面及各面的權重
cli-help-normals-vertex = 頂點編號，從 0 起算
cli-help-normals-pixel = 取最接近這個像素的可見頂點；兩者皆未指定時取最接近圖片中央者
cli-help-defects = 量測內插著色的五種缺陷
cli-help-defects-pixel = 圖片旋轉時追蹤的像素；否則取中央附近受光的像素
cli-help-conditions = 檢查單一著色何時精確：三個條件
cli-help-explain = 列出畫格的計畫：計算了什麼、略過了什麼及原因
    .long = 時間為整個畫格的中位數，依計畫與不略過任何項目交替繪製；百分比相對於各階段總和。並列出 `bench` 的各種變更會重新執行哪些階段。
cli-help-scanline = 逐步將一個多邊形轉換成像素
    .long = 列出作用邊、P 與 Q 及其 α，以及每個像素的值。未指定檔案時，輸出該步驟的掃描線與代入數值的公式。
cli-help-scanline-pixel = 這個像素上的多邊形，否則取中央附近受光的多邊形
cli-help-scanline-face = 多邊形在網格中的編號
cli-help-scanline-rows = 放大像素的列數，8 到 64
cli-help-scanline-step = 要顯示的步驟，從 0 起算，或 `last`；否則為指定的像素，或中間的像素
cli-help-scanline-line = 要顯示的已完成掃描線：網格的列號，或 `last`
cli-help-study = 量測誤差與執行時間的關係
    .long = 各種著色法在不同細分程度下與精確圖片比較。誤差以顯示前的線性亮度計算，包含大於 1 的值；「顯示」誤差則在顯示有截斷時將值截為 1，與 `compare` 相同。
cli-help-study-methods = 著色法，以逗號分隔，預設為全部：flat、flat-vertex-mean、interpolated、gouraud、phong、phong-unnormalised；純量程式碼 phong-scalar、taylor（Bishop 與 Weimer 1986）、angular（Kuijk 與 Blake 1989）
cli-help-study-segments = 繞軸的分段數，以逗號分隔；沿軸的分段數按比例改變
cli-help-study-n = 高光指數，以逗號分隔；預設為場景的指數
cli-help-study-interpolation = 頂點之間的內插方法，以逗號分隔：perspective、affine、scanline
cli-help-study-repeats = 每種設定計時的畫格數
cli-help-study-reference = 與場景的定律對照，並以其精確圖片計算誤差：phong、blinn、cook-torrance、formula；場景用公式時預設為 phong，否則為場景的定律
cli-help-study-threads = 執行緒數；預設為每核心一個。設為 1 時，引擎與純量程式碼的時間差只來自程式碼
cli-help-stability = 繪製病態與極端的情況，或檢查場景自訂的定律
    .long = 比較單純的繪製程式在何處失敗、差多少，以及本引擎不會失敗。參考值以 106 位元計算。若引擎在任何地方誤差超過半個儲存值，結束狀態為 1。若給的場景以公式為定律，則改為以 f32、f64 與 106 位元計算那條定律：哪些運算失去位數或沒有定義、在多少像素，以及在圖片的何處。
cli-help-stability-source = 定律為公式的場景（reflection.model = "formula"），檢查它而不繪製那些情況
cli-help-stability-cases = 只執行這些情況，以逗號分隔名稱；預設為全部
cli-help-code = 將場景寫成 OpenGL 呼叫或 GLSL 著色器，可供複製；無法表達之處輸出到 stderr
cli-help-code-target = 輸出形式：c-snippet（C 的相機、光源與材質）、c（以固定功能 OpenGL 離螢幕繪製場景的完整 C 程式）或 glsl（頂點與片段著色器，GLSL 3.30）
cli-help-code-output = 要寫出的檔案，取代 stdout；著色器寫成同名的 .vert 與 .frag 兩個檔案
cli-help-link = 將場景印成連結
    .long = 連結寫出內建場景的名稱與不同的鍵；有自訂多邊形的場景則整個壓縮在連結中。模型不會隨連結傳送。各鍵見 docs/links.md。
cli-help-link-output = 將連結寫成 QR 碼，.png 或 .svg
cli-help-curves = 繪製一個像素的局部照明曲線
    .long = f(d)、餘弦的各次方、W(θ) 與鏡面反射葉。未指定檔案時，以文字與數字輸出圖表內容。
cli-help-curves-kind = 圖表種類：attenuation、exponent、reflectance 或 lobe；否則為場景具有的全部圖表，f 與 W 只在有變化時列出
cli-help-curves-pixel = 標示其數值的像素，否則取中央附近受光且各向量分明的像素
cli-help-curves-light = 繪製其衰減與反射葉的光源，從 1 起算；否則取該點所面向的第一個光源
cli-help-scenes = 列出內建場景
cli-help-materials = 列出 OpenGL 傳統的具名材質，供 --material 使用
cli-help-parameters = 列出場景檔的每個鍵及其預設值、範圍與意義
cli-help-check = 讀取場景、模型、圖片或單元，並回報其中的錯誤
cli-help-check-file = .toml、.obj、.png 或 .md 檔、內建場景的名稱，或代表標準輸入的 -
cli-help-check-set = 先覆寫場景的一個鍵
cli-help-lesson = 列出單元、以文字印出一個單元，或寫出學習單
    .long = 學習單是一個適合列印的網頁：文字、由引擎繪製的圖片、附書寫空間的問題，解答另起新頁。
cli-help-lesson-lesson = 單元名稱、以 .md 結尾的檔案，或代表標準輸入的 -
cli-help-lesson-output = 寫出學習單（.html）
cli-help-lesson-without-answers = 不附解答
cli-help-lesson-seed = 決定問題中的隨機數值
cli-help-class = 進行課堂：教室裡的手機跟著單元進行，並回答其中的問題
    .long = 印出供手機開啟的網址，並開啟視窗。答案寫入檔案，每行一個；以同一個檔案執行同樣的命令，課堂就接著進行。不開視窗時印出發生的事，並執行輸入的字：show、again、explain、next、back、end。
cli-help-class-lesson = 單元名稱，或以 .md 結尾的檔案
cli-help-class-headless = 不開視窗
cli-help-class-port = 連接埠，取代 8080 或下一個可用的
cli-help-class-bind = 手機可以連到的本機位址；只是試用時為 127.0.0.1
cli-help-class-url = 經過代理伺服器時，手機開啟的網址
cli-help-class-output = 課堂的紀錄，取代 class.jsonl；預演時取代 rehearsal.jsonl
cli-help-class-page = 網頁版的檔案，讓手機開啟操作，取代程式旁的資料夾 page
cli-help-class-own-pace = 讓學生依自己的進度前往其他步驟
cli-help-class-rehearse = 模擬這麼多位學生，他們犯的是單元所知道的錯誤
cli-help-class-seed = 決定問題中的隨機數值
cli-help-collect = 批改學生繳交的圖片
    .long = 每位學生一列，每個問題一欄。答案由引擎批改。無法讀取的檔案會列出，其餘照常處理。
cli-help-collect-files = 由「檔案 > 繳交」產生的圖片
cli-help-collect-lesson = 只收這個單元的答案，內容以這個檔案為準，不用圖片中的
cli-help-collect-pre = 比較課程之前的測驗，取自這些圖片……
cli-help-collect-post = ……與課程之後的測驗：全班的標準化增益（Hake 1998），以及各題的難度、鑑別度與信度
cli-help-collect-output = 寫出附有成績表與各題答案分布的網頁（.html）
cli-help-completions = 寫出命令列介面的自動完成設定
    .long = 請放在命令列介面尋找設定的位置：bash 為 ~/.local/share/bash-completion/completions；zsh 為 $fpath 中的資料夾，檔名 _shading-lab；fish 為 ~/.config/fish/completions，檔名 shading-lab.fish；PowerShell 則由設定檔執行。
cli-help-completions-shell = bash、zsh、fish、powershell 或 elvish
cli-help-manual = 寫出本程式或某個指令的使用說明頁
cli-help-manual-command = 指令；未指定則為本程式
cli-help-manual-output = 將本程式與各指令的使用說明頁寫到這個資料夾
cli-help-help = 顯示本程式或某個指令的說明
cli-help-help-command = 指令；未指定則為本程式
cli-help-bench = 量測畫格及其各階段的時間
    .long = `full` 的每個畫格重新投影、覆蓋、著色並顯示；細分結果保留，如同顯示卡保留在緩衝區中。`changes` 的每個畫格與前一個只差一項：第一個光源的位置、n、ka、環繞物體的眼睛，或分段數。
cli-help-bench-growth = 另量測時間隨像素數（至 800 萬）與三角形數（至 400 萬）的成長
cli-help-bench-simd = SIMD 等級：PC 上為 avx512、avx2、sse4.2 或 sse2；未指定則用這部電腦最好的等級

cli-check-materials = 模型的材質：{ $names }
cli-check-lesson = { $name }：單元沒有問題，{ $steps } 個步驟，{ $questions } 個題目
