// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "manipulation/manipulators/mannequin_body.h"
#include "manipulation/manipulators/posture_finder.h"
#include "mannequin/posture/posture_solver.h"

namespace hapticell::manipulation {

/// A mannequin dragged by a hand, or by what both hands hold: the arms, the trunk and the legs follow; the feet stay,
/// or step if that is allowed.
///
/// The moved frame is the grip of the hand, or the middle between both hands. Its reach is felt as a limit: the solver
/// computes how far the figure could follow outward.
class MannequinManipulator final : public MannequinBody, public PostureFinder {
 public:
  enum class Hands {
    kLeft,
    kRight,
    kBoth,       ///< The part stays fixed in both hands.
    kBothApart,  ///< Each hand makes the same motion, rotating about its own grip.
  };
  struct Locks {
    bool trunk = false;
    bool pelvis = false;
    bool on_seat = false;   ///< The pelvis does not move, and the feet need not bear the body.
    bool may_step = false;  ///< The feet step if the hand's target is out of reach (mannequin_steps.h).
    bool in_air = false;    ///< Nothing bears the feet: no balance, no steps.
    std::array<mannequin::HandLoad, 2> loads{};  ///< Loads in the hands; their weight counts in the balance.
  };

  /// `figure` and `model` belong together. `taken` is the configuration when the figure is taken; both hands keep
  /// holding in the same way.
  MannequinManipulator(std::shared_ptr<const mannequin::Figure> figure,
                       std::shared_ptr<const kinematics::RobotModel> model, Hands hands, const Locks& locks,
                       const EntityConfiguration& taken, std::vector<Part> parts);

  Pose movedFrame(const EntityConfiguration& configuration) const override;
  EntityConfiguration propose(const EntityConfiguration& from, const Pose& X_WM, double duration_s) const override;
  std::vector<PartDifferential> differentiate(const EntityConfiguration& configuration) const override;
  std::vector<MotionLimit> limits(const EntityConfiguration& configuration, double zone, double lever) const override;

  const PostureFinder* postureFinder() const override { return this; }
  std::vector<EntityConfiguration> solvedFrom(const EntityConfiguration& from, const dvec3& p_WM, StartFrom anew,
                                              const std::function<bool()>& interrupted) const override;
  std::vector<EntityConfiguration> upright(const EntityConfiguration& from) const override;
  std::vector<EntityConfiguration> uprightBefore(const EntityConfiguration& from, const dvec3& p_WM) const override;
  dvec3 facing_W(const EntityConfiguration& configuration) const override;

 private:
  using Feet = std::array<Pose, 2>;
  Feet feetOf(const mannequin::Posture& posture) const;
  mannequin::Posture uprightOn(const Feet& feet, const char* posture) const;
  bool mayReach(const mannequin::Posture& upright, const dvec3& p_WM) const;
  mannequin::PostureTask taskFor(const Pose& X_WM, const Feet& X_WF) const;
  mannequin::Posture follow(const mannequin::PostureTask& task, mannequin::Posture posture, dvec3* missing) const;
  /// How far (m, at most `ahead`) the figure follows along `outward` from `posture`; empty if it follows all the way,
  /// or until the time limit.
  std::optional<double> reachAlong(const dvec3& outward, double ahead, mannequin::Posture posture,
                                   const Pose& X_WM) const;
  dvec3 wantedHand(const Pose& X_WM) const;
  dvec3 comfortableNear(const dvec3& seen) const;
  dvec3 beyondComfort(const Pose& X_WM, const Feet& X_WF) const;
  double mindingTheHand(double turn, const Pose& X_WM, const Feet& X_WF) const;
  double turnToFace(const Pose& X_WM, const Feet& X_WF) const;
  mannequin::Posture followStanding(const Pose& X_WM, const Feet& feet, const mannequin::Posture& posture) const;
  mannequin::Posture unwound(const mannequin::Posture& start, const Feet& feet) const;
  mannequin::Posture untwisted(const mannequin::Posture& posture, const Feet& feet) const;
  std::optional<mannequin::Posture> goTo(Feet stepped, const Feet& feet, const mannequin::Posture& posture,
                                         const Pose* X_WM) const;
  bool walksWell(const mannequin::Posture& posture, const Feet& feet) const;
  EntityConfiguration proposeStepping(const mannequin::Posture& from, const Pose& X_WM, double duration_s) const;
  double wishedTurn(const Pose& X_WM, const mannequin::Posture& posture, const Feet& X_WF) const;
  bool isBoth() const { return hands_ == Hands::kBoth || hands_ == Hands::kBothApart; }
  mannequin::Side driven() const;

  mannequin::PostureSolver solver_;
  Hands hands_;
  Locks locks_;
  std::array<Pose, 2> X_MH_;        ///< Left and right hand in the moved frame.
  std::array<dvec3, 2> p_MH_W_;     ///< The same positions in the axes of the cell, for hands that move separately.
  Feet X_WF_;                       ///< Poses of the feet.
  dquat q_WM_{1.0, 0.0, 0.0, 0.0};  ///< The moved frame as taken.
};

}  // namespace hapticell::manipulation
