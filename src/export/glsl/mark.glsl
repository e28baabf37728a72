    // The picture's rows are counted from its top.
    float stripe = floor((floor(gl_FragCoord.x) + $height$ - 1.0 - floor(gl_FragCoord.y)) / 3.0);
    if (any(greaterThan(I, vec3(1.0)))) return vec3(mod(stripe, 2.0));
