# shellcheck shell=bash
# advice.sh - one page for a designer: which device, which values, why, how far from the limit,
# how sure; sourced by scripts/studies/design.sh (results/advice.md) and scripts/study/advice.sh
#
# A table of designs, one row for each layout, has the columns of advice_head; advice_words
# makes the page of it.  Nothing in the page is from anywhere else.

# shellcheck disable=SC2034 # for who makes the table
advice_head=layout,k_s,b,c_d,p,V,shimmy,corner,corners,sample,failing,c_lo,c_hi,zeta,zeta_V,zeta_shimmy,F_z,F_from,F_to,parameter,elasticity

# advice_row LAYOUT K_S,B,C_D,P,V,SHIMMY,CORNER,CORNERS,SAMPLE,FAILING WORD...: the row of a design as
# `mlg tolerance` prints it; WORDs are of the gear
advice_row() {
  local layout=$1 row=$2 k_s b c_d device=()
  IFS=, read -r k_s b c_d _ <<< "$row"
  shift 2
  [ "$layout" = l1 ] || device+=(k_s="$k_s")
  case $layout in l1 | l2) ;; *) device+=(b="$b") ;; esac
  mlg boundary "$layout" "${device[@]}" > /dev/null 2>&1 || device=()
  echo "$layout,$row,$(
    mlg intervals "$layout" "$@" "${device[@]}" | awk -F, -v c="$c_d" 'NR > 2 && $1 < c && c < $2 { printf "%s,%s", $1, $2; n++ } END { if (!n) printf "," }'
  ),$(
    mlg damping "$layout" "$@" "${device[@]}" c_d="$c_d" | awk -F, 'NR == 2 { printf "%s,%s,%s", $1, $2, $4 }'
  ),$(advice_loads "$layout" "$c_d" "$@" "${device[@]}"),$(
    mlg elasticities "$layout" "$@" "${device[@]}" c_d="$c_d" | awk -F, '
      NR > 2 && $1 != "F_z" && $1 != "g" && $1 != "M" { for (k = 4; k <= 5; k++) if ($k * $k > most * most) { most = $k; name = $1 } }
      END { printf "%s,%.3g", name, most }'
  )"
}

# F_z,F_FROM,F_TO: its load, and the loads around it that it bears, in 1/200 of it
advice_loads() { # LAYOUT C_D WORD...
  local layout=$1 c_d=$2 load least words=() word # least: where M is 0
  shift 2
  load=$(mlg gearinfo facts "$@" 2> /dev/null | awk -F, '$1 == "F_z" { print $2 }')
  least=$(mlg gearinfo "$@" 2> /dev/null | awk -F, '{ v[$1] = $2 } END { printf "%.12g", v["m_D"] * v["g"] * (1 + 1e-9) }')
  for word; do case $word in F_z=*) ;; *) words+=("$word") ;; esac; done
  mlg loads "$layout" "${words[@]}" c_d="$c_d" from="$(awk "BEGIN { half = 0.5 * $load; print (half > $least ? half : $least) }")" to="$(awk "BEGIN { print 1.5 * $load }")" \
    step="$(awk "BEGIN { print $load / 200 }")" | awk -F, -v own="$load" '
    NR > 2 { F[++n] = $1; z[n] = $9; if ($1 < own * 1.0001) at = n }
    END {
      for (i = at; i > 1 && z[i - 1] > 0; i--);
      for (j = at; j < n && z[j + 1] > 0; j++);
      printf "%.6g,%.6g,%.6g", own, F[i], F[j]
    }'
}

