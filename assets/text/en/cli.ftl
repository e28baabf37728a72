# Headings and other words of the help.
cli-usage = Usage:
cli-example = Example:
cli-examples = Examples:
cli-arguments = Arguments:
cli-options = Options:
cli-heading-scene = Scene:
cli-heading-output = Output:
cli-heading-window = Window:
cli-heading-general = General options:
cli-group-draw = Draw:
cli-group-explain = Explain a picture:
cli-group-measure = Measure:
cli-group-teach = Teach:
cli-group-scenes = Scenes and files:
cli-group-program = This program:
cli-default = {" "}[default: { $value }]

# Manual pages.
cli-manual = Shading Lab
cli-manual-name = NAME
cli-manual-synopsis = SYNOPSIS
cli-manual-examples = EXAMPLES
cli-manual-description = DESCRIPTION
cli-manual-commands = COMMANDS
cli-manual-version = VERSION

# Messages before their text.
cli-error = error: { $message }
cli-note = note: { $message }

# Progress.
cli-working = working
cli-reading = reading
cli-drawing = drawing

# Lists of words: a, b or c.
cli-or = { $others } or { $last }
cli-expected = expected { $choices }

# What is wrong with arguments.
cli-wrong-value = invalid value '{ $value }' for '{ $argument }': { $reason }
cli-missing-value = '{ $argument }' needs a value
cli-unknown-argument = unknown argument '{ $argument }'{ $meant }; see --help
cli-missing-arguments = missing: { $arguments }; see --help
cli-conflict = '{ $argument }' cannot be used with '{ $other }'
cli-no-language = expected { $first } or { $second }
cli-no-command = no command “{ $name }”{ $meant }; see `shading-lab help`
cli-no-material = no material of that name{ $meant }; see `shading-lab materials`
cli-no-such-output = --output: { $name } does not write .{ $ending }, expected { $expected }
cli-no-window = built without a window, expected a command: see shading-lab --help
cli-set-without-scene = --set without a scene, expected `{ $name }` alone
cli-scene-before-command = a scene before the command, expected it after: shading-lab COMMAND SCENE
cli-expected-whole = expected a whole number from { $low } to { $high }
cli-expected-count = expected a whole number from 0
cli-expected-number = expected a number
cli-fresh-before-command = --fresh before a command: it is for the window alone
cli-url-before-command = --url before a command, expected it after: shading-lab link SCENE --url BASE
cli-expected-step = expected a whole number from 0, or last
cli-expected-size = expected WIDTHxHEIGHT in pixels, 1 to { $most } each, as in 768x512
cli-too-many-pixels = expected at most { $most } pixels in all
cli-expected-pixel = expected X,Y in whole pixels from the top left, as in 100,80
cli-expected-place = expected X,Y in pixels from the top left, as in 100.5,80.5
cli-expected-vertex = expected the number of a vertex, counted from 0
cli-expected-output = expected a name that ends in .json, .png, .svg or .csv
cli-expected-png = expected a name that ends in .png
cli-expected-film = expected a name that ends in .png or .gif
cli-expected-qr = expected a name that ends in .png or .svg
cli-expected-address = expected an address of this machine, as in 127.0.0.1 or ::
cli-expected-html = expected a name that ends in .html
cli-no-lesson = no lesson “{ $name }”{ $meant }; see `shading-lab lesson`
cli-scene-is-lesson = a lesson, expected a scene; see `shading-lab lesson { $name }`
cli-too-long-for-qr = the link has { $length } characters, too many for a QR code; expected a simpler scene
cli-outside-range = { $argument } { $value }: expected { $low } to { $high }
cli-outside-picture = { $what }: outside the picture, expected 0,0 to { $last }
cli-background = { $what }: this pixel does not show the object, expected one that does
cli-surround-too-small = --surround { $surround }: expected more than the centre's { $centre }
cli-surround-too-large = --surround { $surround }: { $pixels } pixels wide, expected at most { $most } for --picture
cli-line-without-profile = --from and --to without a profile, expected --overlay profile
cli-vertex-without-normals = --vertex without normals, expected --overlay vertex-normals
cli-probe-without-pixel = probe without a pixel, expected probe=X,Y
cli-two-pixels = two different pixels, expected one for all overlays
cli-pixel-alone = a pixel alone, expected what to draw there, as in vectors,angles,probe=100,80

# What cannot be done.
cli-no-threads = the threads cannot be started ({ $error })
cli-input-unreadable = cannot be read ({ $error })
cli-picture-on-terminal = a picture cannot be shown in a terminal, expected a file or a pipe
cli-output-unwritable = the output cannot be written ({ $error })
cli-too-large-for-overlays = the picture is too large for overlays

