#!/usr/bin/env bash
# The same bits by every compiler, level of optimisation, instruction set, number of workers and choice of libm:
# compares the digests that state_hashes prints (docs/determinism.md has the last table).
#
#   check.sh --program FILE   one program, built already: its kernels, 1, 2 and 8 workers, and GLIBC_TUNABLES
#                             without AVX2, FMA and AVX-512 (what the suite runs)
#   check.sh [COMPILER-LEVEL...]   builds state_hashes in build/compilers with g++ and clang++ at -O0 to -O3 (or what
#                             is named: clang++-O3), runs each as above, and prints a table. Needs Debian's clang;
#                             15 minutes of one core a level. A compiler that is not there is left out, and said.
#   check.sh --reference FILE [COMPILER-LEVEL...]   compares them with a program that is built already
# Exit code 1: something differs.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
elevation=$root/assets/elevation/mittelland.tif
without="glibc.cpu.hwcaps=-AVX2,-AVX2_Usable,-FMA,-FMA_Usable,-FMA4_Usable,-AVX512F,-AVX512F_Usable,-AVX_Fast_Unaligned_Load"
differences=0

# compare NAME EXPECTED ACTUAL: digests as "part digest" lines; each part of ACTUAL must be as in EXPECTED.
compare() {
  local part digest expected
  while read -r part digest; do
    expected=$(awk -v part="$part" '$1 == part {print $2}' <<<"$2")
    if [ "$digest" != "$expected" ]; then
      echo "differs: $part by $1: $digest, not $expected"
      differences=$((differences + 1))
    fi
  done <<<"$3"
}

# check_program FILE: every way to run one program. Leaves its digests in `truth`.
check_program() {
  local program=$1 name=$2 some kernels workers code
  truth=$("$program" --elevation "$elevation")
  for kernels in baseline sse41 avx2 avx512; do
    code=0
    some=$("$program" --kernels $kernels terrain noise targets) || code=$?
    if [ $code = 3 ]; then echo "not tried: $kernels, which this processor lacks"; continue; fi
    [ $code = 0 ] || exit $code
    compare "$name with the kernels $kernels" "$truth" "$some"
  done
  for workers in 2 8; do
    compare "$name with $workers workers" "$truth" \
      "$("$program" --workers $workers --elevation "$elevation" terrain noise elevation)"
  done
  compare "$name without AVX2, FMA and AVX-512 in libm" "$truth" \
    "$(GLIBC_TUNABLES=$without "$program" --elevation "$elevation")"
}

if [ "${1:-}" = "--program" ]; then
  check_program "$2" "$(basename "$2")"
  echo "$(wc -l <<<"$truth") parts, $differences differences"
  [ $differences = 0 ]
  exit
fi

reference='' reference_name=''
if [ "${1:-}" = "--reference" ]; then
  reference=$("$2" --elevation "$elevation") reference_name=$2
  shift 2
fi
levels=("$@")
if [ ${#levels[@]} = 0 ]; then
  for compiler in g++ clang++; do
    for level in 0 1 2 3; do levels+=("$compiler-O$level"); done
  done
fi
for level in "${levels[@]}"; do
  compiler=${level%-O*} folder=$root/build/compilers/$level
  if ! command -v "$compiler" >/dev/null; then
    echo "not tried: $level, no $compiler (apt-get install ${compiler%++})"
    continue
  fi
  cmake -G Ninja -S "$root" -B "$folder" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_CXX_FLAGS_RELEASE="-O${level##*-O}" -DSKYDROP_PRECOMPILED_HEADERS=ON -DSKYDROP_BENCHMARKS=OFF >/dev/null
  cmake --build "$folder" --target state_hashes -- --quiet -j"${JOBS:-2}"
  check_program "$folder/tests/state_hashes" "$level"
  if [ -z "$reference" ]; then
    reference=$truth reference_name=$level
    echo "$level:"
    echo "$truth"
  else
    before=$differences
    compare "$level" "$reference" "$truth"
    echo "$level: $((differences - before)) parts differ from $reference_name"
  fi
done
[ -n "$reference" ] && [ $differences = 0 ]
