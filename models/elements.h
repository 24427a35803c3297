/* elements.h - the laws of joints, springs and the damper of a device
 *
 * mlg.h includes this.  A layout says how its elements are joined; what each of them
 * does stands here.  By default all are linear, and then the numbers are to the last bit
 * those of the linear formulas.
 *
 *   torque links  T = k_psi D(x, g_psi)
 *   spring k_s    T = k_s y + k_s3 y^3, y = D(x, g_s)
 *   spring k_d    T = k_d x + k_d3 x^3
 *   damper        T = h + T_f tanh(v / v_f), v = o(h) + D(h, T_max) / c_r,
 *                 o the rate at which the orifice carries h = c_d o + c_2 |o| o
 *   wheels        T = T_psi tanh(psi' / v_f)
 *
 * D(x, g) is the dead zone, 0 up to |x| = g and |x| - g beyond: a gap of half-width g in
 * series, or a relief valve that opens at T_max.  Its corners are rounded as hyperbolas of
 * the width corner g; at corner = 0 they are sharp.  D is odd, does not fall, and has
 * 0 <= D' <= 1: gap and valve give no energy.  Sources: dead zone and dry friction, Den
 * Hartog, Mechanical Vibrations, Sections 8.9 and 8.3; tanh, Andersson, Soderberg and
 * Bjorklund, Tribology International 40 (2007) 580-587; orifice and relief valve, Currey,
 * Aircraft Landing Gear Design, Chapter 5.
 */
#ifndef MLG_ELEMENTS_H
#define MLG_ELEMENTS_H

/* --- linear elements, given by numbers ------------------------------------------- */

/* Stiffness of two springs in series; exactly k when k_s is MLG_RIGID. */
static inline double mlg_series(double k, double k_s)
{
  return k / (1. + k / k_s);
}

/* Rate, 1/s, at which a state that a layout does not use follows its value. */
#define MLG_FOLLOW 1e3

/* The device damping to divide by.  A damper of 0 lets its spring follow at
 * once; a millionth of N m s/rad does so 1e10 times faster than shimmy. */
static inline double mlg_damper(double c_d)
{
  const double least = 1e-6;

  return fabs(c_d) < least ? least : c_d;
}

/* Spring k, damper c and inerter b side by side, as states of a device: twist x[0], rad,
 * and its rate x[1], rad/s, under the torque T = k x + c x' + b x''.  Their rates go into
 * dx.  At b = 0 the second state only follows x'; a rigid k holds x at 0. */
static inline void mlg_spring_damper_inerter(double T, double k, double c, double b,
                                             const double x[], double dx[])
{
  if (b > 0. && k < MLG_RIGID) {
    dx[0] = x[1];
    dx[1] = (T - k * x[0] - c * x[1]) / b;
  } else {
    dx[0] = k < MLG_RIGID ? (T - k * x[0]) / mlg_damper(c) : -MLG_FOLLOW * x[0];
    dx[1] = MLG_FOLLOW * (dx[0] - x[1]);
  }
}

/* Spring k_s and inerter b in series with a spring k, over both the twist y: returns
 * the torque T = k (y - x) = k_s x + b x''.  At b = 0 or with a rigid k_s there is no
 * motion of its own, and the two states follow the twist of k_s. */
static inline double mlg_spring_inerter(double k, double y, double k_s, double b,
                                        const double x[], double dx[])
{
  double T;

  if (b > 0. && k_s < MLG_RIGID) {
    T = k * (y - x[0]);
    dx[0] = x[1];
    dx[1] = (T - k_s * x[0]) / b;
  } else {
    T = mlg_series(k, k_s) * y;
    dx[0] = MLG_FOLLOW * (T / k_s - x[0]);
    dx[1] = MLG_FOLLOW * (dx[0] - x[1]);
  }
  return T;
}

