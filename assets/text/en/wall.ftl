# The live class in the lecturer's window, which is on the wall.

wall-about = The students answer on their phones: a code on the wall takes them to the page, in the room’s own network. You ask, their answers lie over one another, you ask again, explain, and go on.
wall-choose = Choose a lesson
wall-teach = Teach “{ $title }” …
wall-not-started = The class has not started
wall-file = Teach a class
    .verb = Start
    .kind = Answers of a class
    .sentence = Answers are kept in this file, as they come. A class goes on with a file that is there.
wall-code = Code of the address { $address }
wall-address = Address
wall-joined = { $count ->
    [one] 1 student has joined
   *[other] { $count } students have joined
 }
wall-note = { $note }.
wall-step = Step { $step } of { $count }
wall-round = Round { $round }
wall-answered = { $answered } of { $joined } have answered
wall-count = { $count ->
    [one] 1 answer
   *[other] { $count } answers
 }
wall-right-of = { $right } of { $count } right
wall-right = Right answer
wall-students-axis = students
wall-students = Students
wall-names = Names
wall-own-pace = Students go at their own pace
    .tip = Students can move to other steps and answer there. Their phones explain nothing before you do.
wall-elsewhere = { $count ->
    [one] 1 student is at another step
   *[other] { $count } students are at other steps
 }
wall-unnamed = without a name: { $count } · not connected: { $away }

wall-back = Back
wall-show = Show answers
wall-again = Ask again
wall-explain = Explain
wall-next = Next
wall-end = End
    .tip = Ends the class. Its answers are in its file; started again with that file, it goes on.
