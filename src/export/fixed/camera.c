/* The eye at ($eye$) looks at ($target$). Matrices are stored by columns. */
void set_up_camera(int width, int height) {
    const double z_near = $near$, z_far = $far$; /* depths that are drawn */
    const double scale = $scale$; /* $scale_means$ */
$span$    const double projection[16] = {
        scale * $across$ / width, 0.0, 0.0, 0.0,
        0.0, $upwards$, 0.0, 0.0,
        0.0, 0.0, $third$,
        0.0, 0.0, $fourth$
    };
    /* The rows are the directions to the right, up and backwards; the last column moves the eye to the origin. */
    const double eye_from_world[16] = {
$columns$
    };

    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixd(projection);
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixd(eye_from_world);
$fog$
}
