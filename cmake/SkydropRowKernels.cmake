# Sources that are compiled once for each instruction set: STEM.inl through its four STEM_*.cpp. Results are the same
# bits (hard case T24), so the program picks the widest at run time; STEM.cpp has the table.
# Optimised in every build type: unoptimised, a debug build could not fly. For the same reason sanitizers watch the
# baseline only; the wide sets are the same source.
function(skydrop_row_kernels stem)
  set(kernels ${PROJECT_SOURCE_DIR}/${stem})
  if(MSVC)
    set(flags_sse41 "")
    set(flags_avx2 /arch:AVX2)
    set(flags_avx512 /arch:AVX512)
  else()
    set(flags_sse41 -O3 -fno-sanitize=all -msse4.1)
    set(flags_avx2 -O3 -fno-sanitize=all -mavx2)
    set(flags_avx512 -O3 -fno-sanitize=all -mavx512f -mavx512vl -mavx512dq -mavx512bw -mprefer-vector-width=512)
    set_source_files_properties(${kernels}_baseline.cpp PROPERTIES COMPILE_OPTIONS -O3 SKIP_PRECOMPILE_HEADERS ON)
  endif()
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
    foreach(isa sse41 avx2 avx512)
      set_source_files_properties(${kernels}_${isa}.cpp PROPERTIES
        COMPILE_OPTIONS "${flags_${isa}}" COMPILE_DEFINITIONS SKYDROP_BUILD_ROW_KERNELS
        SKIP_PRECOMPILE_HEADERS ON)  # those hold the flags of all other files
    endforeach()
    set_source_files_properties(${kernels}.cpp PROPERTIES COMPILE_DEFINITIONS SKYDROP_WIDE_ROW_KERNELS)
  endif()
endfunction()

skydrop_row_kernels(src/terrain/row_kernels)
skydrop_row_kernels(src/noise/octave_kernels)
skydrop_row_kernels(src/elevation/surface_kernels)
