// Hermite's cubic between two edges: 0 below the first, 1 above the second.
float rise(float low, float high, float x) {
    float t = clamp(quotient(x - low, high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}
