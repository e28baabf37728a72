const vec3 points_$index$[$count$] = vec3[$count$](
$points$
);

// $title$: each point of it has an equal share of its intensity.
vec3 light_$index$(vec3 P, vec3 N, vec3 V, vec3 color) {
    const vec3 Ip = $Ip$ / $count$.0;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < $count$; i++) {
$shine$
    }
    return sum;
}