# What `check` says of a valid file.
cli-check-sound =
    { $name }: ok ({ $object }{ $polygons }, { $lights ->
        [one] 1 light
       *[other] { $lights } lights
    }, { $mode } shading, { $size })
cli-check-polygons =
    ,{" "}{ $count ->
        [one] 1 polygon
       *[other] { $count } polygons
    }

# Help: a command `cli-help-NAME`, its argument `cli-help-NAME-ARGUMENT`, an argument of several commands `cli-help-shared-ARGUMENT`.
cli-help-program = A laboratory for local illumination and polygon shading.
    .long = Without a command it opens the window. SCENE is a scene file (.toml), a model (.obj), a picture that this program exported (.png), the name of a built-in scene (`shading-lab scenes`), a lesson (.md), a link (in quotation marks), or `-`: a scene file, a picture or a link from the standard input. Where a file is written, `-` is the standard output. `shading-lab help COMMAND` says more about a command.
cli-help-shared-help = Print help
cli-help-shared-version = Print version
cli-help-shared-language = Language of the texts, instead of the system's
cli-help-shared-source = A .toml, .obj or .png file, the name of a built-in scene, a link, or - for standard input
cli-help-program-source = A .toml, .obj, .png or .md file, the name of a built-in scene, a link, or - for standard input
cli-help-shared-set = Override one key of the scene, as in material.n=1005 or light.0.position=[2,2,3]; keys count lights from 0, so light.0 is light 1
cli-help-shared-material = Use a named material (see `materials`); --set can then change it further
cli-help-shared-url = Address of the page that links begin with, as in https://example.org/shading-lab/; the window remembers it
cli-help-shared-fresh = Open the window as at the very first start, and store nothing: for classrooms
cli-help-shared-seed = Number that decides what the questions of lessons draw at random
cli-help-shared-json = Print one JSON object
cli-help-shared-csv = Write the table as CSV; - is standard output
cli-help-shared-output = Write the figure as .png or .svg, the table as .csv, or the JSON object; - is standard output, as PNG where there is a figure
cli-help-shared-size = Width and height of the picture in pixels, instead of the scene's; for curves, profile and scanline those of the figure
cli-help-shared-dark = Draw the figure with light lines on a dark background
cli-help-shared-pane = Add a pane beside the scene, instead of the scene's own panes: its settings, as in shading.mode=exact, separated by semicolons. The last pane is the reference unless compare.reference names another
cli-help-shared-frames = Frames per measurement
cli-help-shared-threads = Number of threads; one per core unless given
cli-help-render = Draw a scene into a PNG file, without a window
cli-help-render-output = The picture to write; it contains the scene, which can be opened again
cli-help-render-size = Width and height in pixels, instead of the scene's
cli-help-render-samples = Samples per pixel
cli-help-render-compare = How the scene's panes are shown: single (the scene alone), panes (side by side; the default with --pane), wipe (the first pane and the reference on either side of a line at compare.wipe) or difference (the first pane minus the reference, times compare.gain)
cli-help-render-no-captions = Leave out the names and numbers of panes, and the scale of a difference
cli-help-render-overlay = Drawings over the picture: vectors, angles, construction, lights, lobe, side-view, profile, defects, face-normals, vertex-normals; probe=X,Y sets the pixel that they explain, otherwise a lit one near the centre
cli-help-render-from = Start of the line of --overlay profile, in pixels; without a line it is horizontal, through the probe or the centre
cli-help-render-to = End of that line
cli-help-render-vertex = The vertex whose faces --overlay vertex-normals highlights, each with its weight
cli-help-animate = Draw a scene whose numbers change from frame to frame
    .long = Any number changes, and each number of a point, a direction, a coefficient or a colour. Frames are written as they are drawn. An animated PNG keeps every colour and holds the scene of its first frame; a GIF has at most 256 colours a frame, which can show bands that the picture does not have. A name such as frame-%03d.png writes one picture a frame, counted from 1.
cli-help-animate-set-from = A key and its value in the first frame, as in material.n=5; may be repeated
cli-help-animate-set-to = The same key and its value in the last frame
cli-help-animate-frames = Frames from the first to the last
cli-help-animate-logarithmic = Equal ratios from frame to frame instead of equal steps
cli-help-animate-back-and-forth = Return to the first frame the same way
cli-help-animate-seconds = How long the animation takes; otherwise 30 frames a second
cli-help-animate-fps = Frames per second
cli-help-animate-output = The animation to write, .png (APNG) or .gif, or a name such as frame-%03d.png for numbered pictures
cli-help-animate-size = Width and height in pixels, instead of the scene's
cli-help-animate-samples = Samples per pixel
cli-help-probe = Fill in the equation at one pixel
cli-help-probe-pixel = The pixel, (0,0) at the top left
cli-help-profile = Take the intensity along a line, its slope and what is perceived
    .long = Slopes are per pixel; all values are linear and before rounding. Without a file it prints a row for each sample, values separated by commas.
