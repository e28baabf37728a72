// pi*D = alpha^2/((alpha^2 - 1) cos^2 + 1)^2 of the angle whose 1 - cos is `gap`.
float spread(float gap) {
    float cosine = 1.0 - gap;
    float sin2 = gap * (1.0 + cosine);
    float quotient = m * m / (m * m * cosine * cosine + sin2);
    return quotient * quotient / (m * m);
}

// x + sqrt(alpha^2 + (1 - alpha^2) x^2), the divisor of Smith's G1(x) = 2x/(...).
float smith(float x) {
    return x + sqrt(m * m + (1.0 - m * m) * x * x);
}

// pi*D*G/(4*(N.V)), G = G1(N.L) G1(N.V).
float facets(vec3 N, vec3 L, vec3 V, float NL) {
    vec3 H = normalize(L + V);
    if (dot(N, H) <= 0.0) return 0.0;
    float l = max(NL, SMALLEST_COSINE);
    float v = max(dot(N, V), SMALLEST_COSINE);
    return 0.25 * spread(gap_between(N, H)) * 4.0 * l / (smith(l) * smith(v));
}
