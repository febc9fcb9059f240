# Writes a header that holds a text file as a string constant.
# Usage: cmake -DINPUT=... -DOUTPUT=... -DNAME=kConstant -P embed_text.cmake
file(READ "${INPUT}" text)
get_filename_component(source "${INPUT}" NAME)
file(WRITE "${OUTPUT}" "// Made from ${source} by the build; do not edit.
#pragma once

namespace impetus {

inline constexpr char ${NAME}[] = R\"embedded(${text})embedded\";

}  // namespace impetus
")
