// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QThreadPool>
#include <atomic>
#include <functional>
#include <memory>

#include "app/viewport/meshes/display_mesh.h"

namespace hapticell::app {

/// A mesh on its way to the graphics card, in two editions: one that can be shown soon, one to stay.
struct PreparedMesh {
  std::atomic<bool> first_ready{false};  ///< Set with release once `first` is whole; only then may it be read.
  DisplayMesh first;                     ///< Without coarser steps; of a large mesh rough triangles that stand for it.
  std::atomic<bool> ready{false};        ///< The same for `mesh`.
  DisplayMesh mesh;
};

/// Prepares meshes for drawing in background threads of low priority: one makes the first editions, others the lasting
/// ones, so that a large mesh never keeps others from being seen.
class DisplayMeshWorker {
 public:
  /// `on_shown` is called in a worker's thread whenever a mesh can be shown better than before; may be empty.
  explicit DisplayMeshWorker(std::function<void()> on_shown = {});
  /// Drops what was not begun, gives up what was.
  ~DisplayMeshWorker();
  DisplayMeshWorker(const DisplayMeshWorker&) = delete;
  DisplayMeshWorker& operator=(const DisplayMeshWorker&) = delete;

  /// Begins at once or after those asked for before; the mesh is kept alive until then. One whose answer nobody holds
  /// any more is skipped.
  std::shared_ptr<PreparedMesh> prepare(std::shared_ptr<const geometry::TriangleMesh> mesh,
                                        double crease_angle = kPartCrease);
  /// The same for one that is shown already: only the lasting edition, and `on_shown` is not called.
  std::shared_ptr<PreparedMesh> prepareLasting(std::shared_ptr<const geometry::TriangleMesh> mesh,
                                               double crease_angle = kPartCrease);
  /// Frees what is not needed any more; that of a large mesh takes longer than a frame may.
  void letGo(std::shared_ptr<PreparedMesh> prepared);
  /// Waits until all are ready.
  void wait();
  /// Meshes of more triangles are shown by rough ones at first.
  /// Triangles from which it is shown coarsely first (docs/dev/window.md). Half: more parts change shape after reading;
  /// twice: the first picture is late.
  static constexpr std::size_t kLargeMesh = 150'000;

 private:
  void makeLasting(const std::shared_ptr<const geometry::TriangleMesh>& mesh, double crease_angle,
                   const std::weak_ptr<PreparedMesh>& waiting);
  std::function<void()> on_shown_;
  std::atomic<bool> given_up_{false};
  QThreadPool first_, lasting_;
};

}  // namespace hapticell::app
