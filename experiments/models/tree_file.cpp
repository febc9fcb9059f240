// SPDX-License-Identifier: MIT
#include "experiments/models/tree_file.hpp"

#include <stdexcept>
#include <utility>

#include "experiments/models/atomic_file.hpp"
#include "experiments/models/mesh_bytes.hpp"
#include "experiments/models/readable_file.hpp"
#include "experiments/models/tree_arrays.hpp"
#include "experiments/models/tree_header.hpp"

namespace impetus::inline models {
namespace {

constexpr std::string_view kMagic = "impetree";
constexpr std::size_t kChecksumLetters = 32;

[[noreturn]] void refuse(const std::string& name, const std::string& problem) {
  throw std::runtime_error(name + ": " + problem);
}

/// The bytes before the checksum, which is right.
std::string_view unsealed(std::string_view bytes, const std::string& name) {
  if (bytes.size() < kChecksumLetters) {
    refuse(name, "expected a checksum at the end, got " + std::to_string(bytes.size()) +
                     " bytes: the file is cut short");
  }
  const std::string_view content = bytes.substr(0, bytes.size() - kChecksumLetters);
  const std::string_view stored = bytes.substr(content.size());
  const std::string computed = content_hash(content);
  if (stored != computed) {
    refuse(name, "expected the checksum " + computed +
                     " at the end, got another: the file is damaged or cut short");
  }
  return content;
}

StoredTree parsed(ByteReader& bytes) {
  const auto length = bytes.take<std::uint64_t>();
  TreeHeader header = tree_header_from(bytes.take_bytes(length));
  VolumeTree tree = take_tree(bytes, header);
  TriangleMesh mesh = take_mesh(bytes, header.mesh);
  if (bytes.left() > 0) {
    throw std::runtime_error("expected the mesh to end the file, got " +
                             std::to_string(bytes.left()) + " bytes more");
  }
  const std::string hash = content_hash(mesh);
  if (hash != header.mesh_hash) {
    throw std::runtime_error("expected the mesh with the hash that the header names, got " + hash);
  }
  return {std::move(header.name), header.settings,           std::move(mesh),
          std::move(tree),        std::move(header.quality), header.builder_version};
}

}  // namespace

std::string sealed(std::string content) {
  content += content_hash(content);
  return content;
}

std::string bytes_of(const StoredTree& stored) {
  const std::string header = text_of(header_of(stored));
  std::string bytes(kMagic);
  append_number(bytes, kTreeFileFormat);
  append_number(bytes, static_cast<std::uint64_t>(header.size()));
  bytes += header;
  append_tree(bytes, stored.tree);
  append_mesh(bytes, stored.mesh);
  return sealed(std::move(bytes));
}

StoredTree stored_tree_from(std::string_view bytes, const std::string& name) {
  if (bytes.substr(0, kMagic.size()) != kMagic) {
    refuse(name, "expected a tree file, which begins with \"impetree\", got another kind of file");
  }
  ByteReader reader(bytes.substr(kMagic.size()));
  try {
    const auto format = reader.take<std::uint32_t>();
    if (format != kTreeFileFormat) {
      throw std::runtime_error("expected a tree file of format " + std::to_string(kTreeFileFormat) +
                               ", got format " + std::to_string(format));
    }
  } catch (const std::exception& error) {
    refuse(name, error.what());
  }
  const std::string_view content = unsealed(bytes, name);
  try {
    ByteReader body(content);
    body.take_bytes(kMagic.size() + sizeof kTreeFileFormat);
    return parsed(body);
  } catch (const std::exception& error) {
    refuse(name, error.what());
  }
}

void save_tree(const StoredTree& stored, const std::filesystem::path& file, bool replace) {
  if (!replace && std::filesystem::exists(file)) {
    refuse(file.string(), "exists already and is not overwritten");
  }
  const std::string bytes = bytes_of(stored);
  stored_tree_from(bytes, file.string());
  write_whole_file(file, bytes);
}

StoredTree load_tree(const std::filesystem::path& file) {
  std::string bytes;
  try {
    bytes = file_bytes(file);
  } catch (const std::exception& error) {
    refuse(file.string(), error.what());
  }
  return stored_tree_from(bytes, file.string());
}

}  // namespace impetus::inline models
