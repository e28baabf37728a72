// $title$: $what$.
vec3 light_$index$(vec3 P, vec3 N, vec3 V, vec3 color) {
    const vec3 Ip = $Ip$;
$shine$
}

