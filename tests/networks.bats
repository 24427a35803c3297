# networks.bats - devices written as text, and every small network
#
# Counts against all graphs of so many edges, stiffnesses and damping against nodes and
# eigenvalues (networks.py), layouts against their own text, tables against both.
#
# Needs   build/bin/mlg
# Writes  build/tests/networks

# shellcheck disable=SC2154 # stderr and stderr_lines are set by run

bats_require_minimum_version 1.5.0
load scratch

setup_file() {
  scratch networks
}

setup() {
  cd "$SCRATCH" || return
}

oracle() {
  python3 "$ROOT/tests/networks.py" "$@"
}

# LAYOUT TEXT, one a line
layouts_as_text() {
  mlg networks | awk -F, '!/^#/ && $7 != "" && $7 != "layout" { print $7, $2 }'
}

@test "there are as many networks as graphs have different stiffnesses, and paths of springs" {
  local set all=0 path=0 a p
  for set in kc kcb kkc kkcb; do
    read -r a p < <(oracle count $set)
    all=$((all + a)) path=$((path + p))
  done
  [ "$all $path" = "70 35" ]
  mlg networks | head -n 1 | grep -q "^# $all series-parallel networks .* $path of them$"
  [ "$(mlg networks | grep -c '^[0-9]')" -eq "$path" ]
  [ "$(mlg networks | awk -F, '/^[0-9]/ { print $2 }' | sort -u | wc -l)" -eq "$path" ]
}

@test "of the larger family there are as many, none that fewer elements make as well" {
  local set all=0 kept=0 bridges=0 a k b
  mlg networks larger > listed
  for set in kCC kCCb kkCC kkCCb KKkc KKkcb; do
    read -r a k b < <(oracle count $set)
    all=$((all + a)) kept=$((kept + k)) bridges=$((bridges + b))
  done
  [ "$(head -n 1 listed | cut -d ' ' -f 2)" -eq $((all - bridges)) ]
  [ "$bridges" -eq 60 ]
  [ "$(grep -c '^[0-9]' listed)" -eq "$kept" ]
  run --separate-stderr -2 mlg networks larger all
  [ "$stderr" = "mlg networks: 'all': expected nothing, \`larger\`, \`larger same\` or \`larger limits\`" ]
}

@test "a network of the larger family at the end of an element is as stiff as the smaller one that it is said to become" {
  mlg networks larger limits > listed
  [ "$(cut -d, -f1 listed | sort -u | wc -l)" -eq 273 ] # all but one, (k_s|(k_d-b))-(k_2|c_d), and the names
  awk -F, 'BEGIN { srand(1404) } NR > 1 { row[n++] = $0 } END { for (i = 0; i < 40; i++) print row[int(n * rand())] }' listed > some
  # at k_s = 4e5 and c_d = 3e3, or k_2 and c_2 so where the other goes to its end
  awk -F, '{ end = $4 == "inf" ? 1e11 : 1e-3; k_s = 4e5; c_d = 3e3; other = end
      if ($3 == "k_s") { k_s = end; other = 4e5 } if ($3 == "c_d") { c_d = end; other = 3e3 }
      sub("_2=[0-9e.]+", "_2=" other, $2)
      printf "%s,%g,70,%g\n%s,4e5,70,3e3\n", $2, k_s, c_d, $6 }' some | oracle balance | paste -d ' ' - - > both
  [ "$(wc -l < both)" -eq 40 ]
  near_each 1e-4 stiffness < both
}

# same_table TOLERANCE FILE FILE: the same words, and numbers that near
same_table() {
  awk -F, -v tolerance="$1" '
    NR == FNR { first[FNR] = $0; next }
    { rows = FNR; n = split(first[FNR], x, ",")
      for (k = 1; k <= NF || k <= n; k++) {
        number = x[k] + 0 != 0 && $k + 0 != 0
        if (number ? (x[k] - $k) ^ 2 > (tolerance * $k) ^ 2 : x[k] != $k) { print "row " FNR ": " first[FNR] " and " $0; exit wrong = 1 } } }
    END { if (!wrong && rows < 2) print "nothing to compare"; exit wrong || rows < 2 }' "$2" "$3"
}

