// What light of the intensity E = f*Ip from the direction L adds to I.
vec3 reflected(vec3 N, vec3 L, vec3 V, $d$vec3 color, vec3 E) {
    vec3 part = E * vec3(law(0, N, L, V, $given$color), law(1, N, L, V, $given$color), law(2, N, L, V, $given$color));
    // What is not a number counts as 0.
    return mix(clamp(part, -1e34, 1e34), vec3(0.0), isnan(part));
}
