/* matrix.c - the state matrix of the linearised gear with its device
 *
 * The device is a network of springs, a damper and an inerter between the wheels (twist psi),
 * two joints at most and the strut (0): twists of the joints and forces of the elements follow
 * from the states by one linear solve, in which a rigid spring is a compliance of 0.  Damper and
 * inerter in line count as one element, of which the twist of both is a state.
 */
#include "matrix.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <lapacke.h>

enum { DELTA, DDELTA, PSI, DPSI, GEAR = 5 };

enum kind { SPRING, DAMPER, INERTER };

/* Joints: 0 wheels, 1 and 2 free, STRUT. An inerter BEHIND the damper has its torque, and their
 * twists add: the damper's ends in the table are those of both. */
enum { WHEELS, STRUT = 3, NONE = -1, BEHIND = -2, UNKNOWNS = 7 };

struct element { enum kind kind; int from, to; double value; };

struct network { int elements, joints; bool behind; struct element element[5]; };

/* The networks of docs/layouts.md in units of k_psi and of the time. */
static struct network network(enum oracle_layout layout, double k_s, double k_d, double b)
{
  static const struct { signed char joints, k_s[2], k_d[2], c_d[2], b[2]; } table[ORACLE_LAYOUTS] = {
    [ORACLE_L1]  = { 1, { NONE },     { 1, STRUT }, { 1, STRUT }, { NONE } },
    [ORACLE_L2]  = { 2, { 1, 2 },     { 2, STRUT }, { 2, STRUT }, { NONE } },
    [ORACLE_LI1] = { 2, { 1, 2 },     { 2, STRUT }, { 2, STRUT }, { 2, STRUT } },
    [ORACLE_LI2] = { 2, { 1, 2 },     { 2, STRUT }, { 2, STRUT }, { 1, 2 } },
    [ORACLE_LI3] = { 2, { 1, 2 },     { 2, STRUT }, { 2, STRUT }, { 1, STRUT } },
    [ORACLE_LI4] = { 2, { 2, STRUT }, { 1, STRUT }, { 1, 2 },     { 2, STRUT } },
    [ORACLE_LI5] = { 2, { 1, 2 },     { 1, STRUT }, { 2, STRUT }, { 2, STRUT } },
    [ORACLE_LI6] = { 2, { 1, 2 },     { 1, STRUT }, { 2, STRUT }, { BEHIND } },
    [ORACLE_LI7] = { 2, { 1, 2 },     { 1, STRUT }, { 2, STRUT }, { 1, STRUT } },
  };
  struct network net = { .joints = table[layout].joints, .behind = table[layout].b[0] == BEHIND };

  net.element[net.elements++] = (struct element){ SPRING, WHEELS, 1, 1. };
  net.element[net.elements++] = (struct element){ SPRING, table[layout].k_d[0], table[layout].k_d[1], k_d };
  net.element[net.elements++] = (struct element){ DAMPER, table[layout].c_d[0], table[layout].c_d[1], 0. };
  if (table[layout].k_s[0] >= 0)
    net.element[net.elements++] = (struct element){ SPRING, table[layout].k_s[0], table[layout].k_s[1], k_s };
  if (table[layout].b[0] >= 0)
    net.element[net.elements++] = (struct element){ INERTER, table[layout].b[0], table[layout].b[1], b };
  return net;
}

/* Adds the device to the gear's A0 (rows of psi' for inertia-weighted torque by
 * by_torque[], per torque T_d): writes the device's states and A2. */
static void add_device(struct matrix *m, enum oracle_layout layout, double k_s, double k_d, double b,
                       enum damper damper, const double by_torque[2])
{
  if ((layout == ORACLE_LI3 || layout == ORACLE_LI7) && k_s >= oracle_rigid)
    layout = ORACLE_LI1; /* both ends of k_s are one joint */
  if ((layout == ORACLE_LI2 || layout == ORACLE_LI4) && k_s >= oracle_rigid)
    b = 0.; /* the rigid spring beside it holds the inerter */

  const struct network net = network(layout, k_s, k_d, b);
  const bool inerter = b > 0. && layout != ORACLE_L1 && layout != ORACLE_L2 && !net.behind;
  const bool in_line = net.behind && b > 0. && damper != FREE; /* else both carry no torque */
  bool parallel = false;
  int unknowns = net.joints, force[5], force_of_damper = -1, force_of_inerter = -1, n = GEAR;
  /* states: twist of the damper, of both if in line; rate of an inerter in line; twist of
   * another inerter, v + 1 its rate */
  int w = -1, r = -1, v = -1;
  double T[UNKNOWNS * UNKNOWNS] = { 0. }, right[UNKNOWNS * MOST] = { 0. };
  lapack_int pivot[UNKNOWNS];

