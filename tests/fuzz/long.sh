#!/usr/bin/env bash
# Long fuzzing beside other work (docs/fuzzing.md): two targets at a time at the lowest priority, from copies of the
# programs and their seeds, so that the tree may be rebuilt, moved or removed meanwhile. A target runs until it has used
# SECONDS of processor time, however long that takes on a busy machine.
#   tests/fuzz/long.sh queue FOLDER [SECONDS [TARGET..]]  600 seconds, all targets of build/fuzz; returns at once. Again
#                                                 with TARGETS: takes their newer programs and runs them once more
#   tests/fuzz/long.sh table FOLDER               what came of the newest run of each, as a table for docs/fuzzing.md
# In FOLDER: logs/TARGET.RUN, findings/TARGET.RUN-*, corpus/TARGET (grows over the runs). Exit code of table: 1 where there
# is a finding.
set -euo pipefail
# By the clock on the wall: an input of 3 s takes 20 and more where other work has the processors.
most_seconds_an_input=200 most_megabytes=2560 at_a_time=${SKYDROP_FUZZ_AT_A_TIME:-2}

# A target of FOLDER/waiting after the other, until there is none; waiting/NUMBER-TARGET-SECONDS holds it.
work() {
  cd "$1"
  export ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1:handle_abort=1 UBSAN_OPTIONS=print_stacktrace=1
  # Where the scheduler groups sessions, nice counts within one alone: the group's own value is what others feel.
  echo 19 2>/dev/null >/proc/self/autogroup || true
  local entry name seconds run longest dictionary flags used
  local TIMEFORMAT='%0U %0S'
  while true; do
    entry=
    for entry in waiting/*; do
      [ -e "$entry" ] && mv "$entry" "taken/" 2>/dev/null && break  # the other one was faster
      entry=
    done
    [ -n "$entry" ] || return 0
    IFS=- read -r _ name seconds <<<"$(basename "$entry")"
    read -r _ _ longest dictionary _ < <(grep "^$name " targets.txt)
    run=1
    while [ -e "logs/$name.$run" ]; do run=$((run + 1)); done
    mkdir -p "corpus/$name" "temporary/$name"
    flags=(-timeout=$most_seconds_an_input -rss_limit_mb=$most_megabytes -artifact_prefix="findings/$name.$run-"
      -max_len="$longest" -print_final_stats=1)
    [ "$dictionary" = - ] || flags+=(-dict="dictionaries/$dictionary.dict")
    used=0
    : >"logs/$name.$run"
    while [ $used -lt "$seconds" ]; do  # in slices, since libFuzzer knows the clock on the wall alone
      { time TMPDIR=$PWD/temporary/$name nice -n 19 "./fuzz_$name" "${flags[@]}" \
        -max_total_time=$((seconds - used > 20 ? seconds - used : 20)) "corpus/$name" "seeds/$name" \
        >>"logs/$name.$run" 2>&1; } 2>"temporary/$name.time" || { echo "exit code $?" >>"logs/$name.$run" && break; }
      used=$((used + $(tail -n 1 "temporary/$name.time" | tr ' ' '+')))
      echo "processor time: $used s" >>"logs/$name.$run"
    done
  done
}

queue() {
  local folder=$1 seconds=${2:-600} root number=0 seeds name pattern
  shift $(($# < 2 ? $# : 2))
  root=$(cd "$(dirname "$0")/../.." && pwd)
  folder=$(realpath -m "$folder")
  cd "$root"
  for name in "$@"; do
    grep -q "^$name " tests/fuzz/targets.txt || { echo "long.sh: no target $name in targets.txt" >&2 && exit 2; }
  done
  mkdir -p "$folder"/{waiting,taken,logs,findings,corpus,seeds,temporary}
  cp -r tests/fuzz/dictionaries tests/fuzz/targets.txt "$folder/"
  mkdir -p "$folder/tests"
  cp -r assets shaders "$folder/"  # what the targets read at run time
  cp -r tests/corpus "$folder/tests/"
  [ -e "$folder/long.sh" ] || cp tests/fuzz/long.sh "$folder/long.sh"
  number=$(find "$folder/taken" "$folder/waiting" -type f | wc -l)
  while read -r -u 3 name _ _ _ seeds; do
    case $name in '' | \#*) continue ;; esac
    if [ $# -gt 0 ] && [[ " $* " != *" $name "* ]]; then continue; fi
    cp --remove-destination "build/fuzz/tests/fuzz_$name" "$folder/"  # one that runs keeps its own
    mkdir -p "$folder/seeds/$name"
    for pattern in $seeds; do
      # shellcheck disable=SC2086  # a pattern
      [ "$pattern" = - ] || cp $pattern "$folder/seeds/$name/"
    done
    [ -d "tests/fuzz/corpus/$name" ] && cp tests/fuzz/corpus/"$name"/* "$folder/seeds/$name/"
    number=$((number + 1))
    printf '' >"$folder/waiting/$(printf '%04d' $number)-$name-$seconds"
  done 3<tests/fuzz/targets.txt
  for ((i = 0; i < at_a_time; ++i)); do
    setsid bash -c 'flock -n 9 && exec "$0" work "$1"' "$folder/long.sh" "$folder" 9>"$folder/worker$i" \
      </dev/null >/dev/null 2>&1 &
    disown
  done
}

table() {
  cd "$1"
  local name log run seconds executions edges findings state failed=
  echo '| target | executions | processor s | edges | inputs kept | findings |'
  echo '|---|---|---|---|---|---|'
  while read -r -u 3 name _; do
    case $name in '' | \#*) continue ;; esac
    log=$(find logs -name "$name.*" | sort -t. -k2 -n | tail -n 1)
    if [ -z "$log" ]; then
      echo "| $name | not run | | | | |"
      continue
    fi
    run=${log##*.}
    executions=$(awk '/^stat::number_of_executed_units:/ {sum += $2} END {print sum}' "$log")
    seconds=$(sed -n 's/^processor time: \([0-9]*\) s$/\1/p' "$log" | tail -n 1)
    [ -n "$seconds" ] || seconds=$(sed -n 's/^Done .* in \([0-9]*\) second.*/\1/p' "$log")  # of an older long.sh
    edges=$(grep -o 'cov: [0-9]*' "$log" | tail -n 1 | cut -d' ' -f2)
    findings=$(find findings -name "$name.$run-*" | wc -l)
    [ "$findings" = 0 ] || failed=yes
    state=$findings
    [ -n "$seconds" ] || [ "$findings" != 0 ] || state="0, not ended"
    echo "| $name | ${executions:-?} | ${seconds:-?} | ${edges:-?} | $(find "corpus/$name" -type f | wc -l) | $state |"
  done 3<targets.txt
  [ -z "$failed" ]
}

case ${1:-} in
  queue | work | table) [ $# -ge 2 ] && "$@" && exit ;;
  *) sed -n '2,10s/^# \?//p' "$0" ;;
esac
exit 1
