layout(location = 0) in vec3 vertex_position; // world
layout(location = 1) in vec3 vertex_normal; // N, unit, world

// The camera, by columns: another picture's width and height, or another camera, is set from outside.
uniform mat4 clip_from_world = mat4(
$clip_from_world$
);

$declared$
$carried$

void main() {
    $given$
    gl_Position = clip_from_world * vec4(vertex_position, 1.0);
}
