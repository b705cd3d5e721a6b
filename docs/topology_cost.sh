#!/usr/bin/env bash
# Prints the CPU seconds of `isoloop loops` with each topology, and of another build of isoloop if
# one is given: medians of runs in alternation, and their ratios.
#   docs/topology_cost.sh [RUNS [ISOLOOP [DATA [OTHER]]]]
#   (default: 9 build/release/tools/isoloop ../shared/data, no other)
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
runs=${1:-9}
isoloop=${2:-$root/build/release/tools/isoloop}
file=${3:-$root/../shared/data}/volumes/engine_256x256x128_uint8.raw
other=${4:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# NAME COMMAND...: appends user + system seconds to the file NAME.
spend() {
  local name=$1 TIMEFORMAT='%U %S'
  shift
  { time "$@" >"$work/out" 2>"$work/err"; } 2>"$work/time" || { cat "$work/err" >&2; exit 1; }
  awk '{print $1 + $2}' "$work/time" >>"$work/$name"
}
median() { sort -n "$work/$1" | awk '{s[NR] = $1} END {print (s[int((NR + 1) / 2)] + s[int(NR / 2) + 1]) / 2}'; }

for ((run = 0; run < runs; ++run)); do
  for topology in trilinear simple; do
    spend $topology "$isoloop" loops "$file" --iso 70 --topology $topology
  done
  [[ -z $other ]] || spend other "$other" loops "$file" --iso 70
done
for name in trilinear simple ${other:+other}; do
  awk -v name=$name -v mine="$(median trilinear)" -v its="$(median $name)" -v runs="$runs" \
    'BEGIN {printf "%-9s  median of %d runs %.2f CPU s, trilinear / %s %.3f\n", name, runs, its, name, mine / its}'
done
