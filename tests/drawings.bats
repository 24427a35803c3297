# drawings.bats - docs/drawings: the gear, and each layout's device from its network

setup() { . "$BATS_TEST_DIRNAME/../scripts/auto/tools.sh"; }

@test "the committed drawings are those of the source" {
  local layout
  build/bin/mlg gear | cmp - docs/drawings/gear.svg
  for layout in $(layouts); do
    build/bin/mlg draw "$layout" | cmp - "docs/drawings/$layout.svg" || { echo "make drawings makes it anew" && false; }
  done
}

@test "a drawing names every element of the network once, and psi" {
  local layout
  for layout in $(layouts); do
    diff <({ echo psi; sed -n '/device_network(/,/^}/p' "models/$layout.c" | grep -o 'par\[PAR_[A-Z_]*' | sed 's/.*PAR_//'; } |
      tr '[:upper:]' '[:lower:]' | sort) \
      <(sed -n "s/^<text class='i'[^>]*>\(.*\)<\/text>/\1/p" "docs/drawings/$layout.svg" |
        sed "s/<tspan[^>]*>/_/; s/<[^>]*>//; s/ψ/psi/; s/δ/delta/" | sort)
  done
}

@test "the drawings are sound XML" {
  python3 -c 'import sys, xml.dom.minidom
for name in sys.argv[1:]: xml.dom.minidom.parse(name)' docs/drawings/*.svg
}
