# The lights and the object in the controls.

lights-none = There is no light except the ambient light.
lights-add = Add light
lights-duplicate = Duplicate
lights-number = Light { $number }
lights-named = Light { $number }, { $name }
lights-off = { $name }: off, because it is muted or another light is on solo
lights-remove = Remove light { $number }
lights-removed = Light { $number } is removed
lights-mute = Mute
    .name = Mute light { $number }
    .tip = Switches this light off.
lights-solo = Solo
    .name = Solo light { $number }
    .tip = Switches off all lights that are not on solo.
lights-sampling = N = { $samples }: error { $rms } RMS, at most { $greatest }
    .tip = Compares the N sample points with 4096 of them, in a small picture without shadows, in percent of white: the root mean square and the maximum difference of a channel.
lights-sampling-none = No sampling error: this light does not reach the picture.
lights-viewer-far = Attenuation uses the distance to the eye, although V is constant.

lights-model-none = No model yet
lights-model-open = Open model…
lights-mesh = { $faces } polygons, { $vertices } vertices
    .tip = Drawn as { $triangles } triangles. A vertex is a point with one normal.
lights-triangles = Triangles
    .tip = Sets segments and rings together, so that polygons are about as wide as they are high. The slider ends at one million; you can type up to four million.
lights-polygons = { $vertices ->
        [one] 1 vertex
       *[other] { $vertices } vertices
    }, { $faces ->
        [one] 1 face
       *[other] { $faces } faces
    }
lights-polygons-drag = Drag a vertex in the picture; hold Shift to move it towards or away from you. Edit faces in the scene file.
lights-polygons-many = Edit vertices and faces in the scene file.
lights-vertex = Vertex
    .tip = The number of the vertex whose position is shown below, as in the scene file.
lights-vertex-position = Position
    .name = Vertex position
    .tip = Where the vertex is, in world units. A vertex stops where its polygons would cross themselves.
