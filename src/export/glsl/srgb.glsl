    vec3 v = clamp(I, 0.0, 1.0);
    vec3 high = 1.055 * pow(v, vec3(1.0 / 2.4)) - 0.055;
    return mix(high, 12.92 * v, lessThanEqual(v, vec3(0.0031308)));
