"""An example of libmlg from Python, by ctypes alone: parameters, states and rates.

    python3 rhs.py LIBMLG.so

Prints every parameter with its unit and default, then at the defaults, V = 20 m/s
and psi = 1 degree the rate of each state of layout L1.
"""
import ctypes
import math
import sys


class Quantity(ctypes.Structure):
    _fields_ = [(field, ctypes.c_char_p) for field in ('name', 'unit', 'meaning')]

    def __str__(self):
        return f'{self.name.decode():10} {self.unit.decode():12}'


lib = ctypes.CDLL(sys.argv[1])
lib.libmlg_parameter_quantity.restype = ctypes.POINTER(Quantity)
lib.libmlg_state_quantity.restype = ctypes.POINTER(Quantity)
lib.libmlg_default.restype = ctypes.c_double

# arrays of C's doubles, of the length the library names
par = (ctypes.c_double * lib.libmlg_parameters())()
lib.libmlg_defaults(par)
for i in range(len(par)):
    print(lib.libmlg_parameter_quantity(i).contents, f'{par[i]:.6g}')

layout = lib.libmlg_layout(b'l1')
u = (ctypes.c_double * lib.libmlg_states(layout))()
f = (ctypes.c_double * len(u))()
par[lib.libmlg_parameter(b'V')] = 20.0
u[lib.libmlg_state(layout, b'psi')] = math.radians(1)
assert lib.libmlg_outside(par) == -1, 'a parameter is outside its range'
lib.libmlg_rhs(layout, par, u, f)
for i in range(len(u)):
    print(lib.libmlg_state_quantity(layout, i).contents, f'{f[i]:.9g}')
