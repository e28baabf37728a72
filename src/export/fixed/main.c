enum { WIDTH = $width$, HEIGHT = $height$, TRIANGLES = $count$ };

static const GLclampf background[] = {$background$};

/* Where (0, 0, 0) of the positions lies in the world. */
static const double origin[] = {$origin$};

static const GLfloat positions[][3] = {
$positions$
};

/* N at each vertex, unit. */
static const GLfloat normals[][3] = {
$normals$
};

/* Each polygon is a fan about its first vertex$order$. Counter-clockwise from outside. */
static const GLuint triangles[][3] = {
$triangles$
};

$runs$
$concave$
static void fail(const char *what) {
    fprintf(stderr, "%s\n", what);
    exit(EXIT_FAILURE);
}

/* A context of OpenGL's compatibility profile and a picture of WIDTH x HEIGHT pixels, without any window. */
static void open_context(void) {
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                             EGL_RED_SIZE, 8, EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8, EGL_DEPTH_SIZE, 24, $stencil$EGL_NONE};
    const EGLint size[] = {EGL_WIDTH, WIDTH, EGL_HEIGHT, HEIGHT, EGL_NONE};
    EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    EGLConfig config;
    EGLSurface surface;
    EGLContext context;
    EGLint found = 0;

    if (!eglInitialize(display, NULL, NULL) || !eglBindAPI(EGL_OPENGL_API)) fail("no OpenGL without a window here");
    if (!eglChooseConfig(display, wanted, &config, 1, &found) || found < 1) fail("no picture of 8 bits a channel");
    surface = eglCreatePbufferSurface(display, config, size);
    context = eglCreateContext(display, config, EGL_NO_CONTEXT, NULL);
    if (!eglMakeCurrent(display, surface, surface, context)) fail("no OpenGL context");
}

/* OpenGL clamps the intensities at vertices to 0..1 before they are interpolated, unless it is told not to (3.0). */
static void keep_intensities_beyond_one(void) {
    PFNGLCLAMPCOLORPROC clamp_color = (PFNGLCLAMPCOLORPROC)eglGetProcAddress("glClampColor");

    if (clamp_color) clamp_color(GL_CLAMP_VERTEX_COLOR, GL_FALSE);
}

static void draw(void) {
$declared$
    glClearColor(background[0], background[1], background[2], 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glTranslated(origin[0], origin[1], origin[2]);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, positions);
    glNormalPointer(GL_FLOAT, 0, normals);
$draw$
$draw_concave$
}

/* OpenGL's rows begin at the bottom, a picture's at the top. */
static int write_picture(const char *path) {
    const size_t row = 3 * (size_t)WIDTH;
    unsigned char *pixels = malloc(row * HEIGHT);
    FILE *file = fopen(path, "wb");
    int written = pixels && file;
    int y;

    if (written) {
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, WIDTH, HEIGHT, GL_RGB, GL_UNSIGNED_BYTE, pixels);
        written = fprintf(file, "P6\n%d %d\n255\n", WIDTH, HEIGHT) > 0;
        for (y = HEIGHT; y-- > 0;) written = written && fwrite(pixels + row * (size_t)y, 1, row, file) == row;
    }
    free(pixels);
    return file && fclose(file) == 0 && written;
}

int main(int argc, char **argv) {
    if (argc != 2) fail("expected one argument: the PPM picture to write");
    open_context();
    keep_intensities_beyond_one();
    glDisable(GL_DITHER);
    set_up_camera(WIDTH, HEIGHT);
    set_up_lights();
    set_up_material();
    draw();
    if (glGetError() != GL_NO_ERROR) fail("OpenGL reports an error");
    if (!write_picture(argv[1])) fail("the picture cannot be written");
    return EXIT_SUCCESS;
}
