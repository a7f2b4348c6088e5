// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>

#include "manipulation/holding/held_entity.h"

namespace hapticell::manipulation {

class PostureFinder;

/// Drags a mannequin by a hand, both hands or the head to the mouse's target, in short steps with the same HeldEntity
/// as the stylus: it enters nothing and keeps limits, feet and balance. One thread at a time.
class FigureWay {
 public:
  /// How the moved frame rotates on the way.
  enum class Turn {
    kAsWanted,        ///< As the target of aim().
    kWithTheForearm,  ///< Hands: the wrists keep their angles, so only the position counts, and the arms can reach more
                      ///< targets. Both hands rotate with the mean of both forearms. Head: as kAsWanted.
  };
  /// Takes the mannequin in its present posture. Errors: as HeldEntity::take(). Contract: it has a figure.
  static Expected<std::unique_ptr<FigureWay>> take(std::shared_ptr<const PreparedScene> scene,
                                                   workcell::EntityId entity, const HoldOptions& options, Turn turn,
                                                   const config::Configuration& configuration);

  /// Sets the target of the moved frame, in the cell; the newest one counts.
  void aim(const Pose& X_WM);
  /// `interrupted` is called during the search for a detour, which takes a second or two; if it returns true, the
  /// search ends. Called in the thread of follow().
  void setInterrupted(std::function<bool()> interrupted) { interrupted_ = std::move(interrupted); }

  /// Result of a step.
  struct Reach {
    double short_m = 0.0;  ///< Distance from the moved frame to the target.
    std::string obstacle;  ///< What it would touch; empty: not blocked.
    Pose X_WM;             ///< Where the moved frame is.
    bool arrived = false;  ///< It has arrived or comes no nearer; else it is still moving.
  };
  /// Makes a few steps straight towards the target. The path does not depend on how many mouse positions were skipped.
  /// If the arms get stuck (at a limit, at the own body), they make a detour through a newly solved posture; if another
  /// entity blocks them, they stay blocked. It ends at the pose nearest to the target.
  Reach follow();
  /// The configuration to show now.
  const EntityConfiguration& stands() const { return shown_; }

 private:
  FigureWay() = default;
  double missing() const;
  Pose stride() const;
  Reach reachNow() const;
  Reach showRound();
  bool goRound();
  bool walkThere(const PostureFinder& hands);
  bool goBack();
  void keepBest();
  bool isInterrupted() const;
  bool goBy(const std::vector<EntityConfiguration>& stations);
  bool isHeldUpByOthers();
  std::string nearest();
  dquat forearmsTurn() const;
  std::array<dquat, 2> forearms() const;

  std::shared_ptr<const PreparedScene> scene_;
  std::unique_ptr<HeldEntity> held_;
  std::shared_ptr<const mannequin::Figure> figure_;
  std::array<bool, 2> turns_with_{};          ///< Left, right forearm; neither: the target defines the rotation.
  std::array<dquat, 2> forearms_at_start_{};  ///< Orientations in the cell.
  bool may_step_ = false;
  MotionMapping mapping_;
  Pose X_WTaken_, X_WTarget_;
  double nearest_yet_ = 1e9;  ///< Least distance so far, m,
  int idle_steps_ = 0;        ///< and steps without improvement since.
  int rounds_left_ = 0;
  double least_missing_ = 1e9;  ///< Least distance to this target, m,
  EntityConfiguration best_;    ///< and the configuration there.
  bool is_at_best_ = false;     ///< It has returned to that configuration and is done.
  std::function<bool()> interrupted_;
  EntityConfiguration shown_;
  std::vector<EntityConfiguration> round_;  ///< Remaining configurations of a detour to show, in reverse order.
};

}  // namespace hapticell::manipulation
