// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "manipulation/manipulators/manipulator.h"
#include "mannequin/posture/posture.h"

namespace hapticell::manipulation {

/// Common base for all ways to drag a mannequin: its parts, their poses in a posture, and how far they move between two
/// postures. Part poses come from the figure's model (mannequin/shape/figure_model.h).
class MannequinBody : public Manipulator {
 public:
  /// A moved part: a link's own shape, or a part attached to the link (a part in the hand).
  struct Part {
    int link = 0;
    Pose X_LP;
  };

  /// `figure` and `model` belong together.
  MannequinBody(std::shared_ptr<const mannequin::Figure> figure, std::shared_ptr<const kinematics::RobotModel> model,
                std::vector<Part> parts);

  EntityConfiguration between(const EntityConfiguration& from, const EntityConfiguration& to, double s) const override;
  void partPoses(const EntityConfiguration& configuration, std::span<Pose> X_WP) const override;
  Pose partPose(const EntityConfiguration& configuration, std::size_t part) const override;
  void pathBounds(const EntityConfiguration& from, const EntityConfiguration& to, std::span<const PartSphere> spheres,
                  std::span<double> bounds) const override;
  void tightenOwnBounds(const EntityConfiguration& from, const EntityConfiguration& to,
                        std::span<const PartSphere> spheres, std::span<const OwnPair> pairs,
                        std::span<double> bounds) const override;
  double turnBound(const EntityConfiguration& from, const EntityConfiguration& to) const override;

 protected:
  /// Place of a part in the figure: the segment, and for a finger the number of bones before it.
  struct PartPlace {
    mannequin::Segment segment = mannequin::Segment::kPelvis;
    int phalanges = 0;
  };

  const mannequin::Figure& figure() const { return *figure_; }
  const std::vector<Part>& parts() const { return parts_; }
  const std::vector<PartPlace>& places() const { return places_; }
  mannequin::Posture postureOf(const EntityConfiguration& configuration) const;
  EntityConfiguration configurationOf(const mannequin::Posture& posture) const;

 private:
  std::shared_ptr<const mannequin::Figure> figure_;
  std::shared_ptr<const kinematics::RobotModel> model_;
  std::vector<Part> parts_;
  std::vector<PartPlace> places_;
};

}  // namespace hapticell::manipulation
