#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Octet against Debian's `gmsh -3`: the same part, about the same number of tetrahedra, one thread, whole runs from
# the STEP file to the written mesh, in alternating pairs; medians of the wall and the CPU time.
#   tests/bench/compare_gmsh.sh [PART] [TETS] [PAIRS]     (needs gmsh: apt-get install gmsh; OCTET=path/to/octet)
set -eu
cd "$(dirname "$0")/../.."
octet=${OCTET:-build/app/octet}
part=${1:-models/bracket.step}
goal=${2:-100000}
pairs=${3:-5}
[ -x "$octet" ] || { echo "$octet is not built: scripts/quickstart builds it" >&2; exit 2; }
command -v gmsh >/dev/null || { echo "gmsh is not installed: apt-get install gmsh" >&2; exit 2; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

run_octet() { "$octet" mesh "$part" -o "$work/octet.msh" --size "$1" --threads 1 --quiet --report "$work/octet.json" || [ $? -eq 3 ]; }
run_gmsh() { gmsh -3 -v 0 -nt 1 -bin -clmin 0 -clmax "$1" "$part" -o "$work/gmsh.msh" >/dev/null; }
tets_octet() { sed -n 's/^ "tets": \([0-9]*\),*/\1/p' "$work/octet.json"; }
gmsh_count() { gmsh -v 0 -save -format msh2 "$work/gmsh.msh" -o "$work/count.msh" >/dev/null; awk '$2 == 4' "$work/count.msh" | wc -l; }

# The size that gives the wanted count: the count goes as size^-3.
fit() {  # fit NAME
  local size=$2 tets=0
  for _ in 1 2 3 4 5; do
    "run_$1" "$size"
    if [ "$1" = octet ]; then tets=$(tets_octet); else tets=$(gmsh_count); fi
    awk -v t="$tets" -v g="$goal" 'BEGIN { exit !(t > 0.95 * g && t < 1.05 * g) }' && break
    size=$(awk -v s="$size" -v t="$tets" -v g="$goal" 'BEGIN { printf "%.9g", s * exp(log((t > 0 ? t : 1) / g) / 3) }')
  done
  echo "$size $tets"
}
volume=$("$octet" info "$part" --json | sed -n 's/^ "volume": \(.*\),/\1/p')
start=$(awk -v v="$volume" -v g="$goal" 'BEGIN { printf "%.9g", exp(log(6 * v / g) / 3) }')
read -r size_octet count_octet <<<"$(fit octet "$start")"
read -r size_gmsh count_gmsh <<<"$(fit gmsh "$start")"
echo "octet: size $size_octet, $count_octet tetrahedra; gmsh: size $size_gmsh, $count_gmsh tetrahedra"

TIMEFORMAT='%R %U %S'
timed() { { time "$@" >/dev/null 2>&1; } 2>&1 | tail -1; }
for ((i = 0; i < pairs; ++i)); do
  timed run_octet "$size_octet" >>"$work/octet.times"
  timed run_gmsh "$size_gmsh" >>"$work/gmsh.times"
done
median() { awk "{ print $2 }" "$work/$1.times" | sort -g | awk '{ v[NR] = $1 } END { print (v[int((NR + 1) / 2)] + v[int(NR / 2) + 1]) / 2 }'; }
for name in octet gmsh; do
  printf '%-6s wall %.2f s, cpu %.2f s (medians of %d)\n' "$name" "$(median $name '$1')" "$(median $name '$2 + $3')" "$pairs"
done
