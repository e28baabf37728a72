# The panel of controls, its rows and fields, and the commands of the window.

## Sections

controls-material = Material
controls-lights = Lights
controls-shading = Shading
controls-object = Object
controls-surroundings = Surroundings
controls-transparency = Transparency
controls-camera = Camera
controls-display = Display

## Rows

controls-all = All controls
controls-reset = Reset { $name }
controls-reset-tip = Reset to the scene's value (Ctrl+R in the field)
controls-on = on
controls-off = off
controls-no-name = no name
controls-per-channel = { $name } per channel
controls-infinite = { $name } infinite
controls-infinite-tip = Infinite: a perfect mirror
controls-red = red
controls-green = green
controls-blue = blue
controls-x = x
controls-y = y
controls-z = z
controls-width = width
controls-height = height
controls-swatch = { $name } colour
controls-swatch-tip = Choose a colour
controls-channel-slider = { $name } { $channel } slider
controls-chip-white = White
controls-chip-grey = Grey
controls-chip-black = Black
controls-chip-warm-white = Warm white
controls-chip-cool-white = Cool white
controls-chip-red = Red
controls-chip-yellow = Yellow
controls-chip-green = Green
controls-chip-blue = Blue
controls-chip-violet = Violet
controls-field-wrong = “{ $text }” is not a number. The old value is kept.
controls-field-accepts = Accepted: 0.5, 1e-3, 1/3, 2*pi, sqrt(2), 2^10, (1+2)*3, inf

## Material

controls-model-none = The scene's own
controls-materials = Materials
    .label = Preset
    .none = choose…
    .tip = The 24 materials of the OpenGL teapots (Kilgard 1994): Ka, Kd, Ks and n as published.
controls-stones = Stones
controls-metals = Metals
controls-plastics = Plastics
controls-rubbers = Rubbers
controls-matching = Equivalent highlight
    .label = Equivalent
    .tip = The exponent or roughness that gives another model a highlight of the same width at half height. A click changes model and value together.
controls-match-exponent = Equivalent exponent for { $model }
    .tip = Switch to the { $model } model with the n that gives a highlight of the same width
controls-match-roughness = Equivalent roughness
    .tip = Switch to the Cook–Torrance model with the Beckmann roughness m that gives a highlight of the same width
controls-law-hint = a formula; the last line is its value
controls-law-kept = The picture shows the last formula that could be read.
controls-law-beside = Beside Phong
    .tip = Show how the picture differs from that of Phong's model
controls-law-product = dot product of { $a } and { $b }: the cosine of the angle between them
controls-law-distance = distance to the light, in world units
controls-law-theta = θ, the angle between N and L, in degrees
controls-law-phi = φ, the angle between R and V, in degrees

## Shading, surroundings, camera and display

controls-exact-without-surface = This mesh has no exact surface: the exact mode evaluates Phong shading in double precision.
controls-halves = Left half: constant Ia. Right half: one bounce.
controls-fit = Best ambient light
    .label = best fit
    .tip = The constant Ia closest to the light that really arrives from other surfaces: least squares over the picture. Red, green, blue.
    .idle = Ka is 0 wherever light is scattered, so no constant makes a difference
controls-fit-take = Use the best ambient light
    .label = use
    .tip = Set Ia to this value
controls-depth-exact = The exact mode has no vertices: depth is taken at each pixel.
controls-reset-camera = Reset camera
    .tip = Return to the view of the opened scene (key 0)
controls-overflowing =
    { $count ->
        [0] No pixel is above 1
        [one] 1 pixel is above 1
       *[other] { $number } pixels are above 1
    }
controls-overflowing-or-undefined =
    { $count ->
        [0] No pixel is above 1 or without a value
        [one] 1 pixel is above 1 or has no value
       *[other] { $number } pixels are above 1 or have no value
    }
controls-most-lights = A scene has at most { $most } lights.

## Menus and the groups of the keyboard help

controls-group-file = File
controls-group-edit = Edit
controls-group-view = View
controls-group-compare = Compare
controls-group-scene = Scene
controls-group-probe = Probe
controls-group-camera = Camera
controls-group-scan = Scan line (while its view is open)
controls-group-help = Help
controls-theme = Theme

## Commands

controls-command-open = Open…
    .does = Open a scene, a model or an exported picture
controls-command-scenes = Scenes…
    .does = Open the gallery of scenes
controls-command-save = Save scene
    .does = Save the scene
controls-command-save-as = Save scene as…
    .does = Save the scene under another name
controls-command-export = Export picture…
    .does = Export the picture
controls-command-quit = Quit
    .does = Close the window
controls-command-undo = Undo
    .does = Undo the last change
controls-command-redo = Redo
    .does = Redo (also Ctrl + Y)
