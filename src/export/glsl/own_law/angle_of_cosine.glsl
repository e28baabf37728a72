// The angle of a cosine, degrees, 0 where there is none; rounding may take a cosine a little beyond 1. The arc tangent has more
// digits than OpenGL's acos.
float angle_of_cosine(float cosine) {
    float c = clamp(cosine, -1.0, 1.0);
    return abs(cosine) > 1.000001 ? 0.0 : degrees(atan(sqrt((1.0 - c) * (1.0 + c)), c));
}
