# The panel of controls, its rows and fields, and the commands of the window.

## Sections

controls-material = 材質（material）
controls-lights = 光源（light）
controls-shading = 著色（shading）
controls-object = 物體（object）
controls-surroundings = 周圍環境（surroundings）
controls-transparency = 透明度（transparency）
controls-camera = 相機（camera）
controls-display = 顯示（display）

## Rows

controls-all = 所有控制項
controls-reset = 重設{ $name }
controls-reset-tip = 重設為場景的值（在欄位中按 Ctrl+R）
controls-on = 開
controls-off = 關
controls-no-name = 未命名
controls-per-channel = { $name } 各色版
controls-infinite = { $name } 無限大
controls-infinite-tip = 無限大：完美的鏡面
controls-red = 紅
controls-green = 綠
controls-blue = 藍
controls-x = x
controls-y = y
controls-z = z
controls-width = 寬
controls-height = 高
controls-swatch = { $name } 顏色
controls-swatch-tip = 選擇顏色
controls-channel-slider = { $name } { $channel } 滑桿
controls-chip-white = 白
controls-chip-grey = 灰
controls-chip-black = 黑
controls-chip-warm-white = 暖白
controls-chip-cool-white = 冷白
controls-chip-red = 紅
controls-chip-yellow = 黃
controls-chip-green = 綠
controls-chip-blue = 藍
controls-chip-violet = 紫
controls-field-wrong = 「{ $text }」不是數字，保留原來的值。
controls-field-accepts = 可輸入：0.5、1e-3、1/3、2*pi、sqrt(2)、2^10、(1+2)*3、inf

## Material

controls-model-none = 場景本身的材質
controls-materials = 材質範本
    .label = 範本
    .none = 選擇…
    .tip = OpenGL 茶壺的 24 種材質（Kilgard 1994），Ka、Kd、Ks 與 n 依原文。
controls-stones = 石材
controls-metals = 金屬
controls-plastics = 塑膠
controls-rubbers = 橡膠
controls-matching = 等效高光
    .label = 等效高光
    .tip = 使另一模型的高光在半高處同寬的指數或粗糙度。按一下即同時更改模型與數值。
controls-match-exponent = { $model } 模型的等效指數
    .tip = 改用 { $model } 模型，並取使高光同寬的 n
controls-match-roughness = 等效粗糙度
    .tip = 改用 Cook–Torrance 模型，並取使高光同寬的 Beckmann 粗糙度 m
controls-law-hint = 一個公式，最後一行是它的值
controls-law-kept = 圖片仍是最後一個可讀取的公式所畫的。
controls-law-beside = 與 Phong 對照
    .tip = 顯示此圖片與 Phong 模型的圖片有何差異
controls-law-product = { $a } 與 { $b } 的內積：兩者夾角的餘弦
controls-law-distance = 與光源的距離（世界單位）
controls-law-theta = θ，N 與 L 的夾角（度）
controls-law-phi = φ，R 與 V 的夾角（度）

## Shading, surroundings, camera and display

controls-exact-without-surface = 此網格沒有精確的曲面：精確模式改以雙精度計算 Phong 著色。
controls-halves = 左半：常數 Ia。右半：一次反射。
controls-fit = 最佳環境光
    .label = 最佳擬合
    .tip = 最接近其他表面實際反射而來之光的常數 Ia：對整張圖片取最小平方。依序為紅、綠、藍。
    .idle = 有散射光之處 Ka 皆為 0，任何常數都沒有差別
controls-fit-take = 採用最佳環境光
    .label = 採用
    .tip = 將 Ia 設為此值
controls-depth-exact = 精確模式沒有頂點：深度取自各像素。
controls-reset-camera = 重設相機
    .tip = 回到開啟場景時的視角（按鍵 0）
controls-overflowing =
    { $count ->
        [0] 沒有像素超過 1
        [one] 1 個像素超過 1
       *[other] { $number } 個像素超過 1
    }
controls-overflowing-or-undefined =
    { $count ->
        [0] 沒有像素超過 1 或沒有值
        [one] 1 個像素超過 1 或沒有值
       *[other] { $number } 個像素超過 1 或沒有值
    }
controls-most-lights = 一個場景最多有 { $most } 個光源。

## Menus and the groups of the keyboard help

controls-group-file = 檔案
controls-group-edit = 編輯
controls-group-view = 檢視
controls-group-compare = 比較
controls-group-scene = 場景
controls-group-probe = 探測點
controls-group-camera = 相機
controls-group-scan = 掃描線（開啟該檢視時）
controls-group-help = 說明
controls-theme = 佈景主題

## Commands

controls-command-open = 開啟…
    .does = 開啟場景、模型或匯出的圖片
controls-command-scenes = 場景…
    .does = 開啟場景圖庫
controls-command-save = 儲存場景
    .does = 儲存場景
controls-command-save-as = 另存場景…
    .does = 以另一名稱儲存場景
controls-command-export = 匯出圖片…
    .does = 匯出圖片
controls-command-quit = 結束
    .does = 關閉視窗
controls-command-undo = 復原
    .does = 復原上一個變更
controls-command-redo = 重做
    .does = 重做（亦可按 Ctrl + Y）