cli-help-profile-from = Start of the line, in pixels from the top left; a pixel's centre is at +0.5
cli-help-profile-to = End of the line
cli-help-profile-modes = Shading modes to compare, separated by commas
cli-help-profile-picture = Write the whole picture as it is perceived, in the scene's own shading
cli-help-profile-viewing-distance = Distance from the eye to the screen, millimetres
cli-help-profile-density = Pixels of the screen per millimetre; 96 per inch are 3.78
cli-help-profile-response = Model of the response: lateral-inhibition or response-normalisation
cli-help-profile-centre = Width σ of the centre of the receptive field, degrees of visual angle
cli-help-profile-surround = Width σ of the surround, greater than the centre's
cli-help-profile-weight = Strength w of the inhibition
cli-help-profile-saturation = Response at which normalisation halves a channel's gain
cli-help-compare = Measure the panes of a scene against the reference among them
    .long = Differences are those of linear intensities before encoding and rounding; where the display clamps, values above 1 count as 1. `study` also has the errors without clamping.
cli-help-normals = Show which faces a vertex normal comes from, with their weights
cli-help-normals-vertex = The vertex, counted from 0
cli-help-normals-pixel = Take the visible vertex nearest to this pixel; without either, the one nearest to the centre of the picture
cli-help-defects = Measure the five defects of interpolated shading
cli-help-defects-pixel = The pixel whose point is followed while the picture turns; otherwise a lit one near the centre
cli-help-conditions = Check when flat shading is exact: the three conditions
cli-help-explain = Print a frame's plan: what is evaluated, what is skipped and why
    .long = Times are medians of whole frames, drawn alternately by the plan and with nothing skipped that could be kept; shares are of the sum of the stages. For each change that `bench` makes it names the stages that run again.
cli-help-scanline = Convert one polygon to pixels, step by step
    .long = Active edges, P and Q with their α, and the value of each pixel. Without a file it prints the scan line of the step with its formulas filled in.
cli-help-scanline-pixel = The polygon at this pixel, otherwise a lit one near the centre
cli-help-scanline-face = The polygon by its index in the mesh
cli-help-scanline-rows = Rows of enlarged pixels, 8 to 64
cli-help-scanline-step = The step to show, counted from 0, or `last`; otherwise the pixel asked for, or one in the middle
cli-help-scanline-line = The scan line to show, finished: a row of the grid, or `last`
cli-help-study = Measure error against run time
    .long = Every shading method at several tessellations against the exact picture. Errors are those of linear intensities before the display, values above 1 included; “shown” errors are of values clamped to 1 where the display clamps, as in `compare`.
cli-help-study-methods = Shading methods, separated by commas, all unless given: flat, flat-vertex-mean, interpolated, gouraud, phong, phong-unnormalised; in scalar code phong-scalar, taylor (Bishop and Weimer 1986), angular (Kuijk and Blake 1989)
cli-help-study-segments = Numbers of segments around the axis, separated by commas; those along it change in proportion
cli-help-study-n = Exponents of the highlight, separated by commas; the scene's own unless given
cli-help-study-interpolation = Interpolation between vertices, separated by commas: perspective, affine, scanline
cli-help-study-repeats = Frames timed for each setting
cli-help-study-reference = Law from whose exact picture errors are measured, beside the scene's: phong, blinn, cook-torrance, formula; Phong's for a scene with a formula, otherwise the scene's own
cli-help-study-threads = Number of threads; one per core unless given. With 1, times of the engine and of scalar code differ by the code alone
cli-help-stability = Draw stiff and extreme cases, or examine a scene's own law
    .long = Where a naive renderer fails, by how much, and that the engine does not. The reference computes with 106 bits. The exit status is 1 if the engine is off by more than half a code value anywhere. With a scene whose law is a formula, that law is evaluated in f32, f64 and 106 bits instead: which operations lose digits or are undefined, at how many pixels, and in the picture where.
cli-help-stability-source = A scene with reflection.model = "formula", whose law is examined instead of the cases
cli-help-stability-cases = Only these cases by name, separated by commas; all unless given
cli-help-code = Write a scene as OpenGL calls or as GLSL shaders, to copy; what they cannot express is printed on stderr
cli-help-code-target = What to write: c-snippet (camera, lights and material in C), c (a whole program in C that draws the scene off screen with fixed-function OpenGL) or glsl (a vertex and a fragment shader, GLSL 3.30)
cli-help-code-output = The file to write instead of stdout; shaders go to two files of that name, ending in .vert and .frag
cli-help-link = Print a scene as a link
    .long = The link names a built-in scene and the keys that differ; a scene with polygons of its own goes into the link as a whole, compressed. A model does not travel. docs/links.md has the keys.
