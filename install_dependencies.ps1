# Installs the libraries on Windows through vcpkg, which it expects in $env:VCPKG_ROOT, and configures a build.
# Not tried on Windows yet.
$ErrorActionPreference = "Stop"
if (-not $env:VCPKG_ROOT) {
    Write-Error "Set VCPKG_ROOT to a checkout of vcpkg that has been bootstrapped."
}
& "$env:VCPKG_ROOT/vcpkg" install --x-feature=tests --triplet x64-windows
if ($LASTEXITCODE -ne 0) { exit $LASTEXITCODE }
cmake -S . -B build/windows -DCMAKE_TOOLCHAIN_FILE="$env:VCPKG_ROOT/scripts/buildsystems/vcpkg.cmake" -DVCPKG_MANIFEST_FEATURES=tests
exit $LASTEXITCODE
