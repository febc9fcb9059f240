// Numbers as text, the same on every machine and in every library: never by the user's locale.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace impetus::inline tables {

/// The shortest text from which the same double is read back; "inf", "nan".
std::string exact_number(double value);

/// With at most so many significant digits, up to 17.
std::string rounded_number(double value, int digits);

/// "1 trial", "12 trials"; `many`: where it is not `one` and an s.
std::string count_of(std::int64_t count, const std::string& one, const std::string& many = "");

/// What std::printf would print, however long.
std::string printed(const char* format, ...) __attribute__((format(printf, 1, 2)));

/// What exact_number() does without the standard library's own function for it, which the one of
/// browsers lacks: the fewest digits that are read back, as decimals or with an exponent, whichever
/// is shorter.
std::string exact_number_by_trial(double value);

}  // namespace impetus::inline tables