@test "every layout of the paper and of docs/layouts.md is among them, and the same by its text" {
  local layout text n=0 of command
  while read -r layout text; do
    n=$((n + 1))
    of='k_s=6.3e5 b=110'
    case $layout in l1) of='' ;; l2) of=k_s=6.3e5 ;; esac
    for command in intervals boundary "damping c_d=5e3" "hopf c_d=3.6e4" "eigenvalues V=33 c_d=4e3"; do
      # shellcheck disable=SC2086 # one word for each parameter
      mlg ${command%% *} "$layout" $of ${command#"${command%% *}"} > by-name
      # shellcheck disable=SC2086
      mlg ${command%% *} "$text" $of ${command#"${command%% *}"} > by-text
      same_table 1e-6 by-name by-text # V of a least ratio is flat
    done
  done < <(layouts_as_text)
  [ "$n" -eq 9 ]
}

@test "damping ratios are those of the pencil of nodes, at 60 random (network, k_s, b, c_d, V, F_z)" {
  mlg networks | awk -F, '
    /^[0-9]/ { text[n++] = $2 }
    END {
      srand(1401)
      split("c_2=3e3-k_2=2e5|(k_d|c_d-b)|k_s (b_2=40|k_s)-(c_d-(k_d|b)) ((k_s-c_d)|k_d)-(c_2=9e3|k_2=4e6)", more, " ")
      for (i = 1; i in more; i++) text[n++] = more[i]
      for (i = 0; i < 60; i++)
        printf "%s,%.6g,%.6g,%.6g,%.6g,%.6g\n", text[i % n], 2e5 * exp(3 * rand()), 1 + 200 * rand(), 200 * exp(6 * rand()), 1.8e5 + 4e4 * rand(), 1 + 199 * rand() }' > cases
  while IFS=, read -r text k_s b c_d F_z V; do
    case $text in *k_s*) k_s=k_s=$k_s ;; *) k_s=k_s=inf ;; esac
    case "($text)" in *[\(\)\|-]b[\(\)\|-]*) b=b=$b ;; *) b=b=0 ;; esac
    cell zeta damping "$text" "$k_s" "$b" c_d="$c_d" F_z="$F_z" V="$V"
  done < cases > ours
  paste -d ' ' ours <(oracle least < cases) | near_each 1e-6 "zeta"
  [ "$(wc -l < ours)" -eq 60 ]
}

@test "a spring, a damper or an inerter may be a number, two of them one, at any place" {
  mlg intervals 'k_s-(k_d|c_d|b)' k_s=6.38e5 b=140 > named
  mlg intervals ' k=638e3 - ( ( k=54.5e3 | k_2=54500 ) |(b_x=70|c_d| b=70)) ' > numbers
  same_table 1e-9 named numbers
  mlg intervals 'k_d|(k_s-c_d)' k_s=5e5 > named
  mlg intervals '(c_d-k=1e6-k=1e6)|k_d' > numbers
  same_table 1e-9 named numbers
}

@test "what has an equal twin by the inerter's form of Zener's transformation is as well damped" {
  # k_d|(k_s-(c|b)) is k-(K|C|B): k = k_d + k_s, K = k_d k/k_s, C = c (k/k_s)^2, B = b (k/k_s)^2
  local k_s=400000 c=5000 b=60 K C B
  K=$(awk "BEGIN { printf \"%.12g\", 1.09e5 * (1.09e5 + $k_s) / $k_s }")
  C=$(awk "BEGIN { printf \"%.12g\", $c * ((1.09e5 + $k_s) / $k_s) ^ 2 }")
  B=$(awk "BEGIN { printf \"%.12g\", $b * ((1.09e5 + $k_s) / $k_s) ^ 2 }")
  near "$(cell zeta damping 'k_d|(k_s-(c_d|b))' k_s=$k_s c_d=$c b=$b)" \
    "$(cell zeta damping 'k_s-(k_d|c_d|b)' k_s=509000 k_d="$K" c_d="$C" b="$B")" 1e-9 zeta
  # of one family, then, with k_d free, and with k_d held two
  mlg networks | awk -F, '$7 == "li1" { family = $6; same = $5 } $7 == "li5" { other = $6; own = $5 }
    END { exit !(family == other && same != own) }'
}

