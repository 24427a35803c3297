# fig09.gp - Figure 9 from results/fig09.csv
panels = "a b"
columns = 2; rows = 1; width = 1200; height = 620
left_margin = 0.08; bottom_margin = 0.11; top_margin = 0.935; gap_x = 0.06; gap_y = 0.1
c_lo = 1e3; c_hi = 8e4; V_hi = 100; V_tics = 20; key_y = 0.40
title_a = "(a) large k_s"; title_b = "(b) small k_s"
note_a = 3; note_a_1 = "ψ|12|50000"; note_a_2 = "δ|64|9000"; note_a_3 = "ψ|12|1400"
note_b = 2; note_b_1 = "ψ|16|50000"; note_b_2 = "ψ|16|1400"
load "scripts/pictures/curves.gp"
