/* jacobian.h - derivatives of the gear's equations; do not edit
 *
 * Made by models/derive.py with sympy 1.11.1.  After a change of the equations in
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

enum mlg_equation { E_DELTA, E_PSI, E_LAMBDA_L, E_LAMBDA_R, MLG_EQUATIONS };

/* Whether the gear depends on par[slot]; devices depend on the others. */
static inline int mlg_of_gear(int slot)
{
  switch (slot) {
  case PAR_V:
  case PAR_C_PSI:
  case PAR_K_DELTA:
  case PAR_C_DELTA:
  case PAR_A:
  case PAR_E:
  case PAR_L_DELTA:
  case PAR_L_D:
  case PAR_M_D:
  case PAR_J_XI:
  case PAR_J_ETA:
  case PAR_J_ZETA:
  case PAR_PHI:
  case PAR_H:
  case PAR_K_T:
  case PAR_K_ALPHA:
  case PAR_K_LAMBDA:
  case PAR_L:
  case PAR_R:
  case PAR_ALPHA_M:
  case PAR_G:
  case PAR_M:
  case PAR_ZB_SHARED:
  case PAR_R_MOVES:
  case PAR_HEADING:
  case PAR_I_P:
  case PAR_N12_OUT:
    return 1;
  default:
    return 0;
  }
}

/* E by the accelerations, the states, and the parameters of the gear. */
struct mlg_slopes {
  double dddelta[MLG_EQUATIONS], ddpsi[MLG_EQUATIONS];
  double state[GEAR_STATES][MLG_EQUATIONS];
  double parameter[MLG_SLOTS][MLG_EQUATIONS];
};

/* How a shared zB'' ties a wheel to the other: the mean zB'' less its own, m/s^2; and the
 * mean of what zB'' has for weight in E, N s^2 and so on, less its own. */
struct mlg_sharing { double z, delta, psi; };

/* The strut and the bending part, without ground contact. */
static inline void mlg_slopes_body(const double par[], const double u[], const double du[],
    const struct mlg_pose *p, int parameters, struct mlg_slopes *E)
{
  const double c = p->c;
  const double cos_delta = p->cos_delta;
  const double k_delta = par[PAR_K_DELTA];
  const double g = par[PAR_G];
  const double l_D = par[PAR_L_D];
  const double m_D = par[PAR_M_D];
  const double t0 = l_D*m_D;
  const double t1 = g*t0;
  const double J_eta = par[PAR_J_ETA];
  const double J_xi = par[PAR_J_XI];
  const double c_delta = par[PAR_C_DELTA];
  const double dpsi = u[DPSI];
  const double cos_psi = p->cos_psi;
  const double sin_psi = p->sin_psi;
  const double t2 = cos_psi*sin_psi;
  const double t3 = 2*t2;
  const double t4 = dpsi*t3;
  const double t5 = J_eta - J_xi;
  const double ddelta = u[DDELTA];
  const double t6 = ddelta*t3;
  const double t9 = cos_psi*cos_psi;
  const double t10 = J_eta*t9;
  const double t11 = ddelta*dpsi;
  const double t12 = sin_psi*sin_psi;
  const double t13 = J_xi*t12;
  const double t14 = J_xi*t9;
  const double dddelta = du[DDELTA];
  const double t7 = cos_psi*dddelta;
  const double t8 = sin_psi*t7;
  const double t15 = ddelta*ddelta;
  const double c_psi = par[PAR_C_PSI];
  const double J_zeta = par[PAR_J_ZETA];
  E->state[DELTA][E_DELTA] += c*cos_delta*t1 + k_delta;
  E->state[DDELTA][E_DELTA] += J_eta*t4 - J_xi*t4 + c_delta;
  E->state[DDELTA][E_PSI] += -t5*t6;
  E->state[PSI][E_DELTA] += -2*J_eta*t11*t12 + 2*J_eta*t8 - 2*J_xi*t8 + 2*t10*t11 + 2*t11*t13 -
      2*t11*t14;
  E->state[PSI][E_PSI] += t15*(J_eta*t12 + J_xi*t9 - t10 - t13);
  E->state[DPSI][E_DELTA] += t5*t6;
  E->state[DPSI][E_PSI] += c_psi;
  E->dddelta[E_DELTA] += J_eta + l_D*l_D*m_D - t10 + t14;
  E->ddpsi[E_PSI] += J_zeta;

  if (!parameters)
    return;
  const double delta = u[DELTA];
  const double t16 = dddelta*l_D;
  const double sin_delta = p->sin_delta;
  const double t17 = c*sin_delta;
  const double t18 = g*t17;
  const double t19 = 2*t11;
  const double t20 = t15*t2;
  const double ddpsi = du[DPSI];
  const double s = p->s;
  E->parameter[PAR_C_PSI][E_PSI] += dpsi;
  E->parameter[PAR_K_DELTA][E_DELTA] += delta;
  E->parameter[PAR_C_DELTA][E_DELTA] += ddelta;
  E->parameter[PAR_L_D][E_DELTA] += m_D*(2*t16 + t18);
  E->parameter[PAR_M_D][E_DELTA] += l_D*(t16 + t18);
  E->parameter[PAR_J_XI][E_DELTA] += cos_psi*(-sin_psi*t19 + t7);
  E->parameter[PAR_J_XI][E_PSI] += t20;
  E->parameter[PAR_J_ETA][E_DELTA] += -dddelta*t9 + dddelta + t19*t2;
  E->parameter[PAR_J_ETA][E_PSI] += -t20;
  E->parameter[PAR_J_ZETA][E_PSI] += ddpsi;
  E->parameter[PAR_PHI][E_DELTA] += -s*sin_delta*t1;
  E->parameter[PAR_G][E_DELTA] += t0*t17;
}

