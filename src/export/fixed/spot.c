        glLightfv($light$, GL_SPOT_DIRECTION, axis);
        glLightf($light$, GL_SPOT_CUTOFF, $cone$); /* degrees from D to the edge; nothing outside */
        glLightf($light$, GL_SPOT_EXPONENT, $exponent$); /* e of (-L.D)^e, which multiplies f */
