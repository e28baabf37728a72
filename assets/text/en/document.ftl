# Files that cannot be opened or written. The path comes before each of these, in the same line.
document-scene-file = a scene file
document-model = an OBJ model
document-picture = a picture
document-no-such-file = no such file, expected { $expected }
document-unreadable = cannot be read ({ $error }), expected { $expected }
document-not-utf-8 = not UTF-8, expected a text file
document-directory = a directory, expected a .toml, .obj or .png file
document-directory-not-file = a directory, expected { $expected }
document-not-regular = not a regular file, expected { $expected }
document-unknown-kind = an unknown kind of file, expected .toml, .obj or .png
document-elsewhere = a path in a file leads to files of this machine, not to another machine or a device
document-model-memory = a model of this size needs about { $megabytes } MB of memory, which is not available, expected a smaller one
document-did-you-mean = {" "}(did you mean { $name }?)
document-no-such-scene = no built-in scene of that name, expected a .toml, .obj or .png file or a name{ $meant }; see `shading-lab scenes`
document-target-directory = a directory, expected a file to write
document-target-protected = write-protected, expected a file to write
document-target-no-name = not a file name, expected a file to write
document-target-no-folder = its folder does not exist, expected a file in an existing folder
document-unwritable = cannot be written ({ $error })
document-nothing-to-draw = there is nothing to draw
document-figure-too-large = the figure is too large
# On stderr and in the window, beside a picture that is drawn.
document-no-materials = { $name }: drawn with the scene's material; its own materials are not drawn
