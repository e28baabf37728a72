# Lessons: what can be wrong with one, and its questions.

expression-unknown = has no “{ $name }”
expression-too-long = is longer than { $most } bytes
expression-nested = is nested deeper than { $most } levels
expression-unexpected = has an unexpected “{ $found }” at character { $place }
expression-ends = ends too early
expression-arguments = gives “{ $name }” { $count } values, expected { $expected }
expression-list = is a list, expected one number
expression-empty = is an empty list
expression-length = has lists of { $a } and { $b } numbers, expected equally many
expression-not-finite = is no finite number
expression-no-truth = is neither true nor false: a comparison such as a < b was expected

# Formulas: what is wrong at a place.
formula-at = line { $line }, column { $column }: { $problem }
formula-expected-value = a number, a name or “(”
formula-expected-operator = an operator, or a new line
formula-expected-sign = “{ $sign }”
formula-expected-name = a name
formula-expected-quote = text between quotation marks
formula-unexpected = unexpected “{ $found }”, expected { $expected }
formula-ends = the formula ends too early, expected { $expected }
formula-unknown = there is no “{ $name }” here{ $meant }
formula-arguments = “{ $name }” has { $count } values, expected { $expected }
formula-too-long = { $count } characters, expected at most { $most }
formula-nested = nested deeper than { $most } levels
formula-operations = more than { $most } operations
formula-empty = nothing is written yet, expected a formula
formula-no-value = the last line gives the value and has no “name =”
formula-line-without-name = only the last line gives the value; the lines before it begin with “name =”
formula-name-taken = “{ $name }” cannot be the name of a line, it belongs to the language of formulas
formula-result-vector = the value is a vector, expected a number
formula-vector-for-number = a vector where a number is expected: “{ $part }”{ $meant }
formula-number-for-vector = a number where a vector is expected: “{ $part }”
formula-mixed = a number and a vector do not add: “{ $part }”
formula-two-vectors = two vectors are multiplied by “·” (dot product) or cross(a, b): “{ $part }”
formula-no-truth = a comparison such as a < b is expected: “{ $part }”

lesson-too-long = a lesson may have at most { $most } MiB
lesson-no-head = a lesson begins with its head in TOML, between two lines +++
lesson-version = `lesson` is not a version that this program knows: expected { $version }
lesson-name = `name` must be lower-case letters, digits and hyphens, at most 64
lesson-no-steps = there is no step: a step begins with a heading, ## Title
lesson-many-steps = there are more than { $most } steps
lesson-no-scene = the first step needs a `scene`
lesson-block-outside = this block is before the first step
lesson-block-twice = this step has a second block `{ $name }`
lesson-number = a number in the text: { $words }
lesson-number-open = a number in the text has no closing braces
lesson-number-digits = the digits of a number must be 0 to 9
lesson-key = `{ $key }`: { $words }
lesson-missing = `{ $key }` is missing
lesson-positive = expected a number above 0
lesson-range = expected two numbers, the smaller one first, far enough apart to be drawn
lesson-far = `probe` and `line` are in units of the picture's shorter side, from its middle: expected −8 to 8
lesson-step-too-heavy = a step with its question may take { $most } million evaluations of the equation, and this one takes more
lesson-file-too-heavy = a lesson may take { $most } million evaluations of the equation, and this one takes more
lesson-many-triangles = a scene of a lesson may have { $most } triangles, and this one has { $triangles }
lesson-long-settings = the settings of a step may be { $most } characters long
lesson-lights = `lights`: expected at most { $most }
lesson-panes = `panes`: expected at most { $most }
lesson-no-slider = “{ $name }” is not a key of one number that has a slider, as { $near } is
lesson-unknown-block = a block “{ $name }” is not known, expected “step” or “question”; TOML to be shown as it stands is a block “toml”
lesson-no-control = `controls`: there is no “{ $name }”
lesson-options = a choice has { $least } to { $most } options
lesson-items = { $least } to { $most } items can be put in order
lesson-option-both = an option has either `holds` or `right`, not both
lesson-option-neither = options are right by `holds` or `right`, or by `greatest` or `least` of the question
lesson-curve-of = a curve needs either `answer` or `profile`
lesson-goal = settings need one of `equals`, `most = true` and `least = true`
lesson-no-folder = a built-in lesson shows built-in scenes only
lesson-no-line = needs a `line` in the step
lesson-no-probe = needs a `probe` in the step
lesson-probe-outside = the probe lies outside the picture
lesson-probe-misses = the probe does not meet the object
lesson-no-number = `{ $path }` is not a number
lesson-no-list = `{ $path }` is no list
lesson-no-part = there is no `{ $path }`
lesson-no-value = the scene has no `{ $name }`
lesson-no-object = the picture shows no object
lesson-right-options = { $count ->
    [0] no option is right
   *[other] { $count } options are right
 }, expected one
lesson-too-near = two values are within 2 % of each other
lesson-value-outside = the answer is { $value }: it and its tolerance must lie between `from` and `to`
lesson-curve-outside = the curve reaches { $value }, outside `y`
lesson-curve-flat = a flat line would count as right
lesson-no-zero = the sign of `of` does not change in the picture
lesson-point-anywhere = more than half of the object counts as right
lesson-point-alike = another place is as good as the right one
lesson-no-corner = the line crosses no edge between polygons
lesson-settings-many = { $count ->
    [0] no setting reaches it
   *[other] { $count } settings reach it
 }, expected one
lesson-settings-unreachable = no setting comes near enough
lesson-settings-alike = several settings are as good as one another
lesson-not-right = the right answer does not count as right
lesson-match-same = the target looks like the picture at the start
lesson-question = the question: { $words }
lesson-file = a lesson

lesson-wrong = wrong model { $number }: { $words }
lesson-wrong-keys = expected at least one key that changes the answer: { $words }
lesson-wrong-choice = in a choice each wrong [[option]] has its own `says`
lesson-many-wrong = a question has at most { $most } wrong models
lesson-wrong-value-outside = its answer is { $value }, which cannot be entered: expected `from` to `to`
lesson-wrong-near = its answer is { $apart } tolerances away from the right one, expected at least { $least }
lesson-wrong-same = its answer is that of wrong model { $other }
lesson-wrong-unfit = its answer cannot be graded
lesson-right-says = the right option has `says`, which is for wrong ones
lesson-apart = wrong model { $number } is { $apart } tolerances away from the right answer
lesson-no-wrong = the question has no wrong model
lesson-at = in units of the picture's shorter side, from its middle: expected −8 to 8

lesson-hint-high = Too high.
lesson-hint-low = Too low.
lesson-hint-control-high = { $name } is too high.
lesson-hint-control-low = { $name } is too low.
lesson-hint-curve = { $fault } { $span }.
lesson-hint-high-there = Too high
lesson-hint-low-there = Too low
lesson-hint-not-zero = Not zero, as it should be,
lesson-hint-not-level = Not level, as it should be,
lesson-hint-steep = Too steep
lesson-hint-shallow = Not steep enough
lesson-hint-bent = The slope changes in the wrong places
lesson-hint-everywhere = everywhere
lesson-hint-up-to = up to { $to }
lesson-hint-beyond = beyond { $from }
lesson-hint-between = between { $from } and { $to }
lesson-hint-left = Too far to the left.
lesson-hint-right = Too far to the right.
lesson-hint-up = Too high in the picture.
lesson-hint-down = Too low in the picture.
lesson-hint-out = Too far from the middle of the picture.
lesson-hint-in = Too near the middle of the picture.
lesson-hint-share = { $side } The quantity there is { $share } of its maximum.
lesson-hint-beside = That is not on the object.
lesson-hint-early = “{ $item }” is { $places ->
    [one] one place
   *[other] { $places } places
 } too early.
lesson-hint-late = “{ $item }” is { $places ->
    [one] one place
   *[other] { $places } places
 } too late.
lesson-formula-names = `names`: expected names, and where a range is needed a table with one name, as in {"{"} n = [1, 100] {"}"}
lesson-formula-name = `names`: expected a name that no other is equal to, with its range where that is not obvious: {"{"} { $name } = [0, 1] {"}"}
lesson-formula-many-names = `names`: expected 1 to { $most } names
lesson-formula-unused = `names`: “{ $name }” appears neither in the answer nor in a wrong model
lesson-formula-undefined = the answer has no value in more than half of the ranges of its names
lesson-formula-constant = the answer has the same value everywhere
lesson-formula-no-term = `term`: this term has no formula over these names
lesson-formula-other-term = `term`: in this scene the engine computes something else than “{ $text }”
lesson-formula-vector-expected = The value is a number, expected a vector.
lesson-formula-number-expected = The value is a vector, expected a number.
lesson-formula-no-value = no value
lesson-hint-formula = With { $values } yours gives { $given }; expected is { $expected }.
