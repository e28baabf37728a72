
# The construction of R and H, step by step.
point-step-cosine = The cosine of θ
point-step-projection = Project L onto N
point-step-across = From L to its projection
point-step-mirror = Mirror L at N
point-step-halfway = Half vector
point-check-unit = Check: |R| = { $r }, a unit vector like N and L.
point-check-short = Check: |R| = { $r }. N is not a unit vector, |N| = { $n }, so R is not one either.

# The view Point
point-pixel = Pixel { $x }, { $y }
point-pixel-of-pane = { $pixel } of “{ $pane }”
point-stored-tip = The stored colour: red, green and blue, 0 to 255
point-place-face = At the pixel’s centre: face { $face }, depth { $depth }
point-place-surface = At the pixel’s centre: true surface, depth { $depth }
point-background = The probe is on the background. Click or tap the object, or drag the ring onto it.
    .floor = The probe is on the floor, and the numbers here are those of the object. Click or tap the object, or drag the ring onto it.
point-vectors = Vectors
point-vectors-of = Vectors, light { $light }
point-no-light = The scene has no light. Add one to see L, R and H.
point-no-direction = N or L has no direction here.
point-drawing = The vectors seen from the side: { $list }
point-previous-step = Previous step
point-next-step = Next step
point-all-steps = All steps
point-construction-hint = Build R and H step by step
point-step = { $number } of { $count }: { $title }
point-behind = The light is behind the surface, so it is not reflected here.
point-position-short = point
point-curves = Curves
point-no-normal = N has no direction here.
point-light-behind = Light { $light } is behind the surface here, so nothing is reflected.

# The curves
point-curves-title = { $scene }, at pixel ({ $x }, { $y })
point-plot-attenuation = Attenuation by distance
point-plot-exponent = Specular lobe { $lobe }
point-plot-reflectance = Reflectance W(θ): { $substance }
point-plot-lobe = Reflected intensity by direction
point-plot-of-light = { $title }, light { $light }
point-now = { $name }, now
point-mark-nearest = nearest
point-mark-probe = probe
point-mark-farthest = farthest
point-legend-at-probe = at probe
point-legend-half-width = half-width
point-legend-greatest = maximum I
point-axis-from-viewer = { $symbol }, distance from the viewer (world units)
point-axis-from-light = { $symbol }, distance from the light (world units)
point-axis-theta = θ, angle of incidence (degrees)
point-axis-lobe = { $letter }, angle between { $a } and { $b } (degrees)
point-axis-from-normal = angle from N (degrees)
point-red = red
point-green = green
point-blue = blue
point-constant = constant
point-glass = glass
point-silver = silver
point-gold = gold
point-custom = own index
point-diffuse = diffuse
point-own-law = own law
point-own-law-undefined = An operation has no value here, such as a division by 0: it counts as 0.
point-both-terms = diffuse + specular
point-plot-own-law = Own formula by direction of the viewer
point-axis-factor = value of the formula
point-note-constant = W = 1: Ks is the same for every angle. Grey: other materials, luminance.
point-note-fresnel = Fresnel, { $index }. θ is measured between { $vector } and L. Grey: other materials, luminance.
point-note-lobe = In the plane of N and L, θ = { $theta }. Towards the viewer I = { $intensity }.
point-note-own-law = In the plane of N and L, without f·Ip, θ = { $theta }. Towards the viewer: { $value }.
point-note-negative = Negative values are not drawn.
point-note-out-of-plane = V points { $angle } out of this plane.
point-note-laws = { $law }. Grey: the other laws.
point-note-distribution = { $name }: { $formula }. Grey: { $lobe }.
# Between two sentences.
point-sentence-gap = { " " }
point-law = { $law }, d from the light
point-law-viewer = f = 1/(r + k), k = { $k }, r from the viewer
point-law-light = f = 1/(r + k), k = { $k }, r from the light
point-law-none = f = 1: this light is not attenuated
point-law-directional = f = 1: a directional light has no distance
point-error-no-lights = --light { $light }: the scene has no light
point-error-no-such-light = --light { $light }: no such light in the scene, expected 1 to { $last }
point-error-no-light = the scene has no light, expected one
point-error-background = pixel { $x },{ $y } does not show the object, expected one that does
point-error-behind = light { $light } is behind the surface at pixel { $x },{ $y }, expected one in front of it

