# mlg.bats - the one command: its help, and the one set of rules for its words
#
# Needs   build/bin/mlg (make build/bin/mlg)
# Writes  build/tests/mlg

bats_require_minimum_version 1.5.0
load scratch

setup_file() {
  scratch mlg
}

setup() {
  cd "$SCRATCH" || return
}

# refuses LINE WORD...: that line, on standard error alone, and status 2
refuses() {
  run -2 --separate-stderr mlg "${@:2}"
  # shellcheck disable=SC2154 # set by run
  [ -z "$output" ]
  # shellcheck disable=SC2154 # set by run
  [ "$stderr" = "$1" ] || { echo "$stderr" && return 1; }
}

commands() {
  sed -n 's/^const struct command command_\([a-z_]*\) = {$/\1/p' scripts/mlg/*/*.c
}

@test "help lists every command and layout, and says of each what it prints" {
  local command
  mlg help >list
  for command in $(commands); do
    grep -q "^  $command  *[A-Za-z]" list
    mlg help "$command" >one
    [ "$(head -n 1 one | cut -d ' ' -f 1,2)" = "mlg $command" ]
    [ "$(wc -l <one)" -ge 4 ]
    [ "$(awk 'length($0) > 100' one list | wc -l)" -eq 0 ]
  done
  [ "$(commands | wc -l)" -eq "$(($(grep -c "^  [a-z]" list) - 1))" ] # help itself
  for command in models/l*.c; do
    grep -q "^LAYOUT:.* $(basename "$command" .c)\b" list
  done
  cmp list <(mlg --help)
}

@test "no command, or one that is none" {
  refuses "mlg: expected a command; \`mlg help\` lists them"
  refuses "mlg: 'scan': no such command; \`mlg help\` lists them" scan
  refuses "mlg help: 'scan': no such command; \`mlg help\` lists them" help scan
  refuses "mlg help: 'l1': expected one command at most" help draw l1
}

@test "no layout, or one that is none, in every command that has one" {
  local command
  for command in $(commands); do
    mlg help "$command" | head -n 1 | grep -q "^mlg $command LAYOUT" || continue
    refuses "mlg $command: expected a layout; \`mlg help $command\` says more" "$command"
    refuses "mlg $command: 'l9': no such layout; there are l1, l2, li1, li2, li3, li4, li5, li6, li7" "$command" l9
  done
  refuses "mlg draw: 'V=3': expected nothing behind the layout" draw l1 V=3
  refuses "mlg gear: 'l1': expected nothing behind the command" gear l1
}

@test "words that give no value" {
  refuses "mlg eigenvalues: 'c_q=1': no such parameter (see models/mlg.h)" eigenvalues l1 c_q=1
  refuses "mlg eigenvalues: 'psi_max=1': no such parameter (see models/mlg.h)" eigenvalues l1 psi_max=1
  local word
  refuses "mlg eigenvalues: 'R': expected NAME=NUMBER; \`mlg help eigenvalues\` has its other words" eigenvalues l1 R
  for word in R= =1 R=nan R=inf R=1e999 R=0x10 R=1,2 'R=1 2' 'R= 1' R=one V=20=3 '' 'V =3'; do
    refuses "mlg eigenvalues: '$word': expected NAME=NUMBER" eigenvalues l1 "$word" ||
      refuses "mlg eigenvalues: '$word': no such parameter (see models/mlg.h)" eigenvalues l1 "$word"
  done
  refuses "mlg eigenvalues: 'a b=1': no such parameter (see models/mlg.h)" eigenvalues l1 $'a\nb=1'
}

@test "every parameter keeps its range, of models/mlg.h" {
  local name least most n=0
  while read -r name least most; do
    n=$((n + 1))
    run -2 --separate-stderr mlg eigenvalues li1 "$name=$(awk "BEGIN { print $least - 1 }")"
    [[ $stderr == "mlg eigenvalues: '$name="*"': outside its range, "* ]] || { echo "$stderr" && return 1; }
    [ "$most" = INFINITY ] && continue
    run -2 --separate-stderr mlg eigenvalues li1 "$name=$(awk "BEGIN { print 2 * $most }")"
    [[ $stderr == "mlg eigenvalues: '$name="*"': outside its range, "* ]] || { echo "$stderr" && return 1; }
  done < <(sed -n '/define MLG_PARAMETERS/,/^$/s|^ *X([^"]*"\([^"]*\)", *"[^"]*", *[^,]*, *\([^,]*\), *\([^,]*\),.*|\1 \2 \3|p' models/mlg.h)
  [ "$n" -eq 43 ]
  refuses "mlg damping: 'V_top=0': outside its range, 0.001 to 1000 m/s" damping l1 V_top=0
  refuses "mlg damping: 'compliance=-1': outside its range, 0 to 100000 1e-5 rad/(N m)" damping l2 compliance=-1
}

@test "a name is given once" {
  refuses "mlg eigenvalues: 'V=4': given already, by 'V=3'" eigenvalues l1 V=3 V=4
  refuses "mlg eigenvalues: 'compliance=0': given already, by 'k_s=1e6'" eigenvalues l2 k_s=1e6 compliance=0
  refuses "mlg eigenvalues: 'F_z=2e5': M is given already, by 'M=2e4'" eigenvalues l2 F_z=2e5 M=2e4
  refuses "mlg eigenvalues: 'gear=b': given already, by 'gear=a'" eigenvalues l2 gear=a gear=b
  refuses "mlg damping: 'c_d=1:2:3': given already, by 'c_d=4'" damping l1 c_d=4 c_d=1:2:3
  refuses "mlg simulate: 'psi=2': given already, by 'psi=1'" simulate l1 history psi=1 psi=2
}

@test "a parameter that the device does not have is refused, but for a rigid k_s and b = 0" {
  refuses "mlg eigenvalues: 'k_s=1e6': layout l1 has no k_s" eigenvalues l1 k_s=1e6
  refuses "mlg eigenvalues: 'compliance=1': layout l1 has no k_s" eigenvalues l1 compliance=1
  refuses "mlg eigenvalues: 'b=1': layout l2 has no b" eigenvalues l2 b=1
  refuses "mlg damping: 'b=0:1:3': layout l1 has no b" damping l1 b=0:1:3
  mlg eigenvalues l1 k_s=1e30 b=0 | cmp - <(mlg eigenvalues l1 k_s=inf)
  mlg eigenvalues l1 compliance=0 | cmp - <(mlg eigenvalues l1)
  mlg eigenvalues li5 k_s=1e6 b=3 >some
}

@test "F_z is the static load in place of M" {
  mlg eigenvalues li1 F_z=150e3 g=10 m_D=400 V=20 | cmp - <(mlg eigenvalues li1 M=14600 g=10 m_D=400 V=20)
  refuses "mlg eigenvalues: 'F_z=1000': makes M = F_z/g - m_D = -398.063 kg, outside its range, 0 to 1e+06 kg" \
    eigenvalues l1 F_z=1000
}

@test "a gear file gives what is not given by name" {
  mlg eigenvalues l1 gear=constants/gear.printed | cmp - <(mlg eigenvalues l1 phi=0.0524 M=19900)
  mlg eigenvalues l1 M=2e4 gear=constants/gear.printed | cmp - <(mlg eigenvalues l1 phi=0.0524 M=2e4)
  mlg eigenvalues l1 F_z=2e5 gear=constants/gear.printed | cmp - <(mlg eigenvalues l1 phi=0.0524 F_z=2e5)
  # F_z stands for M in it as among the words; a word goes before either
  printf "PAR = {'F_z': 150e3 N, 'g': 10, 'k_s': inf}" >loaded
  mlg eigenvalues li1 gear=loaded m_D=400 | cmp - <(mlg eigenvalues li1 F_z=150e3 g=10 m_D=400)
  mlg eigenvalues li1 gear=loaded M=2e4 | cmp - <(mlg eigenvalues li1 g=10 M=2e4)
  mlg eigenvalues li1 gear=loaded F_z=2e5 | cmp - <(mlg eigenvalues li1 g=10 F_z=2e5)
  printf '! mine\nPAR = {"V" : 30.0 m/s,\n  k_d: 9e4 N m/rad}  # end\n' >mine
  mlg eigenvalues l1 gear=mine | cmp - <(mlg eigenvalues l1 V=30 k_d=9e4)
}

# gear LINE TEXT: the line a gear file of that text is refused with, by commands about a gear
# and where it is handed over to AUTO
gear() {
  printf '%b' "$2" >gear
  refuses "$1" eigenvalues l1 gear=gear && refuses "$1" constants constants/c.l1.straight gear=gear
}

@test "slips in a gear file: its name, the line, what would be right" {
  refuses "mlg eigenvalues: 'gear=': expected gear=FILE" eigenvalues l1 gear=
  refuses "mlg probability: 'spread=': expected spread=FILE" probability l1 spread=
  refuses 'none: No such file or directory; expected a file of gear parameters' eigenvalues l1 gear=none
  gear "gear:1: expected one constant, PAR = {'name': value, ...}" ''
  gear "gear:2: expected one constant, PAR = {'name': value, ...}" '# c\nNMX = 3'
  gear "gear:2: expected one constant, PAR = {'name': value, ...}" "PAR = {'V': 3}\nNMX = 3"
  gear "gear:1: PAR: 'c_q' is not a parameter (docs/model.md has them)" "PAR = {'c_q': 3}"
  gear "gear:2: V = three is not a finite number" "PAR = {\n'V': three}"
  gear "gear:1: V = -3 m/s is outside its range, 0 to 1000" "PAR = {'V': -3}"
  gear "gear:1: PAR: V is in km/h here; it has to be in m/s" "PAR = {'V': 3 km/h}"
  gear "gear:1: PAR: V is given twice" "PAR = {'V': 3, 'V': 4}"
  gear "gear:2: PAR: both M and F_z = (M + m_D) g are given; give one" "PAR = {'F_z': 6e4,\n'M': 2e4}"
  gear "gear:1: PAR: F_z is in kN here; it has to be in N" "PAR = {'F_z': 60 kN}"
  gear "gear:1: F_z = -1 N is outside its range, 0.001 to 1e+09" "PAR = {'F_z': -1}"
  gear "gear:1: PAR: '4' is not a parameter (docs/model.md has them)" "PAR = {4: 0.1}"
  # of the last element: its own line, not that of the bracket behind it
  gear "gear:2: PAR: '09 m' stands where a name should; a number has a decimal point, no comma" "PAR = {\n'e': 0,09 m\n}"
  gear "gear:2: e has no value" "PAR = {\n'e': \n}"
  gear "gear:2: m_D = -5 kg is outside its range, 0.001 to 1e+06" "PAR = {\n'm_D': -5 kg\n}"
  gear "gear:3: PAR: both M and F_z = (M + m_D) g are given; give one" "PAR = {'F_z': 6e4,\n\n'M': 2e4\n}"
  gear "gear:1: PAR: a bracket is left open" "PAR = {'V': 3"
  gear "gear:1: expected ':' and not '}'; the form is PAR = {'name': value, ...}" "PAR = {'V'}"
  gear "gear:1: expected '{' and not '[1, 2]'; the form is PAR = {'name': value, ...}" "PAR = [1, 2]"
  gear 'gear: holds a zero byte; not a file of gear parameters' "PAR = {'V': 3}\\0000"
  gear "gear:1: F_z = inf is not a finite number" "PAR = {'F_z': inf}"
  gear "gear:1: F_z = 0 N is outside its range, 0.001 to 1e+09" "PAR = {'F_z': 0 N}"
  gear "gear:1: PAR: F_z is given twice" "PAR = {'F_z': 2e5, 'F_z': 2e5}"
  printf "\xef\xbb\xbfPAR\t=\t{'V':\t30\tm/s}\r\n" >gear # as Windows writes it
  mlg eigenvalues l1 gear=gear | cmp - <(mlg eigenvalues l1 V=30)
  printf "PAR = {'b': 3}" >gear
  refuses "mlg eigenvalues: 'gear=gear': layout l1 has no b" eigenvalues l1 gear=gear
  printf "PAR = {'F_z': 600}" >gear
  refuses "mlg eigenvalues: 'gear=gear': its F_z makes M = F_z/g - m_D = -438.838 kg, outside its range, 0 to 1e+06 kg" eigenvalues l1 gear=gear
}

@test "of a range no count wraps, no end is a word or a hexadecimal number" {
  local range
  for range in 1:100:4294967298 1:100:1e9 1:100:1.5 1:100:1 1:100: 1:100 :100:3 1::3 100:1:3 nan:100:3 -inf:100:3 1:inf:3 0x1:100:3 '1: 100:3' 1:100:3:4; do
    refuses "mlg joints: 'V=$range': expected NAME=FROM:TO:N, FROM below TO and N a whole number from 2 to 1000000" joints l1 V="$range"
  done
  refuses "mlg tolerance: 'k_s=3e5:4e6:4294967298': expected NAME=FROM:TO:N, FROM below TO and N a whole number from 2 to 1000000" \
    tolerance li2 map k_s=3e5:4e6:4294967298
}

@test "the loads of an axis are those that a gear may have" {
  refuses "mlg loads: from = 1000 N makes M = F_z/g - m_D = -398.063 kg, outside its range, 0 to 1e+06 kg" loads l2 k_s=7e5 from=1e3
  refuses "mlg loads: to = 1e+09 N makes M = F_z/g - m_D = 1.01936e+08 kg, outside its range, 0 to 1e+06 kg" \
    loads l2 k_s=7e5 to=1e9 step=1e8
  refuses "mlg loads: 'widets': expected NAME=NUMBER; \`mlg help loads\` has its other words" loads l2 widets
}

@test "a layout that comes second is told where it goes" {
  refuses "mlg tolerance: 'best': the layout comes first: mlg tolerance li2 best" tolerance best li2
  refuses "mlg damping: 'best': the layout comes first: mlg damping k_s-(k_d|c_d) best" damping best 'k_s-(k_d|c_d)'
  refuses "mlg loads: 'widest': the layout comes first: mlg loads l2 widest" loads widest l2 from=1e5
}

@test "a long search says on a terminal alone how far it is" {
  script -qec "build/bin/mlg damping l2 best 2>&1 >/dev/null" /dev/null < /dev/null > shown
  grep -q "damping, grid over b: 1 of 1" shown
  [ -z "$(build/bin/mlg damping l2 best 2>&1 > /dev/null)" ]
}

@test "every command says that it cannot write" {
  local words
  for words in 'eigenvalues l1' 'damping l1 V=20' 'draw l1' gear help 'help draw' 'simulate l1 history psi=0.1 t_end=0.01'; do
    run -1 bash -c "build/bin/mlg $words >/dev/full"
    [ "$output" = "mlg ${words%% *}: cannot write the output: No space left on device" ]
  done
}

@test "eigenvalues are those of the oracle, without the states that only follow" {
  local layout words n
  while read -r layout n words; do
    # shellcheck disable=SC2086 # one word for each parameter
    mlg eigenvalues "$layout" $words | sed 1d | tr , ' ' >ours
    [ "$(wc -l <ours)" -eq "$n" ]
    # shellcheck disable=SC2086
    "build/bin/eigen-$layout" eigenvalues $words | awk 'NR > 1 && ($1 + 1000) ^ 2 + $2 ^ 2 > 1e-2' >oracle
    paste -d ' ' ours oracle | awk '
      { size = sqrt($1 ^ 2 + $2 ^ 2) + 1; if (($1 - $4) ^ 2 + ($2 - $5) ^ 2 > (1e-8 * size) ^ 2) { print; bad = 1 } }
      END { exit bad || NR != '"$n"' }'
  done <<'END'
l1 7 V=30
l2 7 V=30 k_s=7e5
li1 8 V=30 k_s=7e5 b=50
li1 7 V=30 k_s=7e5 b=0
li1 8 V=30 k_s=1e30 b=50
li2 9 V=30 k_s=7e5 b=50
li2 7 V=30 k_s=7e5 b=0
li2 7 V=30 k_s=1e30 b=50
li3 9 V=30 k_s=7e5 b=50
li3 7 V=30 k_s=7e5 b=0
li3 8 V=30 k_s=1e30 b=50
li4 9 V=30 k_s=7e5 b=50
li4 7 V=30 k_s=7e5 b=0
li5 8 V=30 k_s=7e5 b=50
li6 8 V=30 k_s=7e5 b=50
li6 6 V=30 k_s=7e5 b=0
li7 9 V=30 k_s=7e5 b=50
li7 7 V=30 k_s=7e5 b=0
END
}

@test "an oscillation is called by where its kinetic energy is, not by the larger angle" {
  # the strut twice as long: the mode of 17.2 Hz bends by 0.66 of its torsion, and carries twice its energy
  [ "$(mlg hopf l1 l_delta=1.5 c_d=3.6e4 | sed 1,2d | cut -d , -f 4 | xargs)" = "delta psi psi delta" ]
  [ "$(mlg hopf l1 c_d=3.6e4 | sed 1,2d | cut -d , -f 4 | xargs)" = "psi delta psi delta" ]
}

@test "the criticality of a point that is none" {
  local line
  for line in 20,3000,7e5,50 20,3000,7e5,50,11,3 a,3000,7e5,50,11 ''; do
    run -2 --separate-stderr bash -c "echo '$line' | build/bin/mlg criticality li1"
    [ "$stderr" = "mlg criticality: standard input:1: '$line': expected V,c_d,k_s,b,frequency_hz" ] || { echo "$stderr" && return 1; }
  done
  run -2 --separate-stderr bash -c "printf '20,3000,7e5,50,11\n20,-1,7e5,50,11\n' | build/bin/mlg criticality li1"
  [ "$stderr" = 'mlg criticality: standard input:2: c_d = -1: outside its range, 0 to 1e+09 N m s/rad' ]
  refuses "mlg criticality: 'V=3': the points on standard input give it" criticality li1 V=3
}
