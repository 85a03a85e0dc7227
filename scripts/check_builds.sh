#!/bin/sh
# Compiles the package with each compiler, version of CGAL and option that is supported, warnings being errors, and makes a quad mesh
# with each.
#
# The first configuration is built as a whole, with optimization, which some warnings need. The point of the others is that everything
# compiles: the compiler reads all sources (scripts/check_sources.py), and builds, without optimization, only what is run. Kernels in
# headers are linked from many sources, too, in one configuration.
# Usage: scripts/check_builds.sh [CONFIGURATION...]   (default: all; their names are below)
set -eu

root=$(cd "$(dirname "$0")/.." && pwd)
work="$root/build/check"
jobs=${JOBS:-2}
mkdir -p "$work"

"$root/scripts/install_packages.sh"
command -v clang++ >/dev/null || apt-get install -y -q --no-install-recommends clang

# The headers of CGAL 6, from Debian's release after this one, unpacked beside the installed ones.
cgal6()
{
  [ -d "$work/cgal6/usr/include/CGAL" ] && return
  mkdir -p "$work/apt/lists/partial"
  sed -e '/^#/d' -e '/^Signed-By/d' -e 's/^Types: deb$/Types: deb\nTrusted: yes/' /etc/apt/sources.list.d/debian.sources |
    awk 'BEGIN { RS = ""; ORS = "\n\n" } !/security/' | sed 's/^Suites: .*/Suites: trixie/' >"$work/apt/next.sources"
  apt_options="-o Dir::Etc::sourcelist=$work/apt/next.sources -o Dir::Etc::sourceparts=- -o Dir::State::lists=$work/apt/lists -o Dir::Cache=$work/apt"
  # shellcheck disable=SC2086
  (cd "$work/apt" && apt-get $apt_options update -q && apt-get $apt_options download libcgal-dev)
  dpkg-deb -x "$work"/apt/libcgal-dev_*.deb "$work/cgal6"
}

# check NAME COMPILER CGAL HEADER_ONLY CHOLMOD read|build [TARGET...]    (all are built, or read and only the targets are built)
check()
{
  name=$1 compiler=$2 cgal=$3 header_only=$4 cholmod=$5 way=$6
  shift 6
  case " $wanted " in *" $name "* | "  ") ;; *) return 0 ;; esac
  build="$work/$name"
  cgal_dir=""
  if [ "$cgal" = 6 ]; then
    cgal6
    cgal_dir="-DCGAL_DIR=$(dirname "$(find "$work/cgal6" -name CGALConfig.cmake)")"
  fi
  level=-O1
  [ "$way" = build ] || level=-O0
  echo "== $name"
  if [ ! -d "$build" ] && command -v ninja >/dev/null; then
    export CMAKE_GENERATOR=Ninja
  fi
  # shellcheck disable=SC2086
  cmake -S "$root" -B "$build" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG="$level -Werror" $cgal_dir \
    -DCGAL_QUAD_MESHING_HEADER_ONLY="$header_only" -DCGAL_QUAD_MESHING_WITH_CHOLMOD="$cholmod" \
    -DCGAL_QUAD_MESHING_BUILD_BENCHMARKS=ON -DCGAL_QUAD_MESHING_BUILD_PYTHON=ON \
    -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >"$work/$name.log" 2>&1 &&
    if [ "$way" = read ]; then
      cmake --build "$build" --parallel "$jobs" --target precompiled_headers >>"$work/$name.log" 2>&1 &&
        python3 "$root/scripts/check_sources.py" "$build" --jobs "$jobs" --skip "$alone" >>"$work/$name.log" 2>&1
    fi &&
    cmake --build "$build" --parallel "$jobs" --target quadrangulate "$@" >>"$work/$name.log" 2>&1 &&
    if [ -x "$build/test/Quad_meshing/test_headers" ]; then
      "$build/test/Quad_meshing/test_headers" >>"$work/$name.log" 2>&1
    fi &&
    "$build/examples/Quad_meshing/quadrangulate" "$mesh" "$work/$name.obj" --target-quads 500 >>"$work/$name.log" 2>&1 &&
    echo "   compiles, without warnings, and runs" && return 0
  tail -30 "$work/$name.log"
  echo "   failed, see $work/$name.log"
  failed="$failed $name"
}

# The sources that hold one header each. That every header includes what it needs is seen with one compiler.
alone='/headers/CGAL_Quad_meshing_[A-Z]'
wanted="$*"
failed=""
tar -xzf /usr/share/doc/libcgal-dev/data.tar.gz -C "$work" data/meshes/fandisk.off
mesh="$work/data/meshes/fandisk.off"

check gcc_cgal5 g++ 5 OFF ON build all
check gcc_cgal5_header_only g++ 5 ON ON build test_headers
check gcc_cgal5_without_cholmod g++ 5 OFF OFF build
check clang_cgal5 clang++ 5 OFF ON read
check gcc_cgal6 g++ 6 OFF ON read
check clang_cgal6_header_only clang++ 6 ON OFF read

if [ -n "$failed" ]; then
  echo "Failed:$failed"
  exit 1
fi
echo "All builds are fine."