/* Whether any law is on; else all elements are linear. */
static inline int mlg_has_laws(const double par[])
{
  static const int law[] = { PAR_G_PSI, PAR_G_S, PAR_T_F, PAR_T_PSI, PAR_C_2, PAR_T_MAX, PAR_K_S3, PAR_K_D3 };

  for (size_t i = 0; i < sizeof law / sizeof *law; i++)
    if (fabs(par[law[i]]) > 0.)
      return 1;
  return 0;
}

/* What a law that is on lacks, in words, or NULL. */
static inline const char *mlg_lacks(const double par[])
{
  if ((par[PAR_T_F] > 0. || par[PAR_T_PSI] > 0.) && !(par[PAR_V_F] > 0.))
    return "friction (T_f, T_psi) needs v_f above 0, the speed scale of its tanh, rad/s";
  if (par[PAR_T_MAX] > 0. && !(par[PAR_C_R] > 0.))
    return "a relief valve (T_max) needs c_r above 0, the damping of the open valve, N m s/rad";
  return NULL;
}

/* What linear tools take: orifice and valve are linear at rest; inside a gap a joint has
 * no stiffness, and dry friction no damping, so that these are left out. */
static inline void mlg_at_rest(double par[])
{
  par[PAR_G_PSI] = par[PAR_G_S] = par[PAR_T_F] = par[PAR_T_PSI] = par[PAR_C_2] = par[PAR_T_MAX] = 0.;
}

/* A device in which every law is on, corners rounded, to see what it depends on. */
static inline void mlg_with_all_laws(double par[])
{
  par[PAR_K_S] = 1e6;
  par[PAR_B] = 100.;
  par[PAR_G_PSI] = par[PAR_G_S] = 1e-3;
  par[PAR_CORNER] = 0.5;
  par[PAR_T_F] = par[PAR_T_PSI] = par[PAR_T_MAX] = 100.;
  par[PAR_V_F] = 0.1;
  par[PAR_C_2] = par[PAR_C_R] = 1e3;
  par[PAR_K_S3] = par[PAR_K_D3] = 1e7;
}

/* --- laws --------------------------------------------------------------------------- */

/* Where the laws have sharp corners: functions of the states that pass 0 there, noted by
 * the elements of a device while somebody looks (libmlg/layout.c), in the same order
 * each time. */
enum { MLG_MOST_CORNERS = 8 };
struct mlg_corners { int n; double at[MLG_MOST_CORNERS]; };
static _Thread_local struct mlg_corners *mlg_looking;

static inline void mlg_corner(double passes_zero)
{
  if (mlg_looking && mlg_looking->n < MLG_MOST_CORNERS)
    mlg_looking->at[mlg_looking->n++] = passes_zero;
}

/* D(x, g) with corners of the width w, g > 0, and its slope by x. */
static inline double mlg_dead_zone(double x, double g, double w)
{
  /* x + (s_1 - s_2) / 2 without the difference of the roots s_1 and s_2 */
  return x * (1. - 2. * g / (sqrt((x - g) * (x - g) + w * w) + sqrt((x + g) * (x + g) + w * w)));
}

static inline double mlg_dead_zone_slope(double x, double g, double w)
{
  if (!(w > 0.))
    return fabs(x) > g ? 1. : 0.;
  return 1. + 0.5 * ((x - g) / sqrt((x - g) * (x - g) + w * w) - (x + g) / sqrt((x + g) * (x + g) + w * w));
}

/* The twist x behind a gap of half-width g. */
static inline double mlg_behind_gap(const double par[], double x, double g)
{
  if (!(fabs(g) > 0.))
    return x;
  if (!(par[PAR_CORNER] > 0.)) {
    mlg_corner(x - g);
    mlg_corner(x + g);
  }
  return mlg_dead_zone(x, g, par[PAR_CORNER] * g);
}

static inline double mlg_cubic(double k, double k_3, double x)
{
  return fabs(k_3) > 0. ? (k + k_3 * x * x) * x : k * x;
}

