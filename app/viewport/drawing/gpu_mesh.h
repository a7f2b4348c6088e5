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

/// What was drawn since it was last set back.
struct DrawCount {
  std::size_t calls = 0, triangles = 0, instances = 0;
  double pixels_off = 0.0;  ///< Of the window: how far parts were allowed to be off their shapes.
};

class InstanceBuffer;

/// A mesh in the graphics card's memory: faces, and edges as instances of a quad.
class GpuMesh {
 public:
  /// Empty; fill() takes the room and brings what is in it.
  GpuMesh(Gl& gl, const DisplayMesh& mesh, DrawCount& counted);
  ~GpuMesh();
  GpuMesh(const GpuMesh&) = delete;
  GpuMesh& operator=(const GpuMesh&) = delete;

  /// Copies the mesh that it was made for, in runs of some megabytes while `has_time`; true once all is there.
  bool fill(const DisplayMesh& mesh, const std::function<bool()>& has_time);
  /// All triangles, once.
  void drawFaces();
  /// A run of the triangles of a step of detail for some of the buffer's uses, by one call; `before` are the uses in
  /// the buffer that belong to other meshes and come first.
  void drawUses(std::size_t step, const InstanceBuffer& uses, std::size_t before, const DrawPart& part);
  /// A run of the edges, creases first.
  void drawEdges(std::size_t first, std::size_t count);
  const dvec3& center() const { return center_; }
  const geometry::Bounds& bounds() const { return bounds_; }
  bool closed() const { return closed_; }
  /// How far apart its creases lie on its surface, about, metres: its area by their length; infinite without any.
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
  std::vector<GLuint> buffers_;  ///< Vertices, indices, then runs of edges.
  std::size_t filled_buffers_ = 0;
  std::size_t filled_ = 0;  ///< Bytes of the next one.
  std::size_t edge_count_ = 0, crease_count_ = 0;
  double crease_spacing_ = 0.0;
};

/// Meshes by their address: shared ones are uploaded once; those that no longer occur are let go. Large meshes are made
/// ready in a thread of their own, so that an import never holds up the window.
class GpuMeshCache {
 public:
  /// `on_ready` is called in the worker's thread whenever another mesh can be drawn.
  GpuMeshCache(Gl& gl, std::function<void()> on_ready) : gl_(gl), on_ready_(on_ready), worker_(std::move(on_ready)) {}
  /// What one frame may spend on making meshes ready; what is left over comes with the next one, which `on_ready` asks
  /// for. Negative, as it begins: without limit.
  void setFrameMilliseconds(qint64 most) { most_ms_ = most; }
  /// The item's mesh; null while nothing of it can be shown. What it gives stays until collect().
  GpuMesh* of(const RenderItem& item);
  /// From -0.5 to 0.5 on each axis.
  GpuMesh& unitBox();
  /// Between frames: puts lasting editions in place of first ones, frees what is no more, and what was not asked for
  /// since the last call where that is much.
  void collect();
  /// Of how many not all can be shown yet.
  std::size_t pending() const;
  /// Waits until of() has the lasting answer for all that were asked for.
  void wait();
  DrawCount& counted() { return counted_; }

 private:
  struct Entry {
    std::weak_ptr<const geometry::TriangleMesh> source;
    std::unique_ptr<GpuMesh> mesh;           ///< What is drawn.
    std::unique_ptr<GpuMesh> next;           ///< What is being got onto the card.
    std::shared_ptr<PreparedMesh> prepared;  ///< While the lasting edition is not drawn.
    bool next_lasts = false, rough = false;  ///< `rough`: what is drawn only stands for the mesh.
    bool used = true;
  };
  bool bring(Entry& entry);
  /// Triangles of meshes no longer drawn that are kept for an undo. Half: they are made again; twice: memory.
  static constexpr std::size_t kMostSpareTriangles = 200'000;
  bool hasTime();
  std::unique_ptr<GpuMesh> wholeMesh(const DisplayMesh& mesh);
  Gl& gl_;
  std::function<void()> on_ready_;
  qint64 most_ms_ = -1;
  QElapsedTimer spending_;                    ///< On new meshes of this frame.
  bool left_over_ = false, all_now_ = false;  ///< `all_now_`: somebody waited for them.
  DrawCount counted_;
  DisplayMeshWorker worker_;
  std::map<const geometry::TriangleMesh*, Entry> entries_;
  std::unique_ptr<GpuMesh> unit_box_;
};

}  // namespace hapticell::app
