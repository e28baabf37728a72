// a/b, 0 where b is 0.
float quotient(float a, float b) {
    return abs(b) > 0.0 ? a / b : 0.0;
}