/* Torques, N m, of the torque links, k_s and k_d at a twist x, rad. */
static inline double mlg_links(const double par[], double x)
{
  return par[PAR_K_PSI] * mlg_behind_gap(par, x, par[PAR_G_PSI]);
}

static inline double mlg_k_s(const double par[], double x)
{
  return mlg_cubic(par[PAR_K_S], par[PAR_K_S3], mlg_behind_gap(par, x, par[PAR_G_S]));
}

static inline double mlg_k_d(const double par[], double x)
{
  return mlg_cubic(par[PAR_K_D], par[PAR_K_D3], x);
}

/* Friction of the torque T over the speed v. */
static inline double mlg_friction(const double par[], double T, double v)
{
  return fabs(T) > 0. ? T * tanh(v / par[PAR_V_F]) : 0.;
}

/* That of the wheel assembly, beside c_psi. */
static inline double mlg_wheel_friction(const double par[], double dpsi)
{
  return mlg_friction(par, par[PAR_T_PSI], dpsi);
}

/* The root of f(par, given, x, &slope) = 0 between lo and hi, f rising, from x on.
 * Newton's iteration, halving the interval where that leaves it. */
static inline double mlg_root(double f(const double par[], const double given[], double x, double *slope),
                              const double par[], const double given[], double lo, double hi, double x)
{
  for (int i = 0; i < 200; i++) {
    double slope, next;
    const double value = f(par, given, x, &slope);

    if (value > 0.)
      hi = x;
    else
      lo = x;
    next = x - value / slope;
    if (!(next > lo && next < hi))
      next = fabs(value) > 0. ? 0.5 * (lo + hi) : x;
    if (fabs(next - x) <= 1e-15 * fabs(x) || next <= lo || next >= hi)
      return next;
    x = next;
  }
  return x;
}

/* The rate of the oil, rad/s, at the torque h: orifice and relief valve; and its slope. */
static inline double mlg_oil(const double par[], double h, double *slope)
{
  const double c = mlg_damper(par[PAR_C_D]), c_2 = par[PAR_C_2], T_max = par[PAR_T_MAX];
  const double root = fabs(c_2) > 0. ? sqrt(c * c + 4. * c_2 * fabs(h)) : c;
  double v = 2. * h / (c + root);

  *slope = 1. / root;
  if (T_max > 0.) {
    v += mlg_dead_zone(h, T_max, par[PAR_CORNER] * T_max) / par[PAR_C_R];
    *slope += mlg_dead_zone_slope(h, T_max, par[PAR_CORNER] * T_max) / par[PAR_C_R];
  }
  return v;
}

static inline double mlg_oil_less_rate(const double par[], const double v[], double h, double *slope)
{
  return mlg_oil(par, h, slope) - *v;
}

static inline double mlg_oil_and_friction_less_torque(const double par[], const double T[], double h, double *slope)
{
  const double v = mlg_oil(par, h, slope), t = tanh(v / par[PAR_V_F]);

  *slope = 1. + par[PAR_T_F] * (1. - t * t) / par[PAR_V_F] * *slope;
  return h + par[PAR_T_F] * t - *T;
}

/* Notes where the law of the damper has its corners. */
static inline void mlg_damper_corners(const double par[], double h)
{
  if (fabs(par[PAR_C_2]) > 0.)
    mlg_corner(h);
  if (par[PAR_T_MAX] > 0. && !(par[PAR_CORNER] > 0.)) {
    mlg_corner(h - par[PAR_T_MAX]);
    mlg_corner(h + par[PAR_T_MAX]);
  }
}

/* The torque of the damper at the rate v, and its rate at the torque T. */
static inline double mlg_damper_torque(const double par[], double v)
{
  double h = par[PAR_C_D] * v;

  if (fabs(par[PAR_C_2]) > 0.)
    h += par[PAR_C_2] * fabs(v) * v;
  if (par[PAR_T_MAX] > 0.)
    h = mlg_root(mlg_oil_less_rate, par, &v, fmin(h, 0.), fmax(h, 0.), h);
  mlg_damper_corners(par, h);
  return h + mlg_friction(par, par[PAR_T_F], v);
}

