// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QThreadPool>
#include <atomic>
#include <functional>
#include <memory>

#include "app/viewport/meshes/display_mesh.h"

namespace hapticell::app {

/// A mesh on its way to the graphics card, in two editions: a first one to show soon, and a lasting one.
struct PreparedMesh {
  std::atomic<bool> first_ready{false};  ///< Set (release) once `first` is complete; it may be read only then.
  DisplayMesh first;                     ///< Without coarser steps; of a large mesh, rough triangles in its place.
  std::atomic<bool> ready{false};        ///< The same for `mesh`.
  DisplayMesh mesh;
};

/// Prepares meshes for drawing in background threads of low priority: one makes the first editions, others the lasting
/// ones, so that a large mesh never delays others.
class DisplayMeshWorker {
 public:
  /// Calls `on_shown` in a worker's thread whenever a mesh can be shown better than before; may be empty.
  explicit DisplayMeshWorker(std::function<void()> on_shown = {});
  /// Drops requests that were not started, and cancels the running ones.
  ~DisplayMeshWorker();
  DisplayMeshWorker(const DisplayMeshWorker&) = delete;
  DisplayMeshWorker& operator=(const DisplayMeshWorker&) = delete;

  /// Starts at once, or after earlier requests; keeps the mesh alive until then. Skips requests whose result nobody
  /// holds any more.
  std::shared_ptr<PreparedMesh> prepare(std::shared_ptr<const geometry::TriangleMesh> mesh,
                                        double crease_angle = kPartCrease);
  /// The same for a mesh that is already shown: only the lasting edition, and without calling `on_shown`.
  std::shared_ptr<PreparedMesh> prepareLasting(std::shared_ptr<const geometry::TriangleMesh> mesh,
                                               double crease_angle = kPartCrease);
  /// Frees what is not needed any more; for a large mesh, this takes longer than a frame may take.
  void letGo(std::shared_ptr<PreparedMesh> prepared);
  /// Waits until all are ready.
  void wait();
  /// Number of triangles above which a mesh is first shown by a rough one
  /// (docs/dev/window.md). Half: more parts change shape after reading; twice: the first
  /// picture is late.
  static constexpr std::size_t kLargeMesh = 150'000;

 private:
  void makeLasting(const std::shared_ptr<const geometry::TriangleMesh>& mesh, double crease_angle,
                   const std::weak_ptr<PreparedMesh>& waiting);
  std::function<void()> on_shown_;
  std::atomic<bool> given_up_{false};
  QThreadPool first_, lasting_;
};

}  // namespace hapticell::app
