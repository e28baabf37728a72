// pi*D = exp(-tan^2/m^2)/(m^2 cos^4) of the angle whose 1 - cos is `gap`.
float spread(float gap) {
    float cosine = 1.0 - gap;
    float sin2 = gap * (1.0 + cosine);
    float cos2 = max(cosine * cosine, 1e-8);
    return exp(-sin2 / cos2 / (m * m)) / (m * m) / (cos2 * cos2);
}

// pi*D*G/(4*(N.V)), G = min(1, 2(N.H)(N.V)/(V.H), 2(N.H)(N.L)/(V.H)) of V-shaped cavities (Torrance and Sparrow).
float facets(vec3 N, vec3 L, vec3 V, float NL) {
    vec3 H = normalize(L + V);
    float NH = dot(N, H);
    if (NH <= 0.0) return 0.0;
    float inverse_view = 1.0 / max(dot(N, V), SMALLEST_COSINE);
    float cavity = 2.0 * NH / max(dot(V, H), SMALLEST_COSINE);
    float seen = min(min(inverse_view, cavity), cavity * NL * inverse_view);
    return 0.25 * spread(gap_between(N, H)) * seen;
}
