// SPDX-License-Identifier: Apache-2.0
#include "kinematics/closed_form/offset_wrist.h"

#include "kinematics/closed_form/opw_geometry.h"

namespace hapticell::kinematics {

namespace {

void put(const dvec3& from, double* to) {
  for (int i = 0; i < 3; ++i) to[i] = from[i];
}

class OffsetWrist final : public ClosedForm {
 public:
  explicit OffsetWrist(const ArmAxes& axes) {
    const OpwGeometry geometry(axes);
    arm_.arm = geometry.arm;
    arm_.arm.map.offset[4] = 0.0;
    R_0B_ = glm::transpose(geometry.R_B0);
    p_B0_ = geometry.p_B0;
    const dmat3 R_TB = glm::transpose(axes.R_BT);
    const dvec3& a = axes.axis_B[5];
    const dvec3 foot = axes.origin_B[5] + glm::dot(geometry.wrist_B - axes.origin_B[5], a) * a;
    axis_T_ = R_TB * a;
    foot_T_ = R_TB * (foot - axes.p_BT);
    from_foot_T_ = R_TB * (geometry.wrist_B - foot);
    R_T5_ = R_TB * geometry.R_B4;
  }
  int groups() const override { return 4; }
  void solve(const dmat3& R_BT, const dvec3& p_BT, double, const double* /*previous*/,
             kernels::Solutions& solutions) const override {
    const dmat3 R_0T = R_0B_ * R_BT;
    kernels::OffsetArm arm = arm_;
    // Seen from the tip, what is before joint 6 turns by -q_6.
    const auto turn = [&](const dvec3& v_T, const dvec3& middle_0, kernels::Circle& circle) {
      const dvec3 along = glm::dot(axis_T_, v_T) * axis_T_;
      put(middle_0 + R_0T * along, circle.middle);
      put(R_0T * (v_T - along), circle.cosine);
      put(R_0T * glm::cross(v_T, axis_T_), circle.sine);
    };
    turn(from_foot_T_, R_0B_ * (p_BT - p_B0_) + R_0T * foot_T_, arm.wrist);
    turn(R_T5_[0], dvec3(0.0), arm.across_5);
    turn(R_T5_[1], dvec3(0.0), arm.axis_5);
    turn(R_T5_[2], dvec3(0.0), arm.along_5);
    kernels::table().offsetWrist(arm, solutions);
  }

 private:
  kernels::OffsetArm arm_{};
  dmat3 R_0B_{1.0}, R_T5_{1.0};
  dvec3 p_B0_{0.0}, axis_T_{0.0}, foot_T_{0.0}, from_foot_T_{0.0};
};

}  // namespace

std::unique_ptr<const ClosedForm> makeOffsetWrist(const ArmAxes& axes) {
  return std::make_unique<OffsetWrist>(axes);
}

}  // namespace hapticell::kinematics
