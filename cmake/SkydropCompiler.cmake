# One set of flags for everything that is ours. Simulation and terrain must give the same bits on every
# x86-64 machine: no contraction into fused multiply-add, no fast-math, no -march. The two -fno flags let
# the vectoriser work on floor and sqrt and change no result (docs/determinism.md).
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# Paths relative to the source tree, so that several clones share one cache; what it must overlook for precompiled
# headers.
find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER
    ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${CCACHE_PROGRAM})
endif()

add_library(skydrop_flags INTERFACE)
if(MSVC)
  target_compile_options(skydrop_flags INTERFACE /W4 /permissive- /fp:precise /utf-8 $<$<BOOL:${SKYDROP_WERROR}>:/WX>)
  target_compile_definitions(skydrop_flags INTERFACE NOMINMAX _USE_MATH_DEFINES)
else()
  target_compile_options(skydrop_flags INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Wold-style-cast
    -ffp-contract=off -fno-math-errno -fno-trapping-math
    $<$<BOOL:${SKYDROP_WERROR}>:-Werror>)
  if(SKYDROP_SANITIZE)
    # g++ 12 sees uninitialised members in its own std::function once sanitizers have split it up.
    target_compile_options(skydrop_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>
      -fsanitize=${SKYDROP_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(skydrop_flags INTERFACE -fsanitize=${SKYDROP_SANITIZE})
  endif()
endif()
target_compile_definitions(skydrop_flags INTERFACE
  GLM_FORCE_XYZW_ONLY GLM_FORCE_EXPLICIT_CTOR GLM_ENABLE_EXPERIMENTAL)
