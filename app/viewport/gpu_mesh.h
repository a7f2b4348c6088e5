// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>

#include "app/viewport/display_mesh.h"
#include "app/viewport/gl.h"

namespace hapticell::app {

/// A mesh in the graphics card's memory: faces, and edges as instances of a quad.
class GpuMesh {
 public:
  GpuMesh(Gl& gl, const DisplayMesh& mesh);
  ~GpuMesh();
  GpuMesh(const GpuMesh&) = delete;
  GpuMesh& operator=(const GpuMesh&) = delete;

  void drawFaces();
  void drawCreases();
  void drawAllEdges();
  const dvec3& center() const { return center_; }
  const geometry::Bounds& bounds() const { return bounds_; }
  std::size_t triangles() const { return static_cast<std::size_t>(index_count_) / 3; }
  std::size_t edges() const { return static_cast<std::size_t>(edge_count_); }

 private:
  void drawEdges(GLsizei count);
  Gl& gl_;
  dvec3 center_;
  geometry::Bounds bounds_;
  GLuint face_array_ = 0, edge_array_ = 0;
  GLuint buffers_[3]{};
  GLsizei index_count_ = 0, edge_count_ = 0, crease_count_ = 0;
};

/// Meshes by their address: shared ones are uploaded once; those that no longer occur are let go.
class GpuMeshCache {
 public:
  explicit GpuMeshCache(Gl& gl) : gl_(gl) {}
  GpuMesh& of(const std::shared_ptr<const geometry::TriangleMesh>& mesh);
  /// Frees what was not asked for since the last call.
  void collect();

 private:
  struct Entry {
    std::weak_ptr<const geometry::TriangleMesh> source;
    std::unique_ptr<GpuMesh> mesh;
    bool used = true;
  };
  Gl& gl_;
  std::map<const geometry::TriangleMesh*, Entry> entries_;
};

}  // namespace hapticell::app