# The page of a table of designs, without its title.
advice_words() { # TABLE [B_MOST]: the bound of b, of a study
  awk -F, -v b_most="${2:-}" '
    function name(l) { return toupper(l) }
    function stiff(k) { return k == "inf" ? "rigid" : sprintf("%.4g N m/rad", k) }
    function device(i,  t) {
      t = sprintf("%s with c_d = %.4g N m s/rad", name(v["layout", i]), v["c_d", i])
      if (v["layout", i] != "l1") t = t ", k_s = " stiff(v["k_s", i])
      if (v["b", i] > 0) t = t sprintf(", b = %.4g N m s²/rad", v["b", i])
      return t
    }
    # half of the load and one and a half are where it was looked
    function loads(i,  from, to) {
      from = v["F_from", i] / v["F_z", i]; to = v["F_to", i] / v["F_z", i]
      if (from < 0.501 && to > 1.499) return sprintf("anywhere from %.4g to %.4g kN", v["F_from", i] / 1e3, v["F_to", i] / 1e3)
      if (from < 0.501) return sprintf("up to %.4g kN, and down to %.4g kN at least", v["F_to", i] / 1e3, v["F_from", i] / 1e3)
      return sprintf("from %.4g to %.4g kN%s", v["F_from", i] / 1e3, v["F_to", i] / 1e3, to > 1.499 ? " at least" : "")
    }
    # the parameters of a corner that are at one end of their range, or all
    function at_end(corner, sign,  n, k, one, t) {
      n = split(corner, one, " ")
      for (k = 1; k <= n; k++) if (sign == "" || substr(one[k], length(one[k])) == sign) t = t (t == "" ? "" : ", ") substr(one[k], 1, length(one[k]) - 1)
      return t == "" ? "none" : t
    }
    function bound(c) { return c == "inf" ? "any value" : sprintf("%.5g", c) }
    /^#/ { next }
    !columns { for (k = 1; k <= NF; k++) head[k] = $k; columns = NF; next }
    { n++; for (k = 1; k <= NF; k++) v[head[k], n] = $k; if ($5 + 0 > most + 0) { most = $5; best = n } }
    END {
      if (!best) {
        print "**No device here keeps this gear free of shimmy**, not even exactly as designed. What helps is a change of the gear itself, or a lower load (`mlg loads LAYOUT largest`)."
        exit
      }
      printf "**Take %s.**%s\n\n", device(best), (b_most != "" && v["b", best] > 0.999 * b_most ? " b is at its bound, and a larger one may do more." : "")
      for (i = 1; i <= n; i++) designs += v["p", i] > 0
      printf "**Why.** %s: %s may be off by %.3g %% at once, and no corner of that box shimmies.", (designs > 1 ? (b_most != "" ? "Of the designs below" : "Of all layouts here") " it bears the largest error" : n > 1 ? "It is the only layout here that has a design" : "That is its most tolerant design"),
        (v["corner", best] == "" ? "every parameter" : "each of " at_end(v["corner", best], "")), v["p", best]
      # of many the next two; the table has all
      if (n > 4) {
        for (i = 1; i <= n; i++) if (i != best && v["p", i] + 0 > v["p", second] + 0) second = i
        for (i = 1; i <= n; i++) if (i != best && i != second && v["p", i] + 0 > v["p", third] + 0) third = i
        if (third) printf " Next come %s with %.3g %% and %s with %.3g %%.", name(v["layout", second]), v["p", second], name(v["layout", third]), v["p", third]
      }
      for (i = 1; i <= n; i++) if (i != best && (n <= 4 || !(v["p", i] > 0))) {
        if (v["p", i] > 0) printf " %s bears %.3g %%%s.", name(v["layout", i]), v["p", i], (b_most != "" ? "" : " at its best")
        else printf " %s has no design without shimmy.", name(v["layout", i])
      }
      if (v["b", best] > 0) for (i = 1; i <= n; i++) if (!(v["b", i] > 0) && v["p", i] > simple) { simple = v["p", i]; other = i }
      if (other) printf " Without an inerter the best is %s.", device(other)
      printf "\n\n| layout | k_s (N m/rad) | b (N m s²/rad) | c_d (N m s/rad) | tolerance p (%%) | free c_d | least ζ | loads borne |\n|---|---|---|---|---|---|---|---|\n"
      for (i = 1; i <= n; i++) if (v["p", i] > 0)
        printf "| %s | %s | %.4g | %.4g | %.3g | %s to %s | %.2e | %s |\n", name(v["layout", i]), (v["layout", i] == "l1" ? "-" : v["k_s", i] == "inf" ? "rigid" : sprintf("%.4g", v["k_s", i])),
          v["b", i], v["c_d", i], v["p", i], bound(v["c_lo", i]), bound(v["c_hi", i]), v["zeta", i], loads(i)
      i = best
      printf "\n**How far from the limit.** "
      if (v["V", i] == "") printf "No corner shimmies, however far it was looked."
      else printf "What gives first is a %s mode at %.3g m/s, where %s are at their upper end and %s at their lower.", v["shimmy", i], v["V", i], at_end(v["corner", i], "+"), at_end(v["corner", i], "-")
      printf " c_d alone may lie from %s to %s.", bound(v["c_lo", i]), bound(v["c_hi", i])
      printf " The static load alone may be %s (own load: %.4g kN; steps of 0.5 %%).", loads(i), v["F_z", i] / 1e3
      printf " Of single parameters the bounds of c_d follow %s most, by %.3g %% for one per cent.\n\n", v["parameter", i], v["elasticity", i]
      printf "No shimmy is not much damping: the least damping ratio is %.2e, of the %s mode at %.3g m/s; a quarter of the amplitude after three cycles, as is often asked, would be 0.0735, %.0f times as much.%s\n\n", v["zeta", i], v["zeta_shimmy", i], v["zeta_V", i], 0.0735 / v["zeta", i],
        (v["p", i] < 1 ? " And a tolerance below 1 % is an edge, not a design: look for a change of the gear." : "")
      printf "**How sure.** Each of the %d corners was tested exactly over all speeds; of %d points between them %s. The design comes from a search with a grid over k_s (docs/design.md): a better one between its nodes is not excluded. All of it is the linearised model, and hangs on its choices (docs/doubts.md): the roll inertia of two separate wheel constraints, the loaded radius held fixed, the heading of the wheels, no gyroscopic coupling of the wheels, the tyre'"'"'s k_lambda and its law; a large disturbance and a loose joint are other questions.\n", v["corners", i],
        v["sample", i], (v["failing", i] == 0 ? "none shimmies" : v["failing", i] " shimmy")
    }' "$1"
}
