# The course in the window: lessons, questions and answers.

course = Course
    .words = lessons, exercises, questions
course-start = Start the course
course-lessons = Lessons
course-own = Your own lesson
course-none = This program has no lessons.
course-open-own = Open a lesson of your own…
course-minutes = { $count } min
course-begun = begun
course-done = (done)
course-in-text = in the text

course-step = Step { $number } of { $count }
course-back = Back
    .tip = The step before (Page up)
course-next = Next
    .tip = The next step (Page down)
course-finish = Finish
course-preparing = Computing the numbers …
course-no-step = The lesson has no such step.
course-numbers = Show the numbers: { $view }
course-again = Back to the step’s scene
    .tip = Put everything back as the step shows it
course-hidden = Numbers are hidden while the question is open.
course-to-question = To the question
course-left = Another scene is open. The lesson waits where you left it.
course-return = Back to the lesson
    .tip = Show the scene of the lesson’s step again
course-locked = The scene waits while the question is open.
course-after-answer = after your answer

course-question = Question
course-check = Check
course-show-answer = Show the answer
    .tip = Show the right answer and why it is right; this is counted
course-solving = Computing the right answer …
course-number = a number
course-answer = Your answer
course-no-number = This is not a number.
course-formula = a formula
course-formula-right = Right:
course-formula-put = Insert { $key }
course-point = Click in the picture. By keyboard: F3, the arrow keys, then Enter.
    .touch = Tap in the picture.
course-point-set = Your mark is in the picture. Drag it or click elsewhere to move it.
    .touch = Your mark is in the picture. Drag it or tap elsewhere to move it.
course-settings = Use the control above; Check grades its present value.
    .test = Use the control above; its present value is your answer.
course-order = From smallest to largest. Drag, or use the arrows.
course-up = Move up: { $item }
course-down = Move down: { $item }
course-right-order = The right order
course-curve = Draw the curve with the pointer, or with the arrow keys; Enter checks it.
    .test = Draw the curve with the pointer, or with the arrow keys.
course-curve-area = Drawing of { $y } over { $x }
course-curve-whole = Draw the curve over the whole width.
course-curve-clear = Clear
course-curve-yours = — yours
course-curve-right = — right
course-curve-wrong = — the wrong model
course-mark-yours = yours
course-mark-right = right

course-target = Target
course-yours = Yours
course-warmer = warmer
course-colder = colder
course-match-same = no difference to be seen
course-match-meter = Nearness to the target
course-match-distance = RMS difference { $rms }
course-match-tries =
    { $count ->
        [one] 1 change
       *[other] { $count } changes
    } in { $time }

course-right = Right!
course-right-after = Right, after { $count } tries.
course-looked-up =
    { $count ->
        [one] Looked up after 1 try.
       *[other] Looked up after { $count } tries.
    }
course-wrong = Not right yet.
course-nearly = Not right yet. Closeness: { $share } %
course-try-again = Change your answer and check again, or show the answer.
course-values = Right: { $right } · yours: { $own }
course-place = The ring in the picture marks the right place.
course-places = The dots in the picture mark the right places.
course-set-it = Set it so

course-results = Results
course-results-none = You have not answered a question yet.
course-results-count = { $answered } of { $count } answered. Right: { $right }, of these at the first try: { $first }. Looked up: { $looked }.
course-results-again = Look at these again:
course-kept = Your answer is kept. You can change it until you hand in.
course-not-kept = No answer yet.
course-test-count = { $answered } of { $count } answered
course-test-missing = Still without an answer:
course-test-end = End of the test

course-hand-in = Hand in your answers
    .verb = Write
    .sentence = One picture with the scene, the lesson and your answers inside. Send it to your lecturer.
course-hand-in-name = Your name
course-hand-in-nothing = There are no answers yet: open a lesson and answer a question first.
course-not-handed-in = Answers not written
course-handed-in = Answers written to { $path }

course-answers = Answers handed in
course-answers-void = These answers do not count: { $why }.
course-answers-marking = Marking the answers …
course-answers-right = { $right } of { $count } right
course-answers-question = Question { $number }
course-answers-first = First answer
course-answers-given = Answer
course-answers-model = Wrong model
course-answers-solution = Right answer
course-answers-none = none
course-answers-curve = a drawn curve
course-answers-wrong = wrong
course-answers-close = closeness { $share } %
course-answers-tries = { $count } tries
course-answers-seconds = { $seconds } s

course-target-title = Match: { $scene }
course-target-level = Level { $level }
course-target-ask =
    { $count ->
        [one] Find the value that makes your picture like the target.
       *[other] Find the { $count } values that make your picture like the target.
    }
course-target-file = The scene could not be made a target. Save it as a scene file and open that.
course-loading = Loading the lessons…
# Words of the lessons for a mouse, the longer ones first, and in the same order those for a finger.
course-mouse-words = Clicked clicked Click click
course-finger-words = Tapped tapped Tap tap
