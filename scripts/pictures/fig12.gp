# fig12.gp - Figure 12 from results/fig12.csv
panels = "a b c d e f"
columns = 2; rows = 3; width = 1200; height = 1500
left_margin = 0.08; bottom_margin = 0.045; top_margin = 0.975; gap_x = 0.06; gap_y = 0.055
c_lo = 100; c_hi = 4e4; V_hi = 100; V_tics = 20; key_y = 0.755
title(letter, b) = sprintf("(%s) b = %d N m s^2/rad", letter, b)
title_a = title("a", 20); title_b = title("b", 30); title_c = title("c", 70)
title_d = title("d", 100); title_e = title("e", 130); title_f = title("f", 150)
note_a = 3; note_a_1 = "ψ|30|28000"; note_a_2 = "δ|48|7000"; note_a_3 = "ψ|13|600"
note_b = 3; note_b_1 = "ψ|30|28000"; note_b_2 = "δ|56|5000"; note_b_3 = "ψ|8|1300"
note_c = 4; note_c_1 = "ψ|30|28000"; note_c_2 = "δ|53|7000"; note_c_3 = "ψ|12|1000"; note_c_4 = "third ψ|68|116"
note_d = 4; note_d_1 = "ψ|30|28000"; note_d_2 = "δ|51|7000"; note_d_3 = "ψ|8|1200"; note_d_4 = "third ψ|20|450"
note_e = 4; note_e_1 = "ψ|30|28000"; note_e_2 = "δ|49|7000"; note_e_3 = "ψ|5|1200"; note_e_4 = "third ψ|58|850"
note_f = 4; note_f_1 = "ψ|30|28000"; note_f_2 = "δ|47|7000"; note_f_3 = "ψ|5|1200"; note_f_4 = "third ψ|58|1050"
load "scripts/pictures/curves.gp"
