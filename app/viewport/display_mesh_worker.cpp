// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/display_mesh_worker.h"

#include "app/viewport/detail_steps.h"
#include "workcell/background_thread.h"

namespace hapticell::app {

DisplayMeshWorker::DisplayMeshWorker(std::function<void()> on_ready) : on_ready_(std::move(on_ready)) {
  pool_.setMaxThreadCount(1);
  pool_.setThreadPriority(QThread::LowPriority);
}

DisplayMeshWorker::~DisplayMeshWorker() {
  pool_.clear();
  pool_.waitForDone();
}

std::shared_ptr<PreparedMesh> DisplayMeshWorker::prepare(std::shared_ptr<const geometry::TriangleMesh> mesh,
                                                         double crease_angle) {
  auto prepared = std::make_shared<PreparedMesh>();
  pool_.start([this, crease_angle, mesh = std::move(mesh), waiting = std::weak_ptr(prepared)] {
    const std::shared_ptr<PreparedMesh> answer = waiting.lock();
    if (!answer) return;
    workcell::stepBehind();
    answer->mesh = makeDisplayMesh(*mesh, crease_angle);
    addDetailSteps(answer->mesh);
    answer->ready.store(true, std::memory_order_release);
    if (on_ready_) on_ready_();
  });
  return prepared;
}

void DisplayMeshWorker::letGo(std::shared_ptr<PreparedMesh> prepared) {
  pool_.start([prepared = std::move(prepared)]() mutable { prepared.reset(); });
}

}  // namespace hapticell::app