/* One wheel, 0 left, 1 right. */
static inline void mlg_slopes_wheel(const double par[], const double u[], const double du[],
    const struct mlg_pose *p, int wheel, int parameters, struct mlg_slopes *E)
{
  const double a = par[PAR_A];
  const double g = par[PAR_G];
  const double m_D = par[PAR_M_D];
  const double M = par[PAR_M];
  const double t35 = M + m_D;
  const double k_t = par[PAR_K_T];
  const double mu = p->mu;
  const double side = 2. * wheel - 1.;
  const double t0 = mu*side;
  const double t36 = k_t*t0;
  const double dddelta = du[DDELTA];
  const double ddpsi = du[DPSI];
  const double dpsi = u[DPSI];
  const double c = p->c;
  const double l_delta = par[PAR_L_DELTA];
  const double R = par[PAR_R];
  const double t1 = (1.0/10.0)*t0;
  const double R_i = R - a*t1;
  const double t5 = R_i*c;
  const double Z = l_delta + t5;
  const double sin_delta = p->sin_delta;
  const double cos_delta = p->cos_delta;
  const double e = par[PAR_E];
  const double s = p->s;
  const double t2 = R_i*s;
  const double X = -e - t2;
  const double t3 = (1.0/2.0)*side;
  const double t4 = a*t3;
  const double Y = t4;
  const double cos_psi = p->cos_psi;
  const double sin_psi = p->sin_psi;
  const double t18 = X*sin_psi + Y*cos_psi;
  const double t19 = cos_delta*t18;
  const double t20 = Z*sin_delta - t19;
  const double t21 = c*t20;
  const double t22 = s*t18;
  const double t23 = X*cos_psi - Y*sin_psi;
  const double t24 = c*sin_delta;
  const double t25 = t22 + t23*t24;
  const double ddelta = u[DDELTA];
  const double t26 = cos_delta*dpsi;
  const double t27 = sin_delta*t18;
  const double t28 = Z*cos_delta + t27;
  const double t29 = -ddelta*t28 + t23*t26;
  const double t30 = c*ddelta;
  const double t6 = c*cos_delta;
  const double t31 = t23*t6;
  const double t32 = s*t23;
  const double t33 = c*t27 - t32;
  const double t34 = ddelta*t31 - dpsi*t33;
  const double ddzB_i = -dddelta*t21 + ddpsi*t25 + dpsi*t34 + t29*t30;
  const double t37 = dddelta*sin_delta;
  const double l_D = par[PAR_L_D];
  const double t38 = c*l_D;
  const double t39 = ddelta*ddelta;
  const double t40 = l_D*t6;
  const double t41 = ddzB_i + t37*t38 + t39*t40;
  const double F_z = (1.0/2.0)*a*t36 + (1.0/2.0)*g*t35 + (1.0/2.0)*m_D*t41;
  const double t42 = s*sin_psi;
  const double t43 = cos_psi*t24 + t42;
  const double t44 = 1.0/sqrt(1 - t43*t43);
  const double t45 = cos_psi*t6;
  const double mu_delta = t44*t45;
  const double t72 = cos_delta*dddelta;
  const double t51 = a*side;
  const double t52 = (1.0/10.0)*t51;
  const double R_i_delta = -mu_delta*t52;
  const double X_delta = -R_i_delta*s;
  const double Z_delta = R_i_delta*c;
  const double t64 = cos_delta*t39 + t37;
  const double t65 = c*t64;
  const double t66 = c*t28;
  const double t67 = ddelta*sin_delta;
  const double t68 = dpsi*t19 + t23*t67;
  const double t69 = dpsi*sin_delta;
  const double t70 = ddelta*t20;
  const double t71 = -t23*t69 + t70;
  const double t47 = c*sin_psi;
  const double t46 = cos_psi*s;
  const double t48 = sin_delta*t47;
  const double t49 = -t46 + t48;
  const double t73 = cos_psi*t26 - sin_psi*t67;
  const double t74 = ddpsi*t43 + dpsi*(ddelta*t45 - dpsi*t49) + t30*t73 + t47*t72;
  const double ddzB_i_delta = X_delta*t74 - Z_delta*t65 - c*dpsi*t68 - dddelta*t66 + ddpsi*t31 +
      t30*t71;
  const double t82 = ddzB_i_delta*m_D;
  const double t83 = k_t*t51;
  const double F_z_delta = (1.0/2.0)*m_D*t38*(-sin_delta*t39 + t72) + (1.0/2.0)*mu_delta*t83 +
      (1.0/2.0)*t82;
  const double k_lambda = par[PAR_K_LAMBDA];
  const double lambda = u[LAMBDA_L + wheel];
  const double l = par[PAR_L];
  const double t7 = 1.0/l;
  const double t8 = lambda*t7;
  const double T = atan(7*t8);
  const double t9 = (19.0/20.0)*T;
  const double t10 = cos(t9);
  const double t11 = T*t10;
  const double Lambda = k_lambda*t11;
  const double t100 = s*sin_delta;
  const double sin_theta = p->sin_theta;
  const double t94 = Lambda*sin_theta;
  const double cos_theta = p->cos_theta;
  const double t92 = Lambda*cos_theta;
  const double t99 = cos_delta*t92;
  const double t101 = F_z*(t100*t94 + t24 - t99);
  const double t102 = sin_theta*t28;
  const double t103 = -t20;
  const double t104 = s*t103;
  const double t105 = cos_theta*t104 - t102;
  const double t106 = F_z*Lambda;
  const double psi = u[PSI];
  const double t53 = psi*t24;
  const double theta_delta = -t53;
  const double t107 = t106*theta_delta;
  const double alpha = atan(t8);
  const double alpha_m = par[PAR_ALPHA_M];
  const double grip = ((alpha_m >= fabs(alpha)) ? (    1 ) : (    0 ));
  const double k_alpha = par[PAR_K_ALPHA];
  const double t12 = grip*k_alpha;
  const double t13 = 1.0/MLG_PI;
  const double t14 = alpha/alpha_m;
  const double t15 = MLG_PI*t14;
  const double t16 = sin(t15);
  const double t17 = alpha_m*t13*t16;
  const double C = t12*t17;
  const double t108 = cos_theta*t28;
  const double t109 = Lambda*t108;
  const double t110 = C*s - c*t103 - t104*t94 - t109;
  const double t85 = (1.0/2.0)*m_D;
  const double t90 = ddzB_i*t85;
  const double t86 = l_D*t24;
  const double t91 = (1.0/2.0)*t86;
  const double t93 = sin_delta*t92;
  const double t95 = cos_delta*t94;
  const double t96 = s*t95 + t6 + t93;
  const double t97 = F_z*t96;
  const double t98 = sin_psi*t97;
  const double t50 = -sin_delta*t46 + t47;
  const double t111 = -t50;
  const double t112 = F_z*(-cos_psi*t99 + t111*t94 + t43);
  const double t113 = cos_delta*t23;
  const double t78 = c*t18;
  const double t79 = -s*sin_delta*t23 + t78;
  const double t80 = -t79;
  const double t114 = cos_theta*t80 + sin_theta*t113;
  const double t115 = C*t6 - t23*t99 + t25;
  const double t116 = t115 + t80*t94;
  const double h = par[PAR_H];
  const double t56 = lambda*lambda;
  const double t117 = h - t56*t7;
  const double t118 = cos_theta + sin_theta*t8;
  const double t119 = cos_delta*t118;
  const double t120 = cos_theta*t8 - sin_theta;
  const double t121 = t100*t120 + t119;
  const double t122 = t120*t29;
  const double t123 = t118*t73;
  const double t124 = -t120;
  const double t77 = cos_delta*ddelta;
  const double t125 = t42*t77;
  const double t126 = t123 - t124*(dpsi*t111 + t125);
  const double t127 = -t122;
  const double V = par[PAR_V];
  const double t128 = s*t70;
  const double t129 = V + dpsi*t80 - t128;
  const double t130 = t118*t129 + t127;
  const double t54 = cos_delta*psi;
  const double ddzB_i_ddelta = 2*c*t29;
  const double F_z_ddelta = m_D*(ddelta*t40 + (1.0/2.0)*ddzB_i_ddelta);
  const double t131 = sin_theta*t79;
  const double t132 = -Lambda*t131 + t115;
  const double t133 = s*t20;
  const double mu_psi = -t44*t49;
  const double R_i_psi = -mu_psi*t52;
  const double X_psi = -R_i_psi*s;
  const double Z_psi = R_i_psi*c;
  const double t75 = dpsi*t25;
  const double ddzB_i_psi = X_psi*t74 - Z_psi*t65 + c*cos_delta*dddelta*t23 - ddpsi*t33 -
      dpsi*(t19*t30 + t75) - t30*t68;
  const double t84 = ddzB_i_psi*m_D;
  const double F_z_psi = (1.0/2.0)*mu_psi*t83 + (1.0/2.0)*t84;
  const double theta_psi = t6;
  const double t134 = t106*theta_psi;
  const double t135 = c*t23 + sin_delta*t22;
  const double t136 = ddelta*t121;
  const double t81 = t32*t77;
  const double ddzB_i_dpsi = 2*t34;
  const double F_z_dpsi = ddzB_i_dpsi*t85;
  const double t55 = 1.0/(l*l);
  const double t57 = t55*t56;
  const double t58 = 1.0/(t57 + 1);
  const double alpha_lambda = t58*t7;
  const double t62 = cos(t15);
  const double t63 = t12*t62;
  const double C_lambda = alpha_lambda*t63;
  const double t60 = 7/(49*t57 + 1);
  const double T_lambda = t60*t7;
  const double t61 = k_lambda*(-t10 + t9*sin(t9));
  const double Lambda_lambda = -T_lambda*t61;
  const double t137 = -s*sin_theta*t20 + t108;
  const double t138 = -t137;
  const double t139 = cos_theta*t113 + t131;
  const double t140 = -psi*t67 + t26;
  const double t141 = sin_theta*t29;
  const double ddzB_i_dddelta = -t21;
  const double F_z_dddelta = t85*(ddzB_i_dddelta + t86);
  const double ddzB_i_ddpsi = t25;
  const double F_z_ddpsi = ddzB_i_ddpsi*t85;
  E->state[DELTA][E_DELTA] += -F_z*(Lambda*s*t102 + t20*t92 + t66) - F_z_delta*t110 + X_delta*t98 -
      Z_delta*t101 + t105*t107 + t40*t90 + t82*t91;
  E->state[DELTA][E_PSI] += F_z*(-C*t24 + t23*t93 + t31 + t32*t95) + F_z_delta*t116 + X_delta*t112 +
      t107*t114;
  E->state[DELTA][E_LAMBDA_L + wheel] += -X_delta*t126 + Z_delta*ddelta*t121 + c*t117*(ddelta*t54 +
      t69) - s*t122 - t118*t71 + t130*theta_delta;
  E->state[DDELTA][E_DELTA] += -F_z_ddelta*t110 + (1.0/2.0)*c*ddzB_i_ddelta*l_D*m_D*sin_delta;
  E->state[DDELTA][E_PSI] += F_z_ddelta*t132;
  E->state[DDELTA][E_LAMBDA_L + wheel] += t117*t53 + t118*t28 + t120*t133;
  E->state[PSI][E_DELTA] += -F_z_psi*t110 + X_psi*t98 - Z_psi*t101 + t105*t134 + t23*t97 + t84*t91;
  E->state[PSI][E_PSI] += -F_z*(Lambda*sin_theta*t135 + c*sin_delta*t18 - t19*t92 - t32) +
      F_z_psi*t116 + X_psi*t112 + t114*t134;
  E->state[PSI][E_LAMBDA_L + wheel] += -X_psi*t126 + Z_psi*t136 + ddelta*t117*t24 + t118*t68 -
      t120*(-dpsi*t135 + t81) + t130*theta_psi;
  E->state[DPSI][E_DELTA] += -F_z_dpsi*t110 + (1.0/2.0)*c*ddzB_i_dpsi*l_D*m_D*sin_delta;
  E->state[DPSI][E_PSI] += F_z_dpsi*t132;
  E->state[DPSI][E_LAMBDA_L + wheel] += -t117*t6 - t119*t23 - t120*t80;
  E->state[LAMBDA_L + wheel][E_DELTA] += -F_z*(C_lambda*s + Lambda_lambda*t138);
  E->state[LAMBDA_L + wheel][E_PSI] += F_z*(C_lambda*t6 - Lambda_lambda*t139);
  E->state[LAMBDA_L + wheel][E_LAMBDA_L + wheel] += t7*(2*c*lambda*t140 - cos_theta*t129 - t141);
  E->dddelta[E_DELTA] += -F_z_dddelta*t110 + (1.0/2.0)*c*ddzB_i_dddelta*l_D*m_D*sin_delta;
  E->dddelta[E_PSI] += F_z_dddelta*t132;
  E->ddpsi[E_DELTA] += -F_z_ddpsi*t110 + (1.0/2.0)*c*ddzB_i_ddpsi*l_D*m_D*sin_delta;
  E->ddpsi[E_PSI] += F_z_ddpsi*t132;

  if (!parameters)
    return;
  const double R_i_a = -t1;
  const double X_a = -R_i_a*s;
  const double Y_a = t3;
  const double Z_a = R_i_a*c;
  const double t76 = cos_psi*t67 + sin_psi*t26;
  const double ddzB_i_a = X_a*t74 - Y_a*(-dddelta*t45 + ddpsi*t49 + dpsi*(dpsi*t43 + t47*t77) +
      t30*t76) - Z_a*t65;
  const double t87 = ddzB_i_a*m_D;
  const double F_z_a = (1.0/2.0)*t36 + (1.0/2.0)*t87;
  const double t142 = c*cos_psi + sin_delta*t42;
  const double X_e = -1;
  const double ddzB_i_e = X_e*t74;
  const double t88 = ddzB_i_e*t85;
  const double F_z_e = t88;
  const double t143 = C*s;
  const double t144 = -t109 + t133*t94 + t143 + t21;
  const double t145 = t120*(-dpsi*t50 + t125) + t123;
  const double Z_l_delta = 1;
  const double ddzB_i_l_delta = -Z_l_delta*t65;
  const double F_z_l_delta = ddzB_i_l_delta*t85;
  const double F_z_l_D = t65*t85;
  const double F_z_m_D = (1.0/2.0)*g + (1.0/2.0)*t41;
  const double mu_phi = t44*t50;
  const double R_i_phi = -mu_phi*t52;
  const double X_phi = -R_i_phi*s - t5;
  const double Z_phi = R_i_phi*c - t2;
  const double ddzB_i_phi = X_phi*t74 - Z_phi*t65 + dddelta*s*t20 - ddelta*s*t29 - ddpsi*t80 -
      dpsi*(-dpsi*(c*t23 + s*sin_delta*t18) + t81);
  const double F_z_phi = (1.0/2.0)*ddzB_i_phi*m_D - 1.0/2.0*l_D*m_D*s*t64 + (1.0/2.0)*mu_phi*t83;
  const double theta_phi = -s*t54;
  const double t146 = V - dpsi*t79 - t128;
  const double F_z_k_t = mu*t4;
  const double C_k_alpha = grip*t17;
  const double t147 = F_z*s;
  const double t148 = F_z*t6;
  const double Lambda_k_lambda = t11;
  const double t149 = F_z*Lambda_k_lambda;
  const double t59 = lambda*t55;
  const double alpha_l = -t58*t59;
  const double C_l = alpha_l*t63;
  const double T_l = -t59*t60;
  const double Lambda_l = -T_l*t61;
  const double R_i_R = 1;
  const double X_R = -R_i_R*s;
  const double Z_R = R_i_R*c;
  const double ddzB_i_R = X_R*t74 - Z_R*t65;
  const double t89 = ddzB_i_R*t85;
  const double F_z_R = t89;
  const double C_alpha_m = t12*(t13*t16 - t14*t62);
  const double F_z_g = (1.0/2.0)*t35;
  const double F_z_M = (1.0/2.0)*g;
  E->parameter[PAR_V][E_LAMBDA_L + wheel] += t124;
  E->parameter[PAR_A][E_DELTA] += -F_z_a*t110 + X_a*t98 + Y_a*cos_psi*t97 - Z_a*t101 + t87*t91;
  E->parameter[PAR_A][E_PSI] += F_z*Y_a*(sin_psi*t99 - t142*t94 + t46 - t48) + F_z_a*t116 +
      X_a*t112;
  E->parameter[PAR_A][E_LAMBDA_L + wheel] += -X_a*t126 + Y_a*(t118*t76 + t124*(-dpsi*t142 +
      t46*t77)) + Z_a*t136;
  E->parameter[PAR_E][E_DELTA] += -F_z_e*t144 + X_e*t98 + t86*t88;
  E->parameter[PAR_E][E_PSI] += F_z_e*t116 + X_e*t112;
  E->parameter[PAR_E][E_LAMBDA_L + wheel] += -X_e*t145;
  E->parameter[PAR_L_DELTA][E_DELTA] += -F_z_l_delta*t110 - Z_l_delta*t101 +
      (1.0/2.0)*c*ddzB_i_l_delta*l_D*m_D*sin_delta;
  E->parameter[PAR_L_DELTA][E_PSI] += F_z_l_delta*t132;
  E->parameter[PAR_L_DELTA][E_LAMBDA_L + wheel] += Z_l_delta*t136;
  E->parameter[PAR_L_D][E_DELTA] += -F_z_l_D*t110 + (1.0/2.0)*c*ddzB_i*m_D*sin_delta;
  E->parameter[PAR_L_D][E_PSI] += F_z_l_D*t132;
  E->parameter[PAR_M_D][E_DELTA] += -F_z_m_D*t110 + (1.0/2.0)*c*ddzB_i*l_D*sin_delta;
  E->parameter[PAR_M_D][E_PSI] += F_z_m_D*t132;
  E->parameter[PAR_PHI][E_DELTA] += F_z*Lambda*t105*theta_phi + F_z*X_phi*sin_psi*t96 - F_z*(C*c -
      t133 + t21*t94) - F_z_phi*t110 - Z_phi*t101 + (1.0/2.0)*c*ddzB_i_phi*l_D*m_D*sin_delta -
      l_D*t100*t90;
  E->parameter[PAR_PHI][E_PSI] += -F_z*(cos_delta*t143 + sin_delta*t32 - t25*t94 - t78) +
      F_z_phi*t116 + X_phi*t112 + t106*t114*theta_phi;
  E->parameter[PAR_PHI][E_LAMBDA_L + wheel] += -X_phi*t145 + Z_phi*t136 + s*t117*t140 + t120*(c*t70
      - t75) + theta_phi*(t118*t146 + t127);
  E->parameter[PAR_H][E_LAMBDA_L + wheel] += -c*t140;
  E->parameter[PAR_K_T][E_DELTA] += -F_z_k_t*t144;
  E->parameter[PAR_K_T][E_PSI] += F_z_k_t*t132;
  E->parameter[PAR_K_ALPHA][E_DELTA] += -C_k_alpha*t147;
  E->parameter[PAR_K_ALPHA][E_PSI] += C_k_alpha*t148;
  E->parameter[PAR_K_LAMBDA][E_DELTA] += t137*t149;
  E->parameter[PAR_K_LAMBDA][E_PSI] += -t139*t149;
  E->parameter[PAR_L][E_DELTA] += -F_z*(C_l*s + Lambda_l*t138);
  E->parameter[PAR_L][E_PSI] += F_z*(C_l*t6 - Lambda_l*t139);
  E->parameter[PAR_L][E_LAMBDA_L + wheel] += t59*(-c*lambda*t140 + cos_theta*t146 + t141);
  E->parameter[PAR_R][E_DELTA] += -F_z_R*t110 + X_R*t98 - Z_R*t101 + t86*t89;
  E->parameter[PAR_R][E_PSI] += F_z_R*t116 + X_R*t112;
  E->parameter[PAR_R][E_LAMBDA_L + wheel] += -X_R*t126 + Z_R*ddelta*t121;
  E->parameter[PAR_ALPHA_M][E_DELTA] += -C_alpha_m*t147;
  E->parameter[PAR_ALPHA_M][E_PSI] += C_alpha_m*t148;
  E->parameter[PAR_G][E_DELTA] += -F_z_g*t144;
  E->parameter[PAR_G][E_PSI] += F_z_g*t132;
  E->parameter[PAR_M][E_DELTA] += -F_z_M*t144;
  E->parameter[PAR_M][E_PSI] += F_z_M*t132;
}

