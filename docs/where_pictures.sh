#!/usr/bin/env bash
# Draws the pictures of where_people_work.md. Needs the Python module (cmake --preset python),
# python3-matplotlib, python3-vtk9, xvfb and xauth.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export PYTHONPATH=$PWD/build/python/python/
/usr/bin/python3 python/examples/matplotlib_slice.py docs/where_slice.png
xvfb-run -a /usr/bin/python3 python/examples/vtk_surface.py docs/where_vtk.png
