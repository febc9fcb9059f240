# Writes a header that names this build, only when it changed.
execute_process(COMMAND git -C "${SOURCE}" describe --always --dirty --abbrev=12
                OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT commit)
  set(commit "unknown commit")
endif()
string(REGEX REPLACE " +" " " flags "${FLAGS}")
string(STRIP "${flags}" flags)
set(text "// Made by the build; do not edit.
#define IMPETUS_VERSION \"${VERSION}\"
#define IMPETUS_COMMIT \"${commit}\"
#define IMPETUS_COMPILER \"${COMPILER}\"
#define IMPETUS_FLAGS \"${flags}\"
")
set(before "")
if(EXISTS "${OUTPUT}")
  file(READ "${OUTPUT}" before)
endif()
if(NOT before STREQUAL text)
  file(WRITE "${OUTPUT}" "${text}")
endif()
