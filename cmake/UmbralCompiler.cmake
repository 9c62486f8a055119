# Sets language level, optimisation, warnings and sanitizers for everything below.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# The compilers of Debian 12; older ones lack parts of C++20 that are used throughout.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(umbral_oldest_compiler 12)
elseif(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  set(umbral_oldest_compiler 14)
else()
  set(umbral_oldest_compiler 0)
endif()
if(CMAKE_CXX_COMPILER_VERSION VERSION_LESS umbral_oldest_compiler)
  message(FATAL_ERROR "umbral needs g++ 12 or clang++ 14 or newer; "
                      "${CMAKE_CXX_COMPILER} is ${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}.")
endif()

# -g1 keeps function names and line tables for profilers at little cost in size and time.
# Never -ffast-math: rejected samples are found by NaN and infinity checks, which it removes.
# The two flags below change no result; they drop errno and floating-point traps, which nothing here reads,
# and let the compiler vectorise branches and inline sqrt. Contraction (FMA) stays at the compiler's
# default: the same binary gives the same bits for any number of threads either way.
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG -g1")
add_compile_options(-fno-math-errno -fno-trapping-math)

set(umbral_march "${UMBRAL_MARCH}")
if(umbral_march STREQUAL "x86-64-v3" AND NOT CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
  set(umbral_march portable)
endif()
if(NOT umbral_march STREQUAL "portable")
  add_compile_options(-march=${umbral_march})
endif()

# Link-time optimisation is off: it multiplies the build time, and the hot loops live in headers.

set(umbral_warnings -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # g++ 12 warns of "literal" + std::string (GCC bug 105651).
  list(APPEND umbral_warnings -Wno-restrict)
endif()
if(UMBRAL_WERROR)
  list(APPEND umbral_warnings -Werror)
endif()

if(UMBRAL_SANITIZE)
  add_compile_options(-fsanitize=${UMBRAL_SANITIZE} -fno-omit-frame-pointer)
  if(UMBRAL_SANITIZE MATCHES "undefined")
    add_compile_options(-fno-sanitize-recover=undefined)
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # g++ sees uninitialised values in the code that it instruments itself, as in <regex>.
    list(APPEND umbral_warnings -Wno-maybe-uninitialized)
  endif()
  add_link_options(-fsanitize=${UMBRAL_SANITIZE})
endif()

if(CMAKE_GENERATOR STREQUAL "Ninja")
  add_compile_options(-fdiagnostics-color=auto)
endif()
