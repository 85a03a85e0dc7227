#!/bin/sh
# Installs what is missing on Debian 12 to build and run Quad_meshing, and the packages named. Does nothing where all is there.
# Usage: scripts/install_packages.sh [PACKAGE...]
set -eu

packages="cmake ninja-build g++ ccache libcgal-dev libcgal-demo libeigen3-dev libboost-program-options-dev libsuitesparse-dev libjs-three $*"

missing=""
for package in $packages; do
  if ! dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q "ok installed"; then
    missing="$missing $package"
  fi
done
[ -n "$missing" ] || exit 0

if [ "$(id -u)" -ne 0 ]; then
  echo "Please install these packages, or run this script as root:$missing" >&2
  exit 1
fi
export DEBIAN_FRONTEND=noninteractive
apt-get update -q
# shellcheck disable=SC2086
apt-get install -y -q --no-install-recommends $missing
