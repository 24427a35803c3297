#!/usr/bin/env python3
"""derive.py - the gear's equations of motion from energies, forces and contact

    python3 models/derive.py > models/jacobian.h

Derives what models/mlg.h states, in the order of the paper and by its equation
numbers: Lagrange's equation (1) with the kinetic energy (2), the strut's spring
and the dampers (3), (5), and the tyre forces at the contact points (13)-(21),
(34)-(36); the stretched string (31).  docs/model.md lists where that departs from
print.  Prints models/jacobian.h, its derivatives as C; run it again after a
change of models/mlg.h, and make the same change here.
tests/derivation.py compares the equations themselves with the C code.

Needs sympy (Debian: python3-sympy).  Reads models/mlg.h for the parameters' names.
"""
import re
import sys
import textwrap
from pathlib import Path

import sympy
from sympy import Matrix, Rational, asin, atan, cos, diff, pi, sin
from sympy.printing.c import C11CodePrinter
from sympy.printing.precedence import PRECEDENCE

MLG = Path(__file__).with_name('mlg.h').read_text()
# names of the parameters: 'c_d' is PAR_C_D in C; rows of results have no numbers
PARAMETERS = {name: f'PAR_{id}' for id, name in
              re.findall(r'X\(\s*\d+,\s*(\w+),\s*"(\w+)",\s*"[^"]*",[^"]*,', MLG)}
par = {name: sympy.Symbol(name, real=True) for name in PARAMETERS}


def symbols(names):
    return sympy.symbols(names, real=True)


# ---- motion ------------------------------------------------------------------

delta, psi, ddelta, dpsi, dddelta, ddpsi = symbols('delta psi ddelta dpsi dddelta ddpsi')
dzB, ddzB = symbols('dzB ddzB')     # of B, upwards
side, lam, T_d = symbols('side lambda T_d')
coordinates = {delta: ddelta, psi: dpsi}

s, c = sin(par['phi']), cos(par['phi'])


def rate(f):
    """df/dt"""
    flow = {**coordinates, ddelta: dddelta, dpsi: ddpsi, dzB: ddzB}
    return sum(diff(f, x) * dx for x, dx in flow.items())


RAKE = Matrix([[c, 0, s], [0, 1, 0], [-s, 0, c]])
BENDING = Matrix([[1, 0, 0], [0, cos(delta), -sin(delta)], [0, sin(delta), cos(delta)]])
TORSION = Matrix([[cos(psi), -sin(psi), 0], [sin(psi), cos(psi), 0], [0, 0, 1]])


def in_space(r):
    """H r, (6), not multiplied out; H = RAKE BENDING TORSION"""
    return RAKE * (BENDING * (TORSION * Matrix(r)))


r_D = in_space([0, 0, par['l_D']])
v_D = r_D.applyfunc(rate) - Matrix([0, 0, dzB])                               # (9)
bending, torsion = Matrix([ddelta, 0, 0]), Matrix([0, 0, dpsi])
w = RAKE * (bending + BENDING * torsion)                                      # (10)


def kinetic_energy():
    """(2), (11), (12): the energies of bending and of torsion, each by itself; and, a
    doubt, of the wheels, which turn about their axle with -V/R and with what the gear
    turns about it, what is linear in both"""
    J = sympy.diag(par['J_xi'], par['J_eta'], par['J_zeta'])
    turning = [TORSION.T * bending, torsion]                                  # in body axes
    wheels = -par['I_p'] * par['V'] / par['R'] * sum(v[1] for v in turning)
    return (par['m_D'] * v_D.dot(v_D) + sum(v.dot(J * v) for v in turning)) / 2 + wheels


def body():
    """(1) for delta and psi without the wheels: = 0 with them"""
    energy, weight = kinetic_energy(), par['m_D'] * par['g']
    spring = {delta: par['k_delta'] * delta, psi: T_d}
    damping = {delta: par['c_delta'], psi: par['c_psi']}
    return [rate(diff(energy, dq)) - diff(energy, q) + spring[q] + damping[q] * dq
            - weight * diff(r_D[2], q) for q, dq in coordinates.items()]


