# Writes OUTPUT, a C++ source that defines umbral::assets::IDENTIFIER, declared in HEADER, as the text of INPUT.
file(READ "${INPUT}" text)
string(FIND "${text}" ")embedded\"" clash)
if(NOT clash EQUAL -1)
  message(FATAL_ERROR "${INPUT} holds )embedded\", with which its C++ literal ends")
endif()
file(WRITE "${OUTPUT}" "#include \"${HEADER}\"

namespace umbral::assets {

const std::string_view ${IDENTIFIER} = R\"embedded(${text})embedded\";

}  // namespace umbral::assets
")