@test "a spring that is rigid, or too stiff to tell, is none" {
  local k_s net without
  for k_s in inf 1e16 1e18 1e25; do
    while read -r net without; do
      mlg damping "$net" k_s=$k_s b=60 c_d=1e4 F_z=1.2e5 > answer
      mlg intervals "$net" k_s=$k_s b=60 F_z=1.2e5 >> answer
      mlg damping "$without" b=60 c_d=1e4 F_z=1.2e5 > right
      mlg intervals "$without" b=60 F_z=1.2e5 >> right
      same_table 1e-6 answer right || { echo "$net k_s=$k_s"; cat answer right; return 1; }
    done <<'END'
(k_s-(c_d|b))|k_d|c_2=200 c_d|b|k_d|c_2=200
(k_s-c_d-b)|k_d|c_2=200 (c_d-b)|k_d|c_2=200
((k_s-(k_d|c_d))|b)-k_2=8e5 (k_d|c_d|b)-k_2=8e5
k_s-(k_d|(c_d-b)) k_d|(c_d-b)
END
    for net in li2 li3 li4 li7; do
      mlg intervals $net k_s=$k_s b=60 F_z=1.2e5 > answer
      mlg intervals $net k_s=inf b=60 F_z=1.2e5 | diff - answer
    done
    mlg damping '(k_s|b)-(k_d|c_d)' k_s=$k_s b=60 c_d=3e3 > answer
    mlg damping li2 k_s=inf b=60 c_d=3e3 > right
    same_table 1e-6 answer right
  done
  mlg widest '(k_s-(c_d|b=60))|k_d|c_2=200' e=0.08 l=0.25 k_psi=2.6e5 c_delta=200 F_z=1.2e5 | tail -n 1 | grep -q '^inf,2132.77.*,rigid$'
}

@test "dampers and inerters alone in series leave no root at 0 behind" {
  mlg eigenvalues 'k_d|(c_d-b)' V=40 b=10 c_d=2500 | awk -F, 'NR > 1 && $1 ^ 2 + $2 ^ 2 < 1e-12 { exit wrong = 1 } END { exit wrong || NR != 9 }'
  near "$(cell zeta damping 'k_d|(c_d-b)' b=10 c_d=2500)" "$(cell zeta damping 'k_d|(b-c_d)' b=10 c_d=2500)" 1e-9 zeta
  # with so soft a strut, or so long a lead of the wheels, the gear diverges with any device
  local gear
  for gear in k_delta=1e5 "k_d=1 e=2 k_alpha=0" "e=-5 k_alpha=0"; do
    # shellcheck disable=SC2086 # one word for each parameter
    mlg intervals 'k_d|(c_d-b)' b=10 $gear | head -n 1 | grep -q diverges
    # shellcheck disable=SC2086
    mlg intervals 'k_d|c_d|(c=200-b)' b=10 $gear | head -n 1 | grep -q diverges
    # shellcheck disable=SC2086
    mlg intervals l1 $gear | head -n 1 | grep -q diverges
  done
}

@test "a network that makes no sense is refused in one line that says where" {
  local text
  while IFS= read -r text; do
    run --separate-stderr mlg intervals "$text"
    [ "$status" -eq 2 ] || { echo "$text: $status"; false; }
    [ -z "$output" ] && [ "${#stderr_lines[@]}" -eq 1 ]
    [[ $stderr == "mlg intervals: '$text': no network: "* ]] || { echo "$stderr"; false; }
  done << 'EOF'
k_d|(c_d
k_d|c_d)
k_d|c_d|c_d
k_d|k=2
k_d|k_2=|c_d
k_d|k=-1|c_d
k_d|k=1e31|c_d
k_d|k=0.5|c_d
k_d|b=1e-20|c_d
k_d|c=inf|c_d
k_d|b=1e10|c_d
k_d|c_d|(b=1e29-b=1e29-c=1)
k_d–c_d|c_d
k_d|k=0x10|c_d
k_d|k=nan|c_d
|c_d
c_d-
k_d c_d|b
k_psi|c_d
V|c_d
k_d||c_d
c=1|c_d|b|b=2|b=3
k_d|c_d|k=1|k=2|k=3|k=4|k=5|k=6|k=7|k=8
()|c_d
x=3|c_d
EOF
  run --separate-stderr mlg intervals "$(printf 'k_d|c_d%0200d' 0)"
  [ "$status" -eq 2 ]
  run --separate-stderr mlg intervals 'k_d|c_d' b=10
  [ "$status" -eq 2 ]
  run --separate-stderr mlg networks l1
  [ "$status" -eq 2 ]
}

@test "a network is drawn with every element" {
  mlg draw '(k_s-c_d)|k_d|c_2=300' > drawn.svg
  [ "$(grep -c "class='i'" drawn.svg)" -eq 6 ] # psi, k_psi and the four
}

