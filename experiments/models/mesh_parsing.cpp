// SPDX-License-Identifier: MIT
#include "experiments/models/mesh_parsing.hpp"

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
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "experiments/models/confined_files.hpp"
#include "experiments/models/mesh_claims.hpp"
#include "experiments/models/text_words.hpp"

namespace impetus::inline models {
namespace {

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
  class Line final : public Assimp::LogStream {  // owned by the logger
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
    std::string_view extensions = importer.GetImporterInfo(i)->mFileExtensions;
    bool keep = false;
    for (auto word = take_word(extensions); !word.empty(); word = take_word(extensions)) {
      keep = keep || promised.contains(std::string(word));
    }
    if (Assimp::BaseImporter* reader = importer.GetImporter(i); !keep) {
      importer.UnregisterLoader(reader);
    }
  }
}

}  // namespace

TriangleMesh parse_mesh(const std::filesystem::path& file) {
  refuse_false_claims(file);
  const ErrorLog errors;
  Assimp::Importer importer;
  keep_promised_readers(importer);
  importer.SetIOHandler(new ConfinedFiles(file));  // the importer's from now on
  const aiScene* scene = importer.ReadFile(file.string(), 0);
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

}  // namespace impetus::inline models
