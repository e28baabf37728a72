$declared$
$carried$
out vec4 pixel;

// From a linear intensity to what is stored: $means$.
vec3 display(vec3 I) {
$mark$
$encode$
}

void main() {
    vec3 I = $intensity$;
    pixel = vec4(display(I), 1.0);
}