@test "the search meets what is known: L2's widest interval, farthest ratio and best damping, by its text" {
  mlg explore 'k_s-(k_d|c_d)' starts=2 > found
  near "$(awk -F, '$1 == "width" { print $2 }' found)" 10226.87 1e-6 width
  near "$(awk -F, '$1 == "width" { print $3 }' found)" 786523.7 1e-6 k_s
  near "$(awk -F, '$1 == "zeta" { print $2 }' found)" "$(cell zeta damping l2 best)" 1e-6 zeta
  near "$(awk -F, '$1 == "tolerance" { print $2 }' found)" 0.48608 1e-4 tolerance # of libmlg_most_tolerant, in results/tolerance.csv
  # no design above its largest load, one just below it
  load=$(awk -F, '$1 == "load" { print $2 }' found)
  near "$load" 204504 2e-5 load
  mlg widest l2 F_z="$(awk "BEGIN { print $load * 0.9999 }")" | grep -qv -e ',no interval' -e '^[#k]'
  mlg widest l2 F_z="$(awk "BEGIN { print $load * 1.0001 }")" | grep -q ',no interval'
}

@test "an interval at the largest b and the least k_s alone is found" {
  mlg explore 'k_s|((k_d|b)-c_d)' width > found
  awk -F, '$1 == "width" { exit !($2 > 216.34 && $2 < 216.35 && $3 == 109000 && $4 == 300) }' found
  grep -q '^width' found
}

@test "what is free is searched for every quantity, begins where a table says, and varies with the tolerance" {
  # two dampers side by side are one: the same damping, load and tolerance, whatever part of it each has
  mlg explore l1 zeta load starts=1 > one
  mlg explore 'k_d|c_d|c_2=1e3' zeta load starts=1 free=c_2 > two
  for quantity in zeta load; do
    near "$(awk -F, "\$1 == \"$quantity\" { print \$2 }" two)" "$(awk -F, "\$1 == \"$quantity\" { print \$2 }" one)" 1e-3 $quantity
  done
  near "$(cell p tolerance 'k_d|c_d|c_2=1e3' c_d=1886 vary=c_2 sample=0)" "$(cell p tolerance l1 c_d=2886 sample=0)" 1e-6 p
  [ "$(cell corners tolerance 'k_d|c_d|c_2=1e3' c_d=1886 vary=c_2 sample=0)" -eq 8192 ]
  # an interval without end, too
  [ "$(mlg explore 'k_d|((c_d|b)-c_2=2766.3)' ratio starts=1 free=c_2 c_d=1e6 b=264 | awk -F, '$1 == "ratio" { print $2 }')" = inf ]
  printf '%s\n' c_lo,c_hi,c_2 2754,2754,1 300,inf,2e3 > begin
  mlg explore 'k_d|c_d|c_2=1e3' zeta starts=1 free=c_2 begin=begin | awk -F, '$1 == "zeta" { exit !($2 > 2.69e-5 && $8 == 3) }'
}

@test "a file to begin at and an element to search that are not there, or not once, are told" {
  local words wrong
  printf 'k_s,b,c_lo\n1e6,2,3\n' > short
  printf '\xef\xbb\xbfk_s,b,c_lo,c_hi\r\n1e6,y,3,4\r\n' > windows
  printf 'k_s,b,c_lo,c_hi\n1e6,x,3,4\n' > letters
  { echo k_s,b,c_lo,c_hi; yes 1e6,1,2,3 | head -n 39; } > many
  while IFS=: read -r words wrong; do
    # shellcheck disable=SC2086 # words
    run -2 mlg $words
    [ "$output" = "mlg ${words%% *}: '${words##* }': $wrong" ] || { echo "$output"; false; }
  done << 'EOF'
explore li1 begin=missing:missing: No such file or directory
explore li1 begin=short:short has no column c_hi; expected the columns that explore prints for this device
explore li1 begin=letters:letters, row 1: 'x': expected a b of at least 0
explore li1 begin=windows:windows, row 1: 'y': expected a b of at least 0
explore li1 begin=many:39 designs; 38 are most
explore li1 begin=many begin=many:given already
explore l1 free=c_2:a layout has no elements but those of its parameters; give it as a network
explore k_d|c_d free=c_d:the network has no element NAME=VALUE of this name
explore k_d|(c_d-c=3-c=4) free=c:the network has more than one element of this name
explore k_d|(c_d-c_2=3) free=:the network has no element NAME=VALUE of this name
tolerance l1 vary=c_2:a layout has no elements but those of its parameters; give it as a network
tolerance k_d|(c_d-c_2=3) vary=c_3:the network has no element NAME=VALUE of this name
tolerance k_d|(c_d-c_2=3) vary=c_2 vary=c_2:given already
tolerance k_d|(c_d-c_2=3) best vary=c_2:goes with a design; `mlg explore` searches with free=NAME
EOF
}

