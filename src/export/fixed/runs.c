/* Runs of triangles of one material: the material, and how many. */
static const GLsizei runs[][2] = {
$runs$
};
