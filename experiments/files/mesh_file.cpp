// SPDX-License-Identifier: MIT
#include "experiments/files/mesh_file.hpp"

#include <assimp/DefaultIOSystem.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <array>
#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <new>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "experiments/files/child_process.hpp"
#include "experiments/files/mesh_claims.hpp"
#include "experiments/models/mesh_bytes.hpp"
#include "experiments/models/readable_file.hpp"

namespace impetus::inline files {
namespace {

// ---------------------------------------------------------------- assimp, and what it may not do

/// What assimp may open while it reads a mesh: the file, and files that lie in its folder. An OBJ
/// or a glTF file names others by path; one from elsewhere could name any of the user's.
class ConfinedFiles : public Assimp::DefaultIOSystem {
 public:
  explicit ConfinedFiles(const std::filesystem::path& file) : file_(file) {}

  /// What lies elsewhere, or is no regular file, does not exist, and is not opened.
  bool Exists(const char* name) const override { return may_open(path_of(name)); }

  Assimp::IOStream* Open(const char* name, const char* mode) override {
    const std::string path = path_of(name);
    return may_open(path) ? Assimp::DefaultIOSystem::Open(path.c_str(), mode) : nullptr;
  }

 private:
  /// glTF names files by URI.
  static std::string path_of(const std::string& name) {
    return is_there(name) ? name : decoded_uri(name);
  }

  [[nodiscard]] bool may_open(const std::filesystem::path& name) const {
    const std::filesystem::path folder = file_.has_parent_path() ? file_.parent_path() : ".";
    return (name == file_ || is_really_within(name, folder)) && reading_problem(name).empty();
  }

  std::filesystem::path file_;
};

[[noreturn]] void refuse_mesh(const std::filesystem::path& file, const std::string& problem) {
  throw std::runtime_error(file.string() + ": " + problem);
}

/// Errors of assimp's OBJ reader about what is dropped here: materials and the names of groups.
bool is_harmless(const std::string& error) {
  return error.find("material") != std::string::npos ||
         error.find("No object detected to attach a new mesh") != std::string::npos;
}

/// The errors that assimp logs and then repairs in its own way: its OFF reader, for one, replaces
/// an index out of range by another vertex.
class ErrorLog {
 public:
  ErrorLog() {
    Assimp::DefaultLogger::create(nullptr, Assimp::Logger::NORMAL, 0);
    Assimp::DefaultLogger::get()->attachStream(new Line(first_), Assimp::Logger::Err);
  }
  ~ErrorLog() { Assimp::DefaultLogger::kill(); }
  ErrorLog(const ErrorLog&) = delete;
  ErrorLog& operator=(const ErrorLog&) = delete;

  /// The first error, or nothing.
  [[nodiscard]] const std::string& first() const { return first_; }

 private:
  /// Keeps the first error that is written to it; owned by the logger.
  class Line final : public Assimp::LogStream {
   public:
    explicit Line(std::string& first) : first_(&first) {}
    void write(const char* message) override {
      const std::string text = message;
      if (first_->empty() && !is_harmless(text)) {
        *first_ = text;
        first_->erase(first_->find_last_not_of('\n') + 1);
      }
    }

