# shellcheck shell=bash
# exact.sh - what a study has from the algebra alone; sourced by study.sh
#
# In build/studies/NAME: gear.csv, facts.csv; designs.csv, one row for each zero-shimmy
# interval of each design; limits.LAYOUT.csv (the widest interval over k_s as b grows),
# regions.LAYOUT.csv (intervals over k_s), and for the base design of a layout
# plane.LAYOUT.csv, strips.LAYOUT.csv, telling.LAYOUT.csv, critical.LAYOUT.csv.
# shellcheck disable=SC2154,SC2034 # variables of study.sh

# A command's output as a table of the study; not made again while its words, the gear and mlg
# are the same.
made() { # TABLE COMMAND WORD...
  local table=$folder/$1 key
  key="$binary $gear_sum ${*:2}"
  if [ -s "$table" ] && [ "$(cat "$folder/keys/$1" 2> /dev/null)" = "$key" ]; then return; fi
  mkdir -p "$folder/keys"
  rm -f "$folder/keys/$1"
  mlg "${@:2}" > "$table.new" || return
  mv "$table.new" "$table"
  echo "$key" > "$folder/keys/$1"
}

# A gear file of the study's own, without what belongs to a device: own_k_s, own_b, own_c_d.
read_gear() {
  local name value given values='' table error
  if ! table=$(mlg gearinfo "${parameters[@]}" V_top="$top" 2> "build/tables/study.$study.error"); then
    error=$(sed 's/^mlg gearinfo: /study: /' "build/tables/study.$study.error")
    fail "$error" 2
  fi
  own_k_s='' own_b='' own_c_d=''
  while IFS=, read -r name value _ _ given _; do
    [ "$given" = 1 ] || continue
    case $name in
      V) fail "study: V is the axis of the diagrams; V_top=$value says how far they go" 2 ;;
      k_s) own_k_s=$value ;;
      b) own_b=$value ;;
      c_d) own_c_d=$value ;;
      *) values+="${values:+, }'$name': $value" ;;
    esac
  done <<< "$table"
  [ -z "$own_k_s" ] || in_a_layout k_s || fail "study: k_s=$own_k_s: none of the layouts $layouts has a k_s" 2
  [ -z "$own_b" ] || in_a_layout b || fail "study: b=$own_b: none of the layouts $layouts has a b" 2
  mkdir -p "$folder"
  settle "$folder/gear.csv" <<< "$table"
  [ -z "$own_k_s" ] || own_k_s=$(rigid "$own_k_s")
  if [ -n "$values" ]; then settle "$folder/gear" <<< "PAR = {$values}"; else settle "$folder/gear" < /dev/null; fi
  gear=()
  [ -z "$values" ] || gear=("gear=$folder/gear")
  binary=$(cksum < build/bin/mlg) gear_sum="$(cksum < "$folder/gear") $top"
  [ -n "$b_most" ] || b_most=$(of_gear J_zeta 3)
  made facts.csv gearinfo facts "${gear[@]}" V_top="$top"
}

in_a_layout() { # k_s|b
  local layout
  for layout in $layouts; do ! has "$layout" "$1" || return 0; done
  return 1
}

has() { mlg boundary "$1" "$2=1e3" > /dev/null 2>&1; } # LAYOUT k_s|b: an element of the device

# The device of a design as words for mlg.
device() { # LAYOUT K_S B
  ! has "$1" k_s || echo "k_s=$2"
  ! has "$1" b || echo "b=$3"
}

# Rows of designs.csv: all intervals at that k_s and b, each with its best damped c_d, or with
# the one given.
design() { # LAYOUT DESIGN K_S B LIMIT [C_D]
  local words best intervals
  mapfile -t words < <(device "$1" "$3" "$4")
  intervals=$(mlg intervals "$1" "${gear[@]}" V_top="$top" "${words[@]}") || return
  best=$(least_ratio "$1" "${6:-best}" "${words[@]}")
  grep -v -e '^#' -e '^c_lo' <<< "$intervals" | awk -F, -v OFS=, -v row="$1,$2,$3,$4" -v limit="$5" -v best="$best" '
    { n++; print row, $1, $2, $5, $3, $4, $6, $7, limit, best }
    END { if (!n) print row, "", "", 0, "", "", "", "", limit, best }'
}

