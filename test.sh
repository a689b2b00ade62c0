#!/usr/bin/env bash
# Builds and runs every test, and the sanitizers over what they can see.
#   test.sh [--quick|--all]   --quick leaves out the sanitizer builds; --all tries every combination where a part is tried
#                             otherwise (SKYDROP_ALL), and also runs what OSMesa repeats of EGL (label twin)
set -euo pipefail
cd "$(dirname "$0")"
mode=${1:-}
case "$mode" in
  "" | --quick | --all) ;;
  *) echo "test.sh: unknown option $mode: --quick or --all" >&2 && exit 2 ;;
esac

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

# Runs tests of a preset; its report is kept for the summary. Results of an earlier run are not counted.
reports=()
run_tests() {  # run_tests PRESET CTEST_ARGUMENTS...
  local preset=$1
  shift
  local report="$PWD/build/$preset/test-report.xml"
  rm -f "$report"
  ctest --test-dir "build/$preset" --output-on-failure --no-tests=error -j2 --output-junit "$report" "$@"
  reports+=("$report")
}

# Sweeps of plain arithmetic through hundreds of thousands of moments or directions, a quarter of the time of a sanitizer:
# others of their fixtures enter the same code. --all watches them too.
sweeps='Moonlight[.](dusk|theSkyGlows)|BudgetController[.](changesDieOut|timesInSteps)|SunDogs[.]aSlice'
sweeps+='|SkyShell[.](allOrders|theAirUp|pathsThatAreLed|skiesBetween|aSkyDoesNot)|FlashLight[.]glow|RainbowTable[.]firstRow'
sweeps+='|NoiseLand[.]mostLand|LandingPilot[.]inACrosswind'
[ "$mode" != "--all" ] || sweeps='$'

# The CPU suites: no OpenGL, so a sanitizer sees all that runs. Without the tests of Python scripts and those that read
# the sources, and with the clouds' noise that the first build has made.
cpu_suites() {  # cpu_suites PRESET CTEST_ARGUMENTS...
  local preset=$1
  shift
  SKYDROP_TEST_CACHE="$PWD/build/ci/tests/cache" \
    run_tests "$preset" "$@" -R '^(unit|stability)[.]' -E "^unit[.]((AssetScripts|NoiseScripts|IncludeRule|PrintRule|ReaderRule)[.]|$sweeps)"
}

count_of() { sed -n "s/^[[:space:]]*$1=\"\([0-9]*\)\".*/\1/p" "$2" | head -n 1; }  # count_of tests|skipped REPORT

# A line for each skipped test of a report: its name, and the reason that it printed after "Skipped".
skipped_tests() {
  awk '/<testcase name=/ {split($0, part, "\""); name = part[2]}
       /<skipped/ {if (pending) print pending; pending = name}
       tellsWhy {print pending ": " $0; pending = ""; tellsWhy = 0}
       /: Skipped$/ {tellsWhy = pending != ""}
       END {if (pending) print pending}' "$1"
}

# One whole frame under the address sanitizer, and effects that come and go. Leaks are not looked for: the software
# renderer keeps its own.
gl_smoke() {
  local picture
  picture=$(mktemp --suffix=.png)
  export ASAN_OPTIONS=detect_leaks=0 SKYDROP_TEST_CACHE="$PWD/build/ci/tests/cache"
  build/dev/skydrop render --size 160x90 --time 1 --out "$picture"
  rm -f "$picture"
  build/dev/tests/gl_tests --gtest_brief=1 --gtest_filter='EffectSetGLTest.*'
}

# Programs that Mesa has compiled are kept beside those of the compiler cache, for the next build and the next clone. Tests
# of what a cold cache costs have their own.
export MESA_SHADER_CACHE_DIR="${MESA_SHADER_CACHE_DIR:-${XDG_CACHE_HOME:-$HOME/.cache}/skydrop-test-shaders}"

phase "install" ./install_dependencies.sh
phase "build" build ci all
left_out='^(long|twin)$'
if [ "$mode" = "--all" ]; then
  left_out='^long$'
  export SKYDROP_ALL=1
fi
phase "test" run_tests ci -LE "$left_out"
if [ "$mode" != "--quick" ]; then
  phase "build with address and undefined-behaviour sanitizers" build dev skydrop unit_tests stability_tests gl_tests fuzz_replay
  phase "test with address and undefined-behaviour sanitizers" cpu_suites dev
  phase "frames and effects with address and undefined-behaviour sanitizers" gl_smoke
  phase "build with the thread sanitizer" build tsan unit_tests stability_tests
  phase "test with the thread sanitizer" cpu_suites tsan -L threads
fi

echo
for i in "${!phase_names[@]}"; do printf '%5d s  %s\n' "${phase_seconds[$i]}" "${phase_names[$i]}"; done
total=0 skipped=0
for report in "${reports[@]}"; do
  total=$((total + $(count_of tests "$report")))
  skipped=$((skipped + $(count_of skipped "$report")))
done
if [ "$skipped" -gt 0 ]; then
  echo "Skipped:"
  for report in "${reports[@]}"; do skipped_tests "$report" | sed 's/^/  /'; done
fi
echo "$((total - skipped)) passed, 0 failed, $skipped skipped"
# Where everything is installed by the script above, a skipped test is a fault of the set-up.
if [ "$skipped" -gt 0 ] && [ "${CI:-}" = true ]; then
  echo "test.sh: tests were skipped in continuous integration" >&2
  exit 1
fi
