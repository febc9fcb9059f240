// SPDX-License-Identifier: MIT
#include "experiments/exports/gzip.hpp"

#define ZLIB_CONST  // what is read is not changed
#include <zlib.h>

#include <algorithm>
#include <stdexcept>

namespace impetus::inline exports {

std::string gzip(std::string_view bytes) {
  constexpr int kGzipWindow = 15 + 16;  // 16: a gzip header, which zlib leaves without a time
  constexpr int kMemoryLevel = 8;
  constexpr std::size_t kMost = 1U << 30U;  // zlib counts in 32 bits
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kGzipWindow, kMemoryLevel,
                   Z_DEFAULT_STRATEGY) != Z_OK) {
    throw std::runtime_error("gzip: there is no memory for it");
  }
  std::string result;
  std::string part(1U << 16U, '\0');
  int state = Z_OK;
  while (state != Z_STREAM_END) {
    if (stream.avail_in == 0) {
      const std::string_view next = bytes.substr(0, std::min(bytes.size(), kMost));
      stream.next_in = reinterpret_cast<const Bytef*>(next.data());
      stream.avail_in = static_cast<uInt>(next.size());
      bytes.remove_prefix(next.size());
    }
    stream.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.avail_out = static_cast<uInt>(part.size());
    state = deflate(&stream, bytes.empty() ? Z_FINISH : Z_NO_FLUSH);
    result.append(part, 0, part.size() - stream.avail_out);
  }
  deflateEnd(&stream);
  return result;
}

std::uint32_t crc32_of(std::span<const std::uint8_t> bytes) {
  return static_cast<std::uint32_t>(::crc32(0, bytes.data(), static_cast<uInt>(bytes.size())));
}

}  // namespace impetus::inline exports
