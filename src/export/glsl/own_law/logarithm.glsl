// The natural logarithm, 0 where there is none.
float logarithm(float x) {
    return x > 0.0 ? log(x) : 0.0;
}
