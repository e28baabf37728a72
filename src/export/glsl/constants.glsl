uniform vec3 eye = $eye$; // world
$towards_viewer$
$material$
const vec3 Ia = $Ia$;
$Ka$
$Kd$
$Od$ // the surface's colour
$specular$