   private:
    std::string* first_;
  };
  std::string first_;
};

/// Cutting a face into triangles takes as long as the square of its corners: of these, a second.
constexpr unsigned int kMostFaceCorners = 10'000;

/// Places with a coordinate that is not finite; a place that assimp repeats, bit by bit, counts
/// once.
std::size_t count_not_finite(const aiMesh& part) {
  std::set<std::array<std::uint32_t, 3>> places;
  for (unsigned int i = 0; i < part.mNumVertices; ++i) {
    const aiVector3D& place = part.mVertices[i];
    if (!std::isfinite(place.x) || !std::isfinite(place.y) || !std::isfinite(place.z)) {
      places.insert({std::bit_cast<std::uint32_t>(place.x), std::bit_cast<std::uint32_t>(place.y),
                     std::bit_cast<std::uint32_t>(place.z)});
    }
  }
  return places.size();
}

/// Checks what assimp's own steps take for granted; returns whether a face has over three corners.
bool check(const aiMesh& part, const std::filesystem::path& file) {
  const std::size_t bad = count_not_finite(part);
  if (bad > 0) {
    refuse_mesh(file, std::to_string(bad) + (bad == 1 ? " vertex has" : " vertices have") +
                          " a coordinate that is not a finite number");
  }
  bool has_polygons = false;
  for (unsigned int i = 0; i < part.mNumFaces; ++i) {
    const aiFace& face = part.mFaces[i];
    if (face.mNumIndices == 0) {
      refuse_mesh(file, "a face has no vertices: the file may be cut short");
    }
    for (unsigned int corner = 0; corner < face.mNumIndices; ++corner) {
      if (face.mIndices[corner] >= part.mNumVertices) {
        refuse_mesh(file, "a face names vertex " + std::to_string(face.mIndices[corner]) + " of " +
                              std::to_string(part.mNumVertices));
      }
    }
    if (face.mNumIndices > kMostFaceCorners) {
      refuse_mesh(file, "a face has " + std::to_string(face.mNumIndices) +
                            " corners, more than the " + std::to_string(kMostFaceCorners) +
                            " that are cut into triangles");
    }
    has_polygons = has_polygons || face.mNumIndices > 3;
  }
  return has_polygons;
}

/// Collects placed triangles; equal positions share a vertex.
class Welder {
 public:
  void add(const aiMesh& part, const aiMatrix4x4& placement) {
    const bool mirrored = placement.Determinant() < 0.0F;
    for (unsigned int i = 0; i < part.mNumFaces; ++i) {
      const aiFace& face = part.mFaces[i];
      if (face.mNumIndices != 3) {
        continue;  // points and lines have no surface
      }
      std::array<std::uint32_t, 3> triangle{};
      for (unsigned int corner = 0; corner < 3; ++corner) {
        triangle[corner] = vertex(placement * part.mVertices[face.mIndices[corner]]);
      }
      if (mirrored) {
        std::swap(triangle[1], triangle[2]);
      }
      mesh_.triangles.push_back(triangle);
    }
  }

  TriangleMesh take() { return std::move(mesh_); }

 private:
  std::uint32_t vertex(const aiVector3D& place) {
    // Adding +0 makes both zeros the same place.
    const std::array<double, 3> key{place.x + 0.0, place.y + 0.0, place.z + 0.0};
    const auto next = static_cast<std::uint32_t>(mesh_.vertices.size());
    const auto [entry, is_new] = index_of_.try_emplace(key, next);
    if (is_new) {
      mesh_.vertices.emplace_back(key[0], key[1], key[2]);
    }
    return entry->second;
  }

