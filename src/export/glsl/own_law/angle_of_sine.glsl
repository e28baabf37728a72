// The angle of a sine, degrees, 0 where there is none; rounding may take a sine a little beyond 1. The arc tangent has more
// digits than OpenGL's asin.
float angle_of_sine(float sine) {
    float s = clamp(sine, -1.0, 1.0);
    return abs(sine) > 1.000001 ? 0.0 : degrees(atan(s, sqrt((1.0 - s) * (1.0 + s))));
}
