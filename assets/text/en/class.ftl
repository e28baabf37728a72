# Answers handed in, the sheet of a class, and worksheets.

class-no-answers = a picture without answers, expected one that was handed in
class-version = the answers are of a version that this program does not know, expected { $version }
class-changed = the answers were changed after they were handed in
class-not-answers = the answers cannot be read ({ $error })
