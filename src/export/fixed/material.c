void set_up_material(void) {
$own$
    glShadeModel($model$); /* $model_means$ */
    glFrontFace(GL_CCW); /* $front$ */
$culling$
    glEnable(GL_DEPTH_TEST);
}
