// SPDX-License-Identifier: MIT
#include "experiments/protocol/participant_code.hpp"

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

}  // namespace impetus::inline protocol
