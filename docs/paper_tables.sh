#!/usr/bin/env bash
# Prints the tables of docs/paper.md: total loop lengths of both engines, and the paper's table 1
# beside ours. Times are those of this machine.
#   docs/paper_tables.sh [ISOLOOP [DATA]]   (default: build/release/tools/isoloop ../shared/data)
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
isoloop=${1:-$root/build/release/tools/isoloop}
data=${2:-$root/../shared/data}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

real=(
  "fuel_64x64x64_uint8.raw 15" "nucleon_41x41x41_uint8.raw 140" "silicium_98x34x34_uint8.raw 85"
  "neghip_64x64x64_uint8.raw 55" "hydrogen_128x128x128_uint8.raw 15"
  "engine_half_128x128x64_uint8.raw 70")
shapes=(
  "torus 64" "linked_tori 64" "nested_tori 64" "trefoil 64" "plate 64" "gyroid 64" "lattice 64"
  "engine_block 128")

genus_in() { sed -n 's/.*, genus \([0-9]*\)$/\1/p' "$1"; }
lengths_in() { sed -n 's/^total length of [^:]*: \([0-9.]*\).*/\1/p' "$1" | paste -sd'|' | sed 's/|/ | /'; }

# NAME FILE FLAG...: one row. A run whose engines disagree on the killing pieces ends with code 5.
length_row() {
  local name=$1
  shift
  "$isoloop" loops "$@" >"$work/dual"
  local equal=yes
  "$isoloop" loops "$@" --engine pair >"$work/both" || equal=no
  "$isoloop" loops "$@" --engine pair --refine none >"$work/none"
  echo "| $name | $(genus_in "$work/dual") | $(lengths_in "$work/dual") |" \
    "$(lengths_in "$work/both") | $(lengths_in "$work/none") | $equal |"
}

echo "| volume | genus | dual: handles | tunnels | pair, both: handles | tunnels |" \
  "pair, none: handles | tunnels | killing pieces equal |"
echo "|---|---|---|---|---|---|---|---|---|"
for shape in "${shapes[@]}"; do
  read -r name size <<<"$shape"
  "$isoloop" generate "$name" --size "$size" -o "$work/$name.vdb" 2>"$work/log" ||
    { cat "$work/log" >&2; exit 1; }
  length_row "$name, size $size" "$work/$name.vdb"
done
for volume in "${real[@]}"; do
  read -r file iso <<<"$volume"
  [[ -e $data/volumes/$file ]] || { echo "needs $data/volumes/$file" >&2; continue; }
  length_row "${file%%_[0-9]*}, $iso" "$data/volumes/$file" --iso "$iso"
done

# NAME FILE ISO ENGINE PAPER: one row of table 1.
cost_row() {
  local name=$1 file=$data/volumes/$2 iso=$3 engine=$4 paper=$5
  [[ -e $file ]] || { echo "needs $file" >&2; return; }
  local TIMEFORMAT='%U %S'
  { time "$isoloop" loops "$file" --iso "$iso" --engine "$engine" --stats \
    --json "$work/json" >"$work/out"; } 2>"$work/time"
  local surface volume genus geodesic loops
  read -r surface volume genus geodesic loops _ < <(tail -n 1 "$work/out")
  local cpu peak
  cpu=$(awk '{printf "%.1f", $1 + $2}' "$work/time")
  peak=$(sed -n 's/.*"peak_bytes": \([0-9]*\).*/\1/p' "$work/json" | awk '{printf "%.2f", $1 / 2^30}')
  echo "| $name | $paper | $engine | $surface | $volume | $genus | $geodesic | $loops | $cpu | $peak |"
}

echo
echo "| model | paper: surface triangles | geodesic s | loops s | engine | surface triangles |" \
  "volume triangles | genus | geodesic s | loops s | CPU s | peak GiB |"
echo "|---|---|---|---|---|---|---|---|---|---|---|---|"
unknown="not at hand | not at hand | not at hand"
for engine in pair dual; do
  cost_row Atom hydrogen_128x128x128_uint8.raw 15 $engine "$unknown"
  cost_row Aneurism aneurism_256x256x256_uint8.raw 51 $engine "$unknown"
  cost_row "Engine 1" engine_half_128x128x64_uint8.raw 70 $engine "157 k | 520.0 | 207.1"
  cost_row "Engine 2" engine_256x256x128_uint8.raw 70 $engine "629 k | 7812.6 | 3392.6"
done
