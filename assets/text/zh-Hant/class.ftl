# Answers handed in, the sheet of a class, and worksheets.

class-no-answers = 圖片中沒有答案，應為繳交的圖片
class-version = 答案的版本不是本程式認得的，應為 { $version }
class-changed = 答案在繳交之後被更改過
class-not-answers = 無法讀取答案（{ $error }）
