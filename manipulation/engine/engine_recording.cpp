// SPDX-License-Identifier: Apache-2.0
// What moves, recorded a step of the loop at a time: the part of ManipulationEngine that feeds the TakeRecorder.
#include <utility>

#include "manipulation/engine/manipulation_step.h"

namespace hapticell::manipulation {

namespace {

std::string nameOf(const std::string& entity, const std::string& part) {
  return part.empty() ? entity : entity + "/" + part;
}

}  // namespace

void ManipulationEngine::startRecording(const command::StartRecording& wanted) {
  stopRecording();
  recorder_ = std::make_unique<TakeRecorder>(wanted.options, wanted.take);
  mark_by_button_ = wanted.mark_by_button;
  mark_wanted_ = posed_moved_ = false;
}

void ManipulationEngine::stopRecording() {
  if (!recorder_) return;
  results_.emplace_back(result::Recorded{recorder_->finish()});
  recorder_.reset();
}

/// Of what is held, which stands at `at`; without a time.
TakeRecorder::Sample ManipulationEngine::heldSample(const EntityConfiguration& at) const {
  TakeRecorder::Sample sample;
  sample.moved_by = moved_by_;
  sample.entity = scene_->find(held_->id());
  sample.at = &at;
  sample.X_WM = held_->movedFrame();
  if (state_) sample.force_W = mapping_.axes() * state_->force_D;
  for (const std::size_t i : contacts_) {
    const HeldPair& pair = held_->pairs()[i];
    sample.touching.emplace_back(nameOf(scene_->find(pair.owner)->name, pair.moved_part),
                                 nameOf(scene_->find(pair.other)->name, pair.other_part));
  }
  return sample;
}

void ManipulationEngine::recordHeld(bool by_hand) {
  const workcell::EntityId id = held_ ? held_->id() : chosen_;
  if (scene_->find(id) == nullptr) return;
  const EntityConfiguration at = placement(id);
  TakeRecorder::Sample sample;
  if (held_) {
    sample = heldSample(at);
  } else {
    const auto taken = HeldEntity::take(scene_, id, placements_, {moved_by_}, configuration_);
    if (!taken) return notice(taken.error().message());
    sample.moved_by = moved_by_;
    sample.entity = scene_->find(id);
    sample.at = &at;
    sample.X_WM = (*taken)->movedFrame();
  }
  sample.t = 1e-9 * static_cast<double>(now_ns_ - start_ns_);
  recorder_->take(sample, by_hand);
}

/// What the other stylus moves; of a mannequin that both move, what its other hand touches.
void ManipulationEngine::recordOther(const ManipulationEngine& other) {
  if (!recorder_ || start_ns_ < 0) return;
  const EntityConfiguration at = other.held_->standing();
  TakeRecorder::Sample sample = other.heldSample(at);
  sample.t = 1e-9 * static_cast<double>(now_ns_ - start_ns_);
  if (held_ && held_->id() == sample.entity->id) return recorder_->touch(sample);
  recorder_->take(sample, marked_ns_ == now_ns_);
}

/// A hand that a glove poses and nobody holds.
void ManipulationEngine::recordPosed(bool by_hand) {
  if (!posed_ || !posed_moved_) return;
  const EntityConfiguration at = placement(posed_->id());
  TakeRecorder::Sample sample;
  sample.t = 1e-9 * static_cast<double>(now_ns_ - start_ns_);
  sample.entity = scene_->find(posed_->id());
  sample.at = &at;
  sample.X_WM = at.X_WE;
  sample.moved_by = sample.entity->figure ? MovedBy(by::Whole{}) : MovedBy(by::Base{});
  recorder_->take(sample, by_hand);
}

/// A mark is a frame of everything that moves.
void ManipulationEngine::recordStep() {
  const bool by_hand = std::exchange(mark_wanted_, false);
  if (!recorder_ || !scene_) return;
  if (by_hand) marked_ns_ = now_ns_;
  if (held_ || by_hand) recordHeld(by_hand);
  recordPosed(by_hand);
  for (const auto& [id, on_its_way] : scripted_) {
    const workcell::Entity* entity = scene_->find(id);
    if (entity == nullptr || (held_ && held_->id() == id)) continue;
    const EntityConfiguration at = placement(id);
    TakeRecorder::Sample sample;
    sample.t = 1e-9 * static_cast<double>(now_ns_ - start_ns_);
    sample.entity = entity;
    sample.at = &at;
    sample.X_WM = at.X_WE;
    sample.moved_by = entity->robot ? MovedBy(by::Base{}) : MovedBy(by::Origin{});
    recorder_->take(sample, by_hand);
  }
}

void ManipulationEngine::fillRecording(SceneSnapshot& snapshot) const {
  if (!recorder_) return;
  const double now = 1e-9 * static_cast<double>(now_ns_ - start_ns_);
  snapshot.recording = {true, recorder_->seconds(now), recorder_->frames(), recorder_->framesByHand()};
}

}  // namespace hapticell::manipulation