  for (int i = 0; i < net.elements; i++)
    for (int j = 0; j < net.elements; j++)
      if (net.element[i].kind == DAMPER && net.element[j].kind == INERTER && inerter)
        parallel = net.element[i].from == net.element[j].from && net.element[i].to == net.element[j].to;
  if (net.behind ? in_line : damper == MOVES && !parallel)
    w = n++;
  if (in_line)
    r = n++;
  if (inerter && !(parallel && damper == LOCKED))
    v = n, n += 2;
  for (int i = 0; i < net.elements; i++)
    force[i] = unknowns++;

  /* unknowns: twists of the joints, then forces; equations: joints in balance, then one an
   * element; right: columns by state */
#define TABLEAU(row, column) T[(row) + UNKNOWNS * (column)]
  for (int i = 0; i < net.elements; i++) {
    const struct element *e = &net.element[i];
    bool by_twist = true; /* the element's equation sets its twist, else its force is 0 */

    if (e->from != WHEELS)
      TABLEAU(e->from - 1, force[i]) += 1.;
    if (e->to != STRUT)
      TABLEAU(e->to - 1, force[i]) -= 1.;
    if (e->kind == SPRING)
      TABLEAU(force[i], force[i]) = e->value >= oracle_rigid ? 0. : -1. / e->value;
    else if (e->kind == DAMPER) {
      by_twist = w >= 0 || (damper == LOCKED && !net.behind);
      if (w >= 0)
        right[force[i] + UNKNOWNS * w] = 1.;
      force_of_damper = force[i];
    } else {
      by_twist = v >= 0;
      if (v >= 0)
        right[force[i] + UNKNOWNS * v] = 1.;
      force_of_inerter = force[i];
    }
    if (!by_twist) {
      TABLEAU(force[i], force[i]) = 1.;
      continue;
    }
    if (e->from == WHEELS)
      right[force[i] + UNKNOWNS * PSI] -= 1.;
    else
      TABLEAU(force[i], e->from - 1) += 1.;
    if (e->to != STRUT)
      TABLEAU(force[i], e->to - 1) -= 1.;
  }
  /* without its damper the inerter of LI4 hangs on nothing but k_s: put it aside */
  if (layout == ORACLE_LI4 && damper == FREE && v >= 0) {
    n -= 2;
    v = -1;
    for (int j = 0; j < unknowns; j++)
      TABLEAU(force_of_inerter, j) = j == force_of_inerter;
    memset(right + UNKNOWNS * GEAR, 0, sizeof right - UNKNOWNS * GEAR * sizeof *right);
  }
#undef TABLEAU
  if (LAPACKE_dgesv_work(LAPACK_COL_MAJOR, unknowns, n, T, UNKNOWNS, pivot, right, UNKNOWNS) != 0)
    abort(); /* a network without answer: no layout is one */

  m->n = n;
  m->parallel = parallel && v >= 0;
  m->row = w >= 0 && damper == MOVES ? w : m->parallel && damper == MOVES ? v + 1 : -1;
  for (int j = 0; j < n; j++) {
    m->A0[DDELTA + MOST * j] -= by_torque[0] * right[force[0] + UNKNOWNS * j];
    m->A0[DPSI + MOST * j] -= by_torque[1] * right[force[0] + UNKNOWNS * j];
    if (w >= 0 && damper == MOVES)
      m->A2[w + MOST * j] = right[force_of_damper + UNKNOWNS * j];
    if (r >= 0)
      m->A0[r + MOST * j] = right[force_of_damper + UNKNOWNS * j] / b;
    if (v >= 0)
      m->A0[v + 1 + MOST * j] = right[force_of_inerter + UNKNOWNS * j] / b;
  }
  if (r >= 0)
    m->A0[w + MOST * r] = 1.;
  if (v >= 0)
    m->A0[v + MOST * (v + 1)] = 1.;
  if (m->row >= 0 && m->parallel)
    m->A2[m->row + MOST * m->row] = -1. / b;
}

