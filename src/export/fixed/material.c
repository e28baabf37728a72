void set_up_material(void) {
    const GLfloat ambient[] = {$ambient$}; /* Ka*Od */
    const GLfloat diffuse[] = {$diffuse$}; /* Kd*Od */
    const GLfloat specular[] = {$specular$}; /* Ks*Os$reflectance$ */
    const GLfloat black[] = {0.0f, 0.0f, 0.0f, 1.0f};

    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, ambient);
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, diffuse);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, $n$); /* $n_means$ */
    glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, black); /* it does not shine by itself */
    glShadeModel($model$); /* $model_means$ */
    glFrontFace(GL_CCW); /* $front$ */
$culling$
    glEnable(GL_DEPTH_TEST);
}
