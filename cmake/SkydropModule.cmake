# skydrop_module(NAME LINK <public libraries> PRIVATE <private libraries>)
# A static library from src/NAME/**.cpp with its contract in include/skydrop/NAME.
function(skydrop_module name)
  cmake_parse_arguments(ARG "" "" "LINK;PRIVATE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp)
  if(NOT sources)
    add_library(skydrop_${name} INTERFACE)
    target_include_directories(skydrop_${name} INTERFACE ${PROJECT_SOURCE_DIR}/include)
    target_link_libraries(skydrop_${name} INTERFACE ${ARG_LINK})
  else()
    add_library(skydrop_${name} STATIC ${sources})
    target_include_directories(skydrop_${name}
      PUBLIC ${PROJECT_SOURCE_DIR}/include
      PRIVATE ${PROJECT_SOURCE_DIR}/src)
    target_link_libraries(skydrop_${name} PUBLIC skydrop_flags ${ARG_LINK} PRIVATE ${ARG_PRIVATE})
    skydrop_precompile(skydrop_${name})
  endif()
  add_library(skydrop::${name} ALIAS skydrop_${name})
endfunction()
