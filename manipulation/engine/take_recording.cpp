// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/take_recording.h"

#include <string>
#include <utility>

namespace hapticell::manipulation {

namespace {

std::string pathOf(const std::string& entity, const std::string& part) {
  return part.empty() ? entity : entity + "/" + part;
}

/// What moves by itself is recorded by: a mannequin as a whole, a robot by its base.
MovedBy wholeOf(const workcell::Entity& entity) {
  if (entity.figure()) return by::Whole{};
  return entity.robot() ? MovedBy(by::Base{}) : MovedBy(by::Origin{});
}

}  // namespace

void TakeRecording::start(const command::StartRecording& wanted) {
  stop();
  recorder_ = std::make_unique<TakeRecorder>(wanted.options, wanted.take);
  mark_by_button_ = wanted.mark_by_button;
  mark_wanted_ = false;
}

void TakeRecording::stop() {
  if (!recorder_) return;
  log_.add(result::Recorded{recorder_->finish()});
  recorder_.reset();
}

/// Of what is held, which stands at `at`.
TakeRecorder::Sample TakeRecording::sampleOf(const Hand& hand, const EntityConfiguration& at) const {
  const HeldEntity& held = *hand.grip.held();
  TakeRecorder::Sample sample;
  sample.t = cell_.clock().sinceStart();
  sample.moved_by = hand.grip.movedBy();
  sample.entity = cell_.find(held.id());
  sample.at = &at;
  sample.X_WM = held.movedFrame();
  sample.force_W = hand.force_W;
  for (const std::size_t i : hand.contacts) {
    const HeldPair& pair = held.pairs()[i];
    sample.touching.emplace_back(pathOf(cell_.find(pair.owner)->name, pair.moved_part),
                                 pathOf(cell_.find(pair.other)->name, pair.other_part));
  }
  return sample;
}

void TakeRecording::addHeld(const Hand& hand, bool by_hand) {
  const StylusGrip& grip = hand.grip;
  const workcell::EntityId id = grip.held() ? grip.held()->id() : grip.chosen();
  if (cell_.find(id) == nullptr) return;
  const EntityConfiguration at = grip.placement(id);
  if (grip.held()) return recorder_->take(sampleOf(hand, at), by_hand);
  const auto taken = HeldEntity::take(cell_.scene(), id, cell_.placements(), {grip.movedBy()}, cell_.configuration());
  if (!taken) return log_.notice(taken.error().text());
  TakeRecorder::Sample sample;
  sample.t = cell_.clock().sinceStart();
  sample.moved_by = grip.movedBy();
  sample.entity = cell_.find(id);
  sample.at = &at;
  sample.X_WM = (*taken)->movedFrame();
  recorder_->take(sample, by_hand);
}

void TakeRecording::addOther(const Hand& other, const StylusGrip& first) {
  if (!recorder_ || cell_.clock().steps() == 0) return;
  const EntityConfiguration at = other.grip.held()->standing();
  const TakeRecorder::Sample sample = sampleOf(other, at);
  if (first.holds(sample.entity->id)) return recorder_->touch(sample);
  recorder_->take(sample, marked_ns_ == cell_.clock().now());
}

/// What no stylus holds.
void TakeRecording::addBeside(workcell::EntityId id, bool by_hand) {
  const EntityConfiguration at = cell_.placement(id);
  TakeRecorder::Sample sample;
  sample.t = cell_.clock().sinceStart();
  sample.entity = cell_.find(id);
  sample.at = &at;
  sample.X_WM = at.X_WE;
  sample.moved_by = wholeOf(*sample.entity);
  recorder_->take(sample, by_hand);
}

void TakeRecording::step(const Hand& hand, const HeldEntity* posed, const ScriptedEntities& scripted) {
  const bool by_hand = std::exchange(mark_wanted_, false);
  if (!recorder_ || !cell_.scene()) return;
  if (by_hand) marked_ns_ = cell_.clock().now();
  if (hand.grip.held() || by_hand) addHeld(hand, by_hand);
  if (posed) addBeside(posed->id(), by_hand);
  for (const auto& [id, on_its_way] : scripted.onTheirWay()) {
    if (cell_.find(id) != nullptr && !hand.grip.holds(id)) addBeside(id, by_hand);
  }
}

SceneSnapshot::Recording TakeRecording::shown() const {
  if (!recorder_) return {};
  const double now = cell_.clock().sinceStart();
  return {true, recorder_->seconds(now), recorder_->frames(), recorder_->framesByHand()};
}

}  // namespace hapticell::manipulation
