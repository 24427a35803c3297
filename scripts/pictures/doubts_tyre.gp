# doubts_tyre.gp - Hopf curves in the (V, c_d) plane with other tyres, from results/doubts_tyre.csv
# (scripts/studies/doubts.sh)
curves(tyre, layout) = pick(sprintf("results/doubts_tyre.csv where=tyre=%s where=layout=%s where=type= blocks=curve columns=V,c_d", tyre, layout))
layouts = "l1 l2 li1 li2"
array title[4] = ["(a) L1", "(b) L2, k_s = 7.86·10^5", "(c) LI1, k_s = 6.38·10^5, b = 140", "(d) LI2, k_s = 2.48·10^6, b = 140"]
tyres = "paper half somieski"
array name[3] = ["the paper's tyre", "k_λ 1.19, k_α 0.3 m", "Somieski's tyre"]
array colour[3] = ["#000000", "#2a9d5c", "#d62728"]
do for [ending in "png svg"] {
  if (ending eq "png") { set terminal pngcairo size 1500,520 font "DejaVu Sans,13" } \
  else { set terminal svg size 1500,520 font "DejaVu Sans,14" }
  set output picture(ending)
  set multiplot layout 1,4 margins 0.055,0.99,0.15,0.9 spacing 0.035,0
  set xrange [0:200]; set yrange [500:1e5]; set logscale y
  set ytics ("0.5" 500, "1" 1e3, "3" 3e3, "10" 1e4, "30" 3e4, "100" 1e5)
  do for [i=1:4] {
    set title title[i]
    set xlabel "V (m/s)"
    set ylabel i == 1 ? "c_d (kN m s/rad)" : "" offset 0.5,0
    if (i == 3) { set key at graph 0.99,0.62 right samplen 1.5 } else { unset key }
    plot for [k=1:3] curves(word(tyres, k), word(layouts, i)) with lines lw 2 lc rgb colour[k] title name[k]
  }
  unset multiplot; unset logscale y
}
