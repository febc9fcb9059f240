// SPDX-License-Identifier: MIT
#include "experiments/drawing/uploaded_meshes.hpp"

#include <epoxy/gl.h>

#include <cstddef>
#include <utility>

namespace impetus::inline drawing {
namespace {

template <typename T>
void fill_buffer(GLenum kind, unsigned buffer, const std::vector<T>& values) {
  glBindBuffer(kind, buffer);
  glBufferData(kind, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(),
               GL_STATIC_DRAW);
}

void describe_vertex(unsigned place, std::size_t offset) {
  glEnableVertexAttribArray(place);
  glVertexAttribPointer(place, 3, GL_FLOAT, GL_FALSE, sizeof(ShadedVertex),
                        reinterpret_cast<const void*>(offset));
}

}  // namespace

/// One mesh on the graphics card. While its owner lasts, no other mesh can have its address.
struct UploadedMeshes::Buffers {
  Buffers(const std::shared_ptr<const TriangleMesh>& mesh, double hard_edge_deg,
          const std::function<void()>& describe)
      : owner(mesh) {
    const ShadedMesh ready = shaded(*mesh, hard_edge_deg);
    uploaded.indices = static_cast<int>(ready.indices.size());
    glGenVertexArrays(1, &uploaded.arrangement);
    glGenBuffers(2, buffers);
    glBindVertexArray(uploaded.arrangement);
    fill_buffer(GL_ARRAY_BUFFER, buffers[0], ready.vertices);
    fill_buffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1], ready.indices);
    describe_vertex(0, offsetof(ShadedVertex, position));
    describe_vertex(1, offsetof(ShadedVertex, normal));
    if (describe) {
      describe();
    }
    glBindVertexArray(0);
  }
  ~Buffers() {
    glDeleteBuffers(2, buffers);
    glDeleteVertexArrays(1, &uploaded.arrangement);
  }
  Buffers(const Buffers&) = delete;
  Buffers& operator=(const Buffers&) = delete;

  std::weak_ptr<const TriangleMesh> owner;
  UploadedMesh uploaded;
  unsigned buffers[2]{};
};

UploadedMeshes::UploadedMeshes(std::function<void()> describe) : describe_(std::move(describe)) {}

UploadedMeshes::~UploadedMeshes() = default;

void UploadedMeshes::forget_ended() {
  std::erase_if(meshes_, [](const auto& entry) { return entry.second->owner.expired(); });
}

const UploadedMesh& UploadedMeshes::of(const std::shared_ptr<const TriangleMesh>& mesh,
                                       double hard_edge_deg) {
  std::unique_ptr<Buffers>& place = meshes_[mesh.get()];
  if (!place) {
    place = std::make_unique<Buffers>(mesh, hard_edge_deg, describe_);
  }
  return place->uploaded;
}

}  // namespace impetus::inline drawing
