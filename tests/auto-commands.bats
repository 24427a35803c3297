# auto-commands.bats - do AUTO's own commands take a layout as it is?
#
# In a folder with nothing but copies of models/ and constants/, AUTO compiles
# and runs layout L1, first by its shell commands, then by its Python interface.
# The constants file c.l1.straight is "l1 straight" to @r, and c='l1.straight' to
# run() and load().
#
# Needs   build/auto.mk
# Writes  build/tests/auto-commands

# shellcheck disable=SC2030,SC2031 # each test runs in a shell of its own
bats_require_minimum_version 1.5.0
load scratch

setup_file() {
  export ROOT AUTO OMP_NUM_THREADS=1 LC_ALL=C
  unset MAKEFLAGS MFLAGS MAKELEVEL
  ROOT=$(realpath "$BATS_TEST_DIRNAME/..")
  rm -rf "$ROOT/build/tests/auto-commands"
  # As seen from the folder of a test: AUTO does not stand blanks in AUTO_DIR,
  # and the path to the checkout may have some
  AUTO=$(sed -n 's/^AUTO_DIR = //p' "$ROOT/build/auto.mk")
  case $AUTO in
  /*) ;;
  *) AUTO=../../../../$AUTO ;;
  esac
}

setup() {
  local here=$ROOT/build/tests/auto-commands/$BATS_TEST_NUMBER
  mkdir -p "$here"
  cd "$here" || return
  cp "$ROOT"/models/*.[ch] "$ROOT"/constants/c.* .
  export AUTO_DIR=$AUTO PATH=$AUTO/cmds:$AUTO/bin:$PATH
}

auto_python() { # script
  if command -v auto >/dev/null; then auto "$1"; else auto-07p "$1"; fi
}

# column TYPE N COLUMN: of the N-th such point in AUTO's table
column() {
  awk -v type="$1" -v n="$2" -v column="$3" '
    / PT +TY +LAB / { for (k = 1; k <= NF; k++) if ($k == column) place = k }
    $3 == type && ++seen == n { print $place; exit }' output
}

@test "@r compiles and runs the layout, @sv keeps its runs" {
  local n=0 V
  @r l1 straight >output && @sv straight
  [ "$(grep -c ' HB ' output)" -eq 4 ]
  for V in 13.4308 25.0908 33.8422 61.6176; do
    n=$((n + 1))
    near "$(column HB $n V)" $V 1e-5 "V of HB number $n"
    near "$(column HB $n c_d)" 3.6e4 0 "c_d"
  done
  @r l1 periodic straight >output && @sv psi
  near "$(column TR 1 V)" 30.7865 1e-5 "V of the torus point"
  near "$(column UZ 1 V)" 20 1e-5 "V of A"
  near "$(column UZ 1 psi_max)" 3.66901 1e-5 "psi_max of A"
  @r l1 hopf straight >output
  near "$(column UZ 1 c_d)" 8e4 1e-5 "c_d at the edge of the plane"
}

@test "the states and parameters keep their names in Python, with their values" {
  cat >names.auto <<'END'
straight = run('l1', c='l1.straight')
hopf = straight('HB')
print('number', len(hopf))
print('V', *['%.4f' % s['V'] for s in hopf])
print('parameters', *['%s=%.6g' % (name, hopf[0][name]) for name in ('c_d', 'b', 'k_d', 'a', 'J_eta', 'alpha_m')])
print('states', *[name for name in ('delta', 'ddelta', 'psi', 'dpsi', 'lambda_L', 'lambda_R', 'eps') if name in hopf[0].coordnames])
print('results', *['%.4f' % x for x in (straight['V'][0], straight['psi_max'][0])])
psi = run(straight('HB1'), c='l1.periodic')
print('orbit', '%.4f %.5f' % (psi('TR1')['V'], psi('UZ1')['psi_max']))
END
  auto_python names.auto | grep -E '^(number|V|parameters|states|results|orbit) ' >output
  diff output - <<'END'
number 4
V 13.4308 25.0908 33.8422 61.6176
parameters c_d=36000 b=0 k_d=109000 a=0.5 J_eta=250 alpha_m=0.1745
states delta ddelta psi dpsi lambda_L lambda_R eps
results 1.0000 0.0000
orbit 30.7865 3.66901
END
}

@test "load() and run() take other values by their names" {
  cat >slice.auto <<'END'
model = load('l1', c='l1.straight', PAR={'V': 1.0, 'c_d': 5e3})
straight = run(model)
print('V', *['%.4f' % s['V'] for s in straight('HB')])
print('c_d', *['%g' % s['c_d'] for s in straight('HB')])
curve = run(straight('HB1'), c='l1.hopf', DS='-')
print('bound', '%.2f' % curve('LP1')['c_d'])
END
  auto_python slice.auto | grep -E '^(V|c_d|bound) ' >output
  diff output - <<'END'
V 25.2024 50.6803
c_d 5000 5000
bound 3018.98
END
}

@test "a change in a constants file alone gives a new slice" {
  sed -i "s/'c_d': 3.6e4/'c_d': 2e3/" c.l1.straight
  @r l1 straight >output
  [ "$(grep -c ' HB ' output)" -eq 2 ]
  near "$(column HB 1 V)" 4.14939 1e-5 "V"
  near "$(column HB 2 V)" 25.9574 1e-5 "V"
}
