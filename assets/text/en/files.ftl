open = Open
save = Save
cancel = Cancel
back = Back
dismiss = Dismiss
and = { $first } and { $second }
comma = ,{" "}
file-open = Open a scene, a model or an exported picture
file-open-kinds = Scenes, models, pictures
file-open-example = scene.toml, model.obj or picture.png
file-save = Save the scene
file-scene = Scene
file-export = Export the picture
export = Export
file-picture = Picture
file-analysis = Save the analysis
file-analysis-kind = Analysis
file-code = Save the code
file-code-kind = Code
file = File
browse = Browse…
browse-tip = Opens the desktop's own file dialog, if it has one
browse-none = This desktop has no file dialog for programs (expected the Debian packages xdg-desktop-portal and xdg-desktop-portal-gtk, or zenity). Type the path.
replace-lost = { $names } already exists. Its contents will be replaced.
replace-file = Replace the file?
replace = Replace
unsaved = Save the changes to { $name }?
unsaved-lost = Your changes will be lost if you close the window without saving.
close-unsaved = Close without saving
restore-kept = The last window did not close normally. Its unsaved changes to { $name } were kept.
    .page = Unsaved changes to { $name } were kept when the page was left.
restore-work = Restore unsaved work?
restore = Restore
delete = Delete
later = Later
about = An interactive laboratory for local illumination and polygon shading: the illumination equation, a software rasterizer, and what both do to a pixel.
export-scene = The picture contains its scene: open the picture to get the scene back.
size = Size
width = Width
height = Height
pixels = pixels
keep-shape = Keep proportions
preset-window = Window
preset-square = Square
samples = Samples per pixel
samples-tip = More samples make smoother edges and take longer
vectors = Vectors
vectors-shown = as shown in the window
keys = Keyboard and mouse
keys-search = Search keys
analysis-not-saved = The analysis could not be saved
opening = Opening { $path }
not-opened = The file could not be opened
not-restored = The unsaved work could not be restored
restoring = Restoring unsaved work
drawing-file = Drawing { $path }
not-exported = The picture could not be exported
exported = Exported { $path }
waiting-dialog = Waiting for the desktop's file dialog
did-not-work = The file dialog could not be opened
not-kept = Unsaved changes are not being kept: { $error }
work-stays = { $error } The work stays in { $path }
no-opengl = No OpenGL was found; expected the Debian packages libgl1 and libgl1-mesa-dri ({ $error })
no-window = The window could not be opened ({ $error })
no-display = No display was found; expected DISPLAY or WAYLAND_DISPLAY to name one. “shading-lab render” draws without a display.
no-library = The library { $library } is missing; expected the Debian package { $package }
theme-system = System
theme-dark = Dark
theme-light = Light
coarser = 1/{ $share } size while dragging
coarser-tip = The full picture would not keep up with the pointer; it is drawn when you let go
evaluations = { $count ->
    [one] { $shown } evaluation
   *[other] { $shown } evaluations
}
triangles = { $count } triangles
overflowing = { $count } pixels overflow
overflowing-tip = Pixels with a channel above 1, which the display cannot show; the setting Overflow says what happens to them
left-out = { $count ->
    [one] 1 step skipped
   *[other] { $count } steps skipped
}
left-out-tip = Steps of the computation that would change nothing in this picture. Press to see which, and why.
stage-ran = ran for { $ms } ms, { $evaluations } evaluations
stage-kept = not run: nothing it depends on has changed
code-calls = OpenGL calls
code-calls-tip = Camera, lights and material as calls of fixed-function OpenGL, in C
code-shaders = GLSL 330
code-shaders-tip = A vertex and a fragment shader that evaluate the equation where the shading mode does
code-program = Whole program in C
code-program-tip = The calls and the polygons in a program that draws them off screen
code = The scene as code
code-writing = Writing…
code-lines = { $count ->
    [one] 1 line
   *[other] { $count } lines
}
code-first-lines = the first { $shown } of { $all } lines; Copy and Save take all of them
code-files = Writes { $names }
code-complete = The code expresses the whole scene.
code-limits = The code does not express:
code-text = Code
copy = Copy
save-as = Save…
copied = Copied: { $what }
saved = Saved { $path }
not-saved = The scene could not be saved
copied-picture = Copied the picture
change-opening = opening
change-lights = lights
change-panes = panes
change-one = change
change-several = several settings
recent = Open recent
recent-clear = Clear this list

## The web page
page-full = The browser’s storage is full: save the scene to a file.
