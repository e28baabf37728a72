    const GLfloat black[] = {0.0f, 0.0f, 0.0f, 1.0f};

    use_material(0); /* another one before the polygons that have it */
    glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, black); /* it does not shine by itself */
