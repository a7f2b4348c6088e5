// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/meshes/display_mesh_worker.h"

#include <algorithm>

#include "app/viewport/meshes/detail_steps.h"
#include "app/viewport/meshes/vertex_clusters.h"
#include "workcell/import/background_thread.h"

namespace hapticell::app {
namespace {

// Each may need a few hundred bytes a triangle. Half: large cells appear later; twice: memory, and less for the loops.
constexpr int kMostThreads = 4;
// Some 50 000 triangles, fewer than a moving frame may have (docs/dev/window.md). Half: a quarter, steps are seen;
// twice: four times, the first picture is late.
constexpr int kRoughCells = 96;

}  // namespace

DisplayMeshWorker::DisplayMeshWorker(std::function<void()> on_shown) : on_shown_(std::move(on_shown)) {
  for (QThreadPool* pool : {&first_, &lasting_}) pool->setThreadPriority(QThread::LowPriority);
  first_.setMaxThreadCount(1);
  lasting_.setMaxThreadCount(std::clamp(QThread::idealThreadCount() - 1, 1, kMostThreads));
}

DisplayMeshWorker::~DisplayMeshWorker() {
  given_up_ = true;
  for (QThreadPool* pool : {&first_, &lasting_}) {
    pool->clear();
    pool->waitForDone();
  }
}

void DisplayMeshWorker::wait() {
  first_.waitForDone();
  lasting_.waitForDone();
}

void DisplayMeshWorker::makeLasting(const std::shared_ptr<const geometry::TriangleMesh>& mesh, double crease_angle,
                                    const std::weak_ptr<PreparedMesh>& waiting) {
  lasting_.start([this, mesh, crease_angle, waiting] {
    const std::shared_ptr<PreparedMesh> answer = waiting.lock();
    if (!answer) return;
    workcell::lowerThreadPriority();
    const bool first_is_whole = answer->first.steps.size() == 1 && mesh->triangles.size() <= kLargeMesh;
    answer->mesh = first_is_whole ? answer->first : makeDisplayMesh(*mesh, crease_angle, &given_up_);
    addDetailSteps(answer->mesh, crease_angle, &given_up_);
    answer->ready.store(true, std::memory_order_release);
    if (mesh->triangles.size() > kLargeMesh && on_shown_) on_shown_();
  });
}

std::shared_ptr<PreparedMesh> DisplayMeshWorker::prepareLasting(std::shared_ptr<const geometry::TriangleMesh> mesh,
                                                                double crease_angle) {
  auto prepared = std::make_shared<PreparedMesh>();
  makeLasting(mesh, crease_angle, prepared);
  return prepared;
}

std::shared_ptr<PreparedMesh> DisplayMeshWorker::prepare(std::shared_ptr<const geometry::TriangleMesh> mesh,
                                                         double crease_angle) {
  auto prepared = std::make_shared<PreparedMesh>();
  first_.start([this, crease_angle, mesh = std::move(mesh), waiting = std::weak_ptr(prepared)] {
    const std::shared_ptr<PreparedMesh> answer = waiting.lock();
    if (!answer) return;
    workcell::lowerThreadPriority();
    answer->first = mesh->triangles.size() > kLargeMesh ? makeDisplayMesh(clustered(*mesh, kRoughCells), kSkinCrease)
                                                        : makeDisplayMesh(*mesh, crease_angle, &given_up_);
    answer->first_ready.store(true, std::memory_order_release);
    if (on_shown_) on_shown_();
    makeLasting(mesh, crease_angle, waiting);
  });
  return prepared;
}

void DisplayMeshWorker::letGo(std::shared_ptr<PreparedMesh> prepared) {
  lasting_.start([prepared = std::move(prepared)]() mutable { prepared.reset(); });
}

}  // namespace hapticell::app