static inline double mlg_damper_rate(const double par[], double T)
{
  const double T_f = par[PAR_T_F];
  double h = T, slope;

  if (!(fabs(T_f) > 0. || fabs(par[PAR_C_2]) > 0. || par[PAR_T_MAX] > 0.))
    return T / mlg_damper(par[PAR_C_D]);
  if (fabs(T_f) > 0.)
    h = mlg_root(mlg_oil_and_friction_less_torque, par, &T, -fabs(T), fabs(T), T - copysign(fmin(T_f, fabs(T)), T));
  mlg_damper_corners(par, h);
  return mlg_oil(par, h, &slope);
}

/* --- elements joined, in the words of a layout ------------------------------------------ */

/* Torque links and k_s in series, over both the twist y: k_psi_e (37).  Two gaps in series
 * are one of the sum. */
static inline double mlg_links_and_k_s(const double par[], double y)
{
  const double k_psi = par[PAR_K_PSI], k_s = par[PAR_K_S], k_s3 = par[PAR_K_S3];
  const double z = mlg_behind_gap(par, y, par[PAR_G_PSI] + par[PAR_G_S]);

  if (!(k_s3 > 0. && k_s < MLG_RIGID))
    return mlg_series(k_psi, k_s) * z;
  /* k_psi (z - x) = k_s x + k_s3 x^3 has one root, Cardano's */
  const double p = sqrt((k_psi + k_s) / (3. * k_s3));
  const double x = 2. * p * sinh(asinh(k_psi * z / (2. * k_s3 * p * p * p)) / 3.);

  return k_psi * (z - x);
}

/* Torque links in series with (k_s beside b), as mlg_spring_inerter(). */
static inline double mlg_links_and_inerter(const double par[], double y, const double x[], double dx[])
{
  const double b = par[PAR_B], k_s = par[PAR_K_S];
  double T;

  if (b > 0. && k_s < MLG_RIGID) {
    T = mlg_links(par, y - x[0]);
    dx[0] = x[1];
    dx[1] = (T - mlg_k_s(par, x[0])) / b;
  } else {
    T = mlg_links_and_k_s(par, y);
    dx[0] = MLG_FOLLOW * (T / k_s - x[0]);
    dx[1] = MLG_FOLLOW * (dx[0] - x[1]);
  }
  return T;
}

/* Damper and inerter side by side under the torque T, as mlg_spring_damper_inerter(). */
static inline void mlg_damper_and_inerter(const double par[], double T, const double x[], double dx[])
{
  const double b = par[PAR_B];

  if (b > 0.) {
    dx[0] = x[1];
    dx[1] = (T - mlg_damper_torque(par, x[1])) / b;
  } else {
    dx[0] = mlg_damper_rate(par, T);
    dx[1] = MLG_FOLLOW * (dx[0] - x[1]);
  }
}

/* Behind the torque links k_d beside a branch: the torques of the links, T_d, and into the
 * branch, T_b, N m. */
struct mlg_fork { double T_d, T_b; };

/* Whether the fork has nothing but linear springs: seen from the branch k_psi and k_d are
 * then one spring k = k_psi + k_d, which psi twists by y = psi k_psi / k. */
static inline int mlg_fork_is_linear(const double par[])
{
  return !(fabs(par[PAR_G_PSI]) > 0. || fabs(par[PAR_G_S]) > 0. || fabs(par[PAR_K_D3]) > 0. || fabs(par[PAR_K_S3]) > 0.);
}

/* The branch is twisted by x. */
static inline struct mlg_fork mlg_fork_at(const double par[], double psi, double x)
{
  const double T_d = mlg_links(par, psi - x);

  return (struct mlg_fork){ T_d, T_d - mlg_k_d(par, x) };
}

