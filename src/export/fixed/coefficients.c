    const GLfloat ambient[] = {$ambient$}; /* $ambient_means$ */
    const GLfloat diffuse[] = {$diffuse$}; /* $diffuse_means$ */
    const GLfloat specular[] = {$specular$}; /* $specular_means$ */
    const GLfloat black[] = {0.0f, 0.0f, 0.0f, 1.0f};

    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, ambient);
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, diffuse);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, $n$); /* $n_means$ */
    glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, black); /* it does not shine by itself */
