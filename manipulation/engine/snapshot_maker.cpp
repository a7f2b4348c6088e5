// SPDX-License-Identifier: Apache-2.0
// What the engine shows: the part of ManipulationEngine that only the window needs.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "manipulation/engine/manipulation_engine.h"

namespace hapticell::manipulation {

namespace {

constexpr std::int64_t kMeasurePeriod = 33'000'000;  ///< ns.
constexpr double kLimitShown = 0.005;                ///< m of hand.
constexpr double kLimitHolds = 5e-5;                 ///< m of hand.
constexpr std::size_t kFreeShown = 24;               ///< Free pairs are told while there are fewer than these.
constexpr double kShownAtLeast = 0.05;               ///< m: the nearest pair is shown from here on.

double edgeOf(const haptic::DeviceDescription& device, const dvec3& p_DS) {
  const dvec3 low = p_DS - device.workspace_min, high = device.workspace_max - p_DS;
  return std::max(0.0, std::min({low.x, low.y, low.z, high.x, high.y, high.z}));
}

/// Where an entity stands, and what its own parts meet.
EntityState stateOf(workcell::EntityId id, const EntityConfiguration& at, const std::vector<PairState>& pairs) {
  EntityState state{id, at.X_WE, at.joints, false, false};
  for (const PairState& pair : pairs) {
    if (pair.moved != id && pair.other != id) continue;
    state.in_contact = state.in_contact || pair.contact;
    state.near_miss = state.near_miss || pair.near_miss;
  }
  return state;
}

/// "gripper", or "link_3" of what is held.
std::string subjectOf(const PairState& pair, workcell::EntityId held, const PreparedScene& scene) {
  const bool own_link = pair.moved == held && pair.other == held;
  return own_link ? pair.moved_part : scene.find(pair.moved)->name;
}

}  // namespace

void ManipulationEngine::measureForDisplay(SceneSnapshot& snapshot) {
  if (measured_ns_ < 0 || now_ns_ - measured_ns_ >= kMeasurePeriod || now_ns_ < measured_ns_) {
    measured_ns_ = now_ns_;
    double limit = kShownAtLeast;
    for (const HeldPair& pair : held_->pairs()) limit = std::max(limit, pair.near_miss);
    held_->distances(limit, near_);
    std::sort(near_.begin(), near_.end(),
              [](const auto& a, const auto& b) { return a.result.distance < b.result.distance; });
  }
  for (const FreeMotion::PairDistance& near : near_) {
    const HeldPair& pair = held_->pairs()[near.pair];
    PairState shown;
    shown.moved = pair.owner;
    shown.other = pair.other;
    shown.moved_part = pair.moved_part;
    shown.other_part = pair.other_part;
    shown.distance = near.result.distance;
    shown.p_WA = near.result.p_WA;
    shown.p_WB = near.result.p_WB;
    shown.contact =
        std::find(contacts_.begin(), contacts_.end(), near.pair) != contacts_.end() || near.result.colliding;
    shown.near_miss_distance = pair.near_miss;
    shown.near_miss = near.result.distance < pair.near_miss;
    if (snapshot.pairs.empty()) snapshot.free_gap_m = shown.distance;
    const bool free_shown = snapshot.pairs.size() < kFreeShown;
    if (free_shown || shown.contact || shown.near_miss) snapshot.pairs.push_back(shown);
  }
}

std::vector<LimitState> ManipulationEngine::nearLimits() const {
  std::vector<LimitState> near;
  if (!held_ || !state_) return near;
  const Pose X_DHere = mapping_.toDevice(held_->movedFrame(), state_->X_DP);
  const Twist here = difference(X_DHere, built_.set.X_DR), proxy = difference(state_->X_DP, built_.set.X_DR);
  const auto over = [](const Twist& t) {
    return haptic::Vector6{t.linear.x, t.linear.y, t.linear.z, t.angular.x, t.angular.y, t.angular.z};
  };
  for (std::size_t i = 0; i < built_.set.count && i < built_.origins.size(); ++i) {
    if (built_.origins[i].limit < 0) continue;
    const MotionLimit& limit = built_.limits[static_cast<std::size_t>(built_.origins[i].limit)];
    const double gap = haptic::evaluate(built_.set.constraints[i], over(here));
    if (gap > kLimitShown) continue;
    const double least = std::min(gap, haptic::evaluate(built_.set.constraints[i], over(proxy)));
    near.push_back({limit.text, held_->ownJoint(limit.joint), limit.kind, std::max(0.0, gap) * mapping_.scale(),
                    least < kLimitHolds});
  }
  if (hurried_joint_ >= 0) {
    const std::string& name = held_->jointName(hurried_joint_);
    near.push_back({name + " moves as fast as it can", held_->ownJoint(hurried_joint_), LimitKind::kSpeed, 0.0, true});
  }
  std::stable_sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.gap < b.gap; });
  return near;
}

