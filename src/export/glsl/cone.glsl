    const vec3 D = $axis$; // along the cone
    vec3 chord = L + D;
    float gap = 0.5 * dot(chord, chord); // 1 - cos of the angle to D
    // (-L.D)^e up to $cone$ degrees from D.
    float spot = pow(max(1.0 - gap, 1e-37), $exponent$) * $soft$;
