# Answers handed in, the sheet of a class, and worksheets.

class-no-answers = a picture without answers, expected one that was handed in
class-version = the answers are of a version that this program does not know, expected { $version }
class-changed = the answers were changed after they were handed in
class-not-answers = the answers cannot be read ({ $error })
class-unfit = has an answer that fits no question of its lesson
class-empty = no question of it is answered
class-again = handed in again by the same student: { $file } counts
class-other-lesson = answers to the lesson “{ $lesson }”, expected “{ $expected }”
class-other-version = answers to another version of the lesson “{ $lesson }”
class-no-lesson = the lesson “{ $lesson }” is not known
class-bad-lesson = the lesson inside is not sound: line { $error }
class-needs-lesson = the lesson needs a file: give the lesson with --lesson
class-too-heavy = question { $question } of the lesson in it: { $why }

# The record of a live class.
class-record-too-long = the record is too long, expected at most { $most } MB
class-record-line = line { $line }: { $error }
class-record-head = not the record of a class, whose first line says what it is about
class-record-second = a second beginning, expected answers
class-record-student = a student of that number, expected 1 to { $most }

# The class's table.
class-name = Name
class-right = Right
class-share-right = Share right
class-title = { $title }: { $students ->
    [one] 1 student
   *[other] { $students } students
 }
class-students = { $count ->
    [one] 1 student
   *[other] { $count } students
 }
class-answered = { $answered } answered, { $right } correct finally
class-predicted = Predicted first: { $least } to { $greatest }, half of them { $lower } to { $upper }, median { $median }
class-predicted-same = Predicted first: { $value } by all
class-predicted-few = Predicted first: { $values }
class-off = First answers are off by { $least } to { $greatest }, half of them by { $lower } to { $upper }, median { $median }
class-off-same = First answers are all off by { $value }
class-off-few = First answers are off by { $values }
class-solution = Right: { $right }
class-looked-up = { $count ->
    [one] looked up once
   *[other] looked up { $count } times
 }
class-clicks = First clicks: green ones are right. White: the right place.
class-curves = First curves: green ones are right. Black: the right curve.
class-numbers = First answers. Green: the right one.
class-sheet = Answers of the class
class-unreadable = Not counted

# Worksheets.
class-about = { $topic }, { $minutes } minutes
class-topic-light = Light
class-topic-reflection = Reflection
class-topic-shading = Shading
class-topic-engine = Rendering
class-topic-test = Before and after the course
class-date = Date
class-question = Question { $number }.
class-answers = Answers: { $title }
class-answer = Answer:
class-mark = Mark the place in the picture with a cross.
class-start = Start
class-target = Target (seed { $seed })
class-range = A number from { $from } to { $to } { $unit }
class-models = First answers that follow a wrong model
class-formula = Names: { $names }
class-formula-more =
    { $count ->
        [one] and another spelling
       *[other] and { $count } other spellings
    }

# A test before a course and after it.
inventory-one-test = expected answers to one test, found: { $found }
inventory-items = the tests have { $pre } and { $post } items, expected as many
inventory-item = Item
inventory-title = Title
inventory-pre = Right before
inventory-post = Right after
inventory-gain = Gain
inventory-pre-r = Discrimination before
inventory-post-r = Discrimination after
inventory-before = Before: { $students } students, { $mean } % right (standard deviation { $deviation } %), reliability (KR-20) { $reliability }
inventory-after = After: { $students } students, { $mean } % right (standard deviation { $deviation } %), reliability (KR-20) { $reliability }
inventory-class-gain = Normalised gain of the class: { $gain }