# some_rows QUANTITY N: random rows of results/networks.csv as network,value,k_s,b,c_lo,c_hi
some_rows() {
  awk -F, -v OFS=, -v quantity="$1" -v rows="$2" 'BEGIN { srand(1402) }
    $1 == quantity { row[n++] = $4 OFS $6 OFS ($7 == "" ? "inf" : $7) OFS ($8 == "" ? 0 : $8) OFS $9 OFS $10 }
    END { for (i = 0; i < rows; i++) print row[int(n * rand())] }' "$ROOT/results/networks.csv"
}

@test "random rows of the table of networks stand before the pencil of nodes: damping" {
  # the table has seven digits of k_s and c_d, at which two modes share the ratio, and 400 speeds miss the least a little
  some_rows zeta 8 > rows
  paste -d ' ' <(awk -F, -v OFS=, '{ print $1, $3, $4, $5 }' rows | oracle least) <(cut -d, -f2 rows) | tee both \
    | awk '{ if (($1 - $2) ^ 2 > (2e-3 * $2) ^ 2 + 1e-14) { print; exit wrong = 1 } } END { exit wrong || NR != 8 }' || { cat both; false; }
}

@test "random rows of the table of networks: no shimmy inside the interval, its ends are Hopf points" {
  local size network value k_s b lo hi c
  { some_rows width 4 | sed 's/^/hi - lo,/'; some_rows ratio 4 | sed 's/^/hi \/ lo,/'; } > rows
  while IFS=, read -r size network value k_s b lo hi; do
    near "$(awk "BEGIN { lo = $lo; hi = $hi; printf \"%.10g\", $size }")" "$value" 1e-5 "$size of $network"
    for c in 1.001 0.5 0.999; do # within the interval, in the ratio of its ends
      awk "BEGIN { print ($c > 1 ? $lo * $c : $c < 0.9 ? sqrt($lo * $hi) : $hi * $c) }" | sed "s/^/$network,$k_s,$b,/"
    done | oracle least | awk -v network="$network" '$1 <= -1e-7 { print network, $0; exit wrong = 1 } END { exit wrong || NR != 3 }'
    printf '%s\n' "$network,$k_s,$b,$(awk "BEGIN { print $lo * 0.98 }")" "$network,$k_s,$b,$(awk "BEGIN { print $hi * 1.02 }")" \
      | oracle least | awk -v network="$network" '$1 >= 0 { print network, $0; exit wrong = 1 } END { exit wrong || NR != 2 }'
  done < rows
}

@test "random rows of the table of networks: free of shimmy just below the largest load, not above it" {
  # a design may be free near its largest load alone; the table has seven digits
  some_rows load 6 > rows
  awk -F, -v OFS=, '{ for (i = 0; i < 60; i++) V = V OFS sprintf("%.6g", 0.3 * exp(6.5 * i / 59)); printf "%s,%s,%s,%s,%.10g%s\n", $1, $3, $4, $5, 0.99999 * $2, V; V = "" }' rows \
    | oracle least | awk '$1 < -1e-7 { print NR, $0; exit wrong = 1 } END { exit wrong || NR != 6 }'
  awk -F, -v OFS=, '{ for (i = 0; i < 240; i++) V = V OFS sprintf("%.6g", 0.3 * exp(6.5 * i / 239)); printf "%s,%s,%s,%s,%.10g%s\n", $1, $3, $4, $5, 1.003 * $2, V; V = "" }' rows \
    | oracle least | awk '!($1 < 0) { print NR, $0; exit wrong = 1 } END { exit wrong || NR != 6 }'
}

@test "a random row of the table of networks has its tolerance, all corners tested; beyond it the worst corner shimmies" {
  local network p k_s b c_d rest words=() V corner
  some_rows tolerance 1 > row
  IFS=, read -r network p k_s b c_d rest < row
  [ "$k_s" = inf ] || words+=("k_s=$k_s")
  [ "$b" = 0 ] || words+=("b=$b")
  mlg tolerance "$network" "${words[@]}" c_d="$c_d" sample=0 > found
  near "$(mlg pick "$PWD/found" columns=p)" "$p" 2e-5 "p of $network" # the table has seven digits
  IFS=, read -r V corner < <(mlg pick "$PWD/found" columns=V,corner)
  # 3 % of p before, at 400 speeds, and beyond, about that one
  {
    awk "BEGIN { printf \"$network,$k_s,$b,$c_d,%.10g,$corner\n\", 0.0097 * $p }"
    awk "BEGIN { printf \"$network,$k_s,$b,$c_d,%.10g,$corner\", 0.0103 * $p; for (i = -20; i <= 20; i++) printf \",%.6g\", $V * (1 + 0.01 * i); print \"\" }"
  } | oracle corner > ratios
  awk 'NR == 1 && $1 > 0 || NR == 2 && $1 < 0 { n++ } END { exit n != 2 }' ratios || { cat row found ratios; false; }
}

