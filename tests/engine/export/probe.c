/* Whether this machine has what the exported programs need: headers, EGL without a window, and OpenGL both old and new. */
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <stddef.h>

int main(void) {
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_DEPTH_SIZE, 24, EGL_NONE};
    const EGLint core[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
    EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    EGLConfig config;
    EGLint found = 0;

    if (!eglInitialize(display, NULL, NULL) || !eglBindAPI(EGL_OPENGL_API)) return 1;
    if (!eglChooseConfig(display, wanted, &config, 1, &found) || found < 1) return 1;
    if (!eglCreateContext(display, config, EGL_NO_CONTEXT, NULL)) return 1;
    return eglCreateContext(display, config, EGL_NO_CONTEXT, core) ? 0 : 1;
}
