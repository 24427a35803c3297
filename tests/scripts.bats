# scripts.bats - are the scripts and the tests in shell sound?

@test "scripts and tests pass shellcheck" {
  cd "$BATS_TEST_DIRNAME/.."
  shellcheck --shell=bash --external-sources --source-path=SCRIPTDIR scripts/*.sh tests/*.sh tests/verify/*.sh tests/bench/*.sh tests/*.bash .ci/run
  shellcheck --external-sources --source-path=SCRIPTDIR tests/*.bats tests/pages/*.bats
}
