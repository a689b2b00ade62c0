# Every library that is not ours, by one name each, whether it comes from Debian or from vcpkg.
find_package(Threads REQUIRED)
find_package(glm REQUIRED)
find_package(nlohmann_json 3.10 REQUIRED)
find_package(assimp REQUIRED)
find_package(OpenAL REQUIRED)
find_package(glfw3 3.3 REQUIRED)
find_package(CLI11 REQUIRED)
find_package(CURL 7.85 REQUIRED)
find_package(PkgConfig)

if(NOT TARGET OpenAL::OpenAL)
  add_library(OpenAL::OpenAL INTERFACE IMPORTED)
  target_include_directories(OpenAL::OpenAL INTERFACE ${OPENAL_INCLUDE_DIR}/..)
  target_link_libraries(OpenAL::OpenAL INTERFACE ${OPENAL_LIBRARY})
endif()

find_package(SndFile CONFIG QUIET)
if(NOT TARGET SndFile::sndfile)
  pkg_check_modules(SNDFILE REQUIRED IMPORTED_TARGET sndfile)
  add_library(SndFile::sndfile ALIAS PkgConfig::SNDFILE)
endif()

# CLI11's headers; an own name because Debian and vcpkg export different targets.
add_library(skydrop_cli11 INTERFACE)
target_link_libraries(skydrop_cli11 INTERFACE CLI11::CLI11)
add_library(skydrop::cli11 ALIAS skydrop_cli11)

# Dear ImGui: vcpkg has a CMake config, Debian a pkg-config file.
find_package(imgui CONFIG QUIET)
add_library(skydrop_imgui INTERFACE)
if(TARGET imgui::imgui)
  target_link_libraries(skydrop_imgui INTERFACE imgui::imgui)
else()
  pkg_check_modules(IMGUI REQUIRED IMPORTED_TARGET imgui)
  target_link_libraries(skydrop_imgui INTERFACE PkgConfig::IMGUI)
  target_include_directories(skydrop_imgui SYSTEM INTERFACE ${IMGUI_INCLUDE_DIRS} ${IMGUI_INCLUDE_DIRS}/backends)
endif()
add_library(skydrop::imgui ALIAS skydrop_imgui)

# stb: headers only; the implementations are compiled in one file each of core.
find_path(STB_INCLUDE_DIR stb_image.h PATH_SUFFIXES stb REQUIRED)
add_library(skydrop_stb INTERFACE)
target_include_directories(skydrop_stb SYSTEM INTERFACE ${STB_INCLUDE_DIR})
add_library(skydrop::stb ALIAS skydrop_stb)

# EGL: headless OpenGL on Linux. OSMesa is loaded at run time, never linked (docs/headless.md).
add_library(skydrop_egl INTERFACE)
find_path(EGL_INCLUDE_DIR EGL/egl.h)
find_library(EGL_LIBRARY EGL)
if(EGL_INCLUDE_DIR AND EGL_LIBRARY)
  target_include_directories(skydrop_egl SYSTEM INTERFACE ${EGL_INCLUDE_DIR})
  target_link_libraries(skydrop_egl INTERFACE ${EGL_LIBRARY})
  target_compile_definitions(skydrop_egl INTERFACE SKYDROP_HAS_EGL=1)
endif()
add_library(skydrop::egl ALIAS skydrop_egl)

if(SKYDROP_TESTS)
  find_package(GTest REQUIRED)
endif()
if(SKYDROP_TESTS AND SKYDROP_BENCHMARKS)
  find_package(benchmark REQUIRED)
endif()
