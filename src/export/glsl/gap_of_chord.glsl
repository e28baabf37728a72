// 1 - N.H from the chord between N and H, which keeps its digits where N and H are close.
float gap_between(vec3 N, vec3 H) {
    vec3 chord = N - H;
    return min(0.5 * dot(chord, chord), 1.0);
}
