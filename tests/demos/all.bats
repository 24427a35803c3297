# all.bats - every figure as a demo of AUTO's own kind, run to its end with AUTO alone: `make
# check-demos`, two to four minutes with each AUTO
#
# The folders lie outside the checkout, in a path with a blank, and are run in an empty
# environment.
#
# Needs   build/auto.mk, build/models, build/bin; MLG_AUTO_NEWEST=/path: upstream's newest AUTO,
#         built, which then runs them too
# Writes  build/tests/demos, and a folder of mktemp

bats_require_minimum_version 1.5.0
load ../scratch

setup_file() {
  export AWAY AUTO
  BATS_TEST_DIRNAME=$BATS_TEST_DIRNAME/.. scratch demos
  cp -rp "$ROOT"/{LICENSE,results} .
  AWAY=$(mktemp -d)
  AUTO=$(sed -n 's/^AUTO_DIR = //p' build/auto.mk)
  mkdir "$AWAY/auto"
  cp -r "$AUTO"/{bin,cmds,include,lib,python} "$AWAY/auto"
}

teardown_file() { rm -rf "$AWAY"; }

setup() { cd "$SCRATCH" || return; }

alone() { # AUTO COMMAND...
  env -i HOME="$AWAY" PATH="$1/bin:$1/cmds:/usr/bin:/bin" AUTO_DIR="$1" OMP_NUM_THREADS=1 "${@:2}"
}

# figure NN: its demo by AUTO here and by the newest, the latter by both versions
figure() {
  local folder="$AWAY/a demo/fig$1"
  scripts/auto-demo.sh "fig$1" "$folder"
  cd "$folder" || return
  passes "$AWAY/auto" sh "fig$1.sh"
  # the pictures have all that they ask for
  gnuplot -d plot.gp 2> warnings
  [ ! -s warnings ] || { cat warnings; return 1; }
  [ "$(wc -c < "fig$1.png")" -gt 10000 ]
  if [ -n "${MLG_AUTO_NEWEST:-}" ]; then
    rm -f b.* s.* d.*
    passes "$MLG_AUTO_NEWEST" sh "fig$1.sh"
    rm -f b.* s.* d.*
    passes "$MLG_AUTO_NEWEST" auto "fig$1.auto"
  fi
}

# passes AUTO COMMAND...: with all points where they are to be, and some there
passes() {
  alone "$@" > log 2>&1 || { tail -n 20 log; return 1; }
  grep -qx "all values are as expected" log || { grep differs log; return 1; }
  [ "$(grep -c . points.csv)" -gt 5 ]
}

@test "Figure 6" { figure 06; }
@test "Figure 7" { figure 07; }
@test "Figure 9" { figure 09; }
@test "Figure 10" { figure 10; }
@test "Figure 12" { figure 12; }
@test "Figure 13" { figure 13; }
@test "Figure 14" { figure 14; }
@test "Figure 15" { figure 15; }
