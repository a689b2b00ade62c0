#!/usr/bin/env bash
# Builds what is not built and flies. Words after play.sh go to the program: ./play.sh --autopilot
set -euo pipefail
cd "$(dirname "$0")"

./install_dependencies.sh --play
if [ ! -f build/play/build.ninja ]; then cmake --preset play >build-play.log 2>&1 || { cat build-play.log >&2; exit 1; }; rm -f build-play.log; fi
cmake --build --preset play --target skydrop -- --quiet | sed '/no work to do/d'

program=build/play/skydrop
if [ $# -gt 0 ] || [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
  exec "$program" "$@"
fi

frames=frames/$(date +%Y%m%d-%H%M%S)
mkdir -p "$frames"
echo "No display: the autopilot flies 20 s headless; its pictures are in $frames"
exec "$program" render --autopilot --size 640x360 --time 4 --fps 0.25 --frames 5 --out "$frames/flight-%d.png"
