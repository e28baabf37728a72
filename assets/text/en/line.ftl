# The profile
line-drag-ends = Drag the ends of the line in the picture.
line-mode-own = The picture's own shading mode is always shown.
line-mode-added = Adds or removes the curve of this shading mode.
line-perceived-switch = Perceived
    .tip = Plots the perceived brightness of the picture's mode beside its intensity.
line-edges-switch = Edges
    .tip = Marks where the line crosses polygon edges.
line-picture-perceived = Picture as perceived
    .tip = Shows the picture with the bands that the eye adds.
line-curves = Curves
line-viewing = Viewing
line-save = Save
line-working = Computing the profile…
line-plot-intensity = Intensity
line-plot-slope = Slope
line-plot-added = Perceived − actual
line-value = { $name }: { $value }
line-pixels = { $value } pixels
line-model-inhibition = Lateral inhibition
line-model-normalisation = Normalisation
line-distance = Distance
    .tip = Distance from the eye to the screen, in millimetres.
line-density = Pixel density
    .tip = Pixels per millimetre of the screen. 96 pixels per inch are 3.78.
line-centre = Centre σc
    .tip = Width of the receptive field's centre, in degrees of visual angle.
line-surround = Surround σs
    .tip = Width of the receptive field's surround, in degrees of visual angle.
line-strength = Strength w
    .tip = Strength of the inhibition.
line-error-surround = The surround σs is { $width } pixels wide; a whole picture allows at most { $most }. Reduce the distance, the pixel density or σs.
line-error-outside = outside the picture, expected 0,0 to { $width },{ $height }
line-error-no-length = both ends of the line are at the same place, expected two places
line-error-no-mode = no shading mode, expected at least one
line-phong-bands = Phong shading weakens Mach bands but does not remove them: the slope still jumps, only by less.

# Its plots
line-perceived = perceived brightness
line-intensity-title = Intensity and perceived brightness
line-slope-title = Slope of the intensity
line-slope-note = Mach bands appear where the slope jumps.
line-jumps-title = Jumps of the intensity
line-jumps-note = Within each facet the intensity is constant and its slope is 0. At each edge it jumps.
line-added-title = Perceived minus actual
line-added-note = { $model }, σc = { $centre } and σs = { $surround } pixels, w = { $weight }.
line-added-outline = At the outline the curves leave the plot.
line-lateral-inhibition = Lateral inhibition
line-response-normalisation = Response normalisation
line-axis-x = x (pixels)
line-axis-distance = Distance along the line (pixels)
line-axis-intensity = Linear intensity
line-axis-slope = Slope (linear intensity per pixel)
line-axis-jump = Jump (linear intensity)
line-axis-added = Perceived − actual (linear intensity)
line-edges-crowded = { $count ->
    [one] { $count } polygon edge
   *[other] { $count } polygon edges, too close to draw
}

# The scan line
line-scan-error-no-face = no face { $face } in the object, expected 0 to { $last }
line-scan-error-empty = the object has no polygons
line-scan-error-rows = { $rows } rows, expected { $low } to { $high }
line-scan-error-behind = face { $face } reaches behind the viewer and is clipped before it is drawn, expected one that lies wholly in front
line-scan-error-edge-on = face { $face } is seen edge-on and covers no pixel centre, expected one that is turned towards the viewer
line-scan-error-background = pixel { $x },{ $y } does not show the object, expected one that does
line-scan-error-step = --step { $step }: no such step, expected 0 to { $last } or last
line-scan-error-line = --line { $y }: not a scan line of the polygon, expected { $first } to { $last } or last
line-scan-refused = This polygon cannot be scanned: { $why }.
line-scan-background = The probe is beside the object. Click or tap the object, or drag the ring onto it.
line-scan-figure-title = Scan conversion: { $mode } shading, face { $face }
line-scan-alternative = Scan conversion: { $caption }
line-scan-report-title = face { $face }, { $corners } corners, { $mode } shading: { $what }
line-scan-report-line = scan line { $y }, pixel centres at y = { $at }
line-scan-constant = one intensity for the whole polygon
line-scan-intensities = the intensities at the corners are interpolated
line-scan-normals = the normals at the corners are interpolated
line-scan-drawing = Face { $face }, { $corners } corners, enlarged; { $caption }
line-scan-at = Scan line { $y }: { $what }
line-scan-crosses = Scan line { $y }: active edges { $edges }
line-scan-line = Scan line { $y }
line-scan-active-edges = crosses the edges { $edges }
line-scan-place = scan line { $y }, x = { $x }
line-scan-stored = stored { $r }, { $g }, { $b }
line-scan-difference = difference { $values }
line-scan-on-edge = { $letter } on edge { $edge }
line-scan-pixel = Pixel ({ $x }, { $y })
line-scan-p = P is where the scan line enters the polygon. α says how far down its edge P lies: 0 at { $from }, 1 at { $to }.
line-scan-q = Q is where the scan line leaves the polygon. α says how far down its edge Q lies: 0 at { $from }, 1 at { $to }.
line-scan-pixel-alpha = α says how far from P to Q the pixel's centre lies: 0 at P, 1 at Q.
line-scan-not-interpolated = I is the intensity of the whole polygon. Nothing is interpolated.
line-scan-renormalised = |N| = { $length }; N is renormalised
line-scan-not-renormalised = |N| = { $length }; N is not renormalised
line-scan-affine = Barycentric, affine
line-scan-perspective = Barycentric, perspective-correct
line-scan-formula = in the scan line
line-scan-row-pixel = pixel
line-scan-row-barycentric = barycentric
line-scan-row-difference = difference
line-scan-edge-table = Edge table
line-scan-edge-table-active = Edge table, ● active
line-scan-y-from = y from
line-scan-y-to = y to
line-scan-x-from = x at top
line-scan-edge = edge
line-scan-active = active
line-scan-edge-row = { $edge }  y { $top } to { $bottom }, dx/dy { $slope }
line-scan-speed = Speed
    .name = Scan speed
    .tip = Steps per second while it plays.
line-scan-rows = Rows
    .name = Scan rows
    .tip = Rows of enlarged pixels.
line-scan-first = First step
    .tip = To the first step (Home)
line-scan-last = Last step
    .tip = To the last step (End)
line-scan-play = Play
    .tip = Plays step by step, or pauses (Space)
line-scan-pause = Pause
line-scan-step-of = step { $step } of { $last }
line-scan-step = Scan step
line-scan-level-pixel = pixel
line-scan-level-edge = edge
line-scan-level-line = line
line-scan-pixel-back = Pixel back
line-scan-pixel-forward = Pixel forward
line-scan-edge-back = Edge back
line-scan-edge-forward = Edge forward
line-scan-line-back = Line back
line-scan-line-forward = Line forward
line-colour = colour { $r }, { $g }, { $b }
