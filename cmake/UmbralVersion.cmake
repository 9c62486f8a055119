# Defines umbral::version, a library whose one string is brought up to date by every build.
#
# Only the generated umbral_version.cpp changes with a commit, so that a commit costs one small compilation
# and a link. Without git, or unpacked from an archive, the version is that of project() alone.
find_package(Git QUIET)
set(umbral_version_source "${PROJECT_BINARY_DIR}/version/umbral_version.cpp")
set(umbral_version_command
    ${CMAKE_COMMAND}
    "-DGIT=${GIT_EXECUTABLE}"
    "-DSOURCE_DIR=${PROJECT_SOURCE_DIR}"
    "-DVERSION=${PROJECT_VERSION}"
    "-DTEMPLATE=${PROJECT_SOURCE_DIR}/cmake/version/umbral_version.cpp.in"
    "-DOUTPUT=${umbral_version_source}"
    -P "${PROJECT_SOURCE_DIR}/cmake/version/write_version.cmake")
execute_process(COMMAND ${umbral_version_command} COMMAND_ERROR_IS_FATAL ANY)
add_custom_target(umbral_version_source
  COMMAND ${umbral_version_command}
  BYPRODUCTS "${umbral_version_source}"
  COMMENT "Looking at the version"
  VERBATIM)

add_library(umbral_version "${umbral_version_source}")
add_library(umbral::version ALIAS umbral_version)
add_dependencies(umbral_version umbral_version_source)
target_include_directories(umbral_version PUBLIC "${PROJECT_SOURCE_DIR}/cmake/version")
