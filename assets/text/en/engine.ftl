# The views Plan, Study and Stability, and the benchmark.

# Plan
engine-plan-intro = What drawing this picture takes, step by step, and what is skipped because it would change nothing.
engine-plan-signs = ■ ran after the last change · □ kept from before
engine-plan-summary = { $total }, { $count } skipped
engine-plan-total = { $count ->
    [one] terms and steps evaluated once a frame
   *[other] terms and steps evaluated { $number } times a frame
}
engine-plan-measured = { $frames ->
    [one] { $about }, 1 frame drawn anew
   *[other] { $about }, median of { $frames } frames drawn anew
 }
engine-ran = ■ { $stage }, { $ms } ms
engine-note = { $name }: { $note }
engine-kept = □ { $stage }, kept
engine-not-needed = □ { $stage }, not needed
engine-left-out = Skipped: { $names } — { $reason }
engine-evaluations = evaluations
engine-each-frame = per frame
engine-each-light = per light
engine-each-face = per face
engine-each-vertex = per vertex
engine-each-pixel = per pixel
engine-stage-geometry = Geometry
    .tip = Divides the shape into polygons and finds the vertex normals
engine-stage-transform = Transform
    .tip = Moves the vertices to their places in the picture, clips and drops back faces
engine-stage-coverage = Coverage
    .tip = Finds the polygon that each pixel sees
engine-stage-rays = Rays
    .tip = Finds shadows, what is seen through the object and light from other surfaces
engine-stage-vertices = Vertices
    .tip = Evaluates the equation at vertices or faces
engine-stage-interpolation = Interpolation
    .tip = Carries normals or intensities from the vertices to the pixels
engine-stage-pixels = Pixels
    .tip = Evaluates the equation at pixels
engine-stage-display = Display
    .tip = Turns intensities into stored values
