// The scene's own law: the factor of a light's f*Ip in one channel.$means$
float law(int channel, vec3 N, vec3 L, vec3 V, $d$vec3 color) {
$letters$
$lines$
}

