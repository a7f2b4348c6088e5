// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QThreadPool>
#include <atomic>
#include <functional>
#include <memory>

#include "app/viewport/display_mesh.h"

namespace hapticell::app {

/// A mesh on its way to the graphics card.
struct PreparedMesh {
  std::atomic<bool> ready{false};  ///< Set with release once `mesh` is whole; only then may it be read.
  DisplayMesh mesh;
};

/// Makes meshes ready for drawing, one after the other, in a thread of low priority beside the window's.
class DisplayMeshWorker {
 public:
  /// `on_ready` is called in the worker's thread after each mesh; may be empty.
  explicit DisplayMeshWorker(std::function<void()> on_ready = {});
  /// Drops what was not begun, waits for the one that was.
  ~DisplayMeshWorker();
  DisplayMeshWorker(const DisplayMeshWorker&) = delete;
  DisplayMeshWorker& operator=(const DisplayMeshWorker&) = delete;

  /// Begins at once or after those asked for before; the mesh is kept alive until then. One whose answer nobody holds
  /// any more is skipped.
  std::shared_ptr<PreparedMesh> prepare(std::shared_ptr<const geometry::TriangleMesh> mesh,
                                        double crease_angle = kPartCrease);
  /// Frees what is not needed any more; that of a large mesh takes longer than a frame may.
  void letGo(std::shared_ptr<PreparedMesh> prepared);
  /// Waits until all are ready.
  void wait() { pool_.waitForDone(); }

 private:
  std::function<void()> on_ready_;
  QThreadPool pool_;
};

}  // namespace hapticell::app
