/* To be called after set_up_camera(): places are taken as seen through the modelview matrix of the moment. */
void set_up_lights(void) {
$black$
    const GLfloat ambient[] = {$ambient$}; /* Ia */

    glEnable(GL_LIGHTING);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, $local$); /* $viewer$ */
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, $two_sided$); /* $sides$ */
$lights$
}
