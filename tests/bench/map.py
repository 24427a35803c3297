"""map.py - number of unstable pairs of straight rolling, layout L1, with numpy

  map.py V_N C_D_N

The grid and the output of eigen-l1 map (tests/eigen.c), as one would write it in
Python: the matrix of the linearised equations (docs/model.md, closed form) for
the whole grid at once, numpy.linalg.eigvals on the stack.  make bench compares.
"""
import sys
import numpy as np

V_n, c_d_n = int(sys.argv[1]), int(sys.argv[2])
a, e, l_delta, l_D, m_D, J_xi, J_zeta = 0.5, 0.12, 0.75, 0.72, 500.0, 200.0, 100.0
phi, h, k_t, k_alpha, k_lambda, l, R, g = np.pi / 60, 0.1, 7e5, 1.0, 0.002, 0.3, 0.362, 9.81
k_d, k_psi, c_psi, k_delta, c_delta, F = 1.09e5, 3.8e5, 300.0, 6.1e6, 300.0, 200e3
s, c = np.sin(phi), np.cos(phi)
e_t, L, m, kappa = e + R * s, l_delta + R * c, a * a * m_D / 4, a * a * k_t / 2
mass = np.array([[J_xi + m_D * l_D**2 + m * c * c, m * c * s], [m * c * s, J_zeta + m * s * s]])
stiffness = np.array([[k_delta - F * L * c + kappa * c * c + m_D * g * l_D * c, -F * e_t * c + kappa * c * s],
                      [-F * e_t * c + kappa * c * s, -F * e_t * s + kappa * s * s + k_psi]])
D = F * np.array([7 * k_lambda * L - k_alpha * s, 7 * k_lambda * e_t + k_alpha * c]) / l
inverse = np.linalg.inv(mass)

V, c_d = np.meshgrid(np.linspace(0.5, 200, V_n), np.linspace(250, 1e5, c_d_n))
A = np.zeros(V.shape + (6, 6))  # delta, psi, their rates, lambda_L = lambda_R, eps
A[..., 0, 2] = A[..., 1, 3] = 1
A[..., 2:4, 0:2] = -inverse @ stiffness
A[..., 2:4, 2:4] = -inverse @ np.diag([c_delta, c_psi])
A[..., 2:4, 4] = -inverse @ D
A[..., 2:4, 5] = inverse @ np.array([0, k_psi])
A[..., 4, 1] = V * c
A[..., 4, 2] = L
A[..., 4, 3] = e_t - h * c
A[..., 4, 4] = -V / l
A[..., 5, 1] = k_psi / c_d
A[..., 5, 5] = -(k_psi + k_d) / c_d
values = np.linalg.eigvals(A)
pairs = np.sum((values.real > 0) & (values.imag > 0), axis=-1)
print("V,c_d,unstable_pairs")
for row in zip(V.ravel(), c_d.ravel(), pairs.ravel()):
    print("%.10g,%.10g,%d" % row)