cli-help-link-output = Write the link as a QR code, .png or .svg
cli-help-curves = Plot the curves of local illumination at one pixel
    .long = f(d), the family of powers of a cosine, W(θ), and the specular lobe. Without a file it prints what the plots say in words and numbers.
cli-help-curves-kind = Which plot: attenuation, exponent, reflectance or lobe; otherwise all that the scene has, f and W only where they vary
cli-help-curves-pixel = The pixel whose values are marked, otherwise a lit one near the centre whose vectors are well apart
cli-help-curves-light = The light whose attenuation and lobe are plotted, counted from 1; otherwise the first that the point faces
cli-help-scenes = List the built-in scenes
cli-help-materials = List the named materials of the OpenGL tradition, for --material
cli-help-parameters = List every key of the scene file with its default, limits and meaning
cli-help-check = Read a scene, a model, a picture or a lesson, and report what is wrong with it
cli-help-check-file = A .toml, .obj, .png or .md file, the name of a built-in scene, or - for standard input
cli-help-check-set = Override one key of the scene first
cli-help-lesson = List the lessons, print one in words, or write its worksheet
    .long = The worksheet is one page that prints well: text, pictures drawn by the engine, questions with room to write, and the answers on pages of their own.
cli-help-lesson-lesson = The name of a lesson, a file that ends in .md, or - for standard input
cli-help-lesson-output = Write the worksheet, .html
cli-help-lesson-without-answers = Leave out the answers
cli-help-lesson-seed = Decides what questions draw at random
cli-help-class = Hold a live class: the phones in the room follow a lesson and answer its questions
    .long = It prints the address that phones open, and opens the window. Answers are written to a file, a line each; the same command with the same file goes on with the same class. Without a window it prints what happens, and does what is typed: show, again, explain, next, back, end.
cli-help-class-lesson = The name of a lesson, or a file that ends in .md
cli-help-class-headless = Open no window
cli-help-class-port = The port, instead of 8080 or the next that is free
cli-help-class-bind = The address of this machine that phones may reach; 127.0.0.1 for trying out
cli-help-class-url = What phones open in place of this machine's address, behind a proxy
cli-help-class-output = The record of the class, instead of class.jsonl, or rehearsal.jsonl when rehearsing
cli-help-class-page = The files of the web page, which phones open for playing, instead of the folder page beside the program
cli-help-class-own-pace = Let students move to other steps at their own pace
cli-help-class-rehearse = Simulate this many students, who make the mistakes that the lesson knows
cli-help-class-seed = Decides what questions draw at random
cli-help-collect = Grade the pictures that students handed in
    .long = A row a student, a column a question. The answers are graded by the engine. Files that cannot be read are named and do not stop the others.
cli-help-collect-files = Pictures from File > Hand in
cli-help-collect-lesson = Expect answers to this lesson, and take its text from this file instead of from the pictures
cli-help-collect-pre = Compare the answers to a test before a course, from these pictures, …
cli-help-collect-post = … with those after it: the gain of the class (Hake 1998), and how hard, how telling and how reliable the items are
cli-help-collect-output = Write a page with the table and the answers to each question, .html
cli-help-completions = Write the completions for a shell
    .long = They belong where the shell looks for them; bash, for one, in ~/.local/share/bash-completion/completions. In zsh a folder of $fpath takes them as _shading-lab, in fish ~/.config/fish/completions as shading-lab.fish; in PowerShell the profile runs them.
cli-help-completions-shell = bash, zsh, fish, powershell or elvish
cli-help-manual = Write the manual page of the program, or of a command
cli-help-manual-command = The command; otherwise the program
cli-help-manual-output = Write the pages of the program and of every command into this folder
cli-help-help = Print the help of the program, or of a command
cli-help-help-command = The command; otherwise the program
cli-help-bench = Measure the time of a frame and of its stages
    .long = A frame of `full` is transformed, covered, shaded and displayed anew; the tessellation is kept, as a graphics card keeps it in its buffers. A frame of `changes` differs from the one before in one thing: the position of the first light, n, ka, the eye on an orbit, or the number of segments.
cli-help-bench-growth = Also measure how the time grows with the pixels, up to 8 million, and with the triangles, up to 4 million
cli-help-bench-simd = The SIMD level: avx512, avx2, sse4.2 or sse2 on PCs; the machine's best unless given

cli-check-materials = Materials of the model: { $names }
cli-check-lesson = { $name }: a valid lesson, { $steps } steps, { $questions ->
    [one] 1 question
   *[other] { $questions } questions
 }
