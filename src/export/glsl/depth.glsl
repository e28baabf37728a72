// The depth of a point, its distance from the eye along the viewing direction; goes with clip_from_world.
uniform vec4 depth_from_world = vec4($row$);

