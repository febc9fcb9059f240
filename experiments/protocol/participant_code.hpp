// What a participant may be called.
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace impetus::inline protocol {

inline constexpr std::size_t kLongestParticipantCode = 64;  ///< bytes

/// Whether a code can stand on one line, on a screen and in a file's name: 1 to 64 bytes of UTF-8
/// without control characters, characters that turn the direction of writing or have no width, '/',
/// '\' and a space at either end. All else is text and stays text, quotes and markup too.
bool is_participant_code(std::string_view code);

/// Whether a code reads like a person's name: words of letters alone, the first with a capital
/// before small letters. Codes are to say nothing of the person.
[[nodiscard]] bool looks_like_name(std::string_view code);

}  // namespace impetus::inline protocol
