// I at the point P with the normal N, before the display.
vec3 illuminate(vec3 P, vec3 N) {
    vec3 V = $view$;
    vec3 color = $color$;
    vec3 I = Ka * color * Ia;
$lights$
    return I;
}

