#!/usr/bin/env python3
"""derivation.py - the right-hand sides in C against a symbolic derivation

    tests/derivation.py [short]

The gear is that of models/derive.py: Lagrange's equation from energies, forces and
contact. The devices are written here, as the laws of their springs, dampers and
inerters. At random states and parameters the rates that the C code gives are put
into these equations; what remains is compared with the sum of their terms' sizes.

Prints what,unit,ours,oracle,tolerance, one row for each group of equations of each
layout in the library: ours is the largest remainder of 2000 samples, with the word
short of 200; oracle is 0.

Needs   sympy, numpy; build/lib/libmlg.so (make libmlg)
Exit    0 all rows printed, 1 no library, 2 wrong use. A layout whose device is not
        among DEVICES is named on standard error and gets no rows.
"""
import ctypes
import sys
from pathlib import Path

import numpy
import sympy

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / 'models'))
import derive  # noqa: E402
from derive import T_d, par, psi  # noqa: E402

TOLERANCE = 1e-11

# ---- devices -------------------------------------------------------------------
# Two lists for each: what gives T_d and the twists tau, sigma of k_psi, k_s from the
# states, and the laws that hold then. rate(x) is x'.

k_psi, k_s, k_d, c_d, b = (par[name] for name in ('k_psi', 'k_s', 'k_d', 'c_d', 'b'))
tau, sigma, eps, deps, chi, dchi = derive.symbols('tau sigma eps deps chi dchi')


def rate(state):
    return derive.symbols(f'{state}_rate')


DEVICES = {
    'l1': ([T_d - k_psi * tau, psi - tau - eps],
           [T_d - k_d * eps - c_d * rate(eps)]),
    'l2': ([T_d - k_psi * tau, T_d - k_s * sigma, psi - tau - sigma - eps],
           [T_d - k_d * eps - c_d * rate(eps)]),
    'li1': ([T_d - k_psi * tau, T_d - k_s * sigma, psi - tau - sigma - eps],
            [T_d - k_d * eps - c_d * deps - b * rate(deps), rate(eps) - deps]),
    'li2': ([T_d - k_psi * tau, psi - tau - eps - chi],
            [T_d - k_d * eps - c_d * rate(eps), T_d - k_s * chi - b * rate(dchi), rate(chi) - dchi]),
    'li3': ([T_d - k_psi * tau, psi - tau - chi, chi - sigma - eps],
            [T_d - b * rate(dchi) - k_s * sigma, k_s * sigma - k_d * eps - c_d * rate(eps),
             rate(chi) - dchi]),
    'li4': ([T_d - k_psi * tau, psi - tau - eps - chi],
            [T_d - k_d * (eps + chi) - c_d * rate(eps), c_d * rate(eps) - k_s * chi - b * rate(dchi),
             rate(chi) - dchi]),
    'li5': ([T_d - k_psi * tau, T_d - k_d * (sigma + eps) - k_s * sigma, psi - tau - sigma - eps],
            [k_s * sigma - c_d * deps - b * rate(deps), rate(eps) - deps]),
    'li6': ([T_d - k_psi * tau, T_d - k_d * (sigma + eps) - k_s * sigma, psi - tau - sigma - eps],
            [k_s * sigma - c_d * (rate(eps) - dchi), k_s * sigma - b * rate(dchi)]),
    'li7': ([T_d - k_psi * tau, psi - tau - chi, chi - sigma - eps],
            [T_d - b * rate(dchi) - k_d * chi - k_s * sigma, k_s * sigma - c_d * rate(eps),
             rate(chi) - dchi]),
}


# ---- the C code ------------------------------------------------------------------

class Quantity(ctypes.Structure):
    _fields_ = [(name, ctypes.c_char_p) for name in ('name', 'unit', 'meaning')]


def library():
    try:
        lib = ctypes.CDLL(str(ROOT / 'build/lib/libmlg.so'))
    except OSError as error:
        sys.exit(f'derivation.py: {error}; make libmlg builds it')
    lib.libmlg_layout_name.restype = ctypes.c_char_p
    lib.libmlg_default.restype = ctypes.c_double
    for quantity in lib.libmlg_state_quantity, lib.libmlg_parameter_quantity:
        quantity.restype = ctypes.POINTER(Quantity)
    return lib


def names(quantity, count, *layout):
    return [quantity(*layout, i)[0].name.decode() for i in range(count)]


def rates(lib, layout, parameters, states):
    """f of each sample, a column each"""
    vector = numpy.ctypeslib.ndpointer(dtype=float, flags='C')
    lib.libmlg_rhs.argtypes = [ctypes.c_int, vector, vector, vector]
    f = numpy.empty_like(states.T, order='C')
    for p, u, df in zip(parameters.T.copy(), states.T.copy(), f):
        lib.libmlg_rhs(layout, p, u, df)
    return f.T


# ---- random states and parameters ------------------------------------------------