/* What the doubts add at one wheel. */
static inline void mlg_slopes_doubts(const double par[], const double u[], const double du[],
    const struct mlg_pose *p, int wheel, const struct mlg_sharing *share, int parameters, struct mlg_slopes *E)
{
  const double k_lambda = par[PAR_K_LAMBDA];
  const double lambda = u[LAMBDA_L + wheel];
  const double l = par[PAR_L];
  const double t8 = 1.0/l;
  const double t9 = lambda*t8;
  const double T = atan(7*t9);
  const double t10 = (19.0/20.0)*T;
  const double t11 = cos(t10);
  const double t12 = T*t11;
  const double Lambda = k_lambda*t12;
  const double cos_psi = p->cos_psi;
  const double c = p->c;
  const double sin_delta = p->sin_delta;
  const double t25 = c*sin_delta;
  const double s = p->s;
  const double sin_psi = p->sin_psi;
  const double t46 = s*sin_psi;
  const double t47 = cos_psi*t25 + t46;
  const double t48 = t47*t47;
  const double t49 = 1 - t48;
  const double t50 = 1.0/sqrt(t49);
  const double cos_delta = p->cos_delta;
  const double t6 = c*cos_delta;
  const double t66 = cos_psi*t6;
  const double t96 = t50*t66;
  const double mu_delta = t96;
  const double a = par[PAR_A];
  const double side = 2. * wheel - 1.;
  const double t44 = a*side;
  const double t45 = (1.0/10.0)*t44;
  const double R_i_delta = -mu_delta*t45;
  const double X_delta = -R_i_delta*s;
  const double Z_delta = R_i_delta*c;
  const double dddelta = du[DDELTA];
  const double ddpsi = du[DPSI];
  const double dpsi = u[DPSI];
  const double t112 = dddelta*sin_delta;
  const double ddelta = u[DDELTA];
  const double t41 = ddelta*ddelta;
  const double t113 = cos_delta*t41 + t112;
  const double t114 = c*t113;
  const double l_delta = par[PAR_L_DELTA];
  const double R = par[PAR_R];
  const double mu = p->mu;
  const double t0 = mu*side;
  const double t1 = (1.0/10.0)*t0;
  const double R_i = R - a*t1;
  const double t5 = R_i*c;
  const double Z = l_delta + t5;
  const double e = par[PAR_E];
  const double t2 = R_i*s;
  const double X = -e - t2;
  const double t3 = (1.0/2.0)*side;
  const double t4 = a*t3;
  const double Y = t4;
  const double t19 = X*sin_psi + Y*cos_psi;
  const double t28 = sin_delta*t19;
  const double t29 = Z*cos_delta + t28;
  const double t115 = c*t29;
  const double t20 = cos_delta*t19;
  const double t24 = X*cos_psi - Y*sin_psi;
  const double t74 = ddelta*sin_delta;
  const double t116 = dpsi*t20 + t24*t74;
  const double t117 = dpsi*sin_delta;
  const double t21 = Z*sin_delta - t20;
  const double t118 = ddelta*t21;
  const double t53 = cos_psi*s;
  const double t54 = sin_psi*t25;
  const double t55 = -t53 + t54;
  const double t119 = dpsi*t55;
  const double t51 = cos_psi*ddelta;
  const double t52 = t51*t6;
  const double t120 = -t119 + t52;
  const double t27 = cos_delta*dpsi;
  const double t121 = cos_psi*t27;
  const double t122 = sin_psi*t74;
  const double t123 = ddpsi*t47;
  const double t124 = cos_delta*dddelta;
  const double t84 = c*sin_psi;
  const double t125 = t123 + t124*t84;
  const double t31 = c*ddelta;
  const double t126 = dpsi*t120 + t125 + t31*(t121 - t122);
  const double t32 = t24*t6;
  const double t127 = X_delta*t126 - Z_delta*t114 - c*dpsi*t116 - dddelta*t115 + ddpsi*t32 +
      t31*(-t117*t24 + t118);
  const double ddzB_held_delta = t127;
  const double R_moves = par[PAR_R_MOVES];
  const double t73 = sin_psi*t27;
  const double t75 = cos_psi*t74;
  const double t133 = t73 + t75;
  const double t146 = sin_delta*t46;
  const double t147 = 2*t120;
  const double t148 = cos_delta*cos_psi;
  const double t149 = t148*t55;
  const double t61 = dpsi*t47;
  const double t70 = 1.0/t49;
  const double t71 = t61*t70;
  const double t150 = t149*t71;
  const double t59 = cos_delta*t46;
  const double t60 = t25 + t59;
  const double t62 = s*t61 + t31*t60;
  const double t151 = 2*t62;
  const double t132 = ddpsi*t55;
  const double t67 = dddelta*t66;
  const double t56 = -t55;
  const double t69 = cos_psi*t56;
  const double t72 = t69*t71;
  const double t76 = cos_delta*cos_delta;
  const double t77 = t47*t70;
  const double t78 = t76*t77;
  const double t79 = cos_psi*cos_psi;
  const double t80 = t31*t79;
  const double t81 = t78*t80;
  const double t82 = -t73 - t75 + t81;
  const double t83 = cos_delta*t72 + t82;
  const double t85 = cos_delta*ddelta;
  const double t86 = t84*t85;
  const double t87 = t56*t56;
  const double t88 = t70*t87;
  const double t89 = t61*t88;
  const double t90 = t56*t77;
  const double t91 = t52*t90;
  const double t92 = -t61 - t86 + t89 + t91;
  const double t152 = dpsi*t92 - t132 + t31*t83 + t67;
  const double t153 = cos_delta*sin_psi;
  const double t154 = c*t79;
  const double t63 = c*c;
  const double t155 = ddelta*t63;
  const double t156 = t155*t70;
  const double t157 = cos_delta*cos_delta*cos_delta*cos_psi*cos_psi*cos_psi;
  const double t158 = t70*t76;
  const double t159 = 1.0/(t49*t49);
  const double t160 = t159*t48;
  const double t161 = 3*t160;
  const double t57 = dpsi*t56;
  const double t162 = 3*t57;
  const double t163 = t48*t70;
  const double t164 = t56*t80;
  const double t165 = t56*t71;
  const double t166 = 2*t165;
  const double t167 = t161*t87;
  const double t168 = -t121*t163 + t121*t167 + t121*t88 - t121 + t122 - t153*t166 + t158*t164 +
      t161*t164*t76 - 2*t51*t78*t84 - t75*t90;
  const double t169 = t45*t50;
  const double t170 = c*t169;
  const double t64 = cos_delta*t63;
  const double t65 = -s*t55 + t64;
  const double ddzB_R_delta = t170*(t147*(ddelta*(-t146 + t6) + t27*t53) + t151*(-t133 - t150 + t81)
      + t152*t60 - t65*(-cos_psi*t112 + dddelta*t154*t78 + ddelta*(-cos_delta*t51 -
      2*cos_psi*t71*t76*t84 - sin_delta*t72 + sin_psi*t117 + t154*t158*t57 + t154*t160*t162*t76 +
      t155*t157*t161 + t156*t157 - 3*t25*t77*t79*t85) - ddpsi*t153 + dpsi*t168 - t123*t149*t70));
  const double t187 = R_moves*ddzB_R_delta;
  const double ddzB_own_delta = ddzB_held_delta + t187;
  const double share_delta = share->delta;
  const double m_D = par[PAR_M_D];
  const double t145 = (1.0/2.0)*m_D;
  const double t58 = t52 + t57;
  const double t68 = ddpsi*t56;
  const double t93 = dpsi*t92 + t31*t83 + t67 + t68;
  const double t94 = t50*(2*t58*t62 - t65*t93);
  const double ddzB_R = t45*t94;
  const double t95 = R_moves*ddzB_R;
  const double t195 = t145*t95;
  const double cos_theta = p->cos_theta;
  const double t196 = Lambda*cos_theta;
  const double share_z = share->z;
  const double N12_out = par[PAR_N12_OUT];
  const double t200 = N12_out*dddelta;
  const double l_D = par[PAR_L_D];
  const double t39 = l_D*t25;
  const double zB_shared = par[PAR_ZB_SHARED];
  const double t201 = share_z*zB_shared - t200*t39 + t95;
  const double t202 = t145*t201;
  const double t197 = cos_delta*t196;
  const double sin_theta = p->sin_theta;
  const double t198 = Lambda*sin_theta;
  const double t199 = s*t198;
  const double t203 = t202*(sin_delta*t199 - t197 + t25);
  const double t204 = sin_delta*t196;
  const double t205 = cos_delta*t199 + t204 + t6;
  const double t206 = t202*t205;
  const double t207 = sin_psi*t206;
  const double t208 = sin_theta*t29;
  const double t209 = s*t21;
  const double t210 = Lambda*(cos_theta*t209 + t208);
  const double g = par[PAR_G];
  const double M = par[PAR_M];
  const double t37 = M + m_D;
  const double k_t = par[PAR_K_T];
  const double t38 = k_t*t0;
  const double t22 = c*t21;
  const double t23 = s*t19;
  const double t26 = t23 + t24*t25;
  const double t30 = -ddelta*t29 + t24*t27;
  const double t33 = s*t24;
  const double t34 = c*t28 - t33;
  const double t35 = ddelta*t32 - dpsi*t34;
  const double t36 = -dddelta*t22 + ddpsi*t26 + dpsi*t35 + t30*t31;
  const double ddzB_i = t36;
  const double t40 = dddelta*t39;
  const double t42 = l_D*t6;
  const double t43 = ddzB_i + t40 + t41*t42;
  const double F_z = (1.0/2.0)*a*t38 + (1.0/2.0)*g*t37 + (1.0/2.0)*m_D*t43;
  const double heading = par[PAR_HEADING];
  const double t7 = heading*s;
  const double t211 = F_z*t7;
  const double psi = u[PSI];
  const double t99 = psi*t25 + t7;
  const double theta_delta = -t99;
  const double t212 = t202*theta_delta;
  const double alpha = atan(t9);
  const double alpha_m = par[PAR_ALPHA_M];
  const double grip = ((alpha_m >= fabs(alpha)) ? (    1 ) : (    0 ));
  const double k_alpha = par[PAR_K_ALPHA];
  const double t13 = grip*k_alpha;
  const double t14 = 1.0/MLG_PI;
  const double t15 = alpha/alpha_m;
  const double t16 = MLG_PI*t15;
  const double t17 = sin(t16);
  const double t18 = alpha_m*t14*t17;
  const double C = t13*t18;
  const double t213 = C*s;
  const double t214 = cos_theta*t29;
  const double t215 = -Lambda*t214 + t198*t209 + t213 + t22;
  const double t216 = t200*t215;
  const double t217 = c*l_D*sin_delta - t215;
  const double t218 = t145*t187;
  const double share_psi = share->psi;
  const double t138 = c*t19;
  const double t139 = -s*sin_delta*t24 + t138;
  const double t140 = -t139;
  const double t219 = cos_delta*t24;
  const double t220 = cos_theta*t140 + sin_theta*t219;
  const double t221 = Lambda*t220;
  const double t98 = -sin_delta*t53 + t84;
  const double t185 = -t98;
  const double t222 = cos_psi*t197;
  const double t223 = t202*(t185*t198 - t222 + t47);
  const double t224 = C*t6 + t140*t198 - t197*t24 + t26;
  const double t225 = t145*t224;
  const double V = par[PAR_V];
  const double t226 = -t30*(cos_theta*t9 - sin_theta);
  const double t227 = cos_theta + sin_theta*t9;
  const double t228 = s*t118;
  const double t229 = t226 + t227*(V - dpsi*t139 - t228);
  const double t128 = 2*c*t30;
  const double ddzB_held_ddelta = t128;
  const double t171 = -sin_psi + t69*t77;
  const double t172 = c*cos_psi;
  const double ddzB_R_ddelta = t170*(t147*t60 + t148*t151 - t65*(-t150 + t171*t27 + t51*(-sin_delta
      + t172*t78) + t82));
  const double t188 = R_moves*ddzB_R_ddelta;
  const double ddzB_own_ddelta = ddzB_held_ddelta + t188;
  const double t230 = t145*t188;
  const double I_p = par[PAR_I_P];
  const double t231 = 1.0/R;
  const double t232 = (1.0/2.0)*I_p*t231;
  const double t233 = cos_psi*t232;
  const double t234 = V*t233;
  const double h = par[PAR_H];
  const double t104 = lambda*lambda;
  const double t235 = h - t104*t8;
  const double t97 = t50*t55;
  const double mu_psi = -t97;
  const double R_i_psi = -mu_psi*t45;
  const double X_psi = -R_i_psi*s;
  const double Z_psi = R_i_psi*c;
  const double t129 = X_psi*t126 - Z_psi*t114 + c*cos_delta*dddelta*t24 - ddpsi*t34 - dpsi*(dpsi*t26
      + t20*t31) - t116*t31;
  const double ddzB_held_psi = t129;
  const double t134 = t61 + t86;
  const double t173 = 2*s;
  const double t174 = t55*t55;
  const double t175 = t55*t77;
  const double t176 = t56*t56*t56;
  const double ddzB_R_psi = t169*(s*t152*t47 + t120*t120*t173 + t151*(dpsi*t174*t47*t70 - t134 -
      t175*t52) - t65*(c*ddelta*t168 + ddpsi*t174*t47*t70 + dpsi*(dpsi*t161*t176 + dpsi*t176*t70 +
      t119 - t162*t163 - t163*t52 + t167*t52 + t52*t88 - t52 - 2*t86*t90) - t125 - t175*t67));
  const double t189 = R_moves*ddzB_R_psi;
  const double ddzB_own_psi = ddzB_held_psi + t189;
  const double t236 = V*dpsi;
  const double t237 = sin_psi*t232;
  const double theta_psi = t6;
  const double t238 = t202*theta_psi;
  const double t239 = -cos_theta*s*t21 - t208;
  const double t240 = Lambda*t239;
  const double t241 = t145*t189;
  const double t130 = 2*t35;
  const double ddzB_held_dpsi = t130;
  const double ddzB_R_dpsi = t169*(2*s*t47*t58 - t151*t55 - t65*(ddelta*t171*t6 - t134 - t61*(1 -
      t88) + t89 + t91));
  const double t190 = R_moves*ddzB_R_dpsi;
  const double ddzB_own_dpsi = ddzB_held_dpsi + t190;
  const double t242 = t145*t190;
  const double t103 = 1.0/(l*l);
  const double t105 = t103*t104;
  const double t106 = 1.0/(t105 + 1);
  const double alpha_lambda = t106*t8;
  const double t110 = cos(t16);
  const double t111 = t110*t13;
  const double C_lambda = alpha_lambda*t111;
  const double t108 = 7/(49*t105 + 1);
  const double T_lambda = t108*t8;
  const double t109 = k_lambda*(t10*sin(t10) - t11);
  const double Lambda_lambda = -T_lambda*t109;
  const double t243 = -s*sin_theta*t21 + t214;
  const double t244 = -t243;
  const double t245 = cos_theta*t219 + sin_theta*t139;
  const double t246 = -psi*t74 + t27;
  const double t247 = -c*cos_delta*dpsi + c*t246 + ddelta*t99;
  const double t131 = -t22;
  const double ddzB_held_dddelta = t131;
  const double t177 = t45*t65;
  const double ddzB_R_dddelta = -t177*t96;
  const double t191 = R_moves*ddzB_R_dddelta;
  const double ddzB_own_dddelta = ddzB_held_dddelta + t191;
  const double t248 = t145*t215;
  const double t249 = N12_out*t39;
  const double t250 = t145*t191;
  const double ddzB_held_ddpsi = t26;
  const double ddzB_R_ddpsi = t177*t97;
  const double t192 = R_moves*ddzB_R_ddpsi;
  const double ddzB_own_ddpsi = ddzB_held_ddpsi + t192;
  const double t251 = t145*t192;
  E->state[DELTA][E_DELTA] += X_delta*t207 - Z_delta*t203 + ddzB_own_delta*share_delta +
      t145*t216*t42 + t195*t42 - t202*(Lambda*s*t208 + t115 + t196*t21) + t210*t211 - t210*t212 +
      t217*t218;
  E->state[DELTA][E_PSI] += X_delta*t223 + ddzB_own_delta*share_psi - t200*t225*t42 + t202*(-C*t25 +
      cos_delta*t198*t33 + t204*t24 + t32) - t211*t221 + t212*t221 + t218*t224;
  E->state[DELTA][E_LAMBDA_L + wheel] += -t229*t7;
  E->state[DDELTA][E_DELTA] += ddzB_own_ddelta*share_delta + t217*t230;
  E->state[DDELTA][E_PSI] += ddzB_own_ddelta*share_psi + t224*t230 - t234;
  E->state[DDELTA][E_LAMBDA_L + wheel] += t235*t7;
  E->state[PSI][E_DELTA] += X_psi*t207 - Z_psi*t203 + ddzB_own_psi*share_delta + t206*t24 +
      t217*t241 - t236*t237 + t238*t240;
  E->state[PSI][E_PSI] += V*ddelta*t237 + X_psi*t223 + ddzB_own_psi*share_psi -
      t202*(Lambda*sin_theta*(c*t24 + sin_delta*t23) + c*sin_delta*t19 - t196*t20 - t33) + t221*t238
      + t224*t241;
  E->state[DPSI][E_DELTA] += ddzB_own_dpsi*share_delta + t217*t242 + t234;
  E->state[DPSI][E_PSI] += ddzB_own_dpsi*share_psi + t224*t242;
  E->state[LAMBDA_L + wheel][E_DELTA] += -t202*(C_lambda*s + Lambda_lambda*t244);
  E->state[LAMBDA_L + wheel][E_PSI] += t202*(C_lambda*t6 - Lambda_lambda*t245);
  E->state[LAMBDA_L + wheel][E_LAMBDA_L + wheel] += -2*t247*t9;
  E->dddelta[E_DELTA] += ddzB_own_dddelta*share_delta + t217*t250 + t248*t249;
  E->dddelta[E_PSI] += ddzB_own_dddelta*share_psi + t224*t250 - t225*t249;
  E->ddpsi[E_DELTA] += ddzB_own_ddpsi*share_delta + t217*t251;
  E->ddpsi[E_PSI] += ddzB_own_ddpsi*share_psi + t224*t251;

  if (!parameters)
    return;
  const double R_i_a = -t1;
  const double X_a = -R_i_a*s;
  const double Y_a = t3;
  const double Z_a = R_i_a*c;
  const double t135 = X_a*t126 - Y_a*(dpsi*t134 + t132 + t133*t31 - t67) - Z_a*t114;
  const double ddzB_held_a = t135;
  const double ddzB_R_a = (1.0/10.0)*side*t94;
  const double t193 = R_moves*ddzB_R_a;
  const double ddzB_own_a = ddzB_held_a + t193;
  const double t252 = t145*t193;
  const double t179 = t146 + t172;
  const double X_e = -1;
  const double t136 = X_e*t126;
  const double ddzB_held_e = t136;
  const double ddzB_own_e = ddzB_held_e;
  const double Z_l_delta = 1;
  const double t137 = -Z_l_delta*t114;
  const double ddzB_held_l_delta = t137;
  const double ddzB_own_l_delta = ddzB_held_l_delta;
  const double t253 = t145*t25;
  const double mu_phi = t50*t98;
  const double R_i_phi = -mu_phi*t45;
  const double X_phi = -R_i_phi*s - t5;
  const double Z_phi = R_i_phi*c - t2;
  const double t178 = dpsi*t98;
  const double t180 = t77*t98;
  const double t181 = t76*t79;
  const double t182 = t70*t98;
  const double t183 = t159*t48*t98;
  const double t184 = 3*t183;
  const double t186 = t52*t56;
  const double ddzB_R_phi = t169*(t151*(dpsi*t179 + t165*t98 + t180*t52 - t53*t85) + 2*t58*(c*t61 -
      ddelta*(s*s*t153 - sin_psi*t64 + t173*t25) + s*t178) -
      t65*(-ddelta*(c*cos_delta*dpsi*sin_psi*t47*t70*t98 + c*cos_psi*ddelta*sin_delta*t47*t70*t98 +
      2*c*ddelta*s*t47*t70*t76*t79 + cos_delta*cos_psi*dpsi*s*t47*t56*t70 - t155*t181*t184 -
      t156*t181*t98 - t162*t183*t66 - t179*t66*t71 - t182*t57*t66 - t27*t46 - t53*t74) + ddpsi*t179
      - dpsi*(c*cos_delta*ddelta*sin_psi*t47*t70*t98 + cos_delta*cos_psi*ddelta*s*t47*t56*t70 -
      ddelta*t59 - dpsi*t185 + dpsi*t48*t70*t98 - t166*t179 - t167*t178 - t178*t88 - t179*t52*t77 -
      t182*t186 - t184*t186) - t124*t53 + t180*t67 + t180*t68) + t93*(c*t55 - s*t179 + t173*t6));
  const double t141 = X_phi*t126 - Z_phi*t114 + dddelta*s*t21 - ddelta*s*t30 - ddpsi*t140 -
      dpsi*(-dpsi*(c*t24 + s*sin_delta*t19) + t33*t85);
  const double ddzB_held_phi = t141;
  const double t194 = R_moves*ddzB_R_phi;
  const double ddzB_own_phi = ddzB_held_phi + t194;
  const double t254 = l_D*s;
  const double delta = u[DELTA];
  const double t100 = c*heading;
  const double t101 = delta*t100;
  const double t255 = F_z*t101;
  const double t256 = N12_out*t112*t254;
  const double theta_phi = -cos_delta*psi*s - t101;
  const double C_k_alpha = grip*t18;
  const double t257 = s*t202;
  const double t258 = t202*t6;
  const double Lambda_k_lambda = t12;
  const double t259 = Lambda_k_lambda*t202;
  const double t107 = lambda*t103;
  const double alpha_l = -t106*t107;
  const double C_l = alpha_l*t111;
  const double T_l = -t107*t108;
  const double Lambda_l = -T_l*t109;
  const double R_i_R = 1;
  const double X_R = -R_i_R*s;
  const double Z_R = R_i_R*c;
  const double t142 = X_R*t126 - Z_R*t114;
  const double ddzB_held_R = t142;
  const double ddzB_own_R = ddzB_held_R;
  const double t260 = cos_psi*t236;
  const double t261 = ((1.0/2.0)*I_p)*1.0/(R*R);
  const double t262 = V*t51;
  const double C_alpha_m = t13*(-t110*t15 + t14*t17);
  const double t263 = share_z*t145;
  const double ddzB_own_R_moves = ddzB_R;
  const double t264 = ddzB_R*t145;
  const double t102 = delta*s;
  const double theta_heading = -t102;
  const double t265 = Lambda*(-F_z*t102 + (1.0/2.0)*m_D*t201*theta_heading);
  const double t266 = (1.0/2.0)*t231;
  E->parameter[PAR_V][E_DELTA] += dpsi*t233;
  E->parameter[PAR_V][E_PSI] += -t232*t51;
  E->parameter[PAR_A][E_DELTA] += X_a*t207 + Y_a*cos_psi*t206 - Z_a*t203 + ddzB_own_a*share_delta +
      t217*t252;
  E->parameter[PAR_A][E_PSI] += X_a*t223 + Y_a*t202*(t153*t196 - t179*t198 + t53 - t54) +
      ddzB_own_a*share_psi + t224*t252;
  E->parameter[PAR_E][E_DELTA] += X_e*t207 + ddzB_own_e*share_delta;
  E->parameter[PAR_E][E_PSI] += X_e*t223 + ddzB_own_e*share_psi;
  E->parameter[PAR_L_DELTA][E_DELTA] += -Z_l_delta*t203 + ddzB_own_l_delta*share_delta;
  E->parameter[PAR_L_DELTA][E_PSI] += ddzB_own_l_delta*share_psi;
  E->parameter[PAR_L_D][E_DELTA] += t253*(t216 + t95);
  E->parameter[PAR_L_D][E_PSI] += -t200*t224*t253;
  E->parameter[PAR_M_D][E_DELTA] += -1.0/2.0*t201*t215 + (1.0/2.0)*t39*t95;
  E->parameter[PAR_M_D][E_PSI] += (1.0/2.0)*t201*t224;
  E->parameter[PAR_PHI][E_DELTA] += (1.0/2.0)*Lambda*m_D*t201*t239*theta_phi +
      (1.0/2.0)*R_moves*ddzB_R_phi*m_D*t217 + (1.0/2.0)*X_phi*m_D*sin_psi*t201*t205 - Z_phi*t203 +
      ddzB_own_phi*share_delta - sin_delta*t195*t254 - t202*(C*c + t198*t22 - t209) - t240*t255 -
      t248*t256;
  E->parameter[PAR_PHI][E_PSI] += X_phi*t223 + ddzB_own_phi*share_psi + t145*t194*t224 +
      t202*t221*theta_phi - t202*(cos_delta*t213 + sin_delta*t33 - t138 - t198*t26) - t221*t255 +
      t225*t256;
  E->parameter[PAR_PHI][E_LAMBDA_L + wheel] += -s*t235*t246 - t101*(t226 + t227*(V + dpsi*t140 -
      t228)) + t235*(-ddelta*(psi*s*sin_delta - t100) + s*t27);
  E->parameter[PAR_H][E_LAMBDA_L + wheel] += ddelta*t7;
  E->parameter[PAR_K_ALPHA][E_DELTA] += -C_k_alpha*t257;
  E->parameter[PAR_K_ALPHA][E_PSI] += C_k_alpha*t258;
  E->parameter[PAR_K_LAMBDA][E_DELTA] += t243*t259;
  E->parameter[PAR_K_LAMBDA][E_PSI] += -t245*t259;
  E->parameter[PAR_L][E_DELTA] += -t202*(C_l*s + Lambda_l*t244);
  E->parameter[PAR_L][E_PSI] += t202*(C_l*t6 - Lambda_l*t245);
  E->parameter[PAR_L][E_LAMBDA_L + wheel] += t105*t247;
  E->parameter[PAR_R][E_DELTA] += (1.0/2.0)*X_R*m_D*sin_psi*t201*t205 - Z_R*t203 +
      ddzB_own_R*share_delta - t260*t261;
  E->parameter[PAR_R][E_PSI] += X_R*t202*(c*cos_psi*sin_delta + s*sin_psi - t198*t98 - t222) +
      ddzB_own_R*share_psi + t261*t262;
  E->parameter[PAR_ALPHA_M][E_DELTA] += -C_alpha_m*t257;
  E->parameter[PAR_ALPHA_M][E_PSI] += C_alpha_m*t258;
  E->parameter[PAR_ZB_SHARED][E_DELTA] += -t215*t263;
  E->parameter[PAR_ZB_SHARED][E_PSI] += t224*t263;
  E->parameter[PAR_R_MOVES][E_DELTA] += ddzB_own_R_moves*share_delta - t215*t264 + t264*t39;
  E->parameter[PAR_R_MOVES][E_PSI] += ddzB_own_R_moves*share_psi + t224*t264;
  E->parameter[PAR_HEADING][E_DELTA] += t239*t265;
  E->parameter[PAR_HEADING][E_PSI] += t220*t265;
  E->parameter[PAR_HEADING][E_LAMBDA_L + wheel] += s*(ddelta*t235 - delta*t229);
  E->parameter[PAR_I_P][E_DELTA] += t260*t266;
  E->parameter[PAR_I_P][E_PSI] += -t262*t266;
  E->parameter[PAR_N12_OUT][E_DELTA] += t248*t40;
  E->parameter[PAR_N12_OUT][E_PSI] += -t225*t40;
}

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

#endif