engine-saved = Work saved
engine-by-plan = plan
engine-all-left-in = all left in
engine-ratio = ratio
engine-plan-materials = Materials of the model
engine-plan-material = Material
engine-plan-material-scene = (the scene's)
engine-plan-material-count = evaluations
engine-row-evaluations = evaluations of terms and steps
engine-row-time = ms a frame
engine-runs-again = What runs again after a change
engine-change-light = light
engine-change-camera = camera
engine-change-tessellation = tessellation
engine-window = Window
engine-closed = closed
engine-off = off
engine-no-vectors = the vectors are off
engine-not-in-sight = not in sight
engine-controls = controls
engine-views = views
engine-stages = stages
engine-other-views = other views
engine-vectors = vectors
engine-angles = angles
engine-construction = construction of R
engine-side-view = side view
engine-lobe = reflection lobe
engine-handles = handles

# Times
engine-times = Times
engine-measure-times = Measure times
engine-times-about = Draws the picture again and again, { $frames } times for each number, and shows the medians. This takes { $time }; nothing else should run meanwhile.
engine-time-short = about a second
engine-time-seconds = about { $count } seconds
engine-time-minutes = { $count ->
    [one] about a minute
   *[other] about { $count } minutes
}
engine-bench-counts = { $about }, { $triangles } triangles, { $covered } pixels covered, { $evaluations } evaluations of the equation
engine-bench-measured = { $threads ->
    [one] 1 thread
   *[other] { $threads } threads
 }, SIMD level { $simd }, { $frames ->
    [one] 1 frame
   *[other] median of { $frames } frames
 }, ms
engine-no-simd-level = SIMD level { $level }: not on this machine, expected one of { $available }
engine-dragged = while dragged
engine-coarser = at 1/… of the size
engine-everything = everything
engine-changed = { $what } changed
engine-memory = Memory, bytes
engine-per-vertex = per vertex
engine-per-triangle = per triangle
engine-per-pixel = per pixel
engine-in-all = in all
engine-growth-pixels = Growth with the pixels
engine-growth-triangles = Growth with the triangles
engine-pixels = pixels
engine-triangles = triangles
engine-frames = frames
engine-median-ms = median, ms
engine-fastest-ms = fastest, ms
engine-fit-all = exponent, all
engine-fit-upper = exponent, upper half
engine-fit-fastest = exponent, fastest frames
engine-fit = { $slope } ± { $spread } (95 %, { $count } points)
engine-fit-too-few = too few

# Study
engine-study-intro = How far each way of shading is from the exact picture, and how long it takes.
engine-study-choices = What to measure
engine-study-about = Draws about { $frames } frames: each method at each number of segments. This takes { $time } or longer; times are best while nothing else runs.
engine-measure = Measure
engine-study-segments = Segments
    .tip = Polygons around the axis; the rings along it grow with them
engine-study-frames = Frames timed
    .tip = How often each setting is drawn; the time is the median
engine-study-affine = Affine too
    .tip = Also interpolates linearly in the picture, without regard to perspective
engine-study-n-hint = as in the scene; or 5, 50, 500
engine-study-reference = Beside
    .tip = Measures this law too, and errors from its exact picture
engine-study-nothing-chosen = Choose at least one method and one number of segments.
engine-study-no-number = n: “{ $word }” is not a number.
engine-study-bad-n = n: { $problem }.
engine-study-shown = The picture shows { $setting }. Undo leads back.
engine-study-not-shown = { $setting } is a historic method, measured apart from the engine; it cannot be shown in the picture.
engine-study-impossible = nothing to measure: the method “{ $method }” cannot draw this scene, { $reason }
engine-study-no-segments = nothing to measure: the shape cannot be divided into any of these numbers of segments
engine-study-title = { $about }, { $threads ->
    [one] 1 thread
   *[other] { $threads } threads
}
engine-study-plot = Error against run time
    .note = The lower and the further left, the better. Numbers are segments. Rings: historic methods in scalar code and one thread; compare their times only with each other.
engine-study-note = Errors are in code values (1/255 of the linear intensity), over the pixels inside the object (N·V ≥ 0.2). “RMS as shown” counts what the display clamps as 1. Times are medians in ms, with the spread of the middle half. *: nothing else is both faster and nearer to the exact picture.
engine-study-law-note = Errors are measured from the exact picture of { $reference }. “RMS of the law” is the difference from the same setting with { $reference }. Operations are those at a pixel: +, ×, ÷ and √, powers.
engine-study-remarks = Remarks
engine-study-omitted = Not measured: { $method }, because { $reason }.
engine-study-scalar = The scalar methods run in one thread: compare their times only with each other.
engine-study-point-error = RMS error { $rms }, maximum { $greatest } code values
engine-study-point-law = { $rms } code values RMS from the same with { $reference }
engine-study-point-time = { $time } ms ± { $spread }
engine-study-point-operations = At a pixel: { $additions } +, { $multiplications } ×, { $divisions } ÷ or √, { $powers } powers
engine-study-point-show = Click to show it in the picture
engine-study-point-historic = A historic method: cannot be shown
engine-axis-time = time of a frame, ms
engine-axis-error = RMS error, linear intensity
engine-front = best (Pareto front)
engine-front-law = best (Pareto front), with { $law }
engine-rms = RMS
engine-greatest = maximum
engine-outline = outline
engine-time-ms = ms
engine-spread = spread
engine-rms-shown = RMS as shown
engine-law-rms = RMS of the law
engine-order = Order of convergence
engine-order-note = The error goes as the spacing of the vertices to this power; ± 95 % confidence.
engine-order-greatest = maximum error
engine-order-rms = RMS error
engine-method-affine = { $method }, affine
engine-method-scanline = { $method }, scan line
engine-law = { $name }’s law
engine-law-own = own law
engine-law-method = { $law }: { $method }
engine-cannot-vertex-colours = the scalar code has one colour a material, and the model's vertices have their own
engine-study-own-materials = the model's faces have exponents of their own: with `material.source=scene` all have those given
engine-cannot-rays = the scalar code follows no rays
engine-cannot-depth-cueing = the scalar code has no depth cueing
engine-cannot-perspective = it needs a picture without perspective
engine-cannot-cosine = its highlight is no power of a single cosine
engine-cannot-pattern = a pattern has no Taylor expansion

# Stability
engine-stability-intro = Scenes at the limits of floating point. A naive renderer fails in almost all of them; this engine must not.
engine-stability-title = Maximum error, in code values of 255, against a reference of 106 bits
engine-stability-failed = { $count } of { $all } cases fail
engine-draw-cases = Draw the cases
engine-case = case
engine-condition = condition
engine-naive = Naive
engine-naive-short = naive
engine-this = This engine
engine-this-short = engine
engine-reference = Reference
engine-bits = 106 bits
engine-pixels-off = pixels off
engine-not-finite = not finite
engine-picture = { $case }: { $name }
engine-off-by = off by { $error }
engine-caption = { $name }: off by { $error }
engine-caption-lost = { $caption }, { $count } lost
engine-open-case = Open as scene
    .tip = Makes the case the scene of the window. Undo leads back.
engine-says-naive = Naive renderer: { $text }
engine-says-engine = This engine: { $text }
engine-errors = Maximum error: { $error } naive, { $engine } engine, in code values of 255.
engine-lost = { $count ->
    [one] 1 pixel is infinite or not a number; it is shown in magenta.
   *[other] { $count } pixels are infinite or not a number; they are shown in magenta.
}
engine-condition-number = Condition number { $number } { $of }.

engine-law-heading = The scene’s own law
engine-law-about = Evaluates the law at each pixel in f32, f64 and 106 bits, and names the operation that loses the digits.
engine-law-examine = Examine the law
engine-law-picture = The picture, dimmed: magenta where digits are lost, orange where an operation is undefined
engine-law-none = the scene has no law of its own, expected reflection.model = "formula"
engine-law-title = { $heading }: the scene’s own law in f32, f64 and 106 bits
engine-law-precision = { $name }: { $off } of { $pixels } pixels are off by more than half a code value; the maximum error is { $error }.
engine-law-sound = No operation loses visible digits, and none is undefined.
engine-law-losses = Operations that lose digits in f32
    .why = Rounding an operand of such an operation is visible in the picture; rounding its result is not. The condition number is the factor by which it multiplies the relative error of an operand. Pixels where digits are lost are magenta in the picture.
engine-law-undefined = Operations without a value
    .why = A division by zero, a root or logarithm of a negative number, and the like count as 0. These pixels are orange in the picture.
engine-law-operation = operation
engine-law-line = line
engine-law-pixels = pixels
engine-law-error = max. error
engine-law-worst = worst pixel
engine-law-first = first pixel
engine-condition-power = of the power in R·V
engine-condition-beckmann = of Beckmann’s D in N·H: 1/m²
engine-condition-attenuation = of f in d, relative to f; its slope has no bound
engine-condition-cone = of the angle in its cosine: 2/θ²
engine-condition-sliver = of the normal in the corners: length over width
engine-condition-difference = of a difference of coordinates in the coordinates
engine-condition-discriminant = of the discriminant: (distance/radius)²
engine-condition-depths = of the difference of depths in the depths
engine-condition-refraction = of cos θ₂ in θ₁: 1/(2δ)

engine-case-exponent-0 = n = 0
    .naive = Takes the power only where R·V is above 0, so that 0⁰ becomes 0. The highlight, which covers the whole lit side, ends at a line.
    .engine = Defines max(R·V, 0)⁰ as 1, also where the cosine is 0.
engine-case-exponent-1e4 = n = 10⁴, on the axis of the highlight
    .naive = Takes a power of R·V, which near 1 moves in steps of 6·10⁻⁸ in single precision; n magnifies the steps.
    .engine = Finds 1 − R·V = |R − V|²/2 from the difference of the vectors, which keeps all digits, and takes exp(n·ln(1 − t)).
engine-case-exponent-1e6 = n = 10⁶, on the axis of the highlight
    .naive = R·V takes only a handful of values over the whole highlight: it breaks into rings with hard edges.
    .engine = Uses the difference R − V, as before.
engine-case-exponent-1e9 = n = 10⁹, on the axis of the highlight
    .naive = All or nothing: R·V is either 1 or so far below that the power vanishes.
    .engine = Past n = 10⁷ even the rounding of unit vectors would show, so pixels are evaluated in double precision.
engine-case-exponent-1e12 = n = 10¹², on the axis of the highlight
    .naive = All or nothing; and in single precision the rays of neighbouring pixels hardly differ.
    .engine = Uses double precision, and the difference R − V there too.
engine-case-exponent-infinite = n = ∞, the viewer exactly in the mirrored ray
    .naive = 0.99999994^∞ is 0 and 1.0000001^∞ is infinite: a mirror shows nothing, or too much.
    .engine = Takes a difference R − V that is only rounding error as zero.
engine-case-microfacets = Microfacets with a slope of m = 0.001
    .naive = Finds the angle between N and H by acos: it comes in steps near 0, and is not a number where the cosine rounds above 1.
    .engine = Finds 1 − N·H from the difference of the vectors, and tan² from that.
engine-case-light-in-the-plane = N·L = 0: the light lies in the plane of the surface
    .naive = N·L is only rounding error, above 0 here and below 0 there; or the highlight is added without testing N·L.
    .engine = Ignores a light that is no higher above the tangent plane than the rounding error of its position.
engine-case-light-inside = N·L < 0: a light inside the solid
    .naive = Adds the highlight wherever R·V is above 0: it shines through the solid.
    .engine = Lights only what faces the light, for diffuse and specular reflection alike.
engine-case-opposed-normals = Opposed vertex normals: the normal between them is zero
    .naive = Divides by the length of a zero vector: a whole column of pixels is not a number.
    .engine = Does not normalise a normal shorter than its own rounding error: it has no direction and gets no light.
engine-case-huge-normals = Normals of length 10²⁵
    .naive = The square of the length overflows, and dividing by infinity gives zero: no light at all.
    .engine = Normalises given normals in double precision, where the square of no accepted length overflows.
engine-case-denormal-normals = Normals of length 10⁻³⁰
    .naive = The square of the length underflows to 0, and dividing by it gives infinity.
    .engine = Normalises in double precision too; normals still shorter are refused.
engine-case-light-on-the-surface = A light on the surface, at the centre of a pixel
    .naive = L is the zero vector divided by its length: not a number.
    .engine = Raises lengths to a minimum length before it divides; a zero vector stays zero, and so does N·L.
engine-case-attenuation-0 = f = 1/d² as d → 0
    .naive = f is infinite and N·L is zero; their product is not a number. One rounding error away the pixel is white.
    .engine = Raises d to a minimum length. What lies in the plane of the light is not lit, however near it is.
engine-case-light-at-1e30 = A point light at a distance of 10³⁰
    .naive = The square of the distance overflows: L is zero, and the object is dark.
    .engine = Treats a light farther than 10⁹ camera distances as parallel and finds its direction in double precision.
engine-case-narrow-cone = A spotlight with a cone of 0.1°
    .naive = Compares cosines, which are 1 − 1.5·10⁻⁶ at the edge: only 26 steps of single precision lie between the axis and the edge.
    .engine = Compares 1 − cos, half the square of the difference of the vectors.
engine-case-a-million-lights = As bright as a million lights
    .naive = Casts the intensity times 255 to a byte: of a value above 255 only the lowest 8 bits remain.
    .engine = Clamps the value before storing it.
engine-case-overflow = An intensity beyond the range of single precision
    .naive = Gets infinity, and infinity times 0 in a channel that the surface does not reflect: not a number.
    .engine = Multiplies the coefficients of light and surface in double precision and rounds into the range of single precision; a channel of 0 stays 0.
engine-case-eye-on-the-surface = The viewer on the surface
    .naive = The floor is a line in the picture, and its area of 0 divides the weights; corners behind the eye are projected in front of it.
    .engine = Clips at the near plane before anything is divided by a depth; what has no area in the picture covers no pixel.
engine-case-behind-the-eye = A polygon that reaches behind the eye
    .naive = Divides by a negative w: corners behind the eye appear upside down in front of it.
    .engine = Clips at the near plane, in double precision.
engine-case-w-0 = Vertices at w = 0, in the plane of the eye
    .naive = Divides by 0: the corners are at infinity, and the weights are not numbers.
    .engine = Clips at the near plane too.
engine-case-slivers = Slivers: triangles 10⁻⁸ wide
    .naive = In single precision they have hardly any area. Their normals point anywhere, and spread to valid polygons through the averages at the vertices.
    .engine = Gives a polygon whose area is only rounding error no normal and no weight in any average. Polygons without any area are refused.
engine-case-scale-1e-15 = Coordinates of 10⁻¹⁵
    .naive = The square of the cross product of two edges underflows: normals are not numbers.
    .engine = Finds normals in double precision, and measures lengths in distances from the eye to its target.
engine-case-scale-1e15 = Coordinates of 10¹⁵
    .naive = The same square overflows: normals are zero.
    .engine = Uses the same measure.
engine-case-far-from-the-origin = A mesh 10⁷ away from the origin
    .naive = Positions are rounded to whole units, and the matrix adds what should cancel.
    .engine = Takes differences from the eye and from the centre of the mesh in double precision; only these are rounded.
engine-case-telephoto = A sphere seen from 10⁵ radii away
    .naive = The discriminant b² − 4ac is the difference of two numbers near 10²⁰; single precision has seven digits of each.
    .engine = Meets the surface in double precision; from 10⁴ radii on, pixels are evaluated in double precision too.
engine-case-depth-fighting = Two surfaces, 10⁻⁵ of their distance apart
    .naive = Keeps z/w in single precision, with most of its range spent next to the near plane: from pixel to pixel, another surface is in front.
    .engine = Keeps 1/depth in camera distances, whose digits are spread over the depths of the object.
engine-case-span-of-length-0 = A scan line through a corner, and along an edge
    .naive = At a corner P and Q coincide, and the position between them is 0/0; along a level edge α is 0/0. These pixels are not numbers.
    .engine = Counts the upper end of an edge and not the lower one, the left end of a span and not the right one: a span of length 0 covers no pixel.
engine-case-critical-angle = Within 4·10⁻⁶ radians of the critical angle
    .naive = 1 − sin²θ₂ from a cosine has two or three digits left; past the angle its root is not a number.
    .engine = Finds sin² from the cross product in double precision; where the rest is below 0, nothing is transmitted.