# larger_rows QUANTITY N: random rows of results/networks_larger.csv as network,value,k_s,b,c_lo,c_hi,static,free
larger_rows() {
  awk -F, -v OFS=, -v quantity="$1" -v n="$2" 'BEGIN { srand(1403) }
    $1 == quantity && $6 !~ /inf/ { sub($5, $5 "=" $9, $4); row[m++] = $4 OFS $6 OFS ($7 == "" ? "inf" : $7) OFS ($8 == "" ? 0 : $8) OFS $10 OFS $11 OFS $12 OFS $5 }
    END { for (i = 0; i < n; i++) print row[int(m * rand())] }' "$ROOT/results/networks_larger.csv"
}

@test "random rows of the larger family stand before the pencil of nodes: damping, intervals, static stiffness" {
  local network value k_s b lo hi rest quantity
  larger_rows zeta 6 > rows
  paste -d ' ' <(awk -F, -v OFS=, '{ print $1, $3, $4, $5 }' rows | oracle least) <(cut -d, -f2 rows) | tee both \
    | awk '{ if (($1 - $2) ^ 2 > (5e-3 * $2) ^ 2 + 1e-12) { print; exit wrong = 1 } } END { exit wrong || NR != 6 }' || { cat both; false; }
  for quantity in width ratio; do
    larger_rows $quantity 4 > rows
    while IFS=, read -r network value k_s b lo hi rest; do
      near "$(awk "BEGIN { printf \"%.10g\", $([ $quantity = width ] && echo "$hi - $lo" || echo "$hi / $lo") }")" "$value" 1e-5 "$quantity of $network"
      for c in 0.01 0.5 0.99; do awk "BEGIN { print $lo + $c * ($hi - $lo) }" | sed "s/^/$network,$k_s,$b,/"; done \
        | oracle least | awk -v network="$network" '$1 <= -1e-7 { print network, $0; exit wrong = 1 } END { exit wrong || NR != 3 }'
    done < rows
  done
  for quantity in zeta width load tolerance; do larger_rows $quantity 3; done > rows
  paste -d ' ' <(cut -d, -f1,3 rows | oracle balance) <(cut -d, -f7 rows) | near_each 1e-5 static
}

@test "random rows of the larger family: free of shimmy just below the largest load, and at corners within the tolerance" {
  larger_rows load 6 > rows
  awk -F, -v OFS=, '{ for (i = 0; i < 60; i++) V = V OFS sprintf("%.6g", 0.3 * exp(6.5 * i / 59)); printf "%s,%s,%s,%s,%.10g%s\n", $1, $3, $4, $5, 0.99999 * $2, V; V = "" }' rows \
    | oracle least | awk '$1 < -1e-7 { print NR, $0; exit wrong = 1 } END { exit wrong || NR != 6 }'
  larger_rows tolerance 4 > rows
  awk -F, -v OFS=, '{ print $1, $3, $4, $5, $8, 0.9999 * $2 }' rows | oracle inside | awk '$1 < -1e-7 { print NR, $0; exit wrong = 1 } END { exit wrong || NR != 4 }'
  awk -F, -v OFS=, '{ print $1, $3, $4, $5, $8, 1.4 * $2 }' rows | oracle inside | awk '$1 > 0 { print NR, $0; exit wrong = 1 } END { exit wrong || NR != 4 }'
}

@test "no network of the larger family has less than a smaller one that it becomes" {
  # a spring at 1e9 is nearly rigid, a damper of 10 nearly not there; one of 1e7 still takes a tenth of the damping
  mlg networks larger limits > listed
  awk -F, '
    FILENAME == "listed" { if (($4 == "inf") == ($3 ~ /^k/)) { limit[++n] = $1 SUBSEP $5; element[n] = $3 } next }
    FILENAME ~ /networks.csv/ { if (/^(zeta|width|load),/) small[$1, $3] = $6; next }
    /^(zeta|width|load),/ { large[$1, $3] = $6 }
    END {
      split("zeta width load", quantity, " ")
      for (i = 1; i <= n; i++)
        for (q = 1; q <= 3; q++) {
          split(limit[i], of, SUBSEP)
          if (quantity[q] == "width" && element[i] == "c_d") continue # it is one of c_d
          if (!((quantity[q], of[1]) in large) || !((quantity[q], of[2]) in small) || !(small[quantity[q], of[2]] > 0)) continue
          compared++
          if (large[quantity[q], of[1]] !~ /inf/ && large[quantity[q], of[1]] < 0.97 * small[quantity[q], of[2]]) {
            print quantity[q], of[1], large[quantity[q], of[1]], "less than", small[quantity[q], of[2]], "of", of[2]; exit wrong = 1 }
        }
      exit wrong || compared < 100 }' listed "$ROOT/results/networks.csv" "$ROOT/results/networks_larger.csv"
}

