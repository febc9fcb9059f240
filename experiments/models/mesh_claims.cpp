// SPDX-License-Identifier: MIT
#include "experiments/models/mesh_claims.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <string>
#include <string_view>

#include "experiments/models/gltf_claims.hpp"
#include "experiments/models/ply_claims.hpp"
#include "experiments/models/readable_file.hpp"
#include "experiments/models/text_words.hpp"

namespace impetus::inline models {
namespace {

/// assimp reads an OFF file into lines of this many letters, and beyond the end of a longer one.
constexpr std::size_t kLongestOffLine = 4095;

std::string lower_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension;
}

std::string line_problem(std::string_view text) {
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t length = take_line(text).size();
    if (length > kLongestOffLine) {
      return "its line " + std::to_string(number) + " has " + std::to_string(length) +
             " letters, more than the " + std::to_string(kLongestOffLine) + " that are read";
    }
  }
  return "";
}

/// The first two numbers are those of vertices and faces, on the line of "OFF" or after it.
std::string off_problem(std::string_view text) {
  std::string_view rest = text;
  int numbers = 0;
  for (std::string_view line = take_line(rest); numbers < 2; line = take_line(rest)) {
    line = line.substr(0, line.find('#'));
    for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
      const auto count = whole_number(word);
      if (count && ++numbers <= 2 && *count > text.size()) {
        return "it claims " + std::string(word) + (numbers == 1 ? " vertices" : " faces") +
               ", but has " + std::to_string(text.size()) + " bytes";
      }
    }
    if (rest.empty()) {
      break;
    }
  }
  return line_problem(text);
}

std::string claims_problem(const std::filesystem::path& file) {
  const std::string bytes = file_bytes(file);
  const std::string extension = lower_extension(file);
  if (bytes.starts_with("ply")) {
    return ply_problem(bytes);
  }
  if (extension == ".off") {
    return off_problem(bytes);
  }
  if (extension == ".gltf" || extension == ".glb" || bytes.starts_with("glTF")) {
    return gltf_problem(bytes, file.parent_path());
  }
  return "";
}

}  // namespace

void refuse_false_claims(const std::filesystem::path& file) {
  const std::string problem = claims_problem(file);
  if (!problem.empty()) {
    throw std::runtime_error(file.string() + ": cannot be read as a mesh: " + problem);
  }
}

}  // namespace impetus::inline models