controls-command-copy = 複製圖片
    .does = 將圖片複製到剪貼簿
controls-command-code = 程式碼…
    .does = 以 OpenGL 呼叫與著色器顯示場景
controls-command-find = 尋找指令…
    .does = 依名稱尋找指令、設定、場景或單元
controls-command-manual = 使用手冊
controls-command-reset-scene = 重設場景
controls-command-reset-all = 全部重設
controls-command-reset-layout = 重設檢視與版面
controls-command-next-scene =
    .gesture = PageUp、PageDown
    .does = 開啟上一個或下一個內建場景；在單元中則為上一步或下一步
controls-command-reset-row =
    .does = 重設所選列的值
controls-command-next-field =
    .does = 移到下一個欄位；按住 Shift 則移到上一個
controls-command-leave =
    .does = 離開對話框、欄位或全螢幕；欄位保留原來的值
controls-command-controls = 場景面板
    .does = 顯示或隱藏控制面板
controls-command-views = 檢視面板
    .does = 顯示或隱藏檢視面板
controls-command-stages = 狀態列
    .does = 顯示或隱藏列出各階段的狀態列
controls-command-next-view = 下一個檢視
    .does = 顯示下一個檢視
controls-command-vectors = 向量
    .does = 顯示探測點的向量
controls-command-angles = 角度
controls-command-construction = R 的作圖
controls-command-side-view = 側視圖
controls-command-side-view-where-needed = 需要時顯示側視圖
controls-command-lobe = 反射波瓣
    .does = 顯示探測點的反射波瓣
controls-command-half-vector = 總是顯示 H
controls-command-handles = 控制點
    .does = 顯示光源與頂點的控制點
controls-command-normals = 所有法向量
    .does = 顯示面與頂點的法向量；按一下頂點可持續標示其相鄰的面
controls-command-face-normals = 面法向量
controls-command-vertex-normals = 頂點法向量
controls-command-channels = RGB 值
controls-command-smooth-edges = 平滑邊緣
controls-command-picture-alone = 全螢幕
    .does = 只顯示圖片，全螢幕
controls-command-projector = 投影尺寸
    .does = 開啟或關閉投影尺寸
controls-command-larger = 放大
    .does = 放大介面
controls-command-smaller = 縮小
    .does = 縮小介面
controls-command-ordinary-size = 原始大小
    .does = 重設介面大小
controls-command-next-comparison = 下一種比較
    .does = 依序切換單張、窗格、分割線與差異
controls-command-next-pane = 下一個窗格
    .does = 選取下一個窗格，控制面板顯示其設定
controls-command-all-modes = 所有著色法
controls-command-panes = 窗格與數值…
controls-command-defects = 五種缺陷…
controls-command-flat = 單一著色
    .does = 單一著色（flat）
controls-command-interpolated = 內插著色
    .does = 內插著色（interpolated）
controls-command-gouraud = Gouraud 著色
    .does = Gouraud 著色
controls-command-phong = Phong 著色
    .does = Phong 著色
controls-command-exact = 精確著色
    .does = 精確著色（exact）
controls-command-unnormalised = Phong，不重新單位化
    .does = 不重新單位化法向量的 Phong 著色
controls-command-add-light = 新增光源
controls-command-reset-camera = 重設相機
    .does = 重設相機
controls-command-take-probe =
    .does = 以方向鍵控制探測點
controls-command-probe-pixel =
    .does = 將探測點移動 1 像素
controls-command-probe-stride =
    .does = 將探測點移動 10 像素
controls-command-probe-here =
    .gesture = 按一下或點一下
    .does = 將探測點放在該處
controls-command-orbit =
    .does = 向左、右、上、下旋轉相機
controls-command-pan =
    .does = 向左、右、上、下平移相機
controls-command-zoom =
    .does = 將相機移近或移遠
controls-command-drag =
    .gesture = 拖曳
    .does = 旋轉相機；移動光源、其箭頭或光錐、頂點或探測點
controls-command-deep-drag =
    .gesture = Shift、中鍵或兩指拖曳
    .does = 平移相機；沿深度移動光源或頂點
controls-command-wheel =
    .gesture = 滾輪或兩指縮放
    .does = 將相機移近或移遠；在光源上則沿深度移動光源
controls-command-scan-pixel =
    .does = 上一個或下一個像素
controls-command-scan-edge =
    .does = 上一條或下一條邊
controls-command-scan-line =
    .does = 上一條或下一條掃描線
controls-command-scan-ends =
    .does = 第一步或最後一步
controls-command-scan-play =
    .does = 播放或暫停
controls-command-keys = 鍵盤與滑鼠
    .does = 顯示此表
controls-command-menus =
    .does = 移到選單
controls-command-about = 關於
controls-group-course = 課程
controls-command-lessons = 單元列表
controls-command-teach = 上課…
controls-command-class = 課堂
controls-command-class-step =
    .does = 上課時：顯示答案、說明、下一步；或退回一步
    .gesture = PageUp PageDown
controls-command-course-step =
    .does = 開啟的單元的上一步或下一步
    .gesture = PageUp PageDown
controls-command-hand-in = 繳交答案…
controls-command-set-target = 設為目標
