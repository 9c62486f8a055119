# Writes OUTPUT: the integrator of HEADER and SOURCE with the mistakes of the file EDITS, as class Path_NAME and the
# function make_NAME() declared in mutants.h.
#
# EDITS holds pairs of lines "-old" and "+new". Each old text must occur exactly once, so that a mutation that no
# longer fits its original is an error and not a silent copy of the original.
cmake_minimum_required(VERSION 3.22)

file(READ "${HEADER}" header)
file(READ "${SOURCE}" body)
file(READ "${EDITS}" edits)

function(replace_once old new)
  string(STRIP "${old}" old)
  string(STRIP "${new}" new)
  string(FIND "${body}" "${old}" first)
  string(FIND "${body}" "${old}" last REVERSE)
  if(first EQUAL -1 OR NOT first EQUAL last)
    message(FATAL_ERROR "${EDITS}: '${old}' must occur exactly once in ${SOURCE}: make the mutation anew")
  endif()
  string(REPLACE "${old}" "${new}" replaced "${body}")
  set(body "${replaced}" PARENT_SCOPE)
endfunction()

while(edits MATCHES "\n-([^\n]*)\n[+]([^\n]*)(.*)$")
  set(old "${CMAKE_MATCH_1}")
  set(new "${CMAKE_MATCH_2}")
  set(edits "${CMAKE_MATCH_3}")
  replace_once("${old}" "${new}")
endwhile()

string(REPLACE "#pragma once" "" header "${header}")
string(REPLACE "#include \"integrators/path.h\"" "" body "${body}")
set(text "#include \"mutations/mutants.h\"\n${header}\n${body}
namespace umbral::test {
std::unique_ptr<Integrator> make_${NAME}(int max_depth, int roulette_depth) {
  auto path = std::make_unique<PathIntegrator>();
  path->max_depth = max_depth;
  path->roulette_depth = roulette_depth;
  return path;
}
}  // namespace umbral::test
")
string(REPLACE "PathIntegrator" "Path_${NAME}" text "${text}")
file(WRITE "${OUTPUT}" "${text}")