void ManipulationEngine::describe(SceneSnapshot& snapshot) const {
  if (link_state_ != haptic::LinkState::kConnected) {
    snapshot.status = link_.problem();
    return;
  }
  if (!held_) return;
  const workcell::Entity* moved = scene_->find(held_->id());
  char text[256];
  if (snapshot.pairs.empty()) {
    std::snprintf(text, sizeof text, "%.80s is free", moved->name.c_str());
  } else {
    const PairState& pair = snapshot.pairs.front();
    const workcell::Entity* other = scene_->find(pair.other);
    const std::string subject = subjectOf(pair, held_->id(), *scene_);
    if (pair.other == held_->id()) {
      std::snprintf(text, sizeof text, pair.contact ? "%.80s touches %.80s of %.80s" : "%.80s is near %.80s of %.80s",
                    subject.c_str(), pair.other_part.c_str(), other->name.c_str());
    } else if (pair.contact) {
      std::snprintf(text, sizeof text, "%.80s touches %.80s", subject.c_str(), other->name.c_str());
    } else {
      std::snprintf(text, sizeof text, "%.80s is %.1f mm from %.80s", subject.c_str(), 1e3 * pair.distance,
                    other->name.c_str());
    }
  }
  snapshot.status = text;
  for (const LimitState& limit : snapshot.limits) {
    if (!limit.holds) continue;
    snapshot.status += "; " + limit.text;
    break;
  }
}

void ManipulationEngine::fillSnapshot(SceneSnapshot& snapshot) {
  snapshot = {};
  snapshot.step = step_;
  snapshot.time_s = start_ns_ < 0 ? 0.0 : 1e-9 * static_cast<double>(now_ns_ - start_ns_);
  const auto carried = held_ ? held_->carried() : decltype(held_->carried()){};
  for (const auto& [id, at] : placements_) {
    const bool goes_along =
        std::any_of(carried.begin(), carried.end(), [&, k = id](const auto& c) { return c.first == k; });
    if ((!held_ || id != held_->id()) && !goes_along)
      snapshot.entities.push_back({id, at.X_WE, at.joints, false, false});
  }
  if (held_) {
    measureForDisplay(snapshot);
    const EntityConfiguration stands = held_->standing();
    snapshot.entities.push_back(stateOf(held_->id(), stands, snapshot.pairs));
    for (const auto& [id, at] : carried) snapshot.entities.push_back(stateOf(id, at, snapshot.pairs));
    snapshot.limits = nearLimits();
    snapshot.held = held_->id();
  }
  addPosed(snapshot);
  snapshot.clutched = clutched_;
  snapshot.stopped = stopped_;
  snapshot.connected = link_state_ == haptic::LinkState::kConnected;
  snapshot.motion_scale = mapping_.scale();
  if (state_) {
    snapshot.forces_on = state_->forces_on;
    snapshot.device_fault = state_->device_fault;
    snapshot.loop_stalled = state_->client_stalled;
    snapshot.force_ramp = state_->force_ramp;
    snapshot.X_DS = state_->X_DS;
    snapshot.X_WStylus = mapping_.toCell(state_->X_DS);
    snapshot.force_W = mapping_.axes() * state_->force_D;
    snapshot.force_n = glm::length(state_->force_D);
    if (const auto device = link_.device()) snapshot.device_edge_m = edgeOf(*device, state_->X_DS.p);
  }
  fillRecording(snapshot);
  snapshot.felt_ns = felt_ns_;
  snapshot.server = statistics_;
  describe(snapshot);
}

}  // namespace hapticell::manipulation
