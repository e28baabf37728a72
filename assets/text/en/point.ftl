
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
point-stored-tip = The stored colour: red, green and blue, 0 to 255
point-place-face = At the pixel’s centre: face { $face }, depth { $depth }
point-place-surface = At the pixel’s centre: true surface, depth { $depth }
point-background = The probe is on the background. Double-click the object, or drag the ring onto it.
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
point-legend-at-probe = f at the probe
point-legend-half-width = half-width
point-legend-greatest = greatest I
point-axis-from-viewer = { $symbol }, distance from the viewer (world units)
point-axis-from-light = { $symbol }, distance from the light (world units)
point-axis-theta = θ, angle of incidence (degrees)
point-axis-phi = φ, angle between { $a } and { $b } (degrees)
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
point-both-terms = diffuse + specular
point-note-constant = W = 1: Ks is the same for every angle. Grey: other materials, luminance.
point-note-fresnel = Fresnel, { $index }. θ is measured between { $vector } and L. Grey: other materials, luminance.
point-note-lobe = In the plane of N and L, θ = { $theta }. Towards the viewer I = { $intensity }.
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
point-error-no-such-light = --light { $light }: no such light in the scene, expected 0 to { $last }
point-error-no-light = the scene has no light, expected one
point-error-background = pixel { $x },{ $y } shows the background, expected one that shows the object
point-error-behind = light { $light } is behind the surface at pixel { $x },{ $y }, expected one in front of it
