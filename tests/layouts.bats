# layouts.bats - is a layout one file, and do its constants follow from it?
#
# Needs   the models (make models)
# Writes  build/tests/layouts

bats_require_minimum_version 1.5.0
load scratch

setup_file() {
  scratch layouts
}

setup() {
  cd "$SCRATCH" || return
}

@test "the constants files of a layout name its states, as many as NDIM" {
  local file layout
  for file in constants/c.l*; do
    layout=${file#*c.}
    diff <(build/bin/constants "$file" layout="${layout%%.*}") <(build/bin/constants "$file")
  done
}

@test "those of LI1 and LI2 are those of L2 but for the values of PAR" {
  local layout constants
  for layout in li1 li2; do
    for constants in straight hopf; do
      diff <(build/bin/constants constants/c.l2.$constants layout=$layout | grep -v '^PAR ') \
        <(build/bin/constants constants/c.$layout.$constants | grep -v '^PAR ')
    done
  done
}

@test "a run that a layout has no constants file for takes one made of L1's" {
  auto_run straight li2.straight c_d=3.6e4 k_s=1e30 b=0 -- HB=4
  auto_run psi li2.periodic from=straight -- TR=1 closed=1
  near "$(value psi TR V)" 30.7865 1e-5 "V of the torus point of L1"
  grep -q "^NDIM = 9$" build/runs/psi/c.psi
}

@test "a layout that is none" {
  run -2 build/bin/constants constants/c.l1.straight layout=l9
  [ "$output" = "constants/c.l1.straight: layout=l9: there is no models/l9.c" ]
  run -2 build/bin/constants constants/gear.printed layout=l1
  [ "$output" = "constants/gear.printed: expected NDIM, the number of states of a layout" ]
}
