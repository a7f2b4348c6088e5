// SPDX-License-Identifier: Apache-2.0
#include "kinematics/closed_form/scara.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace hapticell::kinematics {

namespace {

using Planar = std::complex<double>;
// Rounding allowed in 1 - cosine^2 of the elbow, as kStretched of opw_lanes.h. Half: a stretched arm may be refused;
// twice: poses out of reach by one more 1e-12 are taken as stretched; the check on the chain decides.
constexpr double kStretchedScara = 1e-12;

class Scara final : public ClosedForm {
 public:
  explicit Scara(const ArmAxes& axes) : R_home_(axes.R_BT), p_home_(axes.p_BT) {
    // Rails in front belong to the arm: the slide may be its first joint.
    std::array<dvec3, 4> axis, origin;
    std::array<bool, 4> slides{};
    for (std::size_t i = 0; i < 4; ++i) {
      const bool rail = i < axes.rails;
      axis[i] = rail ? axes.rail_B[i] : axes.axis_B[i - axes.rails];
      origin[i] = rail ? dvec3(0.0) : axes.origin_B[i - axes.rails];
      slides[i] = rail || axes.prismatic[i - axes.rails];
    }
    std::size_t count = 0;
    std::array<dvec3, 3> at;
    for (std::size_t i = 0; i < 4; ++i) {
      if (slides[i]) {
        slide_ = i;
        continue;
      }
      if (count == 0) z_ = axis[i];
      sign_[count] = glm::dot(axis[i], z_) < 0.0 ? -1.0 : 1.0;
      at[count] = origin[i];
      turning_[count++] = i;
    }
    slide_sign_ = glm::dot(axis[slide_], z_) < 0.0 ? -1.0 : 1.0;
    const dvec3 other = std::abs(z_.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
    x_ = glm::normalize(other - glm::dot(other, z_) * z_);
    first_ = planar(at[0]);
    upper_ = planar(at[1]) - first_;
    fore_ = planar(at[2]) - planar(at[1]);
    hand_ = planar(p_home_) - planar(at[2]);
  }
  int groups() const override { return 1; }
  void solve(const dmat3& R_BT, const dvec3& p_BT, double, const double* previous,
             kernels::Solutions& solutions) const override {
    const dmat3 R = R_BT * glm::transpose(R_home_);
    const dvec3 turned = R * x_;
    const double phi = std::atan2(glm::dot(z_, glm::cross(x_, turned)), glm::dot(x_, turned));
    const Planar goal = planar(p_BT) - std::polar(1.0, phi) * hand_ - first_;
    // |upper + fore e^(i beta)| is known: fore / upper times e^(i beta) has this real part.
    const double product = 2.0 * std::abs(upper_) * std::abs(fore_);
    const double cosine = (std::norm(goal) - std::norm(upper_) - std::norm(fore_)) / product;
    const double squared = (1.0 - cosine) * (1.0 + cosine);
    solutions.valid = squared >= -kStretchedScara ? 3u : 0u;
    const double bend = std::atan2(std::sqrt(std::max(squared, 0.0)), cosine), straight = std::arg(upper_ / fore_);
    for (int k = 0; k < 4; ++k) {
      const double beta = straight + (k % 2 == 0 ? bend : -bend);
      const Planar reached = upper_ + std::polar(1.0, beta) * fore_;
      const bool free = std::abs(goal) < 1e-12 || std::abs(reached) < 1e-12;
      const double alpha = free ? sign_[0] * previous[turning_[0]] : std::arg(goal / reached);
      const std::array<double, 3> angles = {alpha, beta, phi - alpha - beta};
      for (std::size_t i = 0; i < 3; ++i) solutions.q[turning_[i]][k] = sign_[i] * angles[i];
      solutions.q[slide_][k] = slide_sign_ * glm::dot(p_BT - p_home_, z_);
    }
  }

 private:
  dmat3 R_home_;
  dvec3 p_home_;
  dvec3 x_{1, 0, 0}, z_{0, 0, 1};
  std::array<std::size_t, 3> turning_{};
  std::size_t slide_ = 0;
  std::array<double, 3> sign_{1.0, 1.0, 1.0};
  double slide_sign_ = 1.0;
  Planar first_, upper_, fore_, hand_;

  Planar planar(const dvec3& p) const { return {glm::dot(p, x_), glm::dot(p, glm::cross(z_, x_))}; }
};

}  // namespace

std::unique_ptr<const ClosedForm> makeScara(const ArmAxes& axes) {
  return std::make_unique<Scara>(axes);
}

}  // namespace hapticell::kinematics