controls-command-copy = Copy picture
    .does = Copy the picture to the clipboard
controls-command-code = Code…
    .does = Show the scene as OpenGL calls and shaders
controls-command-find = Find a command…
    .does = Find a command, a setting, a scene or a lesson by its name
controls-command-manual = Manual
controls-command-reset-scene = Reset scene
controls-command-reset-all = Reset everything
controls-command-reset-layout = Reset view and layout
controls-command-next-scene =
    .gesture = PageUp, PageDown
    .does = Open the previous or the next built-in scene; in a lesson, its step
controls-command-reset-row =
    .does = Reset the value of the selected row
controls-command-next-field =
    .does = Go to the next field; with Shift to the previous one
controls-command-leave =
    .does = Leave a dialog, a field or full screen; a field keeps its old value
controls-command-controls = Scene panel
    .does = Show or hide the panel of controls
controls-command-views = Views
    .does = Show or hide the panel of views
controls-command-stages = Status bar
    .does = Show or hide the bar with the stages
controls-command-next-view = Next view
    .does = Show the next view
controls-command-vectors = Vectors
    .does = Show the vectors at the probe
controls-command-angles = Angles
controls-command-construction = Construction of R
controls-command-side-view = Side view
controls-command-side-view-where-needed = Side view where needed
controls-command-lobe = Reflection lobe
    .does = Show the reflection lobe at the probe
controls-command-half-vector = Always show H
controls-command-handles = Handles
    .does = Show the handles of lights and vertices
controls-command-normals = All normals
    .does = Show face and vertex normals; click a vertex to keep its faces highlighted
controls-command-face-normals = Face normals
controls-command-vertex-normals = Vertex normals
controls-command-channels = RGB values
controls-command-smooth-edges = Smooth edges
controls-command-picture-alone = Full screen
    .does = Show only the picture, full screen
controls-command-projector = Projector size
    .does = Switch projector size on or off
controls-command-larger = Larger
    .does = Make the interface larger
controls-command-smaller = Smaller
    .does = Make the interface smaller
controls-command-ordinary-size = Actual size
    .does = Reset the size of the interface
controls-command-next-comparison = Next comparison
    .does = Cycle through one picture, panes, wipe and difference
controls-command-next-pane = Next pane
    .does = Select the next pane; the controls show its settings
controls-command-all-modes = All shading modes
controls-command-panes = Panes and figures…
controls-command-defects = The five defects…
controls-command-flat = Flat
    .does = Flat shading
controls-command-interpolated = Interpolated
    .does = Interpolated shading
controls-command-gouraud = Gouraud
    .does = Gouraud shading
controls-command-phong = Phong
    .does = Phong shading
controls-command-exact = Exact
    .does = Exact shading
controls-command-unnormalised = Phong, not renormalised
    .does = Phong shading without renormalising the normals
controls-command-add-light = Add a light
controls-command-reset-camera = Reset camera
    .does = Reset the camera
controls-command-take-probe =
    .does = Control the probe with the arrow keys
controls-command-probe-pixel =
    .does = Move the probe by 1 pixel
controls-command-probe-stride =
    .does = Move the probe by 10 pixels
controls-command-probe-here =
    .gesture = Click or tap
    .does = Put the probe there
controls-command-orbit =
    .does = Turn the camera left, right, up or down
controls-command-pan =
    .does = Shift the camera left, right, up or down
controls-command-zoom =
    .does = Move the camera closer or farther away
controls-command-drag =
    .gesture = Drag
    .does = Turn the camera; move a light, its arrow or cone, a vertex or the probe
controls-command-deep-drag =
    .gesture = Shift, middle or two-finger drag
    .does = Shift the camera; move a light or a vertex in depth
controls-command-wheel =
    .gesture = Wheel or pinch
    .does = Move the camera closer or farther away; over a light, move it in depth
controls-command-scan-pixel =
    .does = Previous or next pixel
controls-command-scan-edge =
    .does = Previous or next edge
controls-command-scan-line =
    .does = Previous or next scan line
controls-command-scan-ends =
    .does = First or last step
controls-command-scan-play =
    .does = Play or pause
controls-command-keys = Keyboard and mouse
    .does = Show this table
controls-command-menus =
    .does = Go to the menus
controls-command-about = About
controls-group-course = Course
controls-command-lessons = Lessons
controls-command-teach = Teach a class…
controls-command-class = Class
controls-command-class-step =
    .does = In a class: the answers, the explanation, the next step; or a step back
    .gesture = PageUp PageDown
controls-command-course-step =
    .does = The step before or the next step of the lesson that is open
    .gesture = PageUp PageDown
controls-command-hand-in = Hand in answers…
controls-command-set-target = Set as target
