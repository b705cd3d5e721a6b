#!/usr/bin/env bash
# Draws docs/engine.png: the CT engine at iso value 70 with its handle loops (green) and tunnel
# loops (red). Another volume and its flags may stand in its place, and so may another picture:
#   docs/picture.sh PICTURE.png VOLUME [FLAG...]
# Needs Debian's python3-vtk9, xvfb, xauth and pngquant, and the built isoloop.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
if (($# == 0)); then
  engine=$root/../shared/data/volumes/engine_256x256x128_uint8.raw
  set -- "$root/docs/engine.png" "$engine" --iso 70
fi
picture=$1
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$root/build/release/tools/isoloop" loops "$@" --ply "$work/surface.ply" --json "$work/loops.json"
xvfb-run -a /usr/bin/python3 "$root/docs/picture.py" \
  "$work/surface.ply" "$work/loops.json" "$work/picture.png" 30 25
pngquant --force --output "$picture" 128 "$work/picture.png"
