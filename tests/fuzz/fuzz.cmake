# The fuzz targets of fuzz/targets.txt (docs/fuzzing.md). With SKYDROP_FUZZERS a libFuzzer program each, fuzz_NAME; in
# any build fuzz_replay, which holds all of them and gives them their seeds and damaged copies of these.
set(fuzz_dir ${CMAKE_CURRENT_SOURCE_DIR}/fuzz)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${fuzz_dir}/targets.txt)
file(STRINGS ${fuzz_dir}/targets.txt fuzz_lines REGEX "^[a-z]")
set(fuzz_names)
foreach(line ${fuzz_lines})
  string(REGEX MATCHALL "[^ ]+" words ${line})
  list(POP_FRONT words name copies longest dictionary)
  set(fuzz_${name}_copies ${copies})
  list(APPEND fuzz_names ${name})
  set(fuzz_${name}_seeds ${words})
endforeach()

add_library(fuzz_inputs STATIC ${fuzz_dir}/fuzz_input.cpp ${fuzz_dir}/model_input.cpp ${fuzz_dir}/weather_input.cpp
  ${fuzz_dir}/elevation_input.cpp support/paths.cpp)
target_link_libraries(fuzz_inputs PUBLIC skydrop_test_paths skydrop::render skydrop::audio skydrop::accuracy
  skydrop::forecast skydrop::elevation)
skydrop_precompile(fuzz_inputs)

if(SKYDROP_FUZZERS)
  add_custom_target(fuzzers)
  foreach(name ${fuzz_names})
    add_executable(fuzz_${name} ${fuzz_dir}/targets/${name}.cpp)
    target_link_libraries(fuzz_${name} PRIVATE fuzz_inputs skydrop::app)
    target_link_options(fuzz_${name} PRIVATE -fsanitize=fuzzer)
    add_dependencies(fuzzers fuzz_${name})
  endforeach()
else()
  set(declarations)
  set(entries)
  foreach(name ${fuzz_names})
    set_source_files_properties(${fuzz_dir}/targets/${name}.cpp PROPERTIES
      COMPILE_DEFINITIONS LLVMFuzzerTestOneInput=fuzz_${name})
    string(APPEND declarations "extern \"C\" int fuzz_${name}(const std::uint8_t*, std::size_t);\n")
    string(APPEND entries "    {\"${name}\", fuzz_${name}},\n")
  endforeach()
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/fuzz_targets.cpp CONTENT "#include \"fuzz/fuzz_targets.h\"

${declarations}
namespace skydrop::fuzz {

constexpr Target kTargets[] = {
${entries}};

std::span<const Target> targets() { return kTargets; }

}  // namespace skydrop::fuzz
")
  list(TRANSFORM fuzz_names REPLACE "(.+)" "${fuzz_dir}/targets/\\1.cpp" OUTPUT_VARIABLE target_sources)
  add_executable(fuzz_replay ${fuzz_dir}/replay.cpp support/mutants.cpp ${CMAKE_CURRENT_BINARY_DIR}/fuzz_targets.cpp
    ${target_sources})
  target_link_libraries(fuzz_replay PRIVATE fuzz_inputs skydrop::app)
  skydrop_precompile(fuzz_replay)
  foreach(name ${fuzz_names})
    set(seeds)
    foreach(pattern ${fuzz_${name}_seeds})
      if(NOT pattern STREQUAL "-")
        file(GLOB found CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${pattern})
        list(APPEND seeds ${found})
      endif()
    endforeach()
    if(EXISTS ${fuzz_dir}/corpus/${name})
      list(APPEND seeds ${fuzz_dir}/corpus/${name})
    endif()
    # As a test of the CPU suites, so that the sanitizers run them too.
    add_test(NAME unit.Fuzz.${name} COMMAND fuzz_replay ${name} ${fuzz_${name}_copies} ${seeds})
    set_tests_properties(unit.Fuzz.${name} PROPERTIES LABELS unit TIMEOUT 300)
  endforeach()
endif()
