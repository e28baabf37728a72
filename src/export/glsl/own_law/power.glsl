// a^b, 0 where it has no value: for a negative a and a b that is not whole, and for a = 0 and a negative b.
float power(float a, float b) {
    if (b == 0.0) return 1.0;
    // Products, of which each digit counts.
    if (b == 2.0) return a * a;
    if (b == 3.0) return a * a * a;
    if (b == 4.0) return a * a * a * a;
    if (a == 0.0 || (a < 0.0 && b != floor(b))) return 0.0;
    float size = pow(abs(a), b);
    return a < 0.0 && mod(b, 2.0) == 1.0 ? -size : size;
}
