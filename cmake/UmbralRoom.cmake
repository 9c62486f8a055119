# Defines umbral_room(): one library for one folder of src/.
#
#   umbral_room(image
#     SOURCES film.cpp exr.cpp
#     DEPENDS umbral::core              # in the public headers
#     PRIVATE OpenEXR::OpenEXR)         # in the .cpp files only
#
# makes the target umbral_image with the alias umbral::image. Headers are included from the root of src/.
# A room links with its DEPENDS alone, so a call against the arrows does not link: at once with
# -DBUILD_SHARED_LIBS=ON (preset "debug"), where every room must resolve all its symbols, and otherwise in
# that room's tests. tests/architecture names the offending include.
function(umbral_room name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;DEPENDS;PRIVATE")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "umbral_room(${name}): unknown arguments: ${arg_UNPARSED_ARGUMENTS}")
  endif()
  set(target umbral_${name})
  set(scope PUBLIC)
  if(arg_SOURCES)
    add_library(${target} ${arg_SOURCES})
    target_compile_options(${target} PRIVATE ${umbral_warnings})
    target_link_libraries(${target} PRIVATE ${arg_PRIVATE})
    if(BUILD_SHARED_LIBS AND NOT UMBRAL_SANITIZE)
      target_link_options(${target} PRIVATE LINKER:-z,defs)
    endif()
  else()
    set(scope INTERFACE)
    add_library(${target} INTERFACE)
  endif()
  add_library(umbral::${name} ALIAS ${target})
  target_include_directories(${target} ${scope} "${PROJECT_SOURCE_DIR}/src")
  target_link_libraries(${target} ${scope} ${arg_DEPENDS} umbral::version fmt::fmt)
endfunction()
