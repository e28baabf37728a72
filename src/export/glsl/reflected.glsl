// What light of the intensity E = f*Ip from the direction L adds to I.
vec3 reflected(vec3 N, vec3 L, vec3 V, vec3 color, vec3 E) {
    float NL = dot(N, L);
$turn$
    if (NL <= 0.0) return vec3(0.0);
$incidence$
    return E * (Kd * color * NL$specular$);
}