# The terms and their numbers
point-channels = { $red } red, { $green } green, { $blue } blue
point-ambient = ambient
point-specular = specular
point-bounce = one bounce
point-bounce-note = Light from one bounce off other surfaces replaces the constant, which would be:
point-transparency = transparency
point-transmitted = transmitted
point-depth-cueing = depth cueing
point-seen = displayed
point-light = light { $number }
point-sum = sum
point-sum-reflected = I reflected
point-sum-before-cueing = I before depth cueing
point-sum-cued = I with depth cueing
point-clamped = clamped
point-scaled = scaled
point-stored = stored
point-hatched = A value is above 1: the pixel is hatched in black and white.
point-divided = Divided by { $divisor }, the maximum value of the picture:
point-refractions = { $refractions ->
    [one] 1 refraction
   *[other] { $refractions } refractions
}
point-refractions-and-totals = { $refractions ->
    [one] 1 refraction
   *[other] { $refractions } refractions
}, { $totals ->
    [one] 1 total reflection
   *[other] { $totals } total reflections
}
point-snell-in = Snell’s law: sin { $v } = { $eta } · sin { $t }, the angles of the line of sight and of T to the normal
point-snell-out = Snell’s law: { $eta } · sin { $v } = sin { $t }, the angles of the line of sight and of T to the normal
point-snell-total = The line of sight is { $v } from the normal and η = { $eta }: total reflection, no T
point-cue-at-points = Depth cueing is applied where the equation is evaluated. The mean s0 is { $s0 }.
point-cue-interpolated = s0 = { $s0 }, interpolated between the vertices. The depth of the pixel itself gives { $own }.
point-cue-at-pixel = s0 goes from { $front_scale } at depth { $front } to { $back_scale } at depth { $back }. Here s0 = { $s0 }.
point-cue-left = { $percent } % remains at depth { $depth }
point-what-position = position
point-what-n = normal
point-what-v = to the viewer
point-what-l = to the light
point-what-r = L mirrored at N
point-what-h = halfway between L and V
point-what-t = transmitted
point-over-centre = the polygon’s centre
point-over-first-vertex = the polygon’s first vertex
point-over-vertices = the polygon’s vertices
point-over-samples = { $count ->
    [one] one point of the light
   *[other] { $count } points of the light
}
point-and = { " and " }
point-evaluated = Evaluated at { $over }
point-evaluated-mean = Evaluated at { $over }. A bar over letters marks the mean.
point-light-adds-nothing = It adds nothing: { $why }.
point-term-adds-nothing = { $term } adds nothing: { $why }.
point-spot-part = , the spot’s factor
point-law-clamped = , clamped to 1 (d = { $d })
point-points-away = : { $vector } points away
point-by-viewer = by the distance to the viewer, { $d } world units
point-by-light = by the distance to the light, { $d } world units
point-here = Here { $values }.
point-here-mean = Here { $values }, the mean of all evaluations.
point-here-product = The product of the column is { $values } here.
point-here-product-mean = The mean product of the column is { $values } here.
point-angle = { $letter }, { $a } to { $b }
point-light-row = light
point-in-light = in light
point-part-in-shadow = { $percent } % in shadow
point-at-probe = at the probe
point-line-at-probe = { $name } at the probe: { $value }
point-share-tip = { $share } of the pixel’s luminance (Rec. 709)
point-letter-irefl = Irefl: the reflected light, the sum of the terms
point-letter-s = s: the spot’s factor in this direction, 0 to 1
point-letter-lit = lit: the part of the light that is not in shadow, 0 to 1
point-letter-law = law: the factor that the scene’s own law, a formula, gives for each channel
point-letter-facets = S: the microfacets that reflect the light to the viewer, π·D·G/(4·(N·V))
point-letter-idc = Idc: the colour that intensities fade into

# Why a light adds nothing: in a word or two, and in a clause. C is the name of a coefficient.
point-zero-muted = muted
    .why = it is muted
point-zero-not-soloed = not soloed
    .why = another light is soloed
point-zero-black = Ip is 0
    .why = its Ip is 0
point-zero-not-reflected = not reflected
    .why = { $c } is 0
    .channel = Ip and { $c } have no channel in common
point-zero-behind = behind the surface
    .why = the light is behind the surface, N·L ≤ 0
point-zero-outside-cone = outside the cone
    .why = the point is outside the light’s cone
point-zero-in-shadow = in shadow
    .why = something blocks the light
point-zero-not-to-viewer = away from the viewer
    .why = the highlight points away from the viewer
point-zero-too-faint = too faint
    .why = it is so faint that it rounds to 0
point-zero-law = the law gives 0
    .why = the scene’s own law gives 0 here
point-zero-one-term = one term
    .why = the scene’s own law is one term
point-zero-nothing = adds nothing
point-zero-both = { $diffuse }, and { $specular }
point-zero-in-part = in part { $clause }
# Between two clauses.
point-clause-gap = { "; " }

# The report in words
point-report-background = pixel ({ $x }, { $y }) shows the background
    .floor = pixel ({ $x }, { $y }) shows the floor
point-material = Material { $name }
point-report-material = Material { $name }: { $numbers }
point-report-face = pixel ({ $x }, { $y }), face { $face }, depth { $depth }
point-report-surface = pixel ({ $x }, { $y }), depth { $depth }
point-report-places = Evaluated at { $places }. The vectors are those at the pixel’s centre.
point-report-sampling = over the whole picture { $rms } (rms), { $greatest } (maximum) from { $samples } samples
point-report-stored = sum and stored value
point-report-fit = The constant Ia that fits the bounce in this picture best: { $r } { $g } { $b }
point-report-light = light { $number }{ $name }, { $kind }, { $law }
point-report-share = { $name }, { $share } of the pixel’s luminance
point-mean-of = mean of { $formula }
