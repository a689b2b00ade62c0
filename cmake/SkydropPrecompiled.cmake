# What nearly every file includes, parsed once a build tree: half of the compile time is these headers. Off in the
# preset `play`, which so checks that every file includes what it uses.
#   skydrop_precompile(TARGET)       standard library and GLM
#   skydrop_precompile_test(TARGET)  GoogleTest too
set(skydrop_common_headers <algorithm> <array> <chrono> <cmath> <cstdint> <cstdio> <filesystem> <functional> <map>
    <memory> <mutex> <optional> <set> <span> <string> <string_view> <thread> <utility> <vector>
    <glm/geometric.hpp> <glm/gtc/quaternion.hpp> <glm/mat3x3.hpp> <glm/mat4x4.hpp> <glm/vec2.hpp> <glm/vec3.hpp>
    <glm/vec4.hpp>)

function(skydrop_precompiled_headers name)
  file(WRITE ${PROJECT_BINARY_DIR}/${name}.cpp.in "// Holds the precompiled headers of ${name}.\n")
  configure_file(${PROJECT_BINARY_DIR}/${name}.cpp.in ${PROJECT_BINARY_DIR}/${name}.cpp COPYONLY)
  add_library(${name} OBJECT ${PROJECT_BINARY_DIR}/${name}.cpp)
  target_link_libraries(${name} PRIVATE skydrop_flags glm::glm Threads::Threads)
  target_precompile_headers(${name} PRIVATE ${ARGN})
endfunction()

if(SKYDROP_PRECOMPILED_HEADERS)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # For ccache; and g++ 12 sees overflows in its own std::string once that comes from a precompiled header (the
    # sanitizers look for real ones).
    target_compile_options(skydrop_flags INTERFACE -fpch-preprocess -Wno-array-bounds -Wno-restrict
      -Wno-stringop-overflow)
  endif()
  skydrop_precompiled_headers(skydrop_precompiled ${skydrop_common_headers})
  if(SKYDROP_TESTS)
    skydrop_precompiled_headers(skydrop_precompiled_tests ${skydrop_common_headers} <gtest/gtest.h>)
    target_link_libraries(skydrop_precompiled_tests PRIVATE GTest::gtest)
  endif()
endif()

function(skydrop_precompile target)
  if(SKYDROP_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} REUSE_FROM skydrop_precompiled)
  endif()
endfunction()

function(skydrop_precompile_test target)
  if(SKYDROP_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} REUSE_FROM skydrop_precompiled_tests)
  endif()
endfunction()
