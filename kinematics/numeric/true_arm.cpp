// SPDX-License-Identifier: Apache-2.0
#include "kinematics/numeric/true_arm.h"

#include <algorithm>
#include <cmath>

namespace hapticell::kinematics {

bool fitsTrueArm(const Chain& chain, std::size_t slides) {
  const auto& elements = chain.elements();
  if (elements.size() != chain.size() || chain.size() > slides + kernels::kMaxJoints) return false;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (elements[i].variable != static_cast<int>(i) || elements[i].factor != 1.0 || elements[i].offset != 0.0) {
      return false;
    }
  }
  return true;
}

kernels::TrueArm trueArm(const Chain& chain, std::size_t slides) {
  kernels::TrueArm arm;
  const auto put = [](const dmat3& R, const dvec3& p, double* R_rows, double* p_out) {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) R_rows[3 * row + column] = R[column][row];
      p_out[row] = p[row];
    }
  };
  dmat3 before(1.0);  // takes the frame with z along the last axis to that joint's own
  dvec3 p(0.0);
  dmat3 R(1.0);
  for (std::size_t i = 0; i < chain.elements().size(); ++i) {
    const Chain::Element& element = chain.elements()[i];
    p += R * (before * element.p_PJ);
    R = R * before * element.R_PJ;
    before = dmat3(1.0);
    if (i < slides) continue;
    const dvec3 z = element.axis_J, other = std::abs(z.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
    const dvec3 x = glm::normalize(other - glm::dot(other, z) * z);
    const dmat3 A(x, glm::cross(z, x), z);
    const auto joint = static_cast<std::size_t>(arm.joints++);
    arm.slides[joint] = element.prismatic;
    put(R * A, p, arm.R[joint], arm.p[joint]);
    R = dmat3(1.0);
    p = dvec3(0.0);
    before = glm::transpose(A);
  }
  put(before * chain.R_LT(), before * chain.p_LT(), arm.R_tip, arm.p_tip);
  arm.scale = 3.0 / std::max(chain.scale(), 1e-3);
  return arm;
}

}  // namespace hapticell::kinematics
