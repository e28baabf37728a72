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
line-intensity = intensity
line-perceived = perceived brightness
line-mode-title = { $mode }: intensity and perceived brightness
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
