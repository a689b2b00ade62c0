#!/usr/bin/env bash
# Packs what tests/device/check.sh runs into a folder that works on another x86-64 Linux with an EGL driver of its own:
# programs, tests, data and every library that they need, but none of a driver.
#   bundle.sh [FOLDER]     build/device unless told
set -euo pipefail
cd "$(dirname "$0")/../.."
folder=${1:-build/device}
most_mib=60

cmake --preset ci >/dev/null
cmake --build --preset ci --target skydrop gl_tests golden_tests device_check -- --quiet
rm -rf "$folder"
mkdir -p "$folder"/{bin,tests,lib,glibc,loaders}
folder=$(cd "$folder" && pwd)

strip_to() { strip -o "$2" "$1"; }
strip_to build/ci/skydrop "$folder/bin/skydrop"
for program in gl_tests golden_tests device_check; do strip_to "build/ci/tests/$program" "$folder/bin/$program"; done
cp -r assets shaders noise_scripts "$folder/"
cp -r tests/golden "$folder/tests/"
mkdir -p "$folder/tests/gl"
cp -r tests/gl/shaders "$folder/tests/gl/"
cp tests/device/check.sh "$folder/check.sh"

# C library and loader lie apart: where the machine's own are newer, they are used, because its driver needs them. The
# vendor-neutral OpenGL loaders likewise.
libraries() { ldd "$folder"/bin/* | awk '/=> \//{print $3} /^\t\/.*ld-linux/{print $1}' | sort -u; }
for library in $(libraries); do
  case $(basename "$library") in
    ld-linux* | libc.so* | libm.so* | libpthread.so* | libdl.so* | librt.so* | libresolv.so* | libmvec.so*) to=glibc ;;
    libEGL.so* | libGL.so* | libGLX.so* | libGLdispatch.so* | libOpenGL.so*) to=loaders ;;
    *) to=lib ;;
  esac
  cp -L "$library" "$folder/$to/"
done
# Loaded by name while running, so ldd does not see it.
for loader in libEGL.so.1 libGLdispatch.so.0 libOpenGL.so.0; do
  found=$(ldconfig -p | awk -v name="$loader" '$1 == name && /x86-64/ {print $NF; exit}')
  [ -z "$found" ] || cp -L "$found" "$folder/loaders/"
done

mib=$(du -sm "$folder" | cut -f1)
echo "$folder: $mib MiB"
if [ "$mib" -gt "$most_mib" ]; then
  echo "bundle.sh: larger than $most_mib MiB" >&2
  exit 1
fi
