#!/usr/bin/env bash
# Builds and runs every test, and the sanitizers over what they can see.
#   test.sh [--quick]     --quick leaves out the sanitizer builds
set -euo pipefail
cd "$(dirname "$0")"
quick=${1:-}

phase_names=() phase_seconds=()
phase() {  # phase NAME COMMAND...: runs and times it
  local name=$1 begin=$SECONDS
  shift
  echo "== $name"
  "$@"
  phase_names+=("$name") phase_seconds+=($((SECONDS - begin)))
}

build() {  # build PRESET TARGETS...
  local preset=$1
  shift
  cmake --preset "$preset" >/dev/null
  cmake --build --preset "$preset" --target "$@" -- --quiet
}

# The CPU suites: no OpenGL, so a sanitizer sees all that runs.
cpu_suites() { ctest --test-dir "build/$1" --output-on-failure --no-tests=error -j2 -R '^(unit|stability)[.]'; }

# One whole frame under the address sanitizer. Leaks are not looked for: the software renderer keeps its own.
gl_smoke() {
  local picture
  picture=$(mktemp --suffix=.png)
  ASAN_OPTIONS=detect_leaks=0 build/dev/skydrop render --size 160x90 --time 1 --out "$picture"
  rm -f "$picture"
}

phase "install" ./install_dependencies.sh
phase "build" build ci all
phase "test" ctest --test-dir build/ci --output-on-failure --no-tests=error -j2
if [ "$quick" != "--quick" ]; then
  phase "build with address and undefined-behaviour sanitizers" build dev all
  phase "test with address and undefined-behaviour sanitizers" cpu_suites dev
  phase "one frame with address and undefined-behaviour sanitizers" gl_smoke
  phase "build with the thread sanitizer" build tsan unit_tests stability_tests
  phase "test with the thread sanitizer" cpu_suites tsan
fi

echo
for i in "${!phase_names[@]}"; do printf '%5d s  %s\n' "${phase_seconds[$i]}" "${phase_names[$i]}"; done
echo "All tests passed."