# ---- one wheel ---------------------------------------------------------------

# Computed one after another, as WHEEL says, and by name in the equations: the
# contact point's place in the gear is held where its motion is derived.
mu, R_i, X, Y, Z = symbols('mu R_i X Y Z')
theta, alpha, T, grip, Lambda, C = symbols('theta alpha T grip Lambda C')
ddzB_held, ddzB_R, ddzB_own, ddzB_i, F_z = symbols('ddzB_held ddzB_R ddzB_own ddzB_i F_z')
contact = in_space([X, Y, Z])                                                 # (18), (20)
bent = -par['heading'] * s * delta                                            # a doubt
WHEEL = {
    mu: asin(s * sin(psi) + c * sin(delta) * cos(psi)),                       # (16)
    R_i: par['R'] - Rational(2, 10) * side * par['a'] * mu / 2,               # (19)
    X: -(par['e'] + R_i * s), Y: side * par['a'] / 2, Z: par['l_delta'] + R_i * c,
    theta: psi * c * cos(delta) + bent,                                       # (14)
    alpha: atan(lam / par['l']), T: atan(7 * lam / par['l']),
    Lambda: par['k_lambda'] * T * cos(Rational(95, 100) * T),                 # (25)
    grip: sympy.Piecewise((1, abs(alpha) <= par['alpha_m']), (0, True)),
    C: grip * par['k_alpha'] * par['alpha_m'] / pi * sin(pi * alpha / par['alpha_m']),  # (26)
}


def moving_radius():
    """What (23), (24) have more in zB'' when R_i is differentiated too, a doubt: z is
    linear in R_i"""
    z_R = sum(diff(contact[2], x) * diff(WHEEL[x], R_i) for x in (X, Z))
    radius = WHEEL[R_i].subs(mu, WHEEL[mu])
    return z_R * rate(rate(radius)) + 2 * rate(z_R) * rate(radius)


# zB'' of the wheel; then what is in F_z for it, where ddzB is the mean of both wheels
ddzB_out = par['N12_out'] * diff(rate(rate(r_D[2])), dddelta) * dddelta       # a doubt
WHEEL.update({
    ddzB_held: rate(rate(contact[2])), ddzB_R: moving_radius(),               # (23), (24)
    ddzB_own: ddzB_held + par['R_moves'] * ddzB_R,
})
LOAD = {
    ddzB_i: ddzB_own + par['zB_shared'] * (ddzB - ddzB_own),
    F_z: (side * par['a'] * mu * par['k_t']
          + par['m_D'] * (ddzB_i - rate(rate(r_D[2])) + ddzB_out)
          + (par['m_D'] + par['M']) * par['g']) / 2,                          # (34)-(36)
}


def wheel(load=F_z):
    """What a wheel adds to body(): its forces by their virtual work (13)-(17), (21)"""
    force = Matrix([-Lambda * sin(theta), Lambda * cos(theta), -1])           # per F_z
    return [-load * (force.dot(contact.diff(q)) - C * diff(w[2], dq))
            for q, dq in coordinates.items()]


def stretched_string():
    """lambda' (31)"""
    v_X, v_Y = par['V'] + rate(contact[0]), rate(contact[1])
    slope = lam / par['l']
    return (v_X * (sin(theta) - slope * cos(theta)) - v_Y * (cos(theta) + slope * sin(theta))
            - (par['h'] - lam * slope) * rate(WHEEL[theta]))


# ---- C -----------------------------------------------------------------------

