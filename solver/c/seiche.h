/* Exact solutions for programs in C and, by seiche.f90, in Fortran: initial and boundary conditions of waves, velocities
 * below them, motions of wavemakers, at arrays of points. Lengths in metres and times in seconds unless a parameter such
 * as gravity=1 makes them nondimensional; `seiche exact NAME --help` and `seiche exact list` name parameters, coordinates
 * and outputs.
 *
 *     seiche_solution* wave = seiche_create("solitary", "amplitude=0.3,depth=1,gravity=9.81");
 *     if (wave == NULL) fprintf(stderr, "%s\n", seiche_error());
 *     double point[] = {0, -0.5, 0}, values[5];                          // x, y, t
 *     seiche_evaluate(wave, 1, point, values);
 *     seiche_free(wave);
 *
 * Nothing is thrown through this interface. Different threads may use it at once, a solution one at a time. */
#ifndef SEICHE_H
#define SEICHE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct seiche_solution seiche_solution;

/* A solution by its name; parameters as "name=value,..." with numbers or choices, NULL or "" for none. NULL on error. */
seiche_solution* seiche_create(const char* name, const char* parameters);
void seiche_free(seiche_solution* solution);

/* How many coordinates a point has, and how many values it gets; their names, NULL beyond. NULL for a solution has none,
 * and an error where it is evaluated. */
size_t seiche_inputs(const seiche_solution* solution);
size_t seiche_outputs(const seiche_solution* solution);
const char* seiche_input(const seiche_solution* solution, size_t k);
const char* seiche_output(const seiche_solution* solution, size_t k);

/* Values at count points, point by point; NaN outside the water. 0, or 1 where the error's text says why not. */
int seiche_evaluate(const seiche_solution* solution, size_t count, const double* points, double* values);

/* A number of the solution as a whole, such as "speed"; NaN and an error's text where it has none of that name. */
double seiche_scalar(const seiche_solution* solution, const char* name);

/* What was wrong with the last call of this thread that failed. */
const char* seiche_error(void);

#ifdef __cplusplus
}
#endif
#endif