@test "what inertance buys: no less with more of it, as damped and tolerant before the pencil of nodes as the table says" {
  awk -F, '$1 == "zeta" || $1 == "tolerance" {
      if ($1 $2 == series && ($5 < 0.999 * value || $4 <= b_most)) { print; exit wrong = 1 }
      if ($7 > $4 * 1.000001) { print; exit wrong = 1 }
      series = $1 $2; value = $5; b_most = $4; n++ }
    END { exit wrong || n < 36 }' "$ROOT/results/networks_b.csv"
  awk -F, -v OFS=, 'BEGIN { srand(1405) } $1 == "zeta" || $1 == "tolerance" { if ($3 != "") sub($3, $3 "=" $8, $2); row[$1, n[$1]++] = $2 OFS $6 OFS $7 OFS $9 OFS $3 OFS $5 }
    END { for (i = 0; i < 5; i++) { print row["zeta", int(n["zeta"] * rand())] > "damped"; print row["tolerance", int(n["tolerance"] * rand())] > "tolerant" } }' \
    "$ROOT/results/networks_b.csv"
  paste -d ' ' <(cut -d, -f1-4 damped | oracle least) <(cut -d, -f6 damped) \
    | awk '{ if (($1 - $2) ^ 2 > (5e-3 * $2) ^ 2 + 1e-12) { print; exit wrong = 1 } } END { exit wrong || NR != 5 }'
  awk -F, -v OFS=, '{ $6 *= 0.9999; print }' tolerant | oracle inside | awk '$1 < -1e-7 { print NR, $0; exit wrong = 1 } END { exit wrong || NR != 5 }'
  awk -F, -v OFS=, '{ $6 *= 1.5; print }' tolerant | oracle inside | awk '$1 > 0 { print NR, $0; exit wrong = 1 } END { exit wrong || NR != 5 }'
}

@test "the table of networks has the paper's layouts as they are known, and no width above that of LI2 at b = 300 but those it ranks" {
  local layout width
  while read -r layout width; do
    near "$(awk -F, -v layout="$layout" '$1 == "width" && $5 == layout { print $6 }' "$ROOT/results/networks.csv")" "$width" 1e-6 "width of $layout"
  done << 'EOF'
l1 264.6269
l2 10226.87
li1 11244.367
li2 22353.557
li3 14101.398
li4 20740.065
li5 7847.7306
li6 13766.12
li7 10246.19
EOF
  awk -F, '!/^#/ && $1 != "quantity" { if ($1 == last && $6 > before) exit 1; if ($1 == last && $2 != rank + 1) exit 1; last = $1; before = $6; rank = $2; n[$1]++ }
    END { exit n["zeta"] != 35 || n["load"] != 35 || n["tolerance"] > n["width"] || n["width"] != n["ratio"] || n["width"] < 20 }' "$ROOT/results/networks.csv"
}

@test "every passive device of the table is passive, stiff enough, and as well damped as it says" {
  awk -F, -v OFS=, '$3 == "passive" { print $14, $15, $2 + 0, $1 == "any" ? 0 : 109e3, $1 == "fast" ? 10 : 0.3 }' "$ROOT/results/passive.csv" | oracle passive > ours
  paste -d ' ' ours <(awk -F, '$3 == "passive" { print $5 }' "$ROOT/results/passive.csv") \
    | awk '{ if ($1 + 0 == 0 || ($1 - $2) ^ 2 > (2e-3 * $2) ^ 2 + 1e-14) { print; exit wrong = 1 } } END { exit wrong || NR != 48 }'
}