# rad, rad/s, m: large angles, tyres on both sides of alpha_m
STATE_SIZE = {'delta': 0.5, 'ddelta': 5, 'psi': 1, 'dpsi': 10, 'lambda_L': 0.08, 'lambda_R': 0.08}
DEVICE_SIZE = 0.5  # of the device's states
PARAMETER_DECADES = {'c_d': (1, 6), 'k_s': (4, 7), 'b': (0, 3)}
PARAMETER_RANGE = {'V': (0, 200), 'phi': (-0.3, 0.3), 'I_p': (0, 20),
                   **{name: (0, 1) for name in ('zB_shared', 'R_moves', 'heading', 'N12_out')}}


def random_parameter(random, name, default, samples):
    """the doubts (0 by default) in every second sample only"""
    if name in map(str, derive.DOUBTS):
        return random.uniform(*PARAMETER_RANGE[name], samples) * (numpy.arange(samples) % 2)
    if name in PARAMETER_DECADES:
        return 10 ** random.uniform(*PARAMETER_DECADES[name], samples)
    return random.uniform(*PARAMETER_RANGE.get(name, (0.7 * default, 1.3 * default)), samples)


# ---- remainders --------------------------------------------------------------------

def value(expression, at):
    arguments = sorted(expression.free_symbols, key=str)
    return sympy.lambdify(arguments, expression)(*(at[str(x)] for x in arguments))


def size(expression, at):
    return sum(abs(value(term, at)) for term in sympy.Add.make_args(expression))


def remainder(parts):
    """Largest |sum| over the sum of the terms' sizes, of [(expression, values)]"""
    total = sum(value(expression, at) for expression, at in parts)
    return numpy.max(abs(total) / sum(size(expression, at) for expression, at in parts))


def wheels(at):
    """The values at each wheel, with those of derive.WHEEL and LOAD; and with the mean
    zB'' of both, in at as well"""
    both = []
    for side, tyre in (-1, 'lambda_L'), (1, 'lambda_R'):
        here = {**at, 'side': side, 'lambda': at[tyre], 'lambda_rate': at[f'{tyre}_rate']}
        for x, expression in derive.WHEEL.items():
            here[str(x)] = value(expression, here)
        both.append(here)
    at['ddzB'] = sum(here['ddzB_own'] for here in both) / 2
    for here in both:
        here['ddzB'] = at['ddzB']
        for x, expression in derive.LOAD.items():
            here[str(x)] = value(expression, here)
    return both


def remainders(device, at):
    """{group of equations: largest remainder}"""
    in_series, laws = device
    unknown = {T_d, tau, sigma} & set().union(*(law.free_symbols for law in in_series))
    at = {**at, 'dddelta': at['ddelta_rate'], 'ddpsi': at['dpsi_rate'],
          **{str(x): value(found, at)
             for x, found in sympy.solve(in_series, unknown, dict=True)[0].items()}}
    wheel = wheels(at)
    at['dzB'] = sum(value(derive.rate(derive.contact[2]), here) for here in wheel) / 2
    motion = {q: [(strut, at), *((share, here) for here in wheel)]
              for q, strut, share in zip(derive.coordinates, derive.body(), derive.wheel())}
    tyre = rate(derive.lam) - derive.stretched_string()
    return {
        'motion of delta (32)': remainder(motion[derive.delta]),
        'motion of psi (33)': remainder(motion[psi]),
        'tyres (31)': max(remainder([(tyre, here)]) for here in wheel),
        'device': max(remainder([(law, at)]) for law in laws),
        'rates of the angles': max(remainder([(rate(q) - dq, at)])
                                   for q, dq in derive.coordinates.items()),
    }


def main(words):
    if words not in ([], ['short']):
        print('usage: tests/derivation.py [short]', file=sys.stderr)
        return 2
    lib = library()
    samples = 200 if words else 2000
    random = numpy.random.default_rng(20170408)
    parameter_names = names(lib.libmlg_parameter_quantity, lib.libmlg_parameters())
    for layout in range(lib.libmlg_layouts()):
        name = lib.libmlg_layout_name(layout).decode()
        if name not in DEVICES:
            print(f'derivation.py: left out {name}, whose device is not in DEVICES', file=sys.stderr)
            continue
        state_names = names(lib.libmlg_state_quantity, lib.libmlg_states(layout), layout)
        p = numpy.array([random_parameter(random, x, lib.libmlg_default(i), samples)
                         for i, x in enumerate(parameter_names)])
        u = numpy.array([STATE_SIZE.get(x, DEVICE_SIZE) * random.uniform(-1, 1, samples)
                         for x in state_names])
        at = {**dict(zip(parameter_names, p)), **dict(zip(state_names, u)),
              **{f'{x}_rate': f for x, f in zip(state_names, rates(lib, layout, p, u))}}
        for group, largest in remainders(DEVICES[name], at).items():
            print(f'{name}: {group},of its terms,{largest:.1e},0,{TOLERANCE:g}')
    return 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
