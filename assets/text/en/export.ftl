# Parts of an export, and what cannot be written.
export-c = C
export-vertex-shader = vertex shader
export-fragment-shader = fragment shader
export-too-large = { $triangles } triangles to write, expected at most { $most }: use a coarser mesh, or c-snippet

# What OpenGL or GLSL cannot express. English also heads the code as a comment, in plain ASCII.
export-limit-scale = Division by the picture's maximum intensity, which is known only after drawing: I is clamped.
export-limit-shadows = Shadows: every light reaches every point.
export-limit-transparency = Transparency (Kt): the surface is drawn opaque.
export-limit-vertex-colours = Colours of vertices: Od is the material's colour everywhere.
export-limit-ground = The ground: only the object is drawn.
export-limit-backdrop = The backdrop: only the background colour is behind the object.
export-limit-bounce = Light scattered by other surfaces: Ia is constant.
export-limit-lengths = Lengths of this size: OpenGL squares them in single precision. Rescale the scene.
export-limit-flat-own-normal = Flat shading with the polygon's own N: GL_FLAT takes the shade of one vertex, with that vertex's N. With object.normals = "facet" they agree.
export-limit-flat-centre = Flat shading at the polygon's centre: GL_FLAT takes the shade of one vertex, here the polygon's first.
export-limit-flat-mean = Flat shading by the mean of the vertices' shades: GL_FLAT takes the shade of one, here the polygon's first.
export-limit-affine = Affine interpolation: OpenGL's is perspective-correct.
export-limit-scanline = Interpolation along scan lines: polygons are drawn as triangles and interpolated as such.
export-limit-vertex-clamp = Intensities above 1 at vertices: OpenGL clamps them before interpolating, unless the program calls glClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE) (OpenGL 3.0, compatibility profile).
export-limit-phong = Phong shading: the equation is evaluated at vertices only and the intensity interpolated (Gouraud shading). A finer mesh comes closer.
export-limit-exact = Exact shading: the polygons are drawn, outline included, with the equation evaluated at vertices only.
export-limit-exact-pixels = Exact shading: each pixel of the polygons is shaded with its interpolated N (Phong shading); the outline is that of the polygons.
export-limit-pattern = The pattern on the surface: Od is the material's colour everywhere.
export-limit-two-side = backfacing = "flip" turns N towards each light wherever N.L < 0; GL_LIGHT_MODEL_TWO_SIDE turns it on polygons seen from behind, whatever the light. They agree where light and eye are on the same side.
export-limit-lights = Lights beyond the eighth: { $shining } shine, OpenGL has { $most }.
export-limit-hatching = The hatching where I > 1: I is clamped.
export-limit-srgb = The sRGB encoding: stored values are 255*I.
export-limit-phong-lobe = Phong's (R.V)^n: fixed-function lighting has Blinn's (N.H)^n (reflection.model = "blinn"); n = { $blinn } gives a highlight as wide as n = { $phong } does for Phong.
export-limit-microfacets = Cook and Torrance's microfacets: replaced by Blinn's (N.H)^n with n = { $n } from the roughness.
export-limit-own-law = The scene's own law: fixed-function lighting has no formulas. It draws Kd*Od*(N.L) + Ks*Os*(N.H)^n with the scene's coefficients and n = { $n } in its place.
export-limit-shininess = n = { $n }: GL_SHININESS goes up to 128.
export-limit-reflectance = W(theta), the reflectance by angle of incidence: its value at 0 degrees multiplies Ks.
export-limit-light-area = Light { $light }: an area of { $points } points, drawn as the one at its centre.
export-limit-light-soft = Light { $light }: the soft edge of its cone; GL_SPOT_CUTOFF is a hard edge.
export-limit-light-exponent = Light { $light }: its exponent { $exponent }; GL_SPOT_EXPONENT goes up to 128.
export-limit-light-viewer = Light { $light }: attenuation by the distance to the viewer; the distance to the camera's target is used everywhere.
export-limit-light-unclamped = Light { $light }: f = min(1, ...) of its attenuation; OpenGL's f exceeds 1 near the light.
export-limit-cueing-constant = Depth cueing by the same s0 everywhere: OpenGL's fog depends on the depth. It is skipped.
export-limit-cueing-beyond = Depth cueing: s0 continues to 1 and to 0 beyond its two depths.
export-limit-cueing-vertices = Depth cueing at vertices: OpenGL's fog is evaluated at every pixel.
export-limit-cueing-colour = Depth cueing: OpenGL clamps fog's colour to 1.
