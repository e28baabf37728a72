    glDrawElements(GL_TRIANGLES, 3 * TRIANGLES, GL_UNSIGNED_INT, triangles);