HEAD = """\
/* jacobian.h - derivatives of the gear's equations; do not edit
 *
 * Made by models/derive.py with sympy {sympy}.  After a change of the equations in
 * mlg.h make the same change there, and then
 *
 *     python3 models/derive.py > models/jacobian.h
 *
 * plugin.h stops a run whose derivatives do not belong to its right-hand side.
 *
 * E are the equations of motion of delta and psi with all terms on the left, N m,
 * linear in delta'', psi'' and T_d (which stands in that of psi only); and the rate
 * of each tyre's deflection, m/s.
 */
#ifndef MLG_JACOBIAN_H
#define MLG_JACOBIAN_H

#include <stddef.h>
#include <string.h>

enum mlg_equation {{ E_DELTA, E_PSI, E_LAMBDA_L, E_LAMBDA_R, MLG_EQUATIONS }};

/* Whether the gear depends on par[slot]; devices depend on the others. */
static inline int mlg_of_gear(int slot)
{{
  switch (slot) {{
{slots}
    return 1;
  default:
    return 0;
  }}
}}

/* E by the accelerations, the states, and the parameters of the gear. */
struct mlg_slopes {{
  double dddelta[MLG_EQUATIONS], ddpsi[MLG_EQUATIONS];
  double state[GEAR_STATES][MLG_EQUATIONS];
  double parameter[MLG_SLOTS][MLG_EQUATIONS];
}};

/* How a shared zB'' ties a wheel to the other: the mean zB'' less its own, m/s^2; and the
 * mean of what zB'' has for weight in E, N s^2 and so on, less its own. */
struct mlg_sharing {{ double z, delta, psi; }};
"""

FUNCTION = """
/* {comment} */
static inline void {name}(const double par[], const double u[], const double du[],
    const struct mlg_pose *p, {argument}int parameters, struct mlg_slopes *E)
{{
{body}
}}
"""

TAIL = """
/* Whether any of the doubts acts. */
static inline int mlg_doubted(const double par[])
{
  return par[PAR_ZB_SHARED] != 0. || par[PAR_R_MOVES] != 0. || par[PAR_HEADING] != 0. || par[PAR_I_P] != 0.
         || par[PAR_N12_OUT] != 0.;
}

/* Those of the doubts. */
static inline void mlg_slopes_of_doubts(const double par[], const double u[], const double du[],
                                        const struct mlg_pose *p, int parameters, struct mlg_slopes *E)
{
  const double weight = 0.5 * par[PAR_M_D] * par[PAR_ZB_SHARED];
  struct mlg_contact w[2];
  double ddzB[2];

  for (int i = 0; i < 2; i++) {
    w[i] = mlg_contact(par, u, p, 2. * i - 1., u[LAMBDA_L + i]);
    ddzB[i] = w[i].zB_delta * du[DDELTA] + w[i].zB_psi * du[DPSI] + w[i].ddzB;
  }
  for (int i = 0; i < 2; i++) {
    const struct mlg_sharing share = { 0.5 * (ddzB[!i] - ddzB[i]), weight * 0.5 * (w[!i].Q_delta - w[i].Q_delta),
                                       weight * 0.5 * (w[!i].Q_psi - w[i].Q_psi) };

    mlg_slopes_doubts(par, u, du, p, i, &share, parameters, E);
  }
}

/* All slopes at the states u with their rates du; those by parameters if asked for: 1,
 * without those by the doubts while none of these acts, or 2, all. */
static inline void mlg_slopes(const double par[], const double u[], const double du[],
                              int parameters, struct mlg_slopes *E)
{
  const struct mlg_pose p = mlg_pose(par, u);

  memset(E, 0, parameters ? sizeof *E : offsetof(struct mlg_slopes, parameter));
  mlg_slopes_body(par, u, du, &p, parameters, E);
  for (int wheel = 0; wheel < 2; wheel++)
    mlg_slopes_wheel(par, u, du, &p, wheel, parameters, E);
  if (parameters > 1 || mlg_doubted(par))
    mlg_slopes_of_doubts(par, u, du, &p, parameters, E);
}

#endif"""

STATES = {delta: 'DELTA', ddelta: 'DDELTA', psi: 'PSI', dpsi: 'DPSI'}
LOCAL = {**{x: f'u[{slot}]' for x, slot in STATES.items()},
         dddelta: 'du[DDELTA]', ddpsi: 'du[DPSI]', lam: 'u[LAMBDA_L + wheel]',
         **{par[name]: f'par[{slot}]' for name, slot in PARAMETERS.items()},
         side: '2. * wheel - 1.'}
