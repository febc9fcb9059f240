// SPDX-License-Identifier: MIT
#include "experiments/protocol/participant_code.hpp"

#include <algorithm>

#include "experiments/tables/plain_text.hpp"

namespace impetus::inline protocol {
namespace {

bool is_control(std::uint32_t code) { return code < 0x20 || (code >= 0x7F && code <= 0x9F); }

/// Zero-width characters, marks and overrides of direction, separators of lines, the byte order
/// mark: with them two codes look alike, or a line is not what it seems.
bool is_unseen(std::uint32_t code) {
  return (code >= 0x200B && code <= 0x200F) || (code >= 0x2028 && code <= 0x202E) ||
         (code >= 0x2060 && code <= 0x206F) || code == 0x061C || code == 0xFEFF;
}

}  // namespace

bool is_participant_code(std::string_view code) {
  if (code.empty() || code.size() > kLongestParticipantCode || code.front() == ' ' ||
      code.back() == ' ') {
    return false;
  }
  while (!code.empty()) {
    const auto point = first_code_point(code);
    if (!point || is_control(point->value) || is_unseen(point->value) || point->value == '/' ||
        point->value == '\\') {
      return false;
    }
    code.remove_prefix(point->bytes);
  }
  return true;
}

bool looks_like_name(std::string_view code) {
  const auto is_capital = [](char letter) { return letter >= 'A' && letter <= 'Z'; };
  const auto is_small = [](char letter) {  // or of a letter beyond ASCII
    return (letter >= 'a' && letter <= 'z') || static_cast<unsigned char>(letter) >= 0x80;
  };
  const auto may_stand_in_name = [&](char letter) {
    return is_capital(letter) || is_small(letter) || letter == ' ' || letter == '.' ||
           letter == '-' || letter == '\'';
  };
  constexpr std::size_t kShortest = 3;
  return code.size() >= kShortest && is_capital(code[0]) && is_small(code[1]) &&
         is_small(code[2]) && std::all_of(code.begin(), code.end(), may_stand_in_name);
}

}  // namespace impetus::inline protocol
