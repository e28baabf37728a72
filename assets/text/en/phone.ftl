# The page of a class on phones.

phone-no-script = This page needs JavaScript.
phone-lost = No connection. It is tried again by itself; nothing that you have entered is lost.
phone-refused = The class cannot be joined. It is tried again by itself.
phone-missing = This step could not be loaded. It is tried again by itself.
phone-name = Nickname (optional)
phone-name-save = Save
phone-name-about = Only the lecturer sees it.
phone-named = Saved.

# The steps, where students go at their own pace.
phone-back = Back
phone-next = Next
phone-own-step = Step { $step } of { $steps }
phone-lecturer-step = Step { $step } of { $steps } (the lecturer is at step { $lecturer })

# A question.
phone-send = Send
phone-sending = Sending …
phone-saved = Saved. You can change your answer until the answers of the class are shown.
phone-changed = Changed, not sent yet.
phone-waiting = Not sent yet: no connection. It will be sent by itself.
phone-again = Asked again: compare with your neighbour, then answer again.
phone-closed = The class is over.
phone-spread = The answers of the class are being shown.
phone-right = The right answer

# The kinds of questions.
phone-number = Enter a number from { $from } to { $to }.
phone-choose = Choose one of the answers.
phone-formula = Type a formula first.
phone-point = Tap the picture where it is. By keyboard: the arrow keys move the cross.
phone-picture = { $ask } The arrow keys move the cross.
phone-place = Cross at { $x }, { $y } from the middle, to the right and down
phone-no-place = Tap the picture first.
phone-curve = Draw the curve with a finger, over the whole width.
phone-values = Enter values instead
phone-values-range = From { $from } to { $to }; straight lines in between.
phone-value-at = { $y } at { $x_name } = { $x }
phone-order = From smallest to largest: move the items by their buttons, or drag them.
phone-moved = { $item }: place { $place }
phone-settings = Try it in the lab, and enter the value here.
phone-match = Find the values in the lab, and enter them here.
phone-target = Target

# The program itself.
phone-lab = Open the lab
phone-no-lab = The lab cannot be opened from here: the files of the program’s web page are not on the lecturer’s computer.
phone-no-model = The lab cannot be opened from here: the model of this step is a file on the lecturer’s computer.
