// v with the length 1; zero stays zero.
vec3 unit(vec3 v) {
    return v * inversesqrt(max(dot(v, v), 1e-36));
}
