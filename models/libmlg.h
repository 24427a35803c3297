/* libmlg.h - the landing gear as a C library: u' = f(u; par)
 *
 * For continuation and simulation codes that want the very model AUTO runs.
 * Needs nothing of AUTO and no other header of this project; link -lmlg -lm.
 * `make libmlg` builds build/lib/libmlg.a and build/lib/libmlg.so; a layout is in
 * them when its file is in models/.
 *
 * A layout, a parameter and a state each have a number, 0, 1, ..., and a name;
 * numbers may differ from one version to the next, names do not.  SI units and
 * radians.  All functions may be called from several threads at once.
 */
#ifndef LIBMLG_H
#define LIBMLG_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The array sizes that are enough for any layout. */
enum { LIBMLG_MOST_PARAMETERS = 64, LIBMLG_MOST_STATES = 32 };

/* Returned for a name or a number that is none. */
enum { LIBMLG_NONE = -1 };

/* What a parameter or a state is; the texts are not to be freed. */
struct libmlg_quantity {
  const char *name;    /* as in AUTO's constants files: "c_d" */
  const char *unit;    /* "N m s/rad"; "-": a pure number */
  const char *meaning; /* "device damping" */
};

/* --- layouts ----------------------------------------------------------------- */

int libmlg_layouts(void);                   /* how many there are */
int libmlg_layout(const char *name);        /* number of "l1", or LIBMLG_NONE */
const char *libmlg_layout_name(int layout); /* NULL: no such layout */

/* --- states: those of the gear, then those of the device ----------------------- */

int libmlg_states(int layout); /* how many, or LIBMLG_NONE: no such layout */
int libmlg_state(int layout, const char *name); /* number of "psi", or LIBMLG_NONE */
const struct libmlg_quantity *libmlg_state_quantity(int layout, int state); /* or NULL */

/* --- parameters: the same for every layout --------------------------------------- */

int libmlg_parameters(void);             /* how many there are */
int libmlg_parameter(const char *name);  /* number of "c_d", or LIBMLG_NONE */
const struct libmlg_quantity *libmlg_parameter_quantity(int parameter); /* or NULL */

/* The default, that of the paper's gear at V = 1 m/s, c_d = 3.6e4 N m s/rad,
 * k_s rigid, b = 0.  NaN: no such parameter. */
double libmlg_default(int parameter);

/* The least and the largest value it may have; a k_s of 1e30 or infinity is rigid.
 * NaN: no such parameter. */
double libmlg_least(int parameter);
double libmlg_most(int parameter);

/* Defaults into par[libmlg_parameters()]. */
void libmlg_defaults(double par[]);

/* The first parameter outside its range, or LIBMLG_NONE: all are inside. */
int libmlg_outside(const double par[]);

/* --- the equations ----------------------------------------------------------------- */

/* f[] = u' for states u[], both libmlg_states(layout) long, at the parameters
 * par[libmlg_parameters()]; rates are per second.  The ranges are not looked at
 * (libmlg_outside does that).  c_d = 0, b = 0 and a rigid k_s may be given.
 * Returns 0, or LIBMLG_NONE: no such layout, f[] as it was. */
int libmlg_rhs(int layout, const double par[], const double u[], double f[]);

/* Its derivatives there, n = libmlg_states(layout):
 *   dfdu[j * n + i] = d f_i / d u_j,   dfdp[k * n + i] = d f_i / d par[k]
 * dfdp may be NULL.  Exact, but those by the device's own parameters, which are good
 * to 1e-10; 0 for b = 0 and for a rigid k_s.  Returns as libmlg_rhs. */
int libmlg_jacobian(int layout, const double par[], const double u[], double dfdu[], double dfdp[]);

#ifdef __cplusplus
}
#endif

#endif
