    for (i = 0; i < sizeof runs / sizeof *runs; from += 3 * runs[i++][1]) {
        use_material(runs[i][0]);
        glDrawElements(GL_TRIANGLES, 3 * runs[i][1], GL_UNSIGNED_INT, from);
    }
