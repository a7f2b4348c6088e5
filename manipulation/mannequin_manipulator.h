// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "manipulation/manipulator.h"
#include "mannequin/posture_solver.h"

namespace hapticell::manipulation {

/// A mannequin drawn by a hand, or by what both hands hold: the arms, the trunk and the legs follow, feet standing.
///
/// The moved frame is the grip of the hand, or the middle between both hands. Part poses come from the figure's model
/// (mannequin/figure_model.h). Its reach is felt as a limit: how far the figure could follow outward is asked of the
/// solver.
class MannequinManipulator final : public Manipulator {
 public:
  enum class Hands { kLeft, kRight, kBoth };
  struct Locks {
    bool trunk = false;
    bool pelvis = false;
  };

  /// A moved part: a link's own shape, or what hangs on the link (a part in the hand).
  struct Part {
    int link = 0;
    Pose X_LP;
  };

  /// `figure` and `model` belong together. `taken` is how the figure stands when it is taken: that is how both hands go
  /// on holding.
  MannequinManipulator(std::shared_ptr<const mannequin::Figure> figure,
                       std::shared_ptr<const kinematics::RobotModel> model, Hands hands, const Locks& locks,
                       const EntityConfiguration& taken, std::vector<Part> parts);

  Pose movedFrame(const EntityConfiguration& configuration) const override;
  EntityConfiguration propose(const EntityConfiguration& from, const Pose& X_WM, double duration_s) const override;
  EntityConfiguration between(const EntityConfiguration& from, const EntityConfiguration& to, double s) const override;
  void partPoses(const EntityConfiguration& configuration, std::span<Pose> X_WP) const override;
  void pathBounds(const EntityConfiguration& from, const EntityConfiguration& to, std::span<const PartSphere> spheres,
                  std::span<double> bounds) const override;
  double turnBound(const EntityConfiguration& from, const EntityConfiguration& to) const override;
  std::vector<PartDifferential> differentiate(const EntityConfiguration& configuration) const override;
  std::vector<MotionLimit> limits(const EntityConfiguration& configuration, double zone, double lever) const override;

 private:
  /// Where a part hangs in the figure: the segment, and for a finger how many of its bones come before.
  struct PartPlace {
    mannequin::Segment segment = mannequin::Segment::kPelvis;
    int phalanges = 0;
  };

  mannequin::Posture postureOf(const EntityConfiguration& configuration) const;
  EntityConfiguration configurationOf(const mannequin::Posture& posture) const;
  mannequin::PostureTask taskFor(const Pose& X_WM) const;
  mannequin::Side driven() const;

  std::shared_ptr<const mannequin::Figure> figure_;
  std::shared_ptr<const kinematics::RobotModel> model_;
  mannequin::PostureSolver solver_;
  Hands hands_;
  Locks locks_;
  std::array<Pose, 2> X_MH_;  ///< Left and right hand in the moved frame.
  std::array<Pose, 2> X_WF_;  ///< Where the feet stand.
  std::vector<Part> parts_;
  std::vector<PartPlace> places_;
};

}  // namespace hapticell::manipulation
