# verify.bats - do the oracles agree, and does each notice a model that is wrong?
#
# Needs   make test-programs; the tables in results/
# Writes  build/tests/verify-bats

bats_require_minimum_version 1.5.0
load scratch

setup_file() {
  scratch verify-bats
  cp -rp "$ROOT"/{tests,results} .
  objects
}

setup() {
  cd "$SCRATCH" || return
}

@test "the quick checks of every oracle pass" {
  run -0 tests/verify.sh short
  [[ ${lines[-1]} =~ ^[0-9]+\ checks,\ 0\ failed$ ]]
  [ "$(awk -F, 'NR > 1 { print $1 }' build/tests/verify/table | sort -u)" = "$(basename -s .sh tests/verify/*.sh)" ]
  [ ! -e results/verification.csv.new ]
}

# broken SED: the model changed so, its programs made anew; then the quick checks of
# eigenvalues and derivation, whose failed ones are in the file failed
broken() {
  sed -i "$1" models/mlg.h
  run -1 cmp -s models/mlg.h "$ROOT/models/mlg.h"
  made_by_make build/bin/eigen-l1 build/lib/libmlg.so
  run -1 tests/verify.sh short eigenvalues derivation
  awk -F, '$NF == "no"' build/tests/verify/table >failed
  cp -p "$ROOT/models/mlg.h" models
  cp -p "$ROOT"/build/bin/eigen-l1 build/bin
}

@test "a flipped sign is noticed by the derivation and by the eigenvalues" {
  broken 's/+ w.z_psi + C \* c \* cos_delta/+ w.z_psi - C * c * cos_delta/'
  grep -q '^derivation,l1: motion of psi' failed
  run -1 grep -q '^derivation,l1: motion of delta' failed
  grep -q '^eigenvalues,Hopf point at c_d = 36000' failed
}

@test "a wrong k_d is noticed by the eigenvalues; the equations are still right" {
  broken '/K_D, .*"k_d"/s/1.09e5/1.1e5/'
  run -1 grep -q '^derivation' failed
  grep -q '^eigenvalues,Hopf point at c_d = 36000' failed
  grep -q '^eigenvalues,double Hopf point' failed
  grep -q '^eigenvalues,boundary point (fig07.low.up)' failed
}

@test "a wrong table, a row that is no number and a part that ends early fail" {
  cp -p results/special_points.csv good.csv
  sed -i '/fig07.low.up,LP/s/2754.35/2754.45/' results/special_points.csv
  run -1 tests/verify.sh short eigenvalues
  [ "$(awk -F, '$NF == "no" { print $2 }' build/tests/verify/table)" = "boundary point (fig07.low.up): c_d" ]
  cp -p good.csv results/special_points.csv
  printf '#!/bin/sh\necho "not a number,-,nan,1,1e-6"\nexit 1\n' >tests/verify/ends_early.sh
  chmod +x tests/verify/ends_early.sh
  run -1 tests/verify.sh ends_early
  [ "$(awk -F, '$NF == "no" { print $2 }' build/tests/verify/table | wc -l)" -eq 2 ]
  rm tests/verify/ends_early.sh
}

@test "an unknown part is refused" {
  run -2 tests/verify.sh short eigenvalue
  [ "${#lines[@]}" -eq 1 ]
  [[ $output == "verify: no part 'eigenvalue'; there are "*eigenvalues* ]]
}

@test "a line that is no Hopf point is refused" {
  run -2 bash -c "build/bin/mlg criticality l1 2>&1 >/dev/null <<<10,2700,1e30"
  [ "$output" = "mlg criticality: standard input:1: '10,2700,1e30': expected V,c_d,k_s,b,frequency_hz" ]
}