# c_d,zeta,V,frequency_hz,shimmy,t_5 of the least damping ratio over all speeds at that c_d, or at
# the best; empty for a gear that diverges.
least_ratio() { # LAYOUT best|C_D WORD...
  local how=best row
  [ "$2" = best ] || how=c_d=$2
  row=$(mlg damping "$1" "$how" "${gear[@]}" V_top="$top" V_least=0 "${@:3}" 2> /dev/null | sed 1d) || row=''
  [ "$2" = best ] || row=$2,$row
  case $row in '' | *,-1,* | "$2,") echo ,,,,, ;; *) echo "$row" ;; esac
}

# A number of the rows for a design of a layout, the widest of its intervals.
of_design() { # LAYOUT DESIGN COLUMN
  mlg cell "$folder/parts/$1.csv" "$3" layout="$1" design="$2" largest=width 2> /dev/null || true
}

# Of k_s times each FACTOR the one with the widest interval.
widest_of() { # LAYOUT K_S B FACTOR...
  local layout=$1 k_s=$2 b=$3 factor
  for factor in "${@:4}"; do
    mlg intervals "$layout" "${gear[@]}" V_top="$top" k_s="$(times "$k_s" "$factor")" b="$b" |
      awk -F, -v k_s="$(times "$k_s" "$factor")" 'NR > 2 { x = $5 == "inf" ? 1e300 : $5; if (x > w) w = x } END { printf "%.10g %s\n", w, k_s }'
  done | sort -k 1,1gr -s | sed -n '1s/.* //p'
}

# As printed k_s may stand on the wrong side of where a region is born.
inside() { if [ "$2" = inf ]; then echo inf; else widest_of "$@" 1 0.9999999 1.0000001; fi; } # LAYOUT K_S B

# The designs of one layout, best last; see docs/study.md.
designs() { # LAYOUT
  local layout=$1 k_s=inf b=0 limit row
  [ -z "$own_k_s" ] || ! has "$layout" k_s || k_s=$own_k_s
  [ -z "$own_b" ] || ! has "$layout" b || b=$own_b
  design "$layout" "$([ "$k_s$b" = inf0 ] && echo rigid || echo own)" "$k_s" "$b" ''
  [ -z "$own_c_d" ] || design "$layout" yours "$k_s" "$b" '' "$own_c_d"
  ! has "$layout" k_s || {
    made "widest.$layout.csv" widest "$layout" "${gear[@]}" V_top="$top" || return
    IFS=, read -r k_s _ _ _ _ _ limit < <(sed 1,2d "$folder/widest.$layout.csv")
    case $limit in no*) ;; *) design "$layout" 'widest at b = 0' "$(inside "$layout" "$k_s" 0)" 0 "$limit" ;; esac
  }
  ! has "$layout" b || {
    made "limits.$layout.csv" limits "$layout" "${gear[@]}" V_top="$top" b_most="$b_most" b_step="$(awk "BEGIN { print $b_most / 15 }")" \
      tolerance="$(awk "BEGIN { print $b_most / 1000 }")" || return
    row=$(grep -v -e '^#' -e '^layout' -e ',no interval' "$folder/limits.$layout.csv" | sort -t , -k 6,6gr -k 2,2g | sed 1q) # of equal ones that of the least b
    IFS=, read -r _ b k_s _ _ _ _ _ limit <<< "$row"
    [ -z "$row" ] || design "$layout" widest "$(inside "$layout" "$k_s" "$b")" "$b" "$limit"
  }
}

