// SPDX-License-Identifier: Apache-2.0
#include "app/host/motion_memory.h"

#include <algorithm>
#include <utility>

#include "app/host/document_model.h"

namespace hapticell::app {
namespace {

// s that a step of going back takes at most: pauses are cut, so that ten seconds of it are motion. Half: slow motions
// run faster; twice: one waits at pauses.
constexpr double kPause = 0.2;
// ms between two kept places. Half: twice the memory; twice: corners of a motion are cut.
constexpr qint64 kLookMilliseconds = 100;

/// What carries comes before what hangs on it: moving the first takes the second along.
int depthOf(const workcell::Document& document, const workcell::Entity& entity) {
  int depth = 0;
  for (const workcell::Entity* now = &entity; now && !now->attachment.to.empty() && depth < 64; ++depth)
    now = document.findByName(now->attachment.to);
  return depth;
}

}  // namespace

bool MotionMemory::Place::operator==(const Place& other) const {
  return X_WE.p == other.X_WE.p && X_WE.q == other.X_WE.q && joints == other.joints;
}

MotionMemory::MotionMemory(DocumentModel& document, std::function<Places()> places)
    : document_(document), places_(std::move(places)) {
  forget();
}

void MotionMemory::forget() {
  steps_.clear();
  kept_ = 0.0;
  last_ = places_();
}

void MotionMemory::look() {
  if (going_back_ || (since_look_.isValid() && since_look_.elapsed() < kLookMilliseconds)) return;
  const double seconds = since_look_.isValid() ? 1e-3 * static_cast<double>(since_look_.elapsed()) : kPause;
  since_look_.start();
  look(seconds);
}

void MotionMemory::look(double seconds) {
  Places now = places_();
  Step step{std::min(seconds, kPause), {}};
  for (const auto& [id, place] : last_)
    if (const auto found = now.find(id); found != now.end() && !(found->second == place)) step.before[id] = place;
  last_ = std::move(now);
  if (step.before.empty()) return;
  kept_ += step.seconds;
  steps_.push_back(std::move(step));
  while (kept_ > kKept) {
    kept_ -= steps_.front().seconds;
    steps_.pop_front();
  }
}

bool MotionMemory::goBack(double seconds) {
  look(0.0);  // What moved since the last look.
  Places wanted;
  for (double gone = 0.0; !steps_.empty() && gone < seconds; steps_.pop_back()) {
    gone += steps_.back().seconds;
    kept_ -= steps_.back().seconds;
    for (auto& [id, place] : steps_.back().before) wanted[id] = place;
  }
  const workcell::Document& document = document_.document();
  std::vector<std::pair<int, workcell::Command>> ordered;
  for (auto& [id, place] : wanted) {
    const workcell::Entity* entity = document.find(id);
    if (!entity || entity->locked) continue;
    ordered.emplace_back(depthOf(document, *entity), workcell::SetConfiguration{id, place.X_WE, place.joints});
  }
  if (ordered.empty()) return false;
  std::stable_sort(ordered.begin(), ordered.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<workcell::Command> commands;
  commands.reserve(ordered.size());
  for (auto& [depth, command] : ordered) commands.push_back(std::move(command));
  going_back_ = true;
  const bool done = document_.executeAll(tr("Go back %1 s").arg(seconds), commands);
  going_back_ = false;
  last_ = places_();
  return done;
}

}  // namespace hapticell::app
