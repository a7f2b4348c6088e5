// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>

#include "manipulation/holding/held_entity.h"

namespace hapticell::manipulation {

class PostureFinder;

/// Draws a mannequin by a hand, both hands or the head to where a mouse wants it, in short steps of the same held
/// entity that the stylus moves: nothing is entered, and limits, feet and balance hold. One thread at a time.
class FigureWay {
 public:
  /// How the moved frame turns on its way.
  enum class Turn {
    kAsWanted,        ///< As aim() says.
    kWithTheForearm,  ///< Of hands: wrists stay as they are bent, so that the arms find their way; only the place
                      ///< counts. Both hands turn as both forearms do in the mean. Of the head: as wanted.
  };
  /// Takes the mannequin as it stands in the scene. Errors: as HeldEntity::take(). Contract: it has a figure.
  static Expected<std::unique_ptr<FigureWay>> take(std::shared_ptr<const PreparedScene> scene,
                                                   workcell::EntityId entity, const HoldOptions& options, Turn turn,
                                                   const config::Configuration& configuration);

  /// Where the moved frame shall be, in the cell; the newest counts.
  void aim(const Pose& X_WM);
  /// What is asked while a way round is looked for, a second or two of work: true gives it up, as there is something
  /// newer to do. On the thread of follow().
  void setInterrupted(std::function<bool()> interrupted) { interrupted_ = std::move(interrupted); }

  /// How the way went.
  struct Reach {
    double short_m = 0.0;  ///< From the moved frame to where it was wanted.
    std::string obstacle;  ///< What it would touch; empty: nothing is in the way.
    Pose X_WM;             ///< Where the moved frame is.
    bool arrived = false;  ///< It is there, or comes no nearer; else it is on its way.
  };
  /// A few steps straight towards the target. The way is the same however many places of the mouse were left out
  /// meanwhile. Where arms get stuck on it (at a limit, at the own body) they go round by a posture found anew; what
  /// another entity holds up stays held up. It ends where it came nearest.
  Reach follow();
  /// How the figure is to be shown now.
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
  std::array<bool, 2> turns_with_{};          ///< The left, the right forearm; neither: the target says how it turns.
  std::array<dquat, 2> forearms_at_start_{};  ///< In the cell.
  bool may_step_ = false;
  MotionMapping mapping_;
  Pose X_WTaken_, X_WTarget_;
  double nearest_yet_ = 1e9;  ///< m that was missing at the best,
  int idle_steps_ = 0;        ///< and since when it was not bettered.
  int rounds_left_ = 0;
  double least_missing_ = 1e9;  ///< m that was missing of this target at the least,
  EntityConfiguration best_;    ///< and how it stood there.
  bool is_at_best_ = false;     ///< It went back to that, and is done.
  std::function<bool()> interrupted_;
  EntityConfiguration shown_;
  std::vector<EntityConfiguration> round_;  ///< What is to be shown yet of a way round, the last first.
};

}  // namespace hapticell::manipulation
