// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "manipulation/manipulators/mannequin_body.h"

namespace hapticell::manipulation {

/// A mannequin dragged by its head: the moved frame is between the eyes with the head's axes (x ahead). Neck and,
/// unless locked, spine follow; pelvis and legs stay.
class MannequinHead final : public MannequinBody {
 public:
  MannequinHead(std::shared_ptr<const mannequin::Figure> figure, std::shared_ptr<const kinematics::RobotModel> model,
                bool trunk_locked, std::vector<Part> parts)
      : MannequinBody(std::move(figure), std::move(model), std::move(parts)), trunk_locked_(trunk_locked) {}

  Pose movedFrame(const EntityConfiguration& configuration) const override;
  EntityConfiguration propose(const EntityConfiguration& from, const Pose& X_WM, double duration_s) const override;
  std::vector<PartDifferential> differentiate(const EntityConfiguration& configuration) const override;
  std::vector<MotionLimit> limits(const EntityConfiguration& configuration, double zone, double lever) const override;

 private:
  bool trunk_locked_;
};

}  // namespace hapticell::manipulation
