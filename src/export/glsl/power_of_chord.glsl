// log(1 - t); the series where 1 - t would lose the digits of t.
float log_one_minus(float t) {
    return t < 0.01 ? -t * (1.0 + t * (1.0 / 2.0 + t * (1.0 / 3.0 + t / 4.0))) : log(1.0 - t);
}

// (a.b)^n for large n: with the chord between the unit vectors, 1 - a.b = |a - b|^2/2 keeps its digits.
float power(vec3 a, vec3 b) {
    vec3 chord = a - b;
    float t = 0.5 * dot(chord, chord);
    return t < 0.29 ? exp(n * log_one_minus(t)) : 0.0;
}
