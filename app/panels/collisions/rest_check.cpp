// SPDX-License-Identifier: Apache-2.0
#include "app/panels/collisions/rest_check.h"

#include <QThreadPool>
#include <atomic>

#include "manipulation/scene/rest_pairs.h"

namespace hapticell::app {

/// Shared with the thread that does it; it is done when `ready` is set.
struct RestCheck::Job {
  std::shared_ptr<const manipulation::PreparedScene> scene;
  workcell::EntityId moved = 0;
  bool touching_wanted = false;
  std::vector<manipulation::PairState> distances;
  RestCheck::Touching touching;
  std::atomic<bool> ready{false};
};

void RestCheck::watch(const std::shared_ptr<const manipulation::PreparedScene>& scene, workcell::EntityId moved) {
  if (!scene) {
    distances_.clear();
    measured_scene_.reset();
    asked_entities_.reset();
    return;
  }
  if (job_) return;
  std::set<Standing> entities;
  for (const workcell::Entity& entity : scene->entities())
    entities.insert({entity.id, entity.attachment.to, entity.attachment.link});
  const bool touching_wanted = !entities.empty() && asked_entities_ != entities;
  const bool distances_wanted = measured_scene_.lock() != scene || measured_ != moved;
  if (!touching_wanted && !distances_wanted) return;
  if (measured_ != moved) distances_.clear();
  measured_scene_ = scene;
  measured_ = moved;
  asked_entities_ = std::move(entities);
  job_ = std::make_shared<Job>();
  job_->scene = scene;
  job_->moved = moved;
  job_->touching_wanted = touching_wanted;
  QThreadPool::globalInstance()->start([job = job_] {
    if (job->moved != 0) job->distances = manipulation::pairsAtRest(*job->scene, job->moved, kMeasured);
    if (job->touching_wanted) {
      job->touching.pairs = manipulation::touchingAtRest(*job->scene);
      job->touching.deep = manipulation::takeDeepOverlaps(*job->scene, job->touching.pairs);
    }
    job->ready = true;
  });
}

bool RestCheck::takeResults() {
  if (!job_ || !job_->ready) return false;
  if (job_->moved == measured_) distances_ = std::move(job_->distances);
  if (job_->touching_wanted) touching_ = std::move(job_->touching);
  job_.reset();
  return true;
}

std::optional<RestCheck::Touching> RestCheck::takeTouching() {
  auto found = std::move(touching_);
  touching_.reset();
  return found;
}

}  // namespace hapticell::app
