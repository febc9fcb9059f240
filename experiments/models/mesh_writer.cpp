// SPDX-License-Identifier: MIT
#include "experiments/models/mesh_writer.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <limits>
#include <locale>
#include <map>
#include <stdexcept>
#include <string>
#include <system_error>

namespace impetus::inline models {
namespace {

void write_place(std::ostream& out, const Vector3& place) {
  out << place.x() << " " << place.y() << " " << place.z() << "\n";
}

void write_obj(std::ostream& out, const TriangleMesh& mesh) {
  for (const Vector3& vertex : mesh.vertices) {
    out << "v ";
    write_place(out, vertex);
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    out << "f " << a + 1 << " " << b + 1 << " " << c + 1 << "\n";
  }
}

void write_ply(std::ostream& out, const TriangleMesh& mesh) {
  out << "ply\nformat ascii 1.0\nelement vertex " << mesh.vertices.size()
      << "\nproperty float x\nproperty float y\nproperty float z\nelement face "
      << mesh.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vector3& vertex : mesh.vertices) {
    write_place(out, vertex);
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    out << "3 " << a << " " << b << " " << c << "\n";
  }
}

void write_stl(std::ostream& out, const TriangleMesh& mesh) {
  out << "solid mesh\n";
  for (const auto& triangle : mesh.triangles) {
    const Vector3& a = mesh.vertices[triangle[0]];
    const Vector3 across = (mesh.vertices[triangle[1]] - a).cross(mesh.vertices[triangle[2]] - a);
    out << "facet normal ";
    write_place(out, across.stableNormalized());
    out << "outer loop\n";
    for (const std::uint32_t corner : triangle) {
      out << "vertex ";
      write_place(out, mesh.vertices[corner]);
    }
    out << "endloop\nendfacet\n";
  }
  out << "endsolid mesh\n";
}

using Writer = void (*)(std::ostream&, const TriangleMesh&);

/// Nothing for an extension that is not known.
Writer writer_for(const std::filesystem::path& file) {
  static const std::map<std::string, Writer> kWriters{
      {".obj", write_obj}, {".ply", write_ply}, {".stl", write_stl}};
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  const auto found = kWriters.find(extension);
  return found == kWriters.end() ? nullptr : found->second;
}

[[noreturn]] void refuse_to_write(const std::filesystem::path& file, const std::string& problem) {
  throw std::runtime_error(file.string() + ": " + problem);
}

}  // namespace

bool can_write_mesh(const std::filesystem::path& file) { return writer_for(file) != nullptr; }

void write_mesh(const TriangleMesh& mesh, const std::filesystem::path& file) {
  const Writer writer = writer_for(file);
  if (writer == nullptr) {
    refuse_to_write(file, "expected a name that ends in .obj, .ply or .stl");
  }
  if (std::filesystem::exists(file)) {
    refuse_to_write(file, "exists already and is not overwritten");
  }
  std::ofstream out(file, std::ios::binary);
  out.imbue(std::locale::classic());
  out.precision(std::numeric_limits<float>::max_digits10);
  writer(out, mesh);
  out.close();
  if (!out) {
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    refuse_to_write(file, "cannot be written");
  }
}

}  // namespace impetus::inline models
