# Writes a header that holds text files, each with its path below BASE, as an array of constants.
# Usage: cmake -DBASE=... -DINPUTS=a|b|... -DOUTPUT=... -DNAME=kConstant -P embed_files.cmake
string(REPLACE "|" ";" inputs "${INPUTS}")
set(rows "")
foreach(input IN LISTS inputs)
  file(READ "${input}" text)
  file(RELATIVE_PATH name "${BASE}" "${input}")
  string(APPEND rows "    {\"${name}\", R\"embedded(${text})embedded\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "// Made from files under ${BASE} by the build; do not edit.
#pragma once

namespace impetus {

struct EmbeddedFile {
  const char* name;  ///< below the folder that they were in
  const char* text;
};

inline constexpr EmbeddedFile ${NAME}[] = {
${rows}};

}  // namespace impetus
")