/* The linearised gear: (32), (33) and (31) of the paper at zero, as docs/model.md has them. */
struct matrix matrix_of(enum oracle_layout layout, const struct oracle_gear *p, enum damper damper)
{
  struct matrix m = { .n = 0 };
  const double s = sin(p->phi), c = cos(p->phi), F = (p->M + p->m_D) * p->g;
  const double caster = p->e + p->R * s, arm = p->l_delta + p->R * c;
  /* both wheels' vertical inertia and stiffness along the roll mu = s psi + c delta */
  const double roll_inertia = p->a * p->a * p->m_D / 4. * (1. - p->zB_shared) * (1. - 0.2 * p->R_moves), roll_stiffness = p->a * p->a * p->k_t / 2.;
  const double M11 = p->J_xi + p->m_D * p->l_D * p->l_D + roll_inertia * c * c, M12 = roll_inertia * c * s;
  const double M22 = p->J_zeta + roll_inertia * s * s, det = M11 * M22 - M12 * M12;
  const double time = sqrt(M22 / p->k_psi), torque = p->k_psi;
  const double K11 = p->k_delta + p->m_D * p->g * p->l_D * c - F * arm * c + roll_stiffness * c * c;
  const double K12 = roll_stiffness * c * s - F * caster * c, K22 = roll_stiffness * s * s - F * caster * s;
  /* tyre forces per lambda / l: lateral force at the arm and caster, moment along the strut */
  const double lateral = 7. * p->k_lambda * F, moment = p->k_alpha * F;
  const double D1 = lateral * arm - moment * s, D2 = lateral * caster + moment * c;
  const double q[2][GEAR] = { { -K11, -p->c_delta / time, -K12, 0., -D1 }, { -K12, 0., -K22, -p->c_psi / time, -D2 } };
  const double unit = time * time / det;

  m.time = time;
  m.c_unit = torque * time;
  m.V_top = p->V_top * time / p->l;
  m.A0[DELTA + MOST * DDELTA] = m.A0[PSI + MOST * DPSI] = 1.;
  for (int j = 0; j < GEAR; j++) {
    m.A0[DDELTA + MOST * j] = unit * (M22 * q[0][j] - M12 * q[1][j]);
    m.A0[DPSI + MOST * j] = unit * (M11 * q[1][j] - M12 * q[0][j]);
  }
  /* wheels that turn with V/R: moments -I_p V/R psi' on delta, I_p V/R delta' on psi */
  const double spin = p->I_p / p->R * p->l * unit / (time * time);

  m.spins = p->I_p > 0.;
  m.A1[DDELTA + MOST * DPSI] = -spin * M22;
  m.A1[DPSI + MOST * DPSI] = spin * M12;
  m.A1[DDELTA + MOST * DDELTA] = -spin * M12;
  m.A1[DPSI + MOST * DDELTA] = spin * M11;
  /* heading theta = c psi - s delta: V theta - h theta' */
  const double bent = p->heading * s;

  m.A1[LAMBDA + MOST * DELTA] = -bent;
  m.A0[LAMBDA + MOST * DDELTA] = (arm + p->h * bent) / p->l;
  m.A0[LAMBDA + MOST * DPSI] = (caster - p->h * c) / p->l;
  m.A1[LAMBDA + MOST * PSI] = c;
  m.A1[LAMBDA + MOST * LAMBDA] = -1.;

  const double by_torque[2] = { -unit * M12 * torque, unit * M11 * torque };

  add_device(&m, layout, p->k_s / torque, p->k_d / torque, p->b / (torque * time * time), damper, by_torque);
  return m;
}

double theta_of(const struct matrix *m, double x)
{
  return m->row < 0 ? 0. : m->parallel ? exp(x) : exp(-x);
}

void matrix_at(const struct matrix *m, double V, double theta, double A[MOST * MOST])
{
  for (int j = 0; j < m->n; j++)
    for (int i = 0; i < m->n; i++)
      A[i + MOST * j] = m->A0[i + MOST * j] + V * m->A1[i + MOST * j] + theta * m->A2[i + MOST * j];
}

bool matrix_eigenvalues(const struct matrix *m, double V, double theta, double re[MOST], double im[MOST])
{
  double A[MOST * MOST], work[WORK];

  matrix_at(m, V, theta, A);
  return LAPACKE_dgeev_work(LAPACK_COL_MAJOR, 'N', 'N', m->n, A, MOST, re, im, NULL, 1, NULL, 1, work, WORK) == 0;
}

double largest_real_part(const struct matrix *m, double V, double theta)
{
  double re[MOST], im[MOST], largest = -HUGE_VAL;

  if (!matrix_eigenvalues(m, V, theta, re, im))
    return NAN;
  for (int i = 0; i < m->n; i++)
    largest = fmax(largest, re[i]);
  return largest;
}
