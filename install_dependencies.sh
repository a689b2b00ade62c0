#!/usr/bin/env bash
# Installs what is missing on Debian (and its kin). Says nothing and needs no network when nothing is.
#   install_dependencies.sh [--play]     --play leaves out what only tests and scripts need
set -euo pipefail

build=(g++ cmake ninja-build pkg-config ccache)
libraries=(libglfw3-dev libglm-dev libimgui-dev libstb-dev libassimp-dev zlib1g-dev libopenal-dev libsndfile1-dev
           libegl-dev libgl-dev libegl1 libgl1 libgl1-mesa-dri nlohmann-json3-dev libcli11-dev
           libcurl4-openssl-dev libtiff-dev libgeotiff-dev libproj-dev proj-data libzip-dev
           libturbojpeg0-dev)
tests=(libgtest-dev libgmock-dev libbenchmark-dev libosmesa6 xvfb xauth xdotool x11-utils glslang-tools
       python3 python3-numpy python3-jsonschema appstream chromium snakemake)

wanted=("${build[@]}" "${libraries[@]}")
[ "${1:-}" = "--play" ] || wanted+=("${tests[@]}")

if ! command -v dpkg-query >/dev/null; then
  echo "install_dependencies.sh: not a Debian system; it needs what corresponds to: ${wanted[*]}" >&2
  exit 1
fi
missing=()
for package in "${wanted[@]}"; do
  status=$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null || true)
  [ "$status" = "install ok installed" ] || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "install_dependencies.sh: run as root, or install sudo: needs ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
echo "installing: ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
install() { "${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null; }
install 2>/dev/null || { "${as_root[@]}" apt-get update -qq && install; }
