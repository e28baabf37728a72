# 控制面板中的光源與物體。

lights-none = 除了環境光以外沒有其他光源。
lights-add = 新增光源
lights-duplicate = 複製
lights-number = 光源 { $number }
lights-named = 光源 { $number }：{ $name }
lights-off = { $name }：目前關閉，因為已停用，或有其他光源設為「單獨顯示」
lights-remove = 移除光源 { $number }
lights-removed = 已移除光源 { $number }
lights-mute = 停用
    .name = 停用光源 { $number }
    .tip = 停用這個光源。
lights-solo = 單獨顯示
    .name = 單獨顯示光源 { $number }
    .tip = 關閉所有未設為「單獨顯示」的光源。
lights-sampling = N = { $samples }：誤差 { $rms }（RMS），最大 { $greatest }
    .tip = 在一張沒有陰影的小圖片上，將 N 個取樣點與 4096 個取樣點的結果相比，以白色的百分比表示：各色版的均方根差與最大差。
lights-sampling-none = 沒有取樣誤差：這個光源照不到圖片中的物體。
lights-viewer-far = 衰減使用到眼睛的距離，但 V 為常數。

lights-model-none = 尚未開啟模型
lights-model-open = 開啟模型…
lights-mesh = { $faces } 個多邊形、{ $vertices } 個頂點
    .tip = 以 { $triangles } 個三角形繪製。每個頂點是帶有一個法向量的點。
lights-triangles = 三角形
    .tip = 同時設定分段數與環數，使多邊形的寬與高大致相同。滑桿最多到一百萬；可輸入至四百萬。
lights-polygons = { $vertices } 個頂點、{ $faces } 個面
lights-polygons-drag = 在圖片中拖曳頂點；按住 Shift 可拉近或推遠。面請在場景檔中編輯。
lights-polygons-many = 頂點與面請在場景檔中編輯。
lights-vertex = 頂點
    .tip = 下方顯示其位置的頂點編號，與場景檔相同。
lights-vertex-position = 位置
    .name = 頂點位置
    .tip = 頂點的位置，以世界單位表示。若多邊形會自我相交，頂點就會停住。
