# The picture in the middle
picture-name = Picture, { $mode } shading
picture-drawing = drawing…
picture-menu-point = The colour of this pixel
picture-menu-scan = Scan conversion of this polygon
picture-menu-line = Intensity along a line through here
picture-menu-light = Add a light here
picture-menu-settings = Show its settings
picture-menu-enlarged = Enlarged
picture-half-constant = Constant ambient light
picture-half-bounce = One bounce

# Panes and their captions
picture-reference = reference
picture-brightest = brightest { $value }
picture-brightest-of = brightest { $value } of { $truth }
picture-rms-error = RMS error { $value }
picture-error-line = mean { $mean }   RMS { $rms }   maximum { $greatest }
picture-caption = Pane { $number }: { $name }
picture-caption-tip = Click to choose its shading mode, or what else to do with the pane. Drag to another pane to change the order.
picture-make-reference = Use as reference
picture-move-earlier = Move earlier
picture-move-later = Move later
picture-remove-pane = Remove

# The view Compare
picture-view-single = One
    .tip = Shows the scene alone
picture-view-panes = Panes
    .tip = Shows the panes side by side, with one camera and one probe
picture-view-wipe = Wipe
    .tip = Shows the first pane and the reference on either side of a line that you can drag
picture-view-difference = Difference
    .tip = Shows the first pane minus the reference
picture-all-modes = All shading modes
    .tip = Shows flat, interpolated, Gouraud, Phong and exact shading side by side. Exact is the reference.
picture-add-pane = Add pane
picture-panes-full = There are { $count } panes, the most there can be. Remove one first.
picture-compare-empty = Nothing is compared yet. Choose a view above, or add a pane that shows the scene in another way.
picture-own-changes = Change the active pane only
    .tip = Otherwise a change applies to all panes, except for what a pane sets itself
picture-reference-pane = Use pane { $number } as reference
picture-pane-menu = Menu of pane { $number }
picture-activate-tip = Shows this pane’s settings in the controls
picture-release-setting = Removes the pane’s own { $key }; it follows the first pane again
picture-add-shading = { $name } shading
picture-add-interpolation = { $name } interpolation
picture-add-finer = Four times as many polygons each way
picture-add-same = The same
    .tip = A copy, to change afterwards
picture-add-setting = Any other setting:
picture-add = Add
picture-against = Compared with { $name }
picture-greatest = { $name } differs most at pixel { $x }, { $y }
    .tip = Moves the probe there

# The report of a comparison
picture-no-panes = nothing to compare with, expected --pane KEY=VALUE or a scene with panes
picture-compared = { $scene }, compared with { $reference }
picture-linear = Linear intensity at the pixels’ centres: 1 is white, 1/255 = 0.0039 is one code value.
picture-column-pane = pane
picture-column-brightest = brightest
picture-column-mean = mean
picture-column-greatest = maximum
picture-column-at = at
picture-column-region = which is
picture-region-inside = inside
picture-region-outline = at the outline

# The normals of vertices
picture-vertex-normal = Where a vertex normal comes from
picture-no-vertex-seen = no vertex is seen in the picture, expected --vertex or a camera that sees the object
picture-no-vertices = --vertex { $number }: no such vertex, expected none: the object has no vertices
picture-no-vertex = --vertex { $number }: no such vertex, expected 0 to { $last }
picture-weighted-equally = weighted equally
picture-weighted-by-area = weighted by area
picture-weighted-by-angle = weighted by angle
picture-normal-averaged = the mean of { $count ->
    [one] 1 face
   *[other] { $count } faces
}, { $weights }
picture-normal-mirrored = the mean of { $count ->
    [one] 1 face and its mirror image in x
   *[other] { $count } faces and their mirror images in x
}, { $weights }
picture-normal-of-file = the file’s own
picture-normal-of-surface = the true surface’s
picture-normal-of-face = the face’s own
picture-normal-of-first = the first face’s: the normals of all { $count } cancel
picture-normal-nowhere = no face at this vertex has an area
picture-vertex = { $scene }: vertex { $number } of { $count }, at { $at }
picture-normal-sum = Σ share·N = { $sum }, of length { $length }
picture-column-face = face
picture-column-share = share
picture-column-angle = angle, °
picture-column-area = area
picture-column-weight = weight
picture-column-off = from N, °
picture-column-normal = normal
picture-needles-vertices = { $shown } of { $all } vertex normals
picture-needles-faces = { $shown } of { $all } face normals
picture-needles-both = { $vertices }, { $faces }
picture-lit-faces = { $count } faces
picture-lit-faces-each = { $count } faces, { $share } each
picture-lit-faces-range = { $count } faces, { $least } to { $greatest }
picture-lit-mean = mean
picture-lit-n-file = N of the file
picture-lit-n-surface = N of the surface

# The five defects of interpolated shading
picture-defects-about = Five things that interpolation gets wrong, measured in the active picture.
picture-defects-stop = Stops measuring until the scene changes
picture-defects-stopped = Stopped. It is measured again when the scene changes.
picture-defects-of = { $scene }; linear intensity, 1 is white
picture-not-here = Not measured: { $why }.
picture-mark = Show in the picture
    .tip = Marks where the defect is largest; for the dependence on orientation, a ring that turns the picture
picture-try = Try this: { $what }
picture-example = Open an example
picture-example-of = Example: { $name }
picture-silhouette = Polygonal silhouette
    .says = However smooth the shading, the outline is still made of straight edges.
    .try = increase the segments. The distance falls with their square.
picture-silhouette-distance = pixels from the true outline, at { $at }
picture-perspective = Perspective distortion
    .says = Values are interpolated in the picture, where halfway between two vertices is not halfway in space.
    .try = turn the floor away, or divide it into smaller polygons.
