// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "config/configuration.h"
#include "haptic/transport/haptic_link.h"
#include "manipulation/holding/contact_search.h"
#include "manipulation/holding/held_entity.h"
#include "manipulation/engine/manipulation_command.h"
#include "manipulation/holding/motion_mapping.h"
#include "manipulation/scene/prepared_scene.h"
#include "manipulation/engine/scene_snapshot.h"
#include "manipulation/engine/take_recorder.h"

namespace hapticell::manipulation {

/// One step of the manipulation loop, without a thread or a clock of its own.
///
/// Newest stylus and proxy -> mapping -> manipulator -> exact motion check -> accept, stop or slide -> constraint set
/// about the accepted pose -> server. Driven by ManipulationLoop in real time and by a session in virtual time. One
/// thread.
class ManipulationEngine {
 public:
  /// `link` must outlive the engine.
  ManipulationEngine(haptic::HapticLink& link, const config::Configuration& configuration);

  /// From now on contacts are looked for in a thread of their own: a step never waits for them, the last set is held
  /// meanwhile. Without it every step does all that it needs, so that the same inputs give the same steps.
  void searchInThread();

  /// The scene that counts from now on. What is held goes on being held if it still exists.
  void setScene(std::shared_ptr<const PreparedScene> scene);
  /// Takes a command; SetDocument prepares its meshes at once (ManipulationLoop does that beforehand).
  void apply(const Command& command);
  /// One step at `now_ns` of a steady clock that never goes back.
  void step(std::int64_t now_ns);

  /// What `other` holds in the same scene counts here where it stands now: as something in the way, or, where both hold
  /// the same mannequin, as the other hand's doing, which goes as far as this one's exact check finds it free. What it
  /// holds is not taken here but for a mannequin's other hand; where both have it, this one lets go and says so. A take
  /// that is recorded here has it too.
  void takeOver(const ManipulationEngine& other);

  /// The joints that a glove poses at `other` are posed here while this one holds them alone.
  void borrowPose(const ManipulationEngine& other);

  /// While `other` records with frames marked by the button, this one's second button marks too, and is no clutch.
  void marksFor(const ManipulationEngine& other) { marks_for_other_ = other.recorder_ && other.mark_by_button_; }
  /// True once for each time that its button has marked a frame of the other's recording.
  bool takeMarkForOther() { return std::exchange(mark_for_other_, false); }

  /// What happened since the last call, in order.
  std::vector<Result> takeResults();

  const PreparedScene* scene() const { return scene_.get(); }
  const std::shared_ptr<const PreparedScene>& sharedScene() const { return scene_; }
  const HeldEntity* held() const { return held_.get(); }
  /// Where an entity stands now, moved or not. It exists (contract).
  EntityConfiguration placement(workcell::EntityId entity) const;
  const std::optional<haptic::HapticState>& hapticState() const { return state_; }

  const haptic::ServerStatistics& serverStatistics() const { return statistics_; }

  /// Nothing is held, posed, recorded or on its way, and forces are off: all there is to do is to watch the stylus.
  bool isIdle() const;

  /// Sequence of the newest set that was sent; 0 before the first.
  std::uint64_t sentSet() const { return sequence_; }

  /// Pairs of what is held that are at their boundary now: indices into held()->pairs().
  const std::vector<std::size_t>& contacts() const { return contacts_; }
  /// When the newest of them was felt first, by now_ns's clock; 0 before any.
  std::int64_t feltAt() const { return felt_ns_; }

  /// Limits of what is held that are near, nearest first, and what else holds it back: why it does not follow.
  std::vector<LimitState> nearLimits() const;

  /// The picture of the newest step, made here (distances are measured for it at most 30 times a second).
  void fillSnapshot(SceneSnapshot& snapshot);

 private:
  void startRecording(const command::StartRecording& wanted);
  void stopRecording();
  void recordStep();
  void recordHeld(bool by_hand);
  void recordOther(const ManipulationEngine& other);
  void recordPosed(bool by_hand);
  TakeRecorder::Sample heldSample(const EntityConfiguration& at) const;
  void fillRecording(SceneSnapshot& snapshot) const;
  void takeState();
  void watchButtons();
  void grab(workcell::EntityId wanted);
  std::string heldElsewhere(workcell::EntityId wanted) const;
  bool standsOn(workcell::EntityId entity, workcell::EntityId below) const;
  void release();
  void hold(workcell::EntityId entity);
  void retake();
  void anchorMapping();
  void updateLoad();
  void updateMapping();
  void setClutched(bool clutched);
  double scaleInForce() const;
  workcell::EntityId entityAtTip() const;
  void updateSet();
  void wishZone(HeldEntity::SetWish& wish);
  bool needsSet() const;
  bool holdsStill() const;
  void addLagRow();
  void driftAtEdge();
  void moveScripted();
  void addVelocities();
  void addGuideRows();
  void makeRoom(std::size_t rows);
  void slaveSet(const Pose& X_WM0);
  double guidedTurnWithin(double radius) const;
  Pose onGuides(const Pose& X_DP) const;
  std::vector<const workcell::Guide*> guidesOfHeld() const;
  Pose movedFrameAtRest() const;
  double stepTime() const;
  void findContacts();
  void findPassed();
  std::int64_t stateTime() const;
  void tellWherePlain();
  void measureForDisplay(SceneSnapshot& snapshot);
  void describe(SceneSnapshot& snapshot) const;
  void wishSetForOthers();
  void placeOther(workcell::EntityId id, const EntityConfiguration& at);
  void poseJoints(const command::PoseJoints& wanted);
  bool yieldJoints();
  HeldEntity* poser(workcell::EntityId entity);
  void followPose();
  void addPosed(SceneSnapshot& snapshot);
  void notice(const std::string& sentence) { results_.emplace_back(result::Notice{sentence}); }

