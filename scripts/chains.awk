# chains.awk - the zero-shimmy intervals of one layout and b as closed areas
#   awk -v layout=li1 -v b=70 -f chains.awk results/fig13.csv
# Rows k_s,c_lo,c_hi,width in blocks with a blank line between.  From one k_s to
# the next an interval goes on in the one of the same rank; where their number
# changes, which the table resolves finely, in the one it overlaps most.
BEGIN { FS = "," }

function link(    i, j, best) {
  for (i = 1; i <= n; i++) {
    best = 0
    if (n == n_was) best = i
    else
      for (j = 1; j <= n_was; j++)
        if (!taken[j] && lo_was[j] < hi[i] && hi_was[j] > lo[i] && (!best || hi_was[j] - lo_was[j] > hi_was[best] - lo_was[best])) best = j
    if (best) taken[best] = 1
    chain[i] = best ? chain_was[best] : ++chains
    rows[chain[i]] = rows[chain[i]] text[i]
  }
  for (i = 1; i <= n; i++) { lo_was[i] = lo[i]; hi_was[i] = hi[i]; chain_was[i] = chain[i] }
  split("", taken)
  n_was = n
  n = 0
}

/^#/ || $1 != layout || $2 != b || $3 == "inf" { next }
$3 != k_s { if (k_s != "") link(); k_s = $3 }
{ lo[++n] = $4; hi[n] = $5; text[n] = $3 "," $4 "," $5 "," $8 "\n" }
END { link(); for (i = 1; i <= chains; i++) print rows[i] }
