#!/bin/sh
# Installs what is missing, builds the program `quadrangulate`, and makes a quad mesh of a real triangle mesh and a page that shows it.
# Usage: scripts/quickstart.sh [IN [OUT]]    (default: the fan disk of CGAL's data, result in build/)
set -eu

root=$(cd "$(dirname "$0")/.." && pwd)
build="$root/build/quickstart"
input=${1:-}
output=${2:-$root/build/fandisk_quads.obj}

"$root/scripts/install_packages.sh"
if [ ! -d "$build" ] && command -v ninja >/dev/null; then
  export CMAKE_GENERATOR=Ninja
fi
cmake -S "$root" -B "$build" -DCGAL_QUAD_MESHING_BUILD_TESTS=OFF
cmake --build "$build" --parallel 2 --target quadrangulate

if [ -z "$input" ]; then
  tar -xzf /usr/share/doc/libcgal-dev/data.tar.gz -C "$build" data/meshes/fandisk.off
  input="$build/data/meshes/fandisk.off"
fi
# Pages need three.js, which the build looks for.
set --
if [ -f "$build/page/CGAL/Quad_meshing/IO/internal/page_text.h" ]; then
  set -- --html "${output%.*}.html"
fi
"$build/examples/Quad_meshing/quadrangulate" "$input" "$output" "$@"
echo "The quad mesh of $input is in $output"
[ $# -eq 0 ] || echo "A page that shows it in a browser: $2"
