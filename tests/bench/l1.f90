! l1.f90 - layout L1 as an AUTO user would write it: one Fortran equation file
!
! The same model as models/mlg.h with models/l1.c (docs/model.md), written for
! make bench to compare with: parameters fixed but for V and c_d, derivatives by
! AUTO.  PAR(1) V, PAR(2) c_d; PAR(33) maximum of psi over the period, degrees.

subroutine func(ndim, u, icp, par, ijac, f, dfdu, dfdp)
  implicit none
  integer, intent(in) :: ndim, icp(*), ijac
  double precision, intent(in) :: u(ndim), par(*)
  double precision, intent(out) :: f(ndim)
  double precision, intent(inout) :: dfdu(ndim, ndim), dfdp(ndim, *)
  double precision, parameter :: pi = 3.14159265358979323846d0
  double precision, parameter :: a = 0.5d0, e = 0.12d0, l_delta = 0.75d0, l_D = 0.72d0
  double precision, parameter :: m_D = 500d0, J_xi = 200d0, J_eta = 250d0, J_zeta = 100d0
  double precision, parameter :: phi = pi/60d0, h = 0.1d0, k_t = 7d5, k_alpha = 1d0
  double precision, parameter :: k_lambda = 0.002d0, l = 0.3d0, R = 0.362d0, alpha_m = 0.1745d0
  double precision, parameter :: g = 9.81d0, M = 2d5/9.81d0 - 500d0, k_d = 1.09d5, k_psi = 3.8d5
  double precision, parameter :: c_psi = 300d0, k_delta = 6.1d6, c_delta = 300d0
  double precision, parameter :: s = sin(phi), c = cos(phi)
  double precision :: V, c_d, delta, ddelta, psi, dpsi, eps, T_d, sd, cd, sp, cp, theta, st, ct
  double precision :: dtheta, mu, J, N12, M11, M12, M21, M22, b1, b2, det, side, lambda, dev, R_i
  double precision :: X, Y, Z, P, Q, xd, yd, zd, xp, yp, zp, ddz, F0, Fd, Fp, t, alpha, restoring
  double precision :: aligning, Qd, Qp, vX(2), vY(2)
  integer :: i

  V = par(1); c_d = par(2)
  delta = u(1); ddelta = u(2); psi = u(3); dpsi = u(4); eps = u(7)
  T_d = k_psi*(psi - eps)
  sd = sin(delta); cd = cos(delta); sp = sin(psi); cp = cos(psi)
  theta = psi*c*cd; st = sin(theta); ct = cos(theta)
  dtheta = c*(dpsi*cd - psi*sd*ddelta)
  mu = asin(s*sp + c*sd*cp)
  J = J_xi - J_eta
  N12 = m_D*l_D*c*sd
  M11 = J_eta + J*cp*cp + m_D*l_D*l_D; M12 = 0; M21 = 0; M22 = J_zeta
  b1 = 2*J*cp*sp*ddelta*dpsi - c_delta*ddelta - k_delta*delta - l_D*m_D*g*sd*c
  b2 = -J*cp*sp*ddelta*ddelta - c_psi*dpsi - T_d
  do i = 1, 2
    side = 2*i - 3; lambda = u(4 + i)
    dev = side*a*mu/2; R_i = R - 0.2d0*dev
    X = -(e + R_i*s); Y = side*a/2; Z = l_delta + R_i*c
    P = X*sp + Y*cp; Q = X*cp - Y*sp
    xd = s*(P*cd - Z*sd); yd = -P*sd - Z*cd; zd = c*(P*cd - Z*sd)
    xp = Q*s*sd - P*c; yp = Q*cd; zp = Q*c*sd + P*s
    ddz = -c*(P*sd + Z*cd)*ddelta**2 + 2*c*Q*cd*ddelta*dpsi + (Q*s - P*c*sd)*dpsi**2
    F0 = 0.5d0*(side*a*mu*k_t + m_D*ddz + m_D*l_D*c*cd*ddelta**2 + (m_D + M)*g)
    Fd = 0.5d0*m_D*(zd + l_D*c*sd)
    Fp = 0.5d0*m_D*zp
    t = atan(7*lambda/l); restoring = k_lambda*t*cos(0.95d0*t)
    alpha = atan(lambda/l); aligning = 0
    if (abs(alpha) <= alpha_m) aligning = k_alpha*alpha_m/pi*sin(alpha*pi/alpha_m)
    Qd = restoring*(st*xd - ct*yd) + zd - aligning*s
    Qp = restoring*(st*xp - ct*yp) + zp + aligning*c*cd
    M11 = M11 + 0.5d0*N12*zd + Fd*Qd; M12 = M12 + 0.5d0*N12*zp + Fp*Qd
    M21 = M21 + Fd*Qp; M22 = M22 + Fp*Qp
    b1 = b1 - 0.5d0*N12*ddz - F0*Qd; b2 = b2 - F0*Qp
    vX(i) = V + xd*ddelta + xp*dpsi; vY(i) = yd*ddelta + yp*dpsi
  end do
  det = M11*M22 - M12*M21
  f(1) = ddelta; f(2) = (M22*b1 - M12*b2)/det
  f(3) = dpsi; f(4) = (M11*b2 - M21*b1)/det
  do i = 1, 2
    lambda = u(4 + i)
    f(4 + i) = vX(i)*(st - lambda/l*ct) - vY(i)*(ct + lambda/l*st) - (h - lambda**2/l)*dtheta
  end do
  f(7) = (T_d - k_d*eps)/c_d
end subroutine func

subroutine stpnt(ndim, u, par, t)
  implicit none
  integer, intent(in) :: ndim
  double precision, intent(inout) :: u(ndim), par(*)
  double precision, intent(in) :: t

  u = 0; par(1) = 1; par(2) = 3.6d4
end subroutine stpnt

subroutine pvls(ndim, u, par)
  implicit none
  integer, intent(in) :: ndim
  double precision, intent(in) :: u(ndim)
  double precision, intent(inout) :: par(*)
  double precision, external :: getp

  par(33) = getp('MAX', 3, u)*180/3.14159265358979323846d0
end subroutine pvls

subroutine bcnd
end subroutine bcnd

subroutine icnd
end subroutine icnd

subroutine fopt
end subroutine fopt
