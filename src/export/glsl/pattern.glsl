// Od at P: fields $fields$ wide, counted from the origin, every other one in the pattern's colour.
vec3 surface_color(vec3 P) {
    const vec3 pattern = $color$;
    vec3 p = P / $scale$;
    float count = $count$;
    return mod(count, 2.0) > 0.5 ? pattern : Od;
}

