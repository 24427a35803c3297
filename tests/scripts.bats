# scripts.bats - are the scripts, the tests in shell and the C sources sound?

@test "scripts and tests pass shellcheck" {
  cd "$BATS_TEST_DIRNAME/.."
  shellcheck --shell=bash --external-sources --source-path=SCRIPTDIR scripts/*.sh scripts/*/*.sh tests/*.sh tests/verify/*.sh tests/bench/*.sh tests/study/*.sh tests/sweeps/*.sh tests/sweeps/*.bash tests/*.bash .ci/run
  shellcheck --external-sources --source-path=SCRIPTDIR tests/*.bats tests/pages/*.bats
}

@test "the C sources compile without a warning, also where C23 is the default" {
  local file include sundials
  cd "$BATS_TEST_DIRNAME/.."
  include=$(sed -n 's/^AUTO_INCLUDE = //p' build/auto.mk)
  read -ra sundials < <(scripts/auto/sundials.sh)
  for file in models/*.c models/libmlg/*.c scripts/mlg/*.c scripts/mlg/*/*.c tests/eigen.c tests/random/*.c; do
    gcc -fsyntax-only -std=c11 -D_DEFAULT_SOURCE -Wall -Wextra -Wpedantic -Werror -Imodels -Imodels/libmlg -Iscripts/mlg{,/gear,/auto,/report,/sweep} -Ibuild/libmlg \
      -isystem "$include" -DLAYOUT='"l1.c"' -DNAME=l1 "$file" "${sundials[@]}"
  done
  # whatever the user's flags, the models are compiled as C11
  make --no-print-directory -n -B build/models/l1.o build/mlg/main.o CC='gcc -std=gnu2x' CFLAGS=-O3 >"$BATS_TEST_TMPDIR/commands"
  [ "$(grep -c '^{ gcc -std=gnu2x -O3 -std=c11' "$BATS_TEST_TMPDIR/commands")" -eq 2 ]
}

@test "every change made on purpose (make mutants) applies, and names tests that there are" {
  tests/mutants.sh check
}
