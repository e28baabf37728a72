
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
