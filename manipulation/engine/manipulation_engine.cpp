// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/manipulation_engine.h"

#include <array>
#include <utility>

#include "geometry/system/overloaded.h"

namespace hapticell::manipulation {

namespace {

/// The documents say the same of where the entity stands: where else it has come to meanwhile goes on being true.
bool standsInBoth(workcell::EntityId id, const PreparedScene& before, const PreparedScene& now) {
  const workcell::Entity *a = before.find(id), *b = now.find(id);
  return a && b && a->X_WE.p == b->X_WE.p && a->X_WE.q == b->X_WE.q && a->joints() == b->joints();
}

}  // namespace

ManipulationEngine::ManipulationEngine(haptic::HapticLink& link, const config::Configuration& configuration)
    : cell_(configuration),
      holder_(link, cell_),
      scripted_(cell_),
      posed_(cell_, holder_.log()),
      recording_(cell_, holder_.log()) {}

/// The first one last: what it says of the cell counts.
std::vector<StylusHolder*> ManipulationEngine::holders() {
  if (second_ == nullptr) return {&holder_};
  return {second_, &holder_};
}

void ManipulationEngine::setScene(std::shared_ptr<const PreparedScene> scene) {
  Placements kept;
  for (const StylusHolder* holder : holders()) {
    const HeldEntity* held = holder->held();
    if (held == nullptr) continue;
    kept[held->id()] = held->standing();
    for (auto& [id, at] : held->carried()) kept[id] = std::move(at);
  }
  const HeldEntity* posed = posed_.posed();
  if (posed && standsInBoth(posed->id(), *cell_.scene(), *scene)) kept.emplace(posed->id(), posed->standing());
  cell_.setScene(std::move(scene), std::move(kept));
  posed_.takeScene();
  for (StylusHolder* holder : holders()) holder->takeScene();
}

void ManipulationEngine::apply(const Command& command) {
  std::visit(
      Overloaded{[&](const command::SetDocument& c) {
                   setScene(scenes_.prepare({c.entities, c.pairs, pairDefaults(cell_.configuration()), c.revision}));
                 },
                 [&](const command::PoseJoints& c) { posed_.want(c); },
                 [&](const command::StartRecording& c) {
                   recording_.start(c);
                   posed_.beginTake();
                 },
                 [&](const command::MarkFrame&) { recording_.mark(); },
                 [&](const command::StopRecording&) { recording_.stop(); },
                 [&](const auto& of_one_stylus) { holder_.apply(of_one_stylus); }},
      command);
}

/// What gives way to them is what both styluses hold.
void ManipulationEngine::moveScripted(StylusHolder& holder) {
  std::array<StylusGrip*, 2> grips{&holder.grip(), nullptr};
  StylusHolder* const other = &holder == second_ ? &holder_ : second_;
  if (other != nullptr) grips[1] = &other->grip();
  const auto retake = [&] {
    for (StylusHolder* one : {&holder, other}) {
      if (one != nullptr) one->retake();
    }
  };
  if (!scripted_.move({grips.data(), other != nullptr ? 2U : 1U}, retake)) return;
  holder.wantSet();
  if (other != nullptr) other->wantSet();
}

void ManipulationEngine::stepHolder(StylusHolder& holder) {
  holder.watchButtons(recording_);
  holder.driftAtEdge();
  moveScripted(holder);
  holder.follow(scripted_);
}

void ManipulationEngine::step(std::int64_t now_ns) {
  cell_.tick(now_ns);
  holder_.takeState();
  // A glove poses whether a stylus is connected or not; what the other stylus holds alone is posed in its step.
  const workcell::EntityId wanted = posed_.wanted();
  if (wanted != 0 && (wanted != holder_.grip().otherHeld() || holder_.grip().holds(wanted))) posed_.follow(holder_);
  if (!holder_.input().state()) return;
  stepHolder(holder_);
  recording_.step(holder_.hand(), posed_.movedInTake(), scripted_);
}

void ManipulationEngine::stepSecond(std::int64_t now_ns) {
  cell_.tick(now_ns);
  StylusHolder& second = *second_;
  const HeldEntity* posed = posed_.posed();
  if (posed && !second.grip().holds(posed->id())) second.placeOther(posed->id(), posed->standing());
  takeOver(second, holder_);
  second.takeState();
  const workcell::EntityId wanted = posed_.wanted();
  if (wanted != 0 && second.grip().holds(wanted) && !holder_.grip().holds(wanted)) posed_.follow(second);
  if (second.input().state()) stepHolder(second);
  if (second.held() && posed_.poses(second.held()->id())) posed_.letGo();
  takeOver(holder_, second);
}

/// What `from` holds counts for `to` where it stands now.
void ManipulationEngine::takeOver(StylusHolder& to, const StylusHolder& from) {
  const HeldEntity* const held = from.held();
  to.grip().setOther(held ? held->id() : 0, from.grip().movedBy());
  if (held == nullptr) return;
  to.letGoOfWhatOtherHolds();
  if (&to == &holder_) recording_.addOther(from.hand(), holder_.grip());
  const EntityConfiguration at = held->standing();
  if (to.grip().holds(held->id())) return to.followOther(at);
  const auto place = [&](workcell::EntityId id, const EntityConfiguration& there) {
    if (to.placeOther(id, there) && &to == &holder_) posed_.placeOther(id, there);
  };
  place(held->id(), at);
  for (const auto& [carried, there] : held->carried()) {
    if (!to.grip().moves(carried)) place(carried, there);
  }
}

void ManipulationEngine::fillSnapshot(SceneSnapshot& snapshot) {
  snapshot = {};
  snapshot.step = cell_.clock().steps();
  snapshot.time_s = cell_.clock().sinceStart();
  holder_.addTo(snapshot);
  posed_.addTo(snapshot);
  snapshot.recording = recording_.shown();
  holder_.describe(snapshot);
}

bool ManipulationEngine::isIdle() const {
  return !holder_.input().hasForces() && !held() && !posed_.posed() && !recording_.isOn() &&
         holder_.grip().otherHeld() == 0 && scripted_.onTheirWay().empty();
}

}  // namespace hapticell::manipulation
