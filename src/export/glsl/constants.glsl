uniform vec3 eye = $eye$; // world
$towards_viewer$
const vec3 Ia = $Ia$;
const vec3 Ka = $Ka$;
const vec3 Kd = $Kd$;
const vec3 Od = $Od$; // the surface's colour
$specular$
