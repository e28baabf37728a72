// max(c, 0)^n.
float power(float c) {
    if (c <= 0.0) return n == 0.0 ? 1.0 : 0.0;
    return pow(c, n);
}