# what struct mlg_pose has
POSE = {f: symbols(name) for f, name in {
    s: 's', c: 'c', sin(delta): 'sin_delta', cos(delta): 'cos_delta', sin(psi): 'sin_psi',
    cos(psi): 'cos_psi', sin(theta): 'sin_theta', cos(theta): 'cos_theta'}.items()}
LOCAL.update({x: f'p->{x}' for x in [*POSE.values(), mu]})
share_z, share_delta, share_psi = symbols('share_z share_delta share_psi')
LOCAL.update({share_z: 'share->z', share_delta: 'share->delta', share_psi: 'share->psi'})


class Printer(C11CodePrinter):
    """Small powers as products"""

    def _print_Pow(self, expr):
        base, exponent = expr.args
        if exponent.is_Integer and 2 <= abs(exponent) <= 4:
            factor = self.parenthesize(base, PRECEDENCE['Mul'] + 1)
            product = '*'.join([factor] * abs(exponent))
            return product if exponent > 0 else f'1.0/({product})'
        if exponent == Rational(-1, 2):
            return f'1.0/sqrt({self._print(base)})'
        return super()._print_Pow(expr)

    def _print_Mul(self, expr):
        below = [x for x in expr.args if x.is_Pow and x.exp.is_Integer and x.exp < -1]
        if not below:
            return super()._print_Mul(expr)
        above = self.parenthesize(expr.func(*(x for x in expr.args if x not in below)), PRECEDENCE['Mul'])
        return '*'.join([above, *(self._print_Pow(x) for x in below)])

    def _print_Pi(self, expr):
        return 'MLG_PI'


PRINTER = Printer({'math_macros': {}})


def c_assignment(left, value):
    return textwrap.fill(f'{left} {PRINTER.doprint(value)};', 100, initial_indent='  ',
                         subsequent_indent='      ', break_long_words=False, break_on_hyphens=False)


def c_function(name, comment, gear, rows, steps, argument='', more=None):
    """C that adds d(row)/d(input) of each of rows {slot: expression} to E. The
    inputs are states, accelerations and the parameters gear. Of the steps {symbol:
    expression} to the rows the slopes are carried through. more: {(slot, input):
    what comes to that slope}."""
    places = {**{x: f'state[{slot}]' for x, slot in STATES.items()}, lam: 'state[LAMBDA_L + wheel]',
              **{x: str(x) for x in (dddelta, ddpsi)},
              **{x: f'parameter[{PARAMETERS[str(x)]}]' for x in gear}}
    known, slope = [], {}
    for x in steps:
        for y in places:
            value = diff(steps[x], y) + sum(diff(steps[x], z) * slope.get((z, y), 0) for z in steps)
            if value != 0:
                slope[x, y] = symbols(f'{x}_{y}')
                known.append((slope[x, y], value))
    targets = []
    for y in places:
        for slot, row in rows.items():
            value = diff(row, y) + sum(diff(row, x) * slope.get((x, y), 0) for x in steps)
            value += (more or {}).get((slot, y), 0)
            if value != 0:
                targets.append((f'E->{places[y]}[{slot}] +=', y in gear, value))

    given = {x: value for x, value in [*steps.items(), *known] if x not in LOCAL}
    named = list(given)
    found, reduced = sympy.cse([value.xreplace(POSE) for value in
                                [*given.values(), *(value for *_, value in targets)]],
                               symbols=sympy.numbered_symbols('t', real=True), optimizations='basic')
    definition = {**dict(found), **dict(zip(named, reduced))}
    out = [(left, late, value) for (left, late, _), value in zip(targets, reduced[len(named):])]

    lines, done = [], set()

    def define(value):
        for x in sorted(value.free_symbols, key=str):
            if x in done:
                continue
            done.add(x)
            if x in definition:
                define(definition[x])
                lines.append(c_assignment(f'const double {x} =', definition[x]))
            else:
                lines.append(f'  const double {x} = {LOCAL[x]};')

    for late in False, True:
        if late:
            lines.append('\n  if (!parameters)\n    return;')
        for _, is_late, value in out:
            if is_late == late:
                define(value)
        lines += [c_assignment(left, value) for left, is_late, value in out if is_late == late]
    return FUNCTION.format(name=name, comment=comment, argument=argument, body='\n'.join(lines))


