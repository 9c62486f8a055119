# Writes OUTPUT from TEMPLATE with VERSION and the state of the git tree in SOURCE_DIR, if it changed.
set(UMBRAL_FULL_VERSION "${VERSION}")
if(GIT AND EXISTS "${SOURCE_DIR}/.git")
  execute_process(
    COMMAND "${GIT}" describe --always --dirty --tags --abbrev=10
    WORKING_DIRECTORY "${SOURCE_DIR}"
    RESULT_VARIABLE status
    OUTPUT_VARIABLE description
    ERROR_QUIET
    OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(status EQUAL 0 AND description)
    string(APPEND UMBRAL_FULL_VERSION "+${description}")
  endif()
endif()
configure_file("${TEMPLATE}" "${OUTPUT}" @ONLY)