  TriangleMesh mesh_;
  std::map<std::array<double, 3>, std::uint32_t> index_of_;
};

void add_node(const aiScene& scene, const aiNode& node, const aiMatrix4x4& above, Welder& welder) {
  const aiMatrix4x4 placement = above * node.mTransformation;
  for (unsigned int i = 0; i < node.mNumMeshes; ++i) {
    welder.add(*scene.mMeshes[node.mMeshes[i]], placement);
  }
  for (unsigned int i = 0; i < node.mNumChildren; ++i) {
    add_node(scene, *node.mChildren[i], placement, welder);
  }
}

/// What assimp reads beside is not promised, and nobody asked what its files could do.
void keep_promised_readers(Assimp::Importer& importer) {
  const std::set<std::string> promised{"obj", "ply", "stl", "off", "gltf", "glb"};
  for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
    std::istringstream extensions(importer.GetImporterInfo(i)->mFileExtensions);
    bool keep = false;
    for (std::string word; extensions >> word;) {
      keep = keep || promised.contains(word);
    }
    if (Assimp::BaseImporter* reader = importer.GetImporter(i); !keep) {
      importer.UnregisterLoader(reader);
    }
  }
}

/// A binary PLY file whose body begins as a line ends, which assimp would pass over behind a header
/// without carriage returns (it begins so where the first number is 0.02 or 0.64): with another
/// before it, which is passed over. "": any other file.
std::string ply_with_its_first_byte(const std::filesystem::path& file) {
  std::string bytes = file_bytes(file);
  const std::size_t end = bytes.starts_with("ply") ? bytes.find("end_header") : std::string::npos;
  const std::size_t body = end == std::string::npos ? end : bytes.find('\n', end);
  if (body == std::string::npos || body + 1 >= bytes.size() || bytes[body + 1] != '\n' ||
      bytes[body - 1] == '\r' || bytes.substr(0, end).find("format binary") == std::string::npos) {
    return "";
  }
  return bytes.insert(body + 1, 1, '\n');
}

/// What load_mesh() does beyond keeping itself safe. Precondition: `file` is a file.
TriangleMesh parse_mesh(const std::filesystem::path& file) {
  refuse_false_claims(file);
  const ErrorLog errors;
  Assimp::Importer importer;
  keep_promised_readers(importer);
  importer.SetIOHandler(new ConfinedFiles(file));  // the importer's from now on
  const std::string ply = ply_with_its_first_byte(file);
  const aiScene* scene = ply.empty()
                             ? importer.ReadFile(file.string(), 0)
                             : importer.ReadFileFromMemory(ply.data(), ply.size(), 0, "ply");
  if (scene == nullptr) {
    const std::string error = importer.GetErrorString();
    if (error.find("bad_alloc") != std::string::npos) {
      throw std::bad_alloc();
    }
    refuse_mesh(file, "cannot be read as a mesh: " + error);
  }
  if (!errors.first().empty()) {
    refuse_mesh(file, "cannot be read as a mesh: " + errors.first());
  }
  bool has_polygons = false;
  for (unsigned int i = 0; i < scene->mNumMeshes; ++i) {
    has_polygons = check(*scene->mMeshes[i], file) || has_polygons;
  }
  if (has_polygons) {
    scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
  }
  Welder welder;
  add_node(*scene, *scene->mRootNode, aiMatrix4x4(), welder);
  TriangleMesh mesh = welder.take();
  if (mesh.triangles.empty()) {
    refuse_mesh(file, "has no triangles");
  }
  return mesh;
}

// ---------------------------------------------------------------- in a process of its own

/// What the largest sensible file of this size could take.
ChildLimits limits_of(const std::filesystem::path& file) {
  constexpr std::uint64_t kLeastS = 10;
  constexpr std::uint64_t kLeastBytesPerS = 1'000'000;
  constexpr std::uint64_t kLeastBytes = 2'000'000'000;
  constexpr std::uint64_t kMostBytesPerByte = 30;
  const std::uint64_t size = std::filesystem::file_size(file);
  return {static_cast<int>(kLeastS + size / kLeastBytesPerS),
          kLeastBytes + size * kMostBytesPerByte};
}

/// What came of the reader.
enum class Outcome : std::uint8_t { kMesh, kRefused };

std::string refused(const std::string& sentence) {
  std::string bytes;
  append_number(bytes, static_cast<std::uint8_t>(Outcome::kRefused));
  return bytes + sentence;
}

/// The outcome, then the mesh or the sentence.
std::string parsed(const std::filesystem::path& file) {
  std::string bytes;
  try {
    const TriangleMesh mesh = parse_mesh(file);
    append_number(bytes, static_cast<std::uint8_t>(Outcome::kMesh));
    append_number(bytes, static_cast<std::uint64_t>(mesh.vertices.size()));
    append_number(bytes, static_cast<std::uint64_t>(mesh.triangles.size()));
    append_mesh(bytes, mesh);
  } catch (const std::bad_alloc&) {
    bytes = refused(file.string() +
                    ": cannot be read as a mesh: it needs more memory than a mesh of its size");
  } catch (const std::exception& error) {
    bytes = refused(error.what());
  }
  return bytes;
}

}  // namespace

TriangleMesh load_mesh(const std::filesystem::path& file) {
  if (const std::string problem = reading_problem(file); !problem.empty()) {
    refuse_mesh(file, problem);
  }
  const auto bytes = done_by_child([&] { return parsed(file); }, limits_of(file));
  if (!bytes || bytes->empty()) {
    refuse_mesh(file, "cannot be read as a mesh: its reader broke down over it");
  }
  ByteReader reader(*bytes);
  if (reader.take<std::uint8_t>() == static_cast<std::uint8_t>(Outcome::kRefused)) {
    throw std::runtime_error(std::string(reader.take_bytes(reader.left())));
  }
  const auto vertices = reader.take<std::uint64_t>();
  return take_mesh(reader, {vertices, reader.take<std::uint64_t>()});
}

}  // namespace impetus::inline files
