// Cosines are lifted to this before anything is divided by them.
const float SMALLEST_COSINE = 1e-4;

$gap$
