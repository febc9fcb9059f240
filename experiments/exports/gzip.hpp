// Bytes as a gzip file: the same bytes give the same file, for it holds no name and no time. And
// their checksum.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace impetus::inline exports {

/// Throws std::runtime_error when there is no memory for it.
std::string gzip(std::string_view bytes);

/// CRC-32 of at most 4 GB: of a picture's red, green and blue, pixel by pixel, as `ffmpeg -pix_fmt
/// rgb24 -f framehash -hash crc32` has it.
std::uint32_t crc32_of(std::span<const std::uint8_t> bytes);

}  // namespace impetus::inline exports
