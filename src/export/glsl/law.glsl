// What is left of the intensity at a depth.
float s0_at(float depth) {
    float nearness = clamp(($back$ - depth) / $extent$, 0.0, 1.0);
    return mix($back_scale$, $front_scale$, nearness);
}

