# What is wrong with a scene: the words follow the key in backquotes.
problem-value = is { $found }, expected { $expected }
problem-unknown-key = unknown key `{ $key }`, { $expected }
problem-unknown-word = is { $found }, { $expected }
problem-expected = expected { $known }
problem-expected-one-of = expected one of { $known }
problem-did-you-mean = { $expected } (did you mean { $meant }?)
problem-version = `version` is { $found }, expected { $version }: shading-lab { $program } reads version { $version }; a later version needs a later shading-lab
problem-more = { $count } more problems, expected none
problem-too-long = longer than { $limit } MiB, expected a scene
problem-toml = { $message }
problem-no-equals = no `=` after a key, expected KEY=VALUE, for example material.n=50
problem-single-value = is a single value, expected no `{ $part }` after it
problem-no-element = has no element { $index }, expected { $expected }
problem-depth-cueing = is not beyond `depth_cueing.front`, expected a greater depth
problem-eye-target = is the same point as `camera.target`, expected two different points
problem-up-parallel = is parallel to the viewing direction, expected a direction across it
problem-path-missing = is missing, expected the path of a model since `object.kind` is "obj"
problem-attenuation-zero = is 0 like `c2` and `c3`, expected one of c1, c2, c3 above 0
problem-shadow-pixels = has too many pixels for so many shadows, expected a smaller picture, fewer samples of area lights, or no shadows
problem-material-unnamed = is empty, expected the name of one of the model's materials
problem-material-twice = is the name of an earlier `[[object.material]]`, expected another
problem-no-faces = is empty, expected at least one polygon since there are `object.vertices`
problem-nothing-to-compare = has nothing to compare with, expected a [[compare.pane]]

# What was found.
found-date = a date
found-list = a list
found-list-of = a list of { $count }
found-table = a table of keys
found-not-a-value = not a value ({ $message })
found-empty = empty
found-samples = { $count } samples in all
found-corners = { $count } corners
found-vertex-twice = a polygon with the vertex { $vertex } twice
found-no-area = a polygon without an area
found-edges-meet = a polygon whose edges from vertex { $first } to { $first_end } and { $second } to { $second_end } meet

# What was expected.
expected-number = a number
expected-number-in-range = a number below 1.8e308 (or inf)
expected-whole = a whole number, 0 or more
expected-bool = true or false
expected-text = text in quotation marks
expected-path = a path in quotation marks
expected-one-of = one of { $words }
expected-three = a list of three numbers
expected-two = a list of two numbers
expected-two-whole = a list of two whole numbers
expected-list = a list
expected-settings = a list of settings in quotation marks, as in ["shading.mode=exact"]
expected-coefficient = a number or [red, green, blue]
expected-tables = a list of tables
expected-table = a table of keys
expected-index = a number from 0 after it
expected-no-index = none, since it is empty
expected-only-index = 0, its only one
expected-file-value = a value as in a scene file
expected-sides = sides of 1 to { $side } pixels
expected-pixels = at most { $pixels } pixels in total
expected-unicode-path = a path in Unicode, as a scene file can hold it
expected-model-path = the path of a model
expected-channels = { $range } in each channel
expected-degrees = { $range } degrees
expected-coordinates = coordinates up to { $greatest }
expected-direction = a direction, of length { $least } or more
expected-panes = at most { $count } beside the scene itself
expected-pane-key = a key that panes may differ in (they share camera, image and model)
expected-vertex-normals = { $count }, one for each vertex, or none
expected-corners = 3 to { $most } vertices
expected-no-polygon = no polygon, since `object.vertices` is empty
expected-vertex = the number of a vertex, 0 to { $last }
expected-vertex-once = each vertex once
expected-area = corners that span one
expected-no-crossing = one that neither crosses nor touches itself

# Models in Wavefront OBJ.
obj-unreadable = cannot be read: { $error }
obj-empty = the file is empty, expected an OBJ model with `v` and `f` lines
obj-no-face = there is no face with three different corners, expected at least one `f` line
obj-too-large = the model has more than { $most } corners, expected fewer
obj-line-too-long = the line is longer than { $longest } bytes, expected an OBJ model
obj-not-text = this is not text, expected an OBJ model in ASCII or UTF-8
obj-weight-zero = a vertex of weight 0 is at infinity, expected a weight that is not zero
obj-not-finite = the coordinate { $word } is not finite in single precision, expected a number between -3.4e38 and 3.4e38
obj-few-vertices = a face of { $count } vertices, expected at least 3
obj-malformed = `{ $word }` is not { $expected }
obj-few-numbers = { $count } numbers, expected { $expected }
obj-coordinate = a coordinate
obj-three-coordinates = three coordinates x y z
obj-weight = a weight
obj-normal-component = a component of a normal
obj-three-components = three components of a normal
obj-corner = a corner of a face, v, v/vt, v//vn or v/vt/vn with whole numbers
obj-no-such-vertex = the face names vertex { $number }, { $count ->
    [0] but there are no vertices yet
    [1] expected 1 or -1, as one comes before this line
   *[other] expected 1 to { $count } or -{ $count } to -1, as { $count } of them come before this line
 }
obj-no-such-normal = the face names normal { $number }, { $count ->
    [0] but there are no normals yet
    [1] expected 1 or -1, as one comes before this line
   *[other] expected 1 to { $count } or -{ $count } to -1, as { $count } of them come before this line
 }

# Material libraries (MTL) beside models.
obj-vertex-colours = the colour of a vertex is not read, expected three numbers from 0 to 1
mtl-name-too-long = the name of a material is longer than { $longest } characters; its faces have the scene's material
mtl-too-many = more than { $most } materials; the faces of the others have the scene's material
mtl-not-found = no library defines the material `{ $name }`; its faces have the scene's material
mtl-halo = `-halo` is not read
mtl-spectral = a colour given by `{ $word }` is not read, expected red, green and blue
mtl-number = a number from 0 to 1000000

# Pictures with a scene inside.
png-damaged = not a valid PNG picture ({ $error }), expected one that shading-lab exported
png-cut-off = the file ends early
png-malformed = its data is damaged
png-too-large = it asks for too much memory
png-no-scene = a picture without a scene, expected one that shading-lab exported
png-unreadable-text = a text in the picture cannot be read ({ $error }), expected at most { $limit } MiB
