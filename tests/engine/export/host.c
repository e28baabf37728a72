/* Draws a mesh by a pair of shaders with OpenGL 3.3 core, off screen.
 *     host VERTEX FRAGMENT MESH WIDTH HEIGHT RED GREEN BLUE OUT.ppm
 * MESH: four 32-bit counts, of vertices, of triangles, of concave polygons, and of runs of triangles of one material; six floats a
 * vertex, position and normal; three indices a triangle; of each concave polygon the number of triangles of its fan, which follow
 * those, and of the first of them that turn as it does; of each run the material and the number of triangles. */
#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static void fail(const char *what) {
    fprintf(stderr, "host: %s\n", what);
    exit(EXIT_FAILURE);
}

static char *read_whole(const char *path) {
    FILE *file = fopen(path, "rb");
    char *content;
    long size;

    if (!file || fseek(file, 0, SEEK_END) != 0 || (size = ftell(file)) < 0) fail(path);
    rewind(file);
    content = calloc((size_t)size + 1, 1);
    if (!content || fread(content, 1, (size_t)size, file) != (size_t)size) fail(path);
    fclose(file);
    return content;
}

static GLuint compile(GLenum kind, const char *path) {
    GLuint shader = glCreateShader(kind);
    const char *text = read_whole(path);
    char log[4096];
    GLint sound;

    glShaderSource(shader, 1, &text, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &sound);
    glGetShaderInfoLog(shader, sizeof log, NULL, log);
    if (log[0]) fprintf(stderr, "%s: %s\n", path, log);
    if (!sound) fail("a shader does not compile");
    return shader;
}

static void open_context(EGLint width, EGLint height) {
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                             EGL_RED_SIZE, 8, EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8, EGL_DEPTH_SIZE, 24, EGL_STENCIL_SIZE, 8, EGL_NONE};
    const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
    const EGLint core[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    EGLConfig config;
    EGLSurface surface;
    EGLContext context;
    EGLint found = 0;

    if (!eglInitialize(display, NULL, NULL) || !eglBindAPI(EGL_OPENGL_API)) fail("no OpenGL");
    if (!eglChooseConfig(display, wanted, &config, 1, &found) || found < 1) fail("no such picture");
    surface = eglCreatePbufferSurface(display, config, size);
    context = eglCreateContext(display, config, EGL_NO_CONTEXT, core);
    if (!eglMakeCurrent(display, surface, surface, context)) fail("no context");
}

static GLuint use_program(const char *vertex, const char *fragment) {
    GLuint program = glCreateProgram();
    GLint sound;

    glAttachShader(program, compile(GL_VERTEX_SHADER, vertex));
    glAttachShader(program, compile(GL_FRAGMENT_SHADER, fragment));
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &sound);
    if (!sound) fail("the shaders do not fit together");
    glUseProgram(program);
    return program;
}

/* Draws the triangles, then each concave polygon where an odd number of its fan's triangles lie. */
static void draw_mesh(const char *path, GLuint program) {
    const uint32_t *mesh = (const uint32_t *)read_whole(path);
    const size_t vertices = mesh[0], triangles = mesh[1], fans = mesh[2], count = mesh[3], stride = 6 * sizeof(float);
    const uint32_t *indices = mesh + 4 + 6 * vertices, *counts = indices + 3 * triangles;
    const char *offset = (const char *)0 + 12 * triangles;
    const uint32_t *runs;
    size_t all = triangles, from = 0;
    GLuint array, buffers[2];

    for (size_t i = 0; i < fans; i++) all += counts[2 * i];
    runs = counts + 2 * fans + 3 * (all - triangles);

    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(2, buffers);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(stride * vertices), mesh + 4, GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(12 * all), NULL, GL_STATIC_DRAW);
    glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, 0, (GLsizeiptr)(12 * triangles), indices);
    glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, (GLintptr)(12 * triangles), (GLsizeiptr)(12 * (all - triangles)), counts + 2 * fans);
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, (GLsizei)stride, NULL);
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, (GLsizei)stride, (const char *)0 + 3 * sizeof(float));
    if (count == 0) glDrawElements(GL_TRIANGLES, (GLsizei)(3 * triangles), GL_UNSIGNED_INT, NULL);
    for (size_t i = 0; i < count; from += 12 * runs[2 * i++ + 1]) {
        glUniform1i(glGetUniformLocation(program, "material"), (GLint)runs[2 * i]);
        glDrawElements(GL_TRIANGLES, (GLsizei)(3 * runs[2 * i + 1]), GL_UNSIGNED_INT, (const char *)0 + from);
    }
    for (size_t i = 0; i < fans; offset += 12 * counts[2 * i++]) {
        glEnable(GL_STENCIL_TEST);
        glClear(GL_STENCIL_BUFFER_BIT);
        glStencilFunc(GL_ALWAYS, 0, 1);
        glStencilOp(GL_INVERT, GL_INVERT, GL_INVERT);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        glDepthMask(GL_FALSE);
        glDrawElements(GL_TRIANGLES, (GLsizei)(3 * counts[2 * i]), GL_UNSIGNED_INT, offset);
        glStencilFunc(GL_EQUAL, 1, 1);
        glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glDepthMask(GL_TRUE);
        glDrawElements(GL_TRIANGLES, (GLsizei)(3 * counts[2 * i + 1]), GL_UNSIGNED_INT, offset);
    }
}

static void write_picture(const char *path, int width, int height) {
    const size_t row = 3 * (size_t)width;
    unsigned char *pixels = malloc(row * (size_t)height);
    FILE *file = fopen(path, "wb");

    if (!pixels || !file) fail(path);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, pixels);
    fprintf(file, "P6\n%d %d\n255\n", width, height);
    for (int y = height; y-- > 0;) fwrite(pixels + row * (size_t)y, 1, row, file);
    if (fclose(file) != 0) fail(path);
}

int main(int argc, char **argv) {
    if (argc != 10) fail("VERTEX FRAGMENT MESH WIDTH HEIGHT RED GREEN BLUE OUT.ppm");
    int width = atoi(argv[4]), height = atoi(argv[5]);
    open_context(width, height);
    GLuint program = use_program(argv[1], argv[2]);
    glViewport(0, 0, width, height);
    glDisable(GL_DITHER);
    glEnable(GL_DEPTH_TEST);
    glProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
    glClearColor((float)atof(argv[6]), (float)atof(argv[7]), (float)atof(argv[8]), 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_mesh(argv[3], program);
    if (glGetError() != GL_NO_ERROR) fail("OpenGL reports an error");
    write_picture(argv[9], width, height);
    return EXIT_SUCCESS;
}
