
    {
        /* $title$. */
        const GLfloat place[] = {$place$}; /* $means$ */
        const GLfloat intensity[] = {$color$}; /* Ip */
$axis$

        glLightfv($light$, GL_POSITION, place);
        glLightfv($light$, GL_AMBIENT, black); /* all of Ia is in the light model */
        glLightfv($light$, GL_DIFFUSE, intensity); /* Ip of Ip*Kd*Od*(N.L) */
        glLightfv($light$, GL_SPECULAR, intensity); /* Ip of Ip*Ks*Os*(N.H)^n */
        glLightf($light$, GL_CONSTANT_ATTENUATION, $c1$); /* $falloff$ */
        glLightf($light$, GL_LINEAR_ATTENUATION, $c2$); /* c2 */
        glLightf($light$, GL_QUADRATIC_ATTENUATION, $c3$); /* c3 */
$spot$
        glEnable($light$);
    }
