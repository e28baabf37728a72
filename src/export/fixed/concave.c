/* Concave polygons that leave the triangles of their fan: the polygon is where an odd number of them lie. The triangles that
 * turn as their polygon does come first. */
static const GLuint fans[][3] = {
$fans$
};

/* Of each such polygon: its triangles, and those that turn as it does. */
static const GLsizei concave[][$numbers$] = {
$counts$
};

/* Counts a fan's triangles in the stencil buffer, then draws them where their number is odd ("Drawing Filled, Concave Polygons
 * Using the Stencil Buffer", OpenGL Programming Guide). So the first vertex gives the shade to all of the polygon. */
static void draw_concave(void) {
    const GLboolean culls = glIsEnabled(GL_CULL_FACE);
    const GLuint *fan = fans[0];
    size_t i;

    glEnable(GL_STENCIL_TEST);
    for (i = 0; i < sizeof concave / sizeof *concave; fan += 3 * concave[i++][0]) {
        glClear(GL_STENCIL_BUFFER_BIT);
        glStencilFunc(GL_ALWAYS, 0, 1);
        glStencilOp(GL_INVERT, GL_INVERT, GL_INVERT);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        glDepthMask(GL_FALSE);
        glDisable(GL_CULL_FACE);
        glDrawElements(GL_TRIANGLES, 3 * concave[i][0], GL_UNSIGNED_INT, fan);
$use_material$
        glStencilFunc(GL_EQUAL, 1, 1);
        glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glDepthMask(GL_TRUE);
        if (culls) glEnable(GL_CULL_FACE);
        glDrawElements(GL_TRIANGLES, 3 * concave[i][1], GL_UNSIGNED_INT, fan);
    }
    glDisable(GL_STENCIL_TEST);
}
