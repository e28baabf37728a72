// 1 - N.H; N is not unit, so that its chord to H says nothing.
float gap_between(vec3 N, vec3 H) {
    return clamp(1.0 - dot(N, H), 0.0, 1.0);
}