# The best damped device of a layout, or where all shimmy the least unstable: a row of its own, for
# it takes longer than all the rest.
best_damped() { # LAYOUT
  local layout=$1 over_b=() k_s b=0 c_d zeta name
  has "$layout" k_s || return 0
  ! has "$layout" b || over_b=(b_most="$b_most")
  made "best.$layout.csv" damping "$layout" best "${gear[@]}" V_top="$top" V_least=0 "${over_b[@]}" 2> /dev/null || return 0
  IFS=, read -r b k_s c_d zeta _ < <(sed "1d; $([ -n "${over_b[*]}" ] || echo 's/^/0,/')" "$folder/best.$layout.csv")
  name=$(awk -v zeta="$zeta" 'BEGIN { print (zeta > 0 ? "best damped" : "least unstable") }')
  design "$layout" "$name" "$(rigid "$k_s")" "$b" '' > "$folder/parts/$layout.best"
  # at digits rounded the best may have no sure answer; the one found has
  [ -n "$(cut -d , -f 13 "$folder/parts/$layout.best" | head -n 1)" ] || design "$layout" "$name" "$(rigid "$k_s")" "$b" '' "$c_d" > "$folder/parts/$layout.best"
}

rigid() { awk -v k_s="$1" 'BEGIN { print (k_s >= 1e30 ? "inf" : k_s) }'; } # K_S, as a table has it

# The design whose plane and diagrams are shown: the user's own device, or 2 % of k_s beside the
# widest, on the side where more of it is left, for at the widest itself a region is born or two
# bounds meet.  Into base.LAYOUT: k_s b and the words for mlg.
base_of() { # LAYOUT
  local layout=$1 k_s=inf b=0 name=''
  if has "$layout" k_s; then
    for name in widest 'widest at b = 0'; do
      k_s=$(of_design "$layout" "$name" k_s) b=$(of_design "$layout" "$name" b)
      [ -z "$k_s" ] || break
    done
    name="2 % beside the widest"
    if [ -n "$own_k_s$own_b$own_c_d" ] || [ -z "$k_s" ]; then
      k_s=${own_k_s:-inf} b=0
      [ -z "$own_b" ] || ! has "$layout" b || b=$own_b
      name=$([ -n "$own_k_s$own_b$own_c_d" ] && echo "your own device" || echo "rigid, for no k_s has an interval")
    elif [ "$k_s" = inf ]; then
      name="the widest"
    else
      k_s=$(widest_of "$layout" "$k_s" "$b" 0.98 1.02)
    fi
  fi
  printf '%s\n' "$k_s" "$b" "$name" > "$folder/base.$layout"
}

# The layout before it whose base design is the same device, as all are at b = 0 and a rigid k_s.
twin_of() { # LAYOUT
  local other
  for other in $layouts; do
    [ "$other" != "$1" ] || return 0
    if [ "$(sed -n 2p "$folder/base.$1")" = 0 ] && cmp -s <(head -n 2 "$folder/base.$other") <(head -n 2 "$folder/base.$1") &&
      cmp -s "$folder/telling.$other.csv" "$folder/telling.$1.csv"; then
      echo "$other"
      return
    fi
  done
}

range_of_c_d() { sed -n '1s/.*plane [^,]*,[^,]*,\([^,]*\),\(.*\)/\1 \2/p' "$folder/plane.$layout.csv"; } # of the plane

of_gear() { awk -F, -v name="$1" -v factor="$2" '$1 == name { printf "%.6g", factor * $2 }' "$folder/gear.csv"; } # NAME FACTOR

times() { awk "BEGIN { printf \"%.10g\", $1 * $2 }"; }

# Words of the base design for mlg, into `base`; its interval, the widest, into lo and hi.
get_base() { # LAYOUT
  { read -r base_k_s; read -r base_b; read -r base_name; } < "$folder/base.$1"
  mapfile -t base < <(device "$1" "$base_k_s" "$base_b")
  read -r lo hi < <(mlg intervals "$1" "${gear[@]}" V_top="$top" "${base[@]}" | awk -F, 'NR > 2 && $5 + 0 > w + 0 || $5 == "inf" { w = $5; lo = $1; hi = $2 } END { print lo, hi }') || true
}

