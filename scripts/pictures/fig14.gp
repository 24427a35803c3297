# fig14.gp - Figure 14 from results/fig14.csv
panels = "a1 a2 b1 b2"
columns = 2; rows = 2; width = 1200; height = 1060
left_margin = 0.08; bottom_margin = 0.07; top_margin = 0.965; gap_x = 0.06; gap_y = 0.075
c_lo = 1e3; c_hi = 8e4; V_hi = 100; V_tics = 20; key_y = 0.43
title_a1 = "(a1) b = 50 N m s^2/rad, small k_s"; title_a2 = "(a2) b = 50 N m s^2/rad, large k_s"
title_b1 = "(b1) b = 100 N m s^2/rad, small k_s"; title_b2 = "(b2) b = 100 N m s^2/rad, large k_s"
note_a1 = 2; note_a1_1 = "ψ|25|50000"; note_a1_2 = "ψ|12|1600"
note_a2 = 3; note_a2_1 = "ψ|20|50000"; note_a2_2 = "ψ|12|1600"; note_a2_3 = "δ|58|8000"
note_b1 = 3; note_b1_1 = "ψ|25|50000"; note_b1_2 = "ψ|12|1600"; note_b1_3 = "δ|45|6000"
note_b2 = 3; note_b2_1 = "ψ|20|50000"; note_b2_2 = "ψ|12|1600"; note_b2_3 = "δ|56|8000"
load "scripts/pictures/curves.gp"
