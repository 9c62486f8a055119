# Finds every library outside the project, under its usual target name, and names the packages that lack.
#
# umbral::embree (3 or 4, says which)  OpenEXR::OpenEXR  OpenImageIO::OpenImageIO  glm::glm  TBB::tbb
# Boost::headers  tomlplusplus::tomlplusplus  pugixml::pugixml  ZLIB::ZLIB  nlohmann_json::nlohmann_json  CLI11::CLI11  fmt::fmt, and with
# the tests GTest::gtest_main and GTest::gmock, with the benchmarks benchmark::benchmark.
set(umbral_missing "")

# Remembers that `what` was not found and which Debian package brings it.
macro(umbral_lacks what package)
  string(APPEND umbral_missing "\n  ${what} was not found: install the Debian package ${package}.")
endmacro()

# Debian's Imath file reports, at length, parts that no one here asks for.
set(umbral_log_level "${CMAKE_MESSAGE_LOG_LEVEL}")
set(CMAKE_MESSAGE_LOG_LEVEL NOTICE)

set(THREADS_PREFER_PTHREAD_FLAG ON)
find_package(Threads QUIET)

find_package(TBB CONFIG QUIET COMPONENTS tbb)
if(NOT TBB_FOUND)
  umbral_lacks("oneTBB" libtbb-dev)
endif()

# Embree's own configuration ends CMake when TBB is absent, so it is not asked then.
if(TBB_FOUND)
  find_package(embree 4 CONFIG QUIET)
  if(NOT embree_FOUND)
    find_package(embree 3.13 CONFIG QUIET)
  endif()
endif()
if(embree_FOUND)
  string(REGEX MATCH "^[0-9]+" umbral_embree_major "${embree_VERSION}")
  add_library(umbral_embree INTERFACE)
  add_library(umbral::embree ALIAS umbral_embree)
  target_link_libraries(umbral_embree INTERFACE embree)
  # The headers live in embree3/ or embree4/, and rtcIntersect1 takes other arguments.
  target_compile_definitions(umbral_embree INTERFACE UMBRAL_EMBREE_MAJOR=${umbral_embree_major})
else()
  umbral_lacks("Embree (3.13 or 4)" libembree-dev)
endif()

find_package(OpenEXR 3.1 CONFIG QUIET)
if(NOT OpenEXR_FOUND)
  umbral_lacks("OpenEXR (3.1 or newer)" libopenexr-dev)
endif()

# OpenImageIO's CMake file, as Debian ships it, refuses to load unless OpenImageIO's command line programs
# are installed too. The library and its headers are all that is needed here.
find_path(OPENIMAGEIO_INCLUDE_DIR OpenImageIO/imageio.h)
find_library(OPENIMAGEIO_LIBRARY OpenImageIO)
find_library(OPENIMAGEIO_UTIL_LIBRARY OpenImageIO_Util)
mark_as_advanced(OPENIMAGEIO_INCLUDE_DIR OPENIMAGEIO_LIBRARY OPENIMAGEIO_UTIL_LIBRARY)
if(OPENIMAGEIO_INCLUDE_DIR AND OPENIMAGEIO_LIBRARY AND OPENIMAGEIO_UTIL_LIBRARY)
  add_library(OpenImageIO::OpenImageIO UNKNOWN IMPORTED)
  set_target_properties(OpenImageIO::OpenImageIO PROPERTIES
    IMPORTED_LOCATION "${OPENIMAGEIO_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${OPENIMAGEIO_INCLUDE_DIR}")
  target_link_libraries(OpenImageIO::OpenImageIO INTERFACE "${OPENIMAGEIO_UTIL_LIBRARY}")
  if(TARGET Imath::Imath)
    target_link_libraries(OpenImageIO::OpenImageIO INTERFACE Imath::Imath)
  endif()
else()
  umbral_lacks("OpenImageIO (2.4 or newer)" libopenimageio-dev)
endif()

find_package(glm CONFIG QUIET)
if(NOT TARGET glm::glm)
  umbral_lacks("GLM" libglm-dev)
endif()

find_package(tomlplusplus 3.3 CONFIG QUIET)
if(NOT tomlplusplus_FOUND)
  umbral_lacks("toml++ (3.3 or newer)" libtomlplusplus-dev)
endif()

find_package(pugixml CONFIG QUIET)
if(NOT pugixml_FOUND)
  umbral_lacks("pugixml" libpugixml-dev)
endif()

find_package(ZLIB QUIET)
if(NOT ZLIB_FOUND)
  umbral_lacks("zlib" zlib1g-dev)
endif()

find_package(nlohmann_json 3.11 CONFIG QUIET)
if(NOT nlohmann_json_FOUND)
  umbral_lacks("nlohmann/json (3.11 or newer)" nlohmann-json3-dev)
endif()

find_package(CLI11 2.1 CONFIG QUIET)
if(NOT CLI11_FOUND)
  umbral_lacks("CLI11 (2.1 or newer)" libcli11-dev)
endif()

find_package(fmt CONFIG QUIET)
if(NOT fmt_FOUND OR fmt_VERSION VERSION_LESS 9)
  umbral_lacks("fmt (9 or newer)" libfmt-dev)
endif()

find_path(BOOST_INCLUDE_DIR boost/math/distributions/students_t.hpp)
mark_as_advanced(BOOST_INCLUDE_DIR)
if(NOT BOOST_INCLUDE_DIR)
  umbral_lacks("Boost.Math" libboost-dev)
elseif(NOT TARGET Boost::headers)
  add_library(Boost::headers INTERFACE IMPORTED)
  set_target_properties(Boost::headers PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${BOOST_INCLUDE_DIR}")
endif()

if(UMBRAL_TESTS)
  find_package(GTest CONFIG QUIET)
  if(NOT GTest_FOUND)
    umbral_lacks("GoogleTest" libgtest-dev)
  elseif(NOT TARGET GTest::gmock)  # a package of its own in Debian
    umbral_lacks("GoogleMock" libgmock-dev)
  endif()
endif()

if(UMBRAL_BENCH)
  find_package(benchmark CONFIG QUIET)
  if(NOT benchmark_FOUND)
    umbral_lacks("Google Benchmark" libbenchmark-dev)
  endif()
endif()

set(CMAKE_MESSAGE_LOG_LEVEL "${umbral_log_level}")

if(umbral_missing)
  message(FATAL_ERROR "umbral cannot be built yet:${umbral_missing}")
endif()

# How GLM is set up, here and nowhere else. Its vectors stay plain structs of floats (no intrinsics, no
# GLM_FORCE_DEFAULT_ALIGNED_GENTYPES): aligned types would pad vec3 to 16 bytes and break the packed vertex
# arrays that Embree reads, while g++ and clang++ at -O3 put the arithmetic of a plain vec4 into one SSE
# register anyway. GLM_FORCE_XYZW_ONLY would take .r .g .b away and yields the same instructions.
#   GLM_FORCE_EXPLICIT_CTOR  double vectors do not turn into float vectors unasked
#   GLM_FORCE_INLINE         a vector operation is never a call, in large functions and sanitizer builds too
target_compile_definitions(glm::glm INTERFACE GLM_FORCE_EXPLICIT_CTOR GLM_FORCE_INLINE)
