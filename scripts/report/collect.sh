#!/usr/bin/env bash
# Collects what the figures' scripts left in build/tables into
#   results/special_points.csv, boundary_points.csv and widths.csv
# Where a figure has not been made in this tree its rows stay as they are, and so they do in a
# table that is committed and was not made here: what build/tables has of another figure is then
# older, and goes, so that the figure is made anew.  In a table that is neither what was made
# here nor what is committed, rows of the commit are taken.
# Writes the row of versions.csv of a figure that lacks it.
. "$(dirname "$(realpath "$0")")/../auto/lib.sh"
build build/bin/mlg
alone results
export MLG_USES=/dev/null # these tables are made of figures, no figure of them

# is_whole PART COLUMNS: it is there, and each row has a cell for each of the columns; the
# rows of a damaged one come when its figure has been made anew.
is_whole() {
  [ -f "$1" ] && awk -F, -v columns="$(tr -dc , <<< "$2" | wc -c)" 'NF != columns + 1 { exit 1 }' "$1" && [ -z "$(tail -c 1 "$1")" ]
}

# rows FILE COLUMN VALUE[,VALUE...]: those of a table whose column is one of the values
rows() {
  local values value
  IFS=, read -ra values <<< "$3"
  for value in "${values[@]}"; do mlg pick "$1" "$2=$value"; done
}

# collect TABLE PART HEAD... -- VALUE[,VALUE...]=FIGURE...: the head lines, then for each
# FIGURE build/tables/PART.FIGURE.csv, or the rows of TABLE whose first column is a VALUE.
collect() {
  local file=results/$1.csv part=$2 columns column key made known=results/$1.csv here=no
  shift 2
  if [ -f "$file" ] && ! is_known "$file" && ! put_back "$file"; then
    known=build/tables/$(basename "$file" .csv).committed.csv
    git show "HEAD:./$file" > "$known" 2> /dev/null || rm "$known"
    echo "  $file is neither what was made here nor what is committed; it is made anew, from committed rows where it has to be" >&2
  fi
  [ ! -f "$file" ] || [ "$(md5sum < "$file")" != "$(cat "build/tables/${file##*/}.sum" 2> /dev/null)" ] || here=yes
  {
    while [ "$1" != -- ]; do echo "$1"; columns=$1 column=${1%%,*}; shift; done
    shift
    for key; do
      made=build/tables/$part.${key#*=}.csv
      if [ "$here" = no ] && [ "${key#*=}" != "${MLG_FIGURE:-}" ] && [ -f "$made" ] && [ -f "$known" ] &&
        rows "$known" "$column" "${key%%=*}" > "$made.known" && [ -s "$made.known" ] && ! cmp -s "$made" "$made.known"; then
        rm "$made"
      fi
      rm -f "$made.known"
      if is_whole "$made" "$columns"; then
        cat "$made"
      elif [ -f "$known" ]; then
        rows "$known" "$column" "${key%%=*}"
      fi
    done
  } > "$file.new"
  replace "$file"
}

beyond=$(sed -n 's/^parts_layouts := //p' Makefile)

collect special_points points \
  "# Special points of AUTO's runs. V m/s, c_d N m s/rad, k_s N m/rad (inf: rigid), b N m s^2/rad," \
  "# frequency_hz Hz, psi_max deg, dstar_max m (orbits only). type: HB Hopf, HH double Hopf, TR torus," \
  "# LP extremum of c_d along a Hopf curve (boundary point; figures 10 to 15: where a region is born or two meet)," \
  "# UZ a speed or a k_s asked for." \
  figure,layout,run,type,V,c_d,k_s,b,frequency_hz,psi_max,dstar_max \
  -- 6=fig06 7=fig07 10=fig10 13=fig13 15=fig15

collect boundary_points boundary \
  "# Boundary points over k_s: extrema of c_d along the Hopf curves of the (V, c_d) plane (models/boundary.h)." \
  "# b N m s^2/rad, k_s N m/rad (inf: rigid), c_d N m s/rad, V m/s. name: BP1 top of the low psi region, BP3 bottom" \
  "# of the high one, BP2_l and BP2_u bottom and top of a delta region, psi3 top of a third psi region, onset: birth" \
  "# of a delta region, meet: of two psi regions' meeting; type LP there. Every second point of AUTO's." \
  layout,b,curve,name,type,k_s,c_d,V,frequency_hz,extremum,shimmy \
  -- l2=fig10 li1=fig13 li2=fig15 "${beyond// /,}=layouts"

collect widths widths \
  "# The widest zero-shimmy interval over k_s: b N m s^2/rad, k_s N m/rad, c_lo to c_hi and width N m s/rad, V_lo and" \
  "# V_hi m/s at the bounds, lower and upper: which boundary point bounds it, limit: what ends its growth over k_s." \
  "# Between the multiples of 10 stand the b where limit or lower change hands; each interval is tested by Routh." \
  layout,b,k_s,c_lo,c_hi,width,V_lo,V_hi,lower,upper,limit \
  -- li1=fig13 li2=fig15 "${beyond// /,}=layouts"

read -ra figures < <(sed -n 's/^figures := //p' Makefile)
for figure in "${figures[@]}"; do
  [ ! -f "results/$figure.csv" ] || [ ! -f "build/stamps/$figure" ] || has_version || write_version
done
