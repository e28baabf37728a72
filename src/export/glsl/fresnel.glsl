// W at the angle of incidence whose cosine is c: Fresnel's formulas for unpolarised light.
vec3 reflectance(float c) {
    c = clamp(c, 0.0, 1.0);
    float c2 = c * c;
    float s2 = 1.0 - c2;
    vec3 inner = (eta - 1.0) * (eta + 1.0) - kappa * kappa + c2; // eta^2 - kappa^2 - s^2
    vec3 modulus = sqrt(inner * inner + 4.0 * eta * eta * kappa * kappa); // a^2 + b^2
    vec3 twice = 2.0 * c * sqrt(max(0.5 * (modulus + inner), 0.0)); // 2ac
    vec3 across = max(modulus + c2 - twice, 0.0) / max(modulus + c2 + twice, 1e-20);
    vec3 level = c2 * modulus + s2 * s2;
    vec3 ratio = max(level - twice * s2, 0.0) / max(level + twice * s2, 1e-20);
    return 0.5 * (across + across * ratio);
}
