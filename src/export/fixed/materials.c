/* The materials: Ka*Od, Kd*Od and Ks*Os with an alpha of 1 each, and the exponent n. */
static const GLfloat materials[][13] = {
$rows$
};

/* Sets a material for the polygons that are drawn from now on. */
void use_material(int index) {
    const GLfloat *material = materials[index];

    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, material);
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, material + 4);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, material + 8);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, material[12]);
}
