#!/usr/bin/env bash
# Draws docs/page.png: the page of the CT engine at iso value 70, its twelfth tunnel loop chosen.
# Needs what tests/viewer_test needs, pngquant, and the built isoloop.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$root/../shared/data/volumes"
"$root/build/release/tools/isoloop" view engine_256x256x128_uint8.raw --iso 70 \
  -o "$work/page.html" >"$work/table.txt"
node "$root/tools/viewer/picture.mjs" "$work/page.html" "$work/page.png" tunnel 12
pngquant --force --output "$root/docs/page.png" 96 "$work/page.png"