# Are the Hopf points that bound the base's interval super- or subcritical?
critical() { # LAYOUT
  local points
  mlg boundary "$1" "${gear[@]}" V_top="$top" "${base[@]}" | awk -F, -v lo="${lo:-x}" -v hi="${hi:-x}" -v k_s="${base_k_s/inf/1e30}" -v b="$base_b" '
    NR > 2 && ($1 == lo || $1 == hi) && $2 > 0 { print $2 "," $1 "," k_s "," b "," $3 }' > "$folder/parts/$1.points"
  points=$(wc -l < "$folder/parts/$1.points")
  if [ "$points" -gt 0 ]; then
    mlg criticality "$1" "${gear[@]}" < "$folder/parts/$1.points" > "$folder/critical.$1.csv"
  else
    echo V,c_d,frequency_hz,delta_over_psi,a,growth_in_c_d > "$folder/critical.$1.csv"
  fi
}

exact_of() { # LAYOUT
  local layout=$1 value
  get_base "$layout"
  made "plane.$layout.csv" plane "$layout" "${gear[@]}" V_top="$top" "${base[@]}" || return
  made "strips.$layout.csv" plane "$layout" regions "${gear[@]}" V_top="$top" "${base[@]}" || return
  if has "$layout" k_s; then
    made "regions.$layout.csv" regions "$layout" "${gear[@]}" V_top="$top" b="$base_b" k_s_least="$(of_gear k_psi 0.02)" k_s_most="$(of_gear k_psi 2000)" || return
  fi
  if [ -n "$at" ]; then
    {
      echo which,c_d,hopf_points
      for value in $at; do
        echo "asked,$value,$(mlg hopf "$layout" c_d="$value" "${gear[@]}" V_top="$top" "${base[@]}" | sed 1,2d | wc -l)"
      done
    } > "$folder/telling.$layout.csv"
  else
    made "telling.$layout.csv" telling "$layout" "${gear[@]}" V_top="$top" "${base[@]}" || return
  fi
  critical "$layout"
}

# A layout for which the algebra has no answer is left out, and the page says so.
exact_layout() { # LAYOUT
  local layout=$1
  head -n 1 "$folder/designs.csv" > "$folder/parts/$layout.csv"
  if designs "$layout" >> "$folder/parts/$layout.csv" 2> "$folder/parts/$layout.error"; then
    base_of "$layout"
    exact_of "$layout" 2> "$folder/parts/$layout.error" || touch "$folder/parts/$layout.unsure"
  else
    touch "$folder/parts/$layout.unsure"
  fi
}

exact_parts() {
  local layout left=''
  rm -rf "$folder/parts"
  mkdir -p "$folder/parts"
  echo layout,design,k_s,b,c_lo,c_hi,width,V_lo,V_hi,lower,upper,limit,c_d,zeta,V,frequency_hz,shimmy,t_5 > "$folder/designs.csv"
  : > "$folder/unsure"
  for layout in $layouts; do
    job exact_layout "$layout"
  done
  wait
  for layout in $layouts; do
    if [ -e "$folder/parts/$layout.unsure" ]; then
      echo "$layout: $(head -n 1 "$folder/parts/$layout.error")" >> "$folder/unsure"
    else
      left+=" $layout"
      sed 1d "$folder/parts/$layout.csv" >> "$folder/designs.csv"
    fi
  done
  layouts=${left# }
}

processors=$(processors)

# job COMMAND WORD...: in the background, one for each processor at a time, and in a process
# group of its own, by which end_jobs ends it with all that it started.
job() {
  while [ "$(jobs -rp | wc -l)" -ge "$processors" ]; do wait -n || true; done
  set -m
  (trap - ERR EXIT INT TERM HUP; set +em; "$@") < /dev/null &
  set +m
}

end_jobs() {
  local group
  for group in $(jobs -rp); do kill -TERM -- "-$group" 2> /dev/null || true; done
}
