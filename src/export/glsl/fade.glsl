const vec3 Idc = $color$; // what intensities fade into

vec3 fade(vec3 I, float s0) {
    return s0 * I + (1.0 - s0) * Idc;
}

