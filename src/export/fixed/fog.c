
    const GLfloat fog_color[] = {$color$}; /* Idc */
    glEnable(GL_FOG); /* depth cueing: s0*I + (1 - s0)*Idc */
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogf(GL_FOG_START, $start$); /* the depth where s0 would be 1: s0 is $front_scale$ at $front$ */
    glFogf(GL_FOG_END, $end$); /* the depth where s0 would be 0: it is $back_scale$ at $back$ */
    glFogfv(GL_FOG_COLOR, fog_color);
    glHint(GL_FOG_HINT, GL_NICEST); /* at every pixel */