def tidy(expression):
    """sums of squares of sine and cosine out"""
    ones = {sin(x)**2: 1 - cos(x)**2 for x in (par['phi'], delta, psi)}
    return sympy.expand(sympy.expand(expression).subs(ones))


DOUBTS = [par[name] for name in ('zB_shared', 'R_moves', 'heading', 'I_p', 'N12_out')]


def undoubted(expression):
    return expression.subs({x: 0 for x in DOUBTS})


def sharing():
    """What the doubts but heading add to a wheel's rows. Sharing zB'' makes each row
    depend on both wheels, by factor (mean zB'' - own zB'') Q of each: share_z is that
    difference, share_delta and share_psi factor (mean Q - own Q), as numbers."""
    spin = [(row - row.subs(par['I_p'], 0)) / 2 for row in map(tidy, body())]
    load = par['m_D'] * (par['R_moves'] * ddzB_R + par['zB_shared'] * share_z + ddzB_out) / 2
    mean = [diff(tidy(whole), ddzB) * par['R_moves'] * ddzB_R / 2 for whole in body()]
    return [row + whole + ddzB_own * share + half
            for row, whole, share, half in zip(wheel(load), mean, (share_delta, share_psi), spin)]


def used(parameters, *expressions):
    free = set().union(*(x.free_symbols for x in expressions))
    return [x for x in parameters if x in free]


def header():
    whole = [tidy(row) for row in body()]
    strut = [undoubted(row) for row in whole]
    # zB'' is the mean of the two wheels'
    share = [row + diff(both, ddzB) * ddzB_i / 2 for row, both in zip(wheel(), strut)]
    strut = [row.subs(ddzB, 0) for row in strut]
    string = undoubted(stretched_string())
    shown = [x for x in WHEEL if x not in (ddzB_held, ddzB_R, ddzB_own)]
    steps = {**{x: undoubted(WHEEL[x]) for x in shown},
             ddzB_i: WHEEL[ddzB_held], F_z: undoubted(LOAD[F_z])}
    gear = used(par.values(), *strut, *share, string, *steps.values())

    rows = ['E_DELTA', 'E_PSI', 'E_LAMBDA_L + wheel']
    shared = [*sharing(), stretched_string() - string]
    in_steps = {**steps, **WHEEL}
    # heading turns theta in what there is without doubts
    turned = {(slot, y): diff(row, theta) * diff(bent, y)
              for slot, row in zip(rows, [*wheel(), string]) for y in (delta, par['phi'], par['heading'])}
    gear_or_doubt = used(par.values(), *strut, *share, string, *steps.values(), *DOUBTS)

    print(HEAD.format(sympy=sympy.__version__, slots='\n'.join(f'  case {PARAMETERS[str(x)]}:' for x in gear_or_doubt))
          + c_function('mlg_slopes_body', 'The strut and the bending part, without ground contact.', gear,
                       dict(zip(rows, strut)), {})
          + c_function('mlg_slopes_wheel', 'One wheel, 0 left, 1 right.', gear,
                       dict(zip(rows, [*share, string])), steps, 'int wheel, ')
          + c_function('mlg_slopes_doubts', 'What the doubts add at one wheel.', gear_or_doubt,
                       dict(zip(rows, shared)), in_steps,
                       'int wheel, const struct mlg_sharing *share, ', turned)
          + TAIL)


if __name__ == '__main__':
    if len(sys.argv) > 1:
        print('usage: python3 models/derive.py > models/jacobian.h', file=sys.stderr)
        sys.exit(2)
    header()