@test "no higher order and no lesser static stiffness damps less; no known device is better; the search finds L1" {
  awk -F, '$3 == "passive" { if ($1 $2 == series && $5 < zeta) { print; exit wrong = 1 } series = $1 $2; zeta = $5 }
    $1 == "order" { stiff[$2, $4] = $5 }
    $1 != "order" && $3 == "passive" && $5 < 0.999 * stiff[$2, $4] { print; exit wrong = 1 } END { exit wrong }' "$ROOT/results/passive.csv"
  # of its order, with any static stiffness: L1, L2, LI1, LI2
  paste -d ' ' <(awk -F, '$1 == "any" && $2 == "200e3" && $4 <= 4 { print $5 }' "$ROOT/results/passive.csv") \
    <(for layout in l1 l2 li1 li2; do mlg pick "$ROOT/results/networks.csv" where=quantity=zeta where=layout=$layout columns=value; done) \
    | awk '$1 < 0.999 * $2 { print; exit wrong = 1 } END { exit wrong || NR != 4 }'
  near "$(mlg passive order=1 starts=2 | awk -F, '$1 == 1 { print $2 }')" "$(cell zeta damping l1 best)" 1e-3 zeta
}

@test "a search over passive devices goes on from a table of lower orders, and takes none of another gear" {
  mlg passive order=2 starts=1 > whole
  head -n 3 whole > first
  mlg passive order=2 starts=1 from=first | cmp - whole
  run -2 bash -c "build/bin/mlg passive from=first F_z=180e3 2>&1 > /dev/null"
  [[ "$output" == "mlg passive: first: order 1 has zeta = "*", with this gear and range of V it is "* ]]
  run -2 bash -c "build/bin/mlg passive from='$ROOT/results/passive.csv' 2>&1 > /dev/null"
  [ "$output" = "mlg passive: $ROOT/results/passive.csv: no table of mlg passive, for it has no column 'order'" ]
}

@test "the delta mode of locked wheels is that of the gear with a rigid device" {
  mlg deltamode > found
  local V
  V=$(awk -F, '$1 == "locked" { print $3 }' found)
  near "$(awk -F, '$1 == "locked" { print $2 }' found)" "$(mlg eigenvalues l1 V="$V" k_psi=1e12 k_d=1e12 c_d=1 \
    | awk -F, 'NR > 1 && $3 > 16 && $3 < 19 { printf "%.10g", -$1 / sqrt($1 ^ 2 + $2 ^ 2); exit }')" 1e-3 locked
}

@test "counts are whole, speeds above 0, and a strut that does not oscillate has no delta mode" {
  local words
  for words in "passive order=1.5" "passive starts=1.5" "explore l1 starts=1.5"; do
    # shellcheck disable=SC2086 # words
    run -2 mlg $words
    [[ "$output" == "mlg ${words%% *}: '${words##* }': expected a whole number" ]]
  done
  run -2 mlg passive V_least=0
  [[ "$output" == "mlg passive: 'V_least=0': outside its range, 0.001 to 1000 m/s" ]]
  # what is searched is no value to give
  for words in "l2 k_s=3e5" "li1 b=30"; do
    # shellcheck disable=SC2086 # words
    run -2 mlg explore $words
    [[ "$output" == "mlg explore: '${words##* }': all "*" are searched; to begin at a design give its c_d as well" ]]
  done
  for words in F_z=2e5 M=2e4; do
    run -2 mlg explore l1 load $words
    [ "$output" = "mlg explore: '$words': the search for the largest load is over all loads" ]
  done
  run -2 mlg explore 'k_d|(c_d-c_2=300)' free=c_2 free=c_2
  [ "$output" = "mlg explore: 'free=c_2': given already" ]
  run -2 mlg explore l1 zeta zeta
  [ "$output" = "mlg explore: 'zeta': given already" ]
  run -2 mlg explore li1 zeta k_s=1e6 b=400 c_d=1e4
  [ "$output" = "mlg explore: 'b=400': above b_most = 300, up to which b is searched" ]
  run -2 mlg explore 'k_d|(c_d-c_2=300)' free=c_3
  [ "$output" = "mlg explore: 'free=c_3': the network has no element NAME=VALUE of this name" ]
  run -1 mlg deltamode M=1e6
  [ "$output" = "mlg deltamode: delta does not oscillate: the load takes all of k_delta's stiffness away" ]
  [ "$(mlg explore l1 load starts=1 c_delta=0 c_psi=0 | wc -l)" -eq 2 ] # no load, no row
  echo "PAR = {'M': 0.0}" > light.gear
  near "$(mlg explore l1 load starts=1 gear=light.gear | awk -F, '$1 == "load" { print $2 }')" \
    "$(mlg explore l1 load starts=1 | awk -F, '$1 == "load" { print $2 }')" 1e-4 load
}