/* At the branch's twist x = given[1] + z, z across k_s: its torque less what comes in. */
static inline double mlg_fork_excess(const double par[], const double given[], double z, double *slope)
{
  const double g_psi = par[PAR_G_PSI], g_s = par[PAR_G_S], corner = par[PAR_CORNER];
  const double x = given[1] + z, y = given[0] - x;
  const double z_s = g_s > 0. ? mlg_dead_zone(z, g_s, corner * g_s) : z;

  *slope = par[PAR_K_PSI] * mlg_dead_zone_slope(y, g_psi, corner * g_psi) + par[PAR_K_D] + 3. * par[PAR_K_D3] * x * x
           + (par[PAR_K_S] + 3. * par[PAR_K_S3] * z_s * z_s) * mlg_dead_zone_slope(z, g_s, corner * g_s);
  return mlg_cubic(par[PAR_K_S], par[PAR_K_S3], z_s) + mlg_cubic(par[PAR_K_D], par[PAR_K_D3], x)
         - par[PAR_K_PSI] * (g_psi > 0. ? mlg_dead_zone(y, g_psi, corner * g_psi) : y);
}

/* The branch begins with k_s, behind which it is twisted by x. */
static inline struct mlg_fork mlg_fork_and_k_s(const double par[], double psi, double x)
{
  const double k_psi = par[PAR_K_PSI], k_d = par[PAR_K_D], k = k_psi + k_d;

  if (mlg_fork_is_linear(par)) {
    const double y = psi * k_psi / k, T_b = mlg_series(k, par[PAR_K_S]) * (y - x);

    return (struct mlg_fork){ k_d * y + k_psi / k * T_b, T_b };
  }
  if (par[PAR_K_S] >= MLG_RIGID)
    return mlg_fork_at(par, psi, x);

  const double given[2] = { psi, x }, far = fabs(psi) + fabs(x) + 1e-300;
  const double z = mlg_root(mlg_fork_excess, par, given, -far, far, 0.);
  struct mlg_fork fork = mlg_fork_at(par, psi, x + z);

  fork.T_b = mlg_k_s(par, z);
  return fork;
}

/* There is no branch: k_d alone. */
static inline struct mlg_fork mlg_fork_alone(const double par[], double psi)
{
  const double without[MLG_SLOTS] = { [PAR_K_PSI] = par[PAR_K_PSI], [PAR_G_PSI] = par[PAR_G_PSI], [PAR_CORNER] = par[PAR_CORNER],
                                      [PAR_K_D] = par[PAR_K_D], [PAR_K_D3] = par[PAR_K_D3] }; /* k_s = 0 */

  return mlg_fork_and_k_s(without, psi, 0.);
}

/* The branch is something twisted by x in series with (k_s beside b), whose states are chi. */
static inline struct mlg_fork mlg_fork_and_inerter(const double par[], double psi, double x, const double chi[],
                                                   double dchi[])
{
  const double k_psi = par[PAR_K_PSI], k_d = par[PAR_K_D], k = k_psi + k_d, b = par[PAR_B], k_s = par[PAR_K_S];
  struct mlg_fork fork;

  if (mlg_fork_is_linear(par)) {
    const double y = psi * k_psi / k, T_b = mlg_spring_inerter(k, y - x, k_s, b, chi, dchi);

    return (struct mlg_fork){ k_d * y + k_psi / k * T_b, T_b };
  }
  if (b > 0. && k_s < MLG_RIGID) {
    fork = mlg_fork_at(par, psi, x + chi[0]);
    dchi[0] = chi[1];
    dchi[1] = (fork.T_b - mlg_k_s(par, chi[0])) / b;
  } else {
    fork = mlg_fork_and_k_s(par, psi, x);
    dchi[0] = MLG_FOLLOW * (fork.T_b / k_s - chi[0]);
    dchi[1] = MLG_FOLLOW * (dchi[0] - chi[1]);
  }
  return fork;
}

#endif
