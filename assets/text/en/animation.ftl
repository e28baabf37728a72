# Animations: a scene's numbers from one value to another.

animation-one-end = `{ $key }` has only one end, expected its value at the beginning and at the end
animation-no-number = `{ $key }` is not a number, expected a key whose value is a number, a colour, a point or a direction
animation-infinite = `{ $key }` goes to infinity, expected two finite numbers
animation-lengths = `{ $key }` has more numbers at one end, expected as many at both
animation-sign = `{ $key }` cannot go in equal ratios, expected two numbers of the same sign, neither of them 0
animation-nothing = nothing changes, expected a key whose value differs at the end
animation-frames = expected 2 to { $most } frames
animation-frame = frame { $frame }: { $error }
animation-seconds = expected { $least } to { $most } seconds for so many frames

# In the window's export form.
animation = Animation
animation-tip = The value goes from one end to the other; the file repeats for ever
animation-key = Value
animation-from = From
animation-to = To
animation-frame-count = Frames
animation-duration = Seconds
animation-scale = Steps
animation-linear = Equal steps
animation-logarithmic = Equal ratios
animation-back = Back and forth
animation-format = Format
animation-apng-tip = Every colour as it is; browsers show it
animation-gif-tip = At most 256 colours a frame, which may show bands; for slides and documents
