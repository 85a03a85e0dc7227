#!/bin/sh
# What it costs to compile the program of README.md, and the umbrella header alone, against a program that calls CGAL's
# isotropic_remeshing(): processor time and memory, with the flags that the CMake target gives, -O2. The programs take turns.
# Usage: benchmark/Quad_meshing/bench_compile.sh [RUNS]   (default 3; needs GNU time)
set -eu

root=$(cd "$(dirname "$0")/../.." && pwd)
runs=${1:-3}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
command -v /usr/bin/time >/dev/null || apt-get install -y -q time >/dev/null

awk '/^```cpp/ { inside = 1; next } /^```/ { inside = 0 } inside' "$root/README.md" >"$work/readme.cpp"
echo '#include <CGAL/Quad_meshing.h>' >"$work/umbrella.cpp"
cp "$root/benchmark/Quad_meshing/compile/remeshing.cpp" "$work"
# the flags of the target
cat >"$work/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.18...3.25)
project(flags CXX)
add_subdirectory("$root" quad_meshing)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
add_library(flags OBJECT readme.cpp)
target_link_libraries(flags PRIVATE CGAL::Quad_meshing)
END
cmake -S "$work" -B "$work/build" -DCMAKE_BUILD_TYPE=None >/dev/null
flags=$(sed -n '/readme.cpp/s/.*"command": "[^ ]* \(.*\) -o .*/\1/p' "$work/build/compile_commands.json" | head -n 1)

measure()
{
  # shellcheck disable=SC2086
  /usr/bin/time -f "%U %M" -o "$work/$1.time" -a g++ $flags -O2 -c "$work/$1.cpp" -o "$work/$1.o"
}
i=0
while [ "$i" -lt "$runs" ]; do
  for program in remeshing readme umbrella; do
    measure "$program"
  done
  i=$((i + 1))
done
median() { sort -n "$work/$1.time" | awk '{ t[NR] = $1; m[NR] = $2 } END { print t[int((NR + 1) / 2)], m[int((NR + 1) / 2)] }'; }
yardstick=$(median remeshing)
for program in remeshing readme umbrella; do
  echo "$program $(median "$program") $yardstick" |
    awk '{ printf "%-10s %6.1f s %5.2f GB   time %.2f, memory %.2f times that of isotropic_remeshing\n", $1, $2, $3 / 1e6, $2 / $4, $3 / $5 }'
done
