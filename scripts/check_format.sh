#!/bin/sh
# Says which sources are not laid out as .clang-format says; with --fix, lays them out.
# Only version 14 of clang-format is asked: others break lines differently.
# Usage: scripts/check_format.sh [--fix]
set -eu

root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"
program=""
for candidate in clang-format-14 clang-format; do
  if command -v "$candidate" >/dev/null && "$candidate" --version | grep -q 'version 14\.'; then
    program=$candidate
    break
  fi
done
if [ -z "$program" ]; then
  echo "NOTICE: the layout of the sources is not checked, because there is no clang-format 14."
  exit 77
fi

if [ "${1:-}" = --fix ]; then
  mode=-i
else
  mode="--dry-run --Werror"
fi
# shellcheck disable=SC2086
find include src examples benchmark python test \( -name '*.h' -o -name '*.cpp' \) -print0 |
  xargs -0 "$program" $mode
# clang-format leaves comments alone.
if find include src examples benchmark python test \( -name '*.h' -o -name '*.cpp' \) -exec awk 'length > 120 {
  print FILENAME ":" FNR ": more than 120 columns"; found = 1 } END { exit !found }' {} +; then
  exit 1
fi
echo "All sources are laid out as .clang-format says."
