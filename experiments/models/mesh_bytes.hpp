// Numbers and meshes as little-endian bytes, the same on every machine, and the name of a content.
//
//   vertices (x y z, double) ... triangles (a b c, unsigned 32 bits) ...    all little-endian
//
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include "engine/numerics/bits.hpp"
#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline models {

/// The unsigned whole number with the bits of a number of type T.
template <typename T>
using BitsOf = std::conditional_t<sizeof(T) == 1, std::uint8_t,
                                  std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>;

template <typename T>
void append_number(std::string& bytes, T number) {
  static_assert(sizeof(T) == 1 || sizeof(T) == 4 || sizeof(T) == 8);
  const auto bits = bit_cast<BitsOf<T>>(number);
  for (std::size_t byte = 0; byte < sizeof(T); ++byte) {
    bytes.push_back(static_cast<char>(static_cast<unsigned char>(bits >> (8 * byte))));
  }
}

/// Takes numbers from the front of bytes that it does not own.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  /// Throws std::out_of_range when fewer bytes are left.
  std::string_view take_bytes(std::size_t count) {
    if (count > rest_.size()) {
      throw std::out_of_range("expected " + std::to_string(count) + " bytes more, got " +
                              std::to_string(rest_.size()));
    }
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }

  template <typename T>
  T take() {
    const std::string_view bytes = take_bytes(sizeof(T));
    BitsOf<T> bits = 0;
    for (std::size_t byte = sizeof(T); byte-- > 0;) {
      bits = static_cast<BitsOf<T>>(static_cast<std::uint64_t>(bits) << 8U |
                                    static_cast<unsigned char>(bytes[byte]));
    }
    return bit_cast<T>(bits);
  }

  [[nodiscard]] std::size_t left() const { return rest_.size(); }

 private:
  std::string_view rest_;
};

/// How many of both a mesh has.
struct MeshCounts {
  std::uint64_t vertices{0};
  std::uint64_t triangles{0};
};

void append_mesh(std::string& bytes, const TriangleMesh& mesh);

/// Throws std::out_of_range when bytes are missing, std::runtime_error (expected ..., got ...) when
/// a coordinate is not finite or a triangle names a vertex that is not there.
TriangleMesh take_mesh(ByteReader& bytes, const MeshCounts& counts);

/// 32 hexadecimal digits (XXH3, 128 bits): equal content, equal name.
std::string content_hash(std::string_view bytes);

/// Of the counts and the bytes of append_mesh().
std::string content_hash(const TriangleMesh& mesh);

}  // namespace impetus::inline models