  haptic::HapticLink& link_;
  config::Configuration configuration_;
  std::shared_ptr<const PreparedScene> scene_;  // Shared with the thread that prepares the next one.
  Placements placements_;
  std::unique_ptr<ContactSearch> search_;  // Outlives what is held.
  std::unique_ptr<HeldEntity> held_;
  std::unique_ptr<HeldEntity> posed_;  // What a glove poses, unless it is what is held.
  std::optional<command::PoseJoints> wanted_pose_;
  std::int64_t posed_ns_ = -1'000'000'000;
  bool posed_moved_ = false;           // Since the take began.
  bool joints_move_ = false;           // Of what is held, by somebody else.
  workcell::EntityId other_held_ = 0;  // By the other stylus, and how.
  MovedBy other_moved_by_;

  std::optional<haptic::HapticState> state_;
  haptic::ServerStatistics statistics_;
  haptic::LinkState link_state_ = haptic::LinkState::kDisconnected;
  haptic::HapticControl control_;

  std::vector<workcell::Guide> guides_;
  /// Where a scripted entity is on its way: it waits where what is held cannot give way.
  struct OnItsWay {
    double t = 0.0;         ///< s of its script.
    dvec3 velocity_W{0.0};  ///< m/s.
  };
  std::map<workcell::EntityId, OnItsWay> scripted_;
  std::int64_t scripted_ns_ = -1;
  workcell::EntityId chosen_ = 0;
  MovedBy moved_by_;
  AxesChoice axes_;
  ScaleChoice scale_;
  command::SetCamera camera_;
  std::optional<workcell::OnContact> on_contact_;
  std::optional<workcell::ForceClass> force_class_;
  MotionMapping mapping_;
  bool clutched_ = false;
  bool clutch_command_ = false;
  bool stopped_ = false;
  int hurried_joint_ = -1;  ///< Goes as fast as it can, and there is way left; -1: none does.
  dvec3 drift_D_{0.0};      ///< m/s at which the mapping drifts at the edge of the workspace.
  std::int64_t drift_ns_ = 0;
  std::uint32_t last_buttons_ = 0;

  std::int64_t now_ns_ = 0;
  std::int64_t last_step_ns_ = 0;
  std::int64_t start_ns_ = -1;
  std::uint64_t step_ = 0;
  std::uint64_t sequence_ = 0;
  std::int64_t set_ns_ = 0;
  std::int64_t last_set_ns_ = 0;
  std::int64_t adopted_ns_ = 0;  ///< When the set was made that the newest state was rendered with.
  bool set_wanted_ = true;
  BuiltConstraints built_;
  std::deque<std::pair<std::uint64_t, std::int64_t>> on_their_way_;  ///< Sets not seen adopted: number, when made.
  double speed_ = 0.0;                                               ///< Of the hand lately, m/s.
  std::int64_t speed_ns_ = 0;
  Pose X_DSeen_;  ///< The stylus at the set before.
  Pose X_DLag_;   ///< Reference of the set before.
  std::vector<double> gaps_;
  std::vector<std::size_t> contacts_;
  std::int64_t felt_ns_ = 0;
  std::vector<Result> results_;
  std::set<std::string> told_;  ///< Notes on what was taken: each is told once.

  std::unique_ptr<TakeRecorder> recorder_;
  bool mark_by_button_ = false, mark_wanted_ = false;
  bool marks_for_other_ = false, mark_for_other_ = false;
  std::int64_t marked_ns_ = -1;  ///< The step that the newest mark belongs to.

  std::int64_t measured_ns_ = -1;
  std::vector<FreeMotion::PairDistance> near_;
  std::int64_t passed_ns_ = -1;
  std::vector<std::size_t> passed_;  // Pairs that pass through each other and touch; looked at now and then.
};

}  // namespace hapticell::manipulation
