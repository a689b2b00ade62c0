#!/usr/bin/env bash
# Runs the device check of the bundle that it lies in: device.json and device.md in a folder. At most 8 minutes.
#   check.sh [OUT] [--quick]     OUT is "device-check" unless told; --quick tries the check itself with small pictures
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
out=device-check
[ $# -gt 0 ] && [ "${1#-}" = "$1" ] && { out=$1; shift; }

# The newer C library of the two: a driver may need the machine's, the programs need at least the bundle's.
version_of() { "$1" --version 2>/dev/null | sed -n '1s/.* \([0-9]*\.[0-9]*\).*/\1/p'; }
own=/lib64/ld-linux-x86-64.so.2
loader=$here/glibc/ld-linux-x86-64.so.2
path=$here/lib
newest=$(printf '%s\n%s\n' "$(version_of "$own" || true)" "$(version_of "$loader")" | sort -V | tail -n 1)
if [ -e "$own" ] && [ "$(version_of "$own" || true)" = "$newest" ]; then
  loader=$own
else
  path=$here/glibc:$path
fi
ldconfig=$(command -v ldconfig || echo /sbin/ldconfig)
"$ldconfig" -p 2>/dev/null | grep -q 'libEGL\.so\.1' || path=$path:$here/loaders

# Programs start each other by name, so each is a script that starts the real one with this loader.
bin=$(mktemp -d)
trap 'rm -rf "$bin"' EXIT
mkdir "$bin/tests"
start() {  # start NAME FILE
  printf '#!/bin/sh\nexec "%s" --library-path "%s%s" "%s" "$@"\n' \
    "$loader" "$path" "${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}" "$here/bin/$1" >"$2"
  chmod +x "$2"
}
start skydrop "$bin/skydrop"
for name in gl_tests golden_tests; do start "$name" "$bin/tests/$name"; done
start device_check "$bin/device_check"
for data in assets shaders noise_scripts; do ln -s "$here/$data" "$bin/$data"; done
for data in golden gl; do ln -s "$here/tests/$data" "$bin/tests/$data"; done

mkdir -p "$here/cache"
export SKYDROP_TEST_BUNDLE=$bin SKYDROP_DATA_DIR=$here SKYDROP_TEST_CACHE=$here/cache XDG_CACHE_HOME=$here/cache
"$bin/skydrop" noise >/dev/null  # the clouds' noise, once for all programs: 10 MiB that need not travel
"$bin/device_check" "$out" "$@"