picture-perspective-greatest = maximum difference between { $rule } and perspective-correct interpolation
picture-perspective-greatest-at = maximum difference between { $rule } and perspective-correct interpolation, at { $at }
picture-perspective-mean = mean difference
picture-scan-line = scan-line
picture-affine = affine
picture-orientation = Dependence on orientation
    .says = With interpolation along scan lines, a point changes its shade when its polygon turns. Barycentric weights in a triangle do not.
    .try = drag the knob on the ring around the picture and watch the value at the probe.
picture-orientation-scanline = change at the probe, along the scan line
picture-orientation-barycentric = with barycentric weights
picture-shared = Vertices that are not shared
    .says = Where one side of an edge has a vertex and the other has none, the two sides interpolate differently.
    .try = drag the light along the edge, or drag the middle vertex off it.
picture-shared-edges = { $edges ->
    [one] 1 edge
   *[other] { $edges } edges
}
picture-shared-edges-measured = { $edges } edges, { $measured } of them measured
picture-shared-jump = maximum jump of the intensity, at { $at }; { $edges }
picture-normals = Unrepresentative vertex normals
    .says = Averaged over folds, all vertex normals may be equal: the surface looks flat.
    .try = set the rings to 2 or more. The folds come back.
picture-normals-angle = largest angle between a polygon’s normal and its vertices’ normals
picture-normals-contrast = contrast; the true contrast is { $truth }
picture-missing-stopped = stopped
picture-missing-flat = flat shading interpolates nothing
picture-missing-exact = exact shading interpolates nothing
picture-missing-parallel = a parallel projection distorts nothing
picture-missing-background = the probe does not see the object
picture-missing-own-normals = this shading mode uses the polygons’ own normals
picture-missing-exact-normals = exact shading uses the true surface’s normals
picture-missing-object = the object is not in the picture
picture-missing-surface = the object has no surface beyond its polygons
picture-missing-outline = no outline of the object is in the picture
picture-missing-borders = the object has too many open edges to search for unshared vertices
picture-missing-unshared = both sides of each edge share its vertices
picture-missing-edge = no such edge is visible
picture-mark-in-picture = in the picture
picture-mark-in-space = in space
picture-mark-jump = jump { $size }
picture-plot-orientation = One point while the picture turns
picture-curve-scanline = along the scan line
picture-curve-barycentric = barycentric
picture-curve-now = now
picture-axis-roll = roll
picture-plot-shared = Both sides of the edge
picture-curve-with = side with the vertex
picture-curve-without = side without the vertex
picture-curve-vertex = vertex
picture-axis-edge = along the edge

# When flat shading is exact
picture-conditions = When is flat shading exact?
    .about = Flat shading evaluates the equation once per polygon. This is exact if three conditions hold and nothing else varies across a polygon:
picture-conditions-of = { $scene }; when flat shading is exact
picture-condition-light = The light is at infinity, so N·L is constant
    .figures = Across a polygon, L turns by up to { $degrees }° and N·L changes by up to { $change }.
    .meet = Move the lights to infinity
    .break = Bring the lights back
picture-condition-viewer = The viewer is at infinity, so N·V is constant
    .figures = Across a polygon, V turns by up to { $degrees }° and N·V changes by up to { $change }.
    .meet = Move the viewer to infinity
    .break = Bring the viewer back
picture-condition-surface = The polygons are the surface itself
    .figures = A polygon’s normal differs from the surface’s normal by up to { $degrees }°.
    .meet = Draw a cube
    .break = Draw a curved object
picture-condition-polygons = The vertex normals are the polygons’ own
    .figures = A polygon’s normal differs from the normals at its vertices by up to { $degrees }°.
    .meet = Use each polygon’s own normal
    .break = Use averaged normals
picture-further = Nothing else in the equation can vary across a polygon
picture-further-none = Besides L, V and N, everything in the equation is constant.
picture-further-pattern = The pattern can change Od within a polygon.
picture-further-viewer-distance = f changes with the distance to the viewer.
picture-further-light-distance = f changes with the distance to a light.
picture-further-spot = The intensity of a spotlight changes with the angle from its axis.
picture-further-shadows = A shadow can cover part of a polygon.
picture-further-depth-cueing = The intensity fades with depth.
picture-further-vertex-normals = The equation is evaluated at vertices, whose normals are not the polygon’s.
picture-holds = Holds:
picture-fails = Fails:
picture-flat-and-exact = Flat minus exact shading
picture-flat-greatest = maximum difference
picture-flat-compared = Compared where both pictures show the same: { $inside } pixels. Skipped at outlines and edges, where they do not: { $outline }. With these included, the maximum difference is { $greatest }.

# What is wrong with panes, and why a setting has no effect
picture-idle-one-pane = There is only one pane
picture-description = A { $surface } { $colour } { $object } in { $mode } shading, { $light }; { $bright }.
picture-by-formula = formula-lit
picture-matt = matt
picture-glossy = glossy
picture-shiny = shiny
picture-red = red
picture-orange = orange
picture-yellow = yellow
picture-green = green
picture-cyan = cyan
picture-blue = blue
picture-magenta = magenta
picture-white = white
picture-grey = grey
picture-black = black
picture-lit = lit from { $from }
picture-unlit = with no light on
picture-and = { " and " }
picture-behind = behind
picture-front = the viewer’s side
picture-upper-left = the upper left
picture-top = the top
picture-upper-right = the upper right
picture-left = the left
picture-middle = the middle
picture-right = the right
picture-lower-left = the lower left
picture-bottom = the bottom
picture-lower-right = the lower right
picture-brightest-at = brightest at { $place }
picture-dark = all black
picture-probed = Probe at { $x }, { $y }: red { $red }, green { $green }, blue { $blue }
