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

/* All slopes at the states u with their rates du; those by parameters if asked for. */
static inline void mlg_slopes(const double par[], const double u[], const double du[],
                              int parameters, struct mlg_slopes *E)
{
  const struct mlg_pose p = mlg_pose(par, u);

  memset(E, 0, parameters ? sizeof *E : offsetof(struct mlg_slopes, parameter));
  mlg_slopes_body(par, u, du, &p, parameters, E);
  for (int wheel = 0; wheel < 2; wheel++)
    mlg_slopes_wheel(par, u, du, &p, wheel, parameters, E);
}

#endif
