# Answers handed in, the sheet of a class, and worksheets.

class-no-answers = 圖片中沒有答案，應為繳交的圖片
class-version = 答案的版本不是本程式認得的，應為 { $version }
class-changed = 答案在繳交之後被更改過
class-not-answers = 無法讀取答案（{ $error }）
class-unfit = 有一個答案不屬於這個單元的任何問題
class-empty = 沒有回答任何問題
class-again = 同一位學生再次繳交：以 { $file } 為準
class-other-lesson = 是單元「{ $lesson }」的答案，應為「{ $expected }」
class-other-version = 是單元「{ $lesson }」另一版本的答案
class-no-lesson = 不認得單元「{ $lesson }」
class-bad-lesson = 圖片內的單元有誤：第 { $error } 行
class-needs-lesson = 這個單元需要一個檔案：請以 --lesson 指定單元
class-too-heavy = 其中單元的第 { $question } 題：{ $why }

# The record of a live class.
class-record-too-long = 紀錄太長，最多 { $most } MB
class-record-line = 第 { $line } 行：{ $error }
class-record-head = 不是課堂的紀錄：紀錄的第一行說明課堂的內容
class-record-second = 又一個開頭，應為答案
class-record-student = 沒有這個編號的學生，應為 1 至 { $most }

# The class's table.
class-name = 姓名
class-right = 答對
class-share-right = 答對比例
class-title = { $title }：{ $students } 位學生
class-students = { $count } 位學生
class-answered = { $answered } 人作答，最後答對的有 { $right } 人
class-predicted = 最初的預測：{ $least } 至 { $greatest }，半數在 { $lower } 至 { $upper } 之間，中位數 { $median }
class-predicted-same = 最初的預測：全都是 { $value }
class-predicted-few = 最初的預測：{ $values }
class-off = 最初的答案相差 { $least } 至 { $greatest }，半數相差 { $lower } 至 { $upper }，中位數 { $median }
class-off-same = 最初的答案全都相差 { $value }
class-off-few = 最初的答案相差 { $values }
class-solution = 正確答案：{ $right }
class-looked-up = 看過答案 { $count } 次
class-clicks = 最初點選的位置，綠色為正確。白色：正確位置。
class-curves = 最初畫的曲線，綠色為正確。黑色：正確曲線。
class-numbers = 最初的答案。綠色：正確答案。
class-sheet = 全班的答案
class-unreadable = 未計入

# Worksheets.
class-about = { $topic }，{ $minutes } 分鐘
class-topic-light = 光
class-topic-reflection = 反射
class-topic-shading = 著色
class-topic-engine = 繪製
class-topic-test = 課程的前測與後測
class-date = 日期
class-question = 問題 { $number }.
class-answers = 解答：{ $title }
class-answer = 答案：
class-mark = 請在圖片中的位置畫叉。
class-start = 起始
class-target = 目標（種子 { $seed }）
class-range = { $from } 至 { $to } 的數值 { $unit }
class-models = 符合錯誤模型的第一次作答
class-formula = 名稱：{ $names }
class-formula-more = 以及另外 { $count } 種寫法

# A test before a course and after it.
inventory-one-test = 應為同一份測驗的答案，實際為：{ $found }
inventory-items = 兩份測驗分別有 { $pre } 題與 { $post } 題，題數應相同
inventory-item = 題
inventory-title = 主題
inventory-pre = 前測答對率
inventory-post = 後測答對率
inventory-gain = 增益
inventory-pre-r = 前測鑑別度
inventory-post-r = 後測鑑別度
inventory-before = 前測：{ $students } 人，答對 { $mean } %（標準差 { $deviation } %），信度（KR-20）{ $reliability }
inventory-after = 後測：{ $students } 人，答對 { $mean } %（標準差 { $deviation } %），信度（KR-20）{ $reliability }
inventory-class-gain = 全班的標準化增益：{ $gain }
