# 無法開啟或寫入的檔案。同一行的前面是檔案路徑。
document-scene-file = 場景檔
document-model = OBJ 模型
document-picture = 圖片
document-no-such-file = 找不到檔案，應為{ $expected }
document-unreadable = 無法讀取（{ $error }），應為{ $expected }
document-not-utf-8 = 不是 UTF-8，應為文字檔
document-directory = 這是資料夾，應為 .toml、.obj 或 .png 檔
document-directory-not-file = 這是資料夾，應為{ $expected }
document-not-regular = 不是一般檔案，應為{ $expected }
document-unknown-kind = 未知的檔案類型，應為 .toml、.obj 或 .png
document-elsewhere = 檔案中的路徑只能指向本機的檔案，不能指向其他電腦
document-model-memory = 這個大小的模型約需 { $megabytes } MB 記憶體，目前無法取得，請改用較小的模型
document-did-you-mean = （是否要找 { $name }？）
document-no-such-scene = 沒有這個名稱的內建場景，應為 .toml、.obj、.png 檔或場景名稱{ $meant }；見 `shading-lab scenes`
document-target-directory = 這是資料夾，應為可寫入的檔案
document-target-protected = 檔案唯讀，應為可寫入的檔案
document-target-no-name = 不是檔名，應為可寫入的檔案
document-target-no-folder = 所在的資料夾不存在，應為現有資料夾中的檔案
document-unwritable = 無法寫入（{ $error }）
document-nothing-to-draw = 沒有可繪製的內容
document-figure-too-large = 圖形太大
# 在標準錯誤輸出與視窗中，隨圖一起出現。
document-no-materials = { $name }：使用場景的材質繪製，模型本身的材質不會繪出
