// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "app/viewport/drawing/draw_share.h"
#include "app/viewport/drawing/gl.h"
#include "app/viewport/meshes/display_mesh_worker.h"
#include "app/viewport/scene/render_item.h"

namespace hapticell::app {

/// What was drawn since the last reset.
struct DrawCount {
  std::size_t calls = 0, triangles = 0, instances = 0;
  double pixels_off = 0.0;  ///< Pixels of the window: allowed deviation of parts.
};

class InstanceBuffer;

/// A mesh in the graphics card's memory: faces, and edges as instances of a quad.
class GpuMesh {
 public:
  /// Starts empty; fill() allocates the memory and copies the mesh.
  GpuMesh(Gl& gl, const DisplayMesh& mesh, DrawCount& counted);
  ~GpuMesh();
  GpuMesh(const GpuMesh&) = delete;
  GpuMesh& operator=(const GpuMesh&) = delete;

  /// Copies the mesh that it was made for, in pieces of some megabytes while `has_time`; true once all is copied.
  bool fill(const DisplayMesh& mesh, const std::function<bool()>& has_time);
  /// Draws all triangles, once.
  void drawFaces();
  /// Draws a range of the triangles of a detail step for some of the buffer's uses, in one call; `before` is the number
  /// of uses in the buffer that belong to other meshes and precede these.
  void drawUses(std::size_t step, const InstanceBuffer& uses, std::size_t before, const DrawPart& part);
  /// Draws a range of the edges, creases first.
  void drawEdges(std::size_t first, std::size_t count);
  const dvec3& center() const { return center_; }
  const geometry::Bounds& bounds() const { return bounds_; }
  bool closed() const { return closed_; }
  /// Mean distance of its creases on its surface, metres: its area by their length; infinite without creases.
  double creaseSpacing() const { return crease_spacing_; }
  const std::vector<DetailStep>& steps() const { return steps_; }
  std::size_t triangles() const { return steps_.empty() ? 0 : steps_[0].count / 3; }
  std::size_t trianglesOf(std::size_t step) const {
    return steps_.empty() ? 0 : steps_[std::min(step, steps_.size() - 1)].count / 3;
  }
  std::size_t edges() const { return edge_count_; }
  std::size_t creases() const { return crease_count_; }

 private:
  Gl& gl_;
  DrawCount& counted_;
  std::vector<DetailStep> steps_;
  dvec3 center_;
  geometry::Bounds bounds_;
  bool closed_ = true;
  GLuint face_array_ = 0, edge_array_ = 0;
  std::vector<GLuint> buffers_;  ///< Vertices, indices, then blocks of edges.
  std::size_t filled_buffers_ = 0;
  std::size_t filled_ = 0;  ///< Bytes filled in the next buffer.
  std::size_t edge_count_ = 0, crease_count_ = 0;
  double crease_spacing_ = 0.0;
};

/// Meshes by their address: shared ones are uploaded once; those no longer used are freed. Large meshes are prepared in
/// a separate thread, so that an import never blocks the window.
class GpuMeshCache {
 public:
  /// Calls `on_ready` in the worker's thread whenever another mesh can be drawn.
  GpuMeshCache(Gl& gl, std::function<void()> on_ready) : gl_(gl), on_ready_(on_ready), worker_(std::move(on_ready)) {}
  /// Sets how long one frame may prepare meshes; the rest is done in the next frame, which `on_ready` asks for.
  /// Negative (the default): no limit.
  void setFrameMilliseconds(qint64 most) { most_ms_ = most; }
  /// The item's mesh; null while nothing of it can be shown. The result is valid until collect().
  GpuMesh* of(const RenderItem& item);
  /// A box from -0.5 to 0.5 on each axis.
  GpuMesh& unitBox();
  /// Call it between frames: replaces first editions by lasting ones; frees meshes that no longer exist, and meshes not
  /// used since the last call if these have more than kMostSpareTriangles.
  void collect();
  /// Number of meshes that are not completely shown yet.
  std::size_t pending() const;
  /// Waits until of() returns the lasting mesh for all requests.
  void wait();
  DrawCount& counted() { return counted_; }

 private:
  struct Entry {
    std::weak_ptr<const geometry::TriangleMesh> source;
    std::unique_ptr<GpuMesh> mesh;           ///< The mesh that is drawn.
    std::unique_ptr<GpuMesh> next;           ///< The mesh that is being uploaded.
    std::shared_ptr<PreparedMesh> prepared;  ///< Until the lasting edition is drawn.
    bool next_lasts = false, rough = false;  ///< `rough`: a rough mesh is drawn in its place.
    bool used = true;
  };
  bool bring(Entry& entry);
  /// Triangles of unused meshes that are kept for an undo. Half: they are made again; twice: memory.
  static constexpr std::size_t kMostSpareTriangles = 200'000;
  bool hasTime();
  std::unique_ptr<GpuMesh> wholeMesh(const DisplayMesh& mesh);
  Gl& gl_;
  std::function<void()> on_ready_;
  qint64 most_ms_ = -1;
  QElapsedTimer spending_;                    ///< Time spent on new meshes in this frame.
  bool left_over_ = false, all_now_ = false;  ///< `all_now_`: a caller waits for all meshes.
  DrawCount counted_;
  DisplayMeshWorker worker_;
  std::map<const geometry::TriangleMesh*, Entry> entries_;
  std::unique_ptr<GpuMesh> unit_box_;
};

}  // namespace hapticell::app
