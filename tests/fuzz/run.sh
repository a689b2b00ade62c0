#!/usr/bin/env bash
# Builds the fuzzers and runs each (docs/fuzzing.md).
#   tests/fuzz/run.sh [SECONDS [TARGET..]]    60 seconds, all targets
#   tests/fuzz/run.sh --minimise [TARGET..]   takes what was found into tests/fuzz/corpus, as far as it reaches new code
# What is found lies in build/fuzz/corpus/TARGET, inputs that end the program in build/fuzz/findings, logs in
# build/fuzz/logs. Exit code 1 where a target has a finding.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=build/fuzz
seconds=60 minimise=
if [ "${1:-}" = --minimise ]; then
  minimise=yes
  shift
elif [ $# -gt 0 ]; then
  seconds=$1
  shift
fi
if [ -z "${SKYDROP_FUZZ_AS_BUILT:-}" ]; then
  cmake --preset fuzz >/dev/null
  cmake --build --preset fuzz -- --quiet
fi
mkdir -p "$build/findings" "$build/logs"

# Libraries keep what they have once allocated, and PROJ its data bases: leaks are looked for by the usual suites.
export ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1:handle_abort=1 UBSAN_OPTIONS=print_stacktrace=1
most_seconds_an_input=20 most_kept_files=80 most_kept_bytes=4096
failed=
printf '%-20s %12s %8s %8s %8s %s\n' target executions seconds edges corpus findings
while read -r -u 3 name _ longest dictionary seeds; do
  case $name in '' | \#*) continue ;; esac
  if [ $# -gt 0 ] && [[ " $* " != *" $name "* ]]; then continue; fi
  found="$build/corpus/$name"
  mkdir -p "$found" "$build/seeds/$name"
  for pattern in $seeds; do
    # shellcheck disable=SC2086  # a pattern
    [ "$pattern" = - ] || cp $pattern "$build/seeds/$name/"
  done
  folders=("$found" "$build/seeds/$name")
  [ -d "tests/fuzz/corpus/$name" ] && folders+=("tests/fuzz/corpus/$name")
  flags=(-timeout="$most_seconds_an_input" -rss_limit_mb=2560 -artifact_prefix="$build/findings/$name-")
  if [ -n "$minimise" ]; then
    merged=$(mktemp -d)
    "$build/tests/fuzz_$name" "${flags[@]}" -merge=1 "$merged" "${folders[@]:1}" "$found" >"$build/logs/$name.merge" 2>&1
    # The smallest ones: a large input reaches no more than several small ones, and is mutated less well.
    mkdir -p "tests/fuzz/corpus/$name"
    find "$merged" -type f -size -${most_kept_bytes}c -printf '%s %p\n' | sort -n | head -n "$most_kept_files" |
      while read -r _ file; do
        # What the seeds hold already is not kept twice.
        cmp_found=
        for seed in "$build/seeds/$name"/*; do cmp -s "$seed" "$file" && cmp_found=yes && break; done
        [ -n "$cmp_found" ] || cp "$file" "tests/fuzz/corpus/$name/"
      done
    rm -rf "$merged"
    continue
  fi
  [ "$dictionary" = - ] || flags+=(-dict="tests/fuzz/dictionaries/$dictionary.dict")
  code=0
  "$build/tests/fuzz_$name" "${flags[@]}" -max_len="$longest" -max_total_time="$seconds" -print_final_stats=1 \
    "${folders[@]}" >"$build/logs/$name" 2>&1 || code=$?
  executions=$(sed -n 's/^stat::number_of_executed_units: *//p' "$build/logs/$name")
  edges=$(grep -o 'cov: [0-9]*' "$build/logs/$name" | tail -n 1 | cut -d' ' -f2)
  took=$(sed -n 's/^Done .* in \([0-9]*\) second.*/\1/p' "$build/logs/$name")
  findings=$(find "$build/findings" -name "$name-*" | wc -l)
  printf '%-20s %12s %8s %8s %8s %s\n' "$name" "${executions:-?}" "${took:-?}" "${edges:-?}" \
    "$(find "$found" -type f | wc -l)" "$findings"
  if [ "$code" != 0 ] || [ "$findings" != 0 ]; then failed=yes; fi
done 3<tests/fuzz/targets.txt
[ -z "$failed" ]
