// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/snapshot_maker.h"

#include <algorithm>

namespace hapticell::manipulation {

namespace {

/// ns: shown distances are measured 30 times a second, as numbers that change faster are not read. Half: twice the
/// queries; twice: numbers lag visibly.
constexpr std::int64_t kMeasurePeriod = 33'000'000;
/// Free pairs are shown while there are fewer than these: a panel's length. Half: fewer rows; twice: more rows, same
/// queries.
constexpr std::size_t kFreeShown = 24;
/// m: the nearest pair is shown from here on. Half: it appears later; twice: more queries, as farther pairs are
/// measured.
constexpr double kShownAtLeast = 0.05;

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
std::string subjectOf(const PairState& pair, workcell::EntityId held, const CellState& cell) {
  const bool own_link = pair.moved == held && pair.other == held;
  return own_link ? pair.moved_part : cell.find(pair.moved)->name;
}

}  // namespace

PairState shownPair(const HeldPair& pair, const collision::DistanceResult& measured, bool in_contact) {
  PairState shown;
  shown.moved = pair.owner;
  shown.other = pair.other;
  shown.moved_part = pair.moved_part;
  shown.other_part = pair.other_part;
  shown.distance = measured.distance;
  shown.p_WA = measured.p_WA;
  shown.p_WB = measured.p_WB;
  shown.contact = in_contact || measured.colliding;
  shown.near_miss_distance = pair.near_miss;
  shown.near_miss = measured.distance < pair.near_miss;
  return shown;
}

void SnapshotMaker::addPairs(HeldEntity& held, const ContactWatch& contacts, SceneSnapshot& snapshot) {
  const std::int64_t now = cell_.clock().now();
  if (measured_ns_ < 0 || now - measured_ns_ >= kMeasurePeriod || now < measured_ns_) {
    measured_ns_ = now;
    double limit = kShownAtLeast;
    for (const HeldPair& pair : held.pairs()) limit = std::max(limit, pair.near_miss);
    held.distances(limit, near_);
    std::sort(near_.begin(), near_.end(),
              [](const auto& a, const auto& b) { return a.result.distance < b.result.distance; });
  }
  for (const FreeMotion::PairDistance& near : near_) {
    PairState shown = shownPair(held.pairs()[near.pair], near.result, contacts.isInContact(near.pair));
    if (snapshot.pairs.empty()) snapshot.free_gap_m = shown.distance;
    const bool free_shown = snapshot.pairs.size() < kFreeShown;
    if (free_shown || shown.contact || shown.near_miss) snapshot.pairs.push_back(std::move(shown));
  }
}

void SnapshotMaker::addEntities(StylusGrip& grip, const ContactWatch& contacts, SceneSnapshot& snapshot) {
  HeldEntity* const held = grip.held();
  const auto carried = held ? held->carried() : decltype(held->carried()){};
  for (const auto& [id, at] : cell_.placements()) {
    const bool goes_along =
        std::any_of(carried.begin(), carried.end(), [&, k = id](const auto& c) { return c.first == k; });
    if (!grip.holds(id) && !goes_along) snapshot.entities.push_back({id, at.X_WE, at.joints, false, false});
  }
  if (held == nullptr) return;
  addPairs(*held, contacts, snapshot);
  snapshot.entities.push_back(stateOf(held->id(), held->standing(), snapshot.pairs));
  for (const auto& [id, at] : carried) snapshot.entities.push_back(stateOf(id, at, snapshot.pairs));
  snapshot.stylus.held = held->id();
}

void SnapshotMaker::addStylus(const StylusInput& input, const MotionMapping& mapping, SceneSnapshot& snapshot) {
  snapshot.stylus.connected = input.isConnected();
  snapshot.stylus.motion_scale = mapping.scale();
  snapshot.server = input.statistics();
  const std::optional<haptic::HapticState>& state = input.state();
  if (!state) return;
  snapshot.stylus.forces_on = state->forces_on;
  snapshot.stylus.device_fault = state->device_fault;
  snapshot.stylus.loop_stalled = state->client_stalled;
  snapshot.stylus.force_ramp = state->force_ramp;
  snapshot.stylus.X_DS = state->X_DS;
  snapshot.stylus.X_WStylus = mapping.toCell(state->X_DS);
  snapshot.stylus.force_W = mapping.axes() * state->force_D;
  snapshot.stylus.force_n = glm::length(state->force_D);
  if (const auto device = input.link().device()) snapshot.stylus.device_edge_m = edgeOf(*device, state->X_DS.p);
}

Text SnapshotMaker::sentenceOf(const HeldEntity& held, const SceneSnapshot& snapshot) const {
  if (snapshot.pairs.empty()) return Text("%1 is free", cell_.find(held.id())->name);
  const PairState& pair = snapshot.pairs.front();
  const workcell::Entity* other = cell_.find(pair.other);
  const std::string subject = subjectOf(pair, held.id(), cell_);
  if (pair.other == held.id())
    return pair.contact ? Text("%1 touches %2 of %3", subject, pair.other_part, other->name)
                        : Text("%1 is near %2 of %3", subject, pair.other_part, other->name);
  return pair.contact ? Text("%1 touches %2", subject, other->name)
                      : Text("%1 is %2 from %3", subject, Text::Length{pair.distance}, other->name);
}

void SnapshotMaker::describe(const StylusInput& input, const StylusGrip& grip, SceneSnapshot& snapshot) const {
  if (!input.isConnected()) {
    snapshot.problem = input.link().problem();
    return;
  }
  if (grip.held() == nullptr) return;
  snapshot.status = {sentenceOf(*grip.held(), snapshot)};
  const auto holds =
      std::find_if(snapshot.limits.begin(), snapshot.limits.end(), [](const LimitState& limit) { return limit.holds; });
  if (holds != snapshot.limits.end()) snapshot.status.push_back(holds->text);
}

}  // namespace hapticell::manipulation
