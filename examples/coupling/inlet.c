/* Velocities of a Stokes wave at an inlet, as a solver in C would impose them at every time step. */
#include <math.h>
#include <stdio.h>

#include "seiche.h"

int main(void) {
  seiche_solution* wave = seiche_create("stokes", "amplitude=0.05,wavelength=6,depth=1,gravity=9.81");
  if (wave == NULL) {
    fprintf(stderr, "%s\n", seiche_error());
    return 1;
  }
  double points[11 * 3];
  double values[11 * 16];
  if (seiche_inputs(wave) != 3 || seiche_outputs(wave) > 16) return 1;
  for (int k = 0; k < 11; ++k) { /* x, y, t below the crest */
    points[3 * k] = 0;
    points[3 * k + 1] = -1 + 0.1 * k;
    points[3 * k + 2] = 0;
  }
  if (seiche_evaluate(wave, 11, points, values) != 0) {
    fprintf(stderr, "%s\n", seiche_error());
    return 1;
  }
  const size_t outputs = seiche_outputs(wave);
  for (size_t k = 0; k < outputs; ++k) printf("%s%s", seiche_output(wave, k), k + 1 < outputs ? " " : "\n");
  for (size_t k = 0; k < 11; ++k) {
    for (size_t j = 0; j < outputs; ++j) printf("%.6f ", values[k * outputs + j]);
    printf("\n");
  }
  const int slower_below = isfinite(values[1]) && values[1] < values[10 * outputs + 1];
  seiche_free(wave);
  seiche_solution* none = seiche_create("stokes", "amplitude=-1"); /* refused, and seiche_error() says why */
  printf("refused: %s\n", seiche_error());
  if (none != NULL || seiche_evaluate(none, 11, points, values) == 0) return 1;
  return slower_below ? 0 : 1;
}
