// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/gpu_mesh.h"

#include <algorithm>
#include <utility>

#include "app/viewport/instance_buffer.h"

namespace hapticell::app {
namespace {

constexpr std::size_t kSmallMesh = 2000;  // Triangles: sooner made ready than handed over.

const void* offset(std::size_t bytes) {
  return reinterpret_cast<const void*>(bytes);
}

}  // namespace

GpuMesh::GpuMesh(Gl& gl, const DisplayMesh& mesh, DrawCount& counted)
    : gl_(gl), counted_(counted), steps_(mesh.steps), center_(mesh.center), bounds_(mesh.bounds), closed_(mesh.closed) {
  edge_count_ = mesh.edges.size();
  crease_count_ = mesh.creases;
  gl_.glGenBuffers(3, buffers_);
  gl_.glGenVertexArrays(1, &face_array_);
  gl_.glBindVertexArray(face_array_);
  gl_.glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
  gl_.glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(DisplayVertex)),
                   mesh.vertices.data(), GL_STATIC_DRAW);
  gl_.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
  gl_.glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(std::uint32_t)),
                   mesh.indices.data(), GL_STATIC_DRAW);
  for (GLuint i = 0; i < 2; ++i) {
    gl_.glEnableVertexAttribArray(i);
    gl_.glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, sizeof(DisplayVertex), offset(i * sizeof(fvec3)));
  }
  gl_.glGenVertexArrays(1, &edge_array_);
  gl_.glBindVertexArray(edge_array_);
  gl_.glBindBuffer(GL_ARRAY_BUFFER, buffers_[2]);
  gl_.glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.edges.size() * sizeof(DisplayEdge)), mesh.edges.data(),
                   GL_STATIC_DRAW);
  gl_.glBindVertexArray(0);
}

GpuMesh::~GpuMesh() {
  gl_.glDeleteVertexArrays(1, &face_array_);
  gl_.glDeleteVertexArrays(1, &edge_array_);
  gl_.glDeleteBuffers(3, buffers_);
}

void GpuMesh::drawFaces() {
  if (steps_.empty()) return;
  gl_.glBindVertexArray(face_array_);
  gl_.glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(steps_[0].count), GL_UNSIGNED_INT, nullptr);
  ++counted_.calls;
  counted_.triangles += triangles();
}

void GpuMesh::drawUses(std::size_t step, const InstanceBuffer& uses, std::size_t before, const DrawPart& part) {
  if (steps_.empty() || part.uses == 0) return;
  const DetailStep& drawn = steps_[std::min(step, steps_.size() - 1)];
  gl_.glBindVertexArray(face_array_);
  uses.attach(before + part.first_use);
  gl_.glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(3 * part.units), GL_UNSIGNED_INT,
                              offset((drawn.first + 3 * part.first_unit) * sizeof(std::uint32_t)),
                              static_cast<GLsizei>(part.uses));
  ++counted_.calls;
  counted_.instances += part.uses;
  counted_.triangles += part.units * part.uses;
}

void GpuMesh::drawEdges(std::size_t first, std::size_t count) {
  if (count == 0) return;
  gl_.glBindVertexArray(edge_array_);
  gl_.glBindBuffer(GL_ARRAY_BUFFER, buffers_[2]);
  for (GLuint i = 0; i < 4; ++i) {
    gl_.glEnableVertexAttribArray(i);
    gl_.glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, sizeof(DisplayEdge),
                              offset(first * sizeof(DisplayEdge) + i * sizeof(fvec3)));
    gl_.glVertexAttribDivisor(i, 1);
  }
  gl_.glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(count));
  ++counted_.calls;
}

GpuMesh* GpuMeshCache::of(const std::shared_ptr<const geometry::TriangleMesh>& mesh) {
  Entry& entry = entries_[mesh.get()];
  entry.used = true;
  // An address that was reused by another mesh must not show the old one.
  if (entry.source.lock() != mesh) {
    entry.mesh.reset();
    entry.source = mesh;
    if (mesh->triangles.size() <= kSmallMesh && hasTime())
      entry.mesh = std::make_unique<GpuMesh>(gl_, makeDisplayMesh(*mesh), counted_);
    else
      entry.prepared = worker_.prepare(mesh);
  }
  if (entry.prepared && entry.prepared->ready.load(std::memory_order_acquire)) {
    if (!hasTime()) {
      left_over_ = true;
      return nullptr;
    }
    entry.mesh = std::make_unique<GpuMesh>(gl_, entry.prepared->mesh, counted_);
    entry.prepared.reset();
  }
  return entry.mesh.get();
}

/// Many small parts, or many that are ready at once, must not make one long frame.
bool GpuMeshCache::hasTime() {
  if (most_ms_ < 0 || all_now_) return true;
  if (!spending_.isValid()) spending_.start();
  return spending_.elapsed() < most_ms_;
}

std::size_t GpuMeshCache::pending() const {
  return static_cast<std::size_t>(std::count_if(entries_.begin(), entries_.end(),
                                                [](const auto& entry) { return entry.second.prepared != nullptr; }));
}

void GpuMeshCache::collect() {
  spending_.invalidate();
  all_now_ = false;
  if (std::exchange(left_over_, false)) on_ready_();
  std::erase_if(entries_, [](const auto& entry) { return !entry.second.used || entry.second.source.expired(); });
  for (auto& entry : entries_) entry.second.used = false;
}

}  // namespace hapticell::app
