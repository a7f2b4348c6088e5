// SPDX-License-Identifier: Apache-2.0
#include "kinematics/closed_form/spherical_arm.h"

#include <algorithm>
#include <cmath>

#include "kinematics/closed_form/trigonometric_roots.h"

namespace hapticell::kinematics {

namespace {

// Sine below which axes 1 and 2 are parallel: the divisions by it then lose half the digits. Half, twice: no file is
// between, their rounding is 1e-10 or they are not parallel.
constexpr double kParallel = 1e-9;
// m: axes 1 and 2 intersect below it; rounding of files is 1e-10. Half: a rounded file is solved by the quartic, ill
// conditioned; twice: an offset of 2e-9 m is ignored, the polish makes up for it.
constexpr double kMeeting = 1e-9;
// Sine or distance (m) that says nothing of an angle; as kFree of opw_lanes.h, where half and twice are given.
constexpr double kFree = 5e-13;
// How far a square root's argument may be negative by rounding; more than in opw_lanes.h, as the root of a quartic
// comes before it. Half: a stretched wrist may be lost; twice: one more candidate, that the check refuses.
constexpr double kStretched = 1e-9;

/// a turned about the unit vector z by the angle of (c, s).
dvec3 turned(const dvec3& a, const dvec3& z, double c, double s) {
  return c * a + s * glm::cross(z, a) + (1.0 - c) * glm::dot(z, a) * z;
}

double angleAbout(const dvec3& z, const dvec3& from, const dvec3& to) {
  return std::atan2(glm::dot(z, glm::cross(from, to)), glm::dot(from, to) - glm::dot(from, z) * glm::dot(to, z));
}

dvec3 anySquareTo(const dvec3& z) {
  const dvec3 other = std::abs(z.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
  return glm::normalize(other - glm::dot(other, z) * z);
}

/// e_1(q_1) .. e_6(q_6) = N with rotations e_i about axes given at zero, of which the last three meet.
class SphericalArm final : public ClosedForm {
 public:
  SphericalArm(const ArmAxes& axes, bool from_base) : from_base_(from_base), R_home_(axes.R_BT), p_home_(axes.p_BT) {
    for (std::size_t i = 0; i < 6; ++i) {
      const std::size_t from = from_base ? 5 - i : i;
      z_[i] = axes.axis_B[from];
      o_[i] = axes.origin_B[from];
    }
    wrist_ = from_base ? nearestPoint(axes, 0, 1) : nearestPoint(axes, 3, 4);
    setPositionPart();
    setWristPart();
  }

  void solve(const dmat3& R_BT, const dvec3& p_BT, double, const double* previous,
             kernels::Solutions& solutions) const override;

 private:
  bool from_base_;
  dmat3 R_home_;
  dvec3 p_home_;
  std::array<dvec3, 6> z_, o_;
  dvec3 wrist_{0.0};
  // Axis 2's frame: n along the common normal from axis 1 to axis 2, m = z2 x n; heights and offsets in it.
  dvec3 foot_1_{0.0}, foot_2_{0.0}, n_{0.0}, m_{0.0};
  double a1_ = 0.0, cos_12_ = 1.0, sin_12_ = 0.0;
  // The wrist in axis 2's frame as a circle: middle + cos U + sin V.
  dvec3 middle_{0.0}, U_{0.0}, V_{0.0};
  double theta_5_middle_ = 0.0, below_offset_ = 0.0, above_offset_ = 0.0;
  dvec3 reference_{0.0};

  void setPositionPart();
  void setWristPart();
  int thirdJoint(double height, double squared, std::array<double, 4>& theta_3) const;
  int wristAngles(const dmat3& R_36, const double* previous, double (*angles)[3]) const;
};

void SphericalArm::setPositionPart() {
  const dvec3 normal = glm::cross(z_[0], z_[1]);
  sin_12_ = glm::length(normal);
  const dvec3 between = o_[1] - o_[0];
  foot_2_ = o_[1];
  if (sin_12_ < kParallel) {
    sin_12_ = 0.0;
    foot_1_ = o_[0] + glm::dot(between, z_[0]) * z_[0];
    a1_ = glm::length(foot_2_ - foot_1_);
    n_ = a1_ > kMeeting ? (foot_2_ - foot_1_) / a1_ : anySquareTo(z_[0]);
  } else {
    const double squared = sin_12_ * sin_12_;
    foot_1_ = o_[0] + glm::dot(glm::cross(between, z_[1]), normal) / squared * z_[0];
    foot_2_ = o_[1] + glm::dot(glm::cross(between, z_[0]), normal) / squared * z_[1];
    n_ = normal / sin_12_;
    a1_ = glm::dot(foot_2_ - foot_1_, n_);
  }
  m_ = glm::cross(z_[1], n_);
  cos_12_ = glm::dot(z_[0], z_[1]);
  const double along_m = glm::dot(z_[0], m_);
  if (sin_12_ > 0.0) sin_12_ = along_m;
  const dvec3 axis_point = o_[2] + glm::dot(wrist_ - o_[2], z_[2]) * z_[2];
  const auto local = [&](const dvec3& v) { return dvec3(glm::dot(v, n_), glm::dot(v, m_), glm::dot(v, z_[1])); };
  middle_ = local(axis_point - foot_2_);
  U_ = local(wrist_ - axis_point);
  V_ = local(glm::cross(z_[2], wrist_ - axis_point));
}

void SphericalArm::setWristPart() {
  const double cos_45 = glm::dot(z_[3], z_[4]), cos_56 = glm::dot(z_[4], z_[5]);
  const double angle_45 = std::atan2(glm::length(glm::cross(z_[3], z_[4])), cos_45);
  const double angle_56 = std::atan2(glm::length(glm::cross(z_[4], z_[5])), cos_56);
  const double A = glm::dot(z_[3], z_[5]) - cos_45 * cos_56, B = glm::dot(z_[3], glm::cross(z_[4], z_[5]));
  theta_5_middle_ = std::atan2(B, A);
  const double s = std::sin(0.5 * (angle_45 - angle_56)), c = std::cos(0.5 * (angle_45 + angle_56));
  below_offset_ = 2.0 * s * s;
  above_offset_ = 2.0 * c * c;
  reference_ = anySquareTo(z_[5]);
}

// Height over axis 1's foot and squared distance from it fix joint 3.
int SphericalArm::thirdJoint(double height, double squared, std::array<double, 4>& theta_3) const {
  // Squared distance from axis 2's foot and height along axis 2, both constant + cos + sin.
  const double r0 = glm::dot(middle_, middle_) + glm::dot(U_, U_), rc = 2.0 * glm::dot(middle_, U_),
               rs = 2.0 * glm::dot(middle_, V_);
  const double h0 = middle_.z, hc = U_.z, hs = V_.z;
  if (std::abs(a1_) < kMeeting) return realRoots({r0 - squared, rc, rs, 0, 0}, theta_3);
  if (std::abs(sin_12_) < kParallel) return realRoots({h0 - cos_12_ * height, hc, hs, 0, 0}, theta_3);
  const double x0 = 0.5 * (squared - a1_ * a1_ - r0) / a1_, xc = -0.5 * rc / a1_, xs = -0.5 * rs / a1_;
  const double y0 = (height - cos_12_ * h0) / sin_12_, yc = -cos_12_ * hc / sin_12_, ys = -cos_12_ * hs / sin_12_;
  // x^2 + y^2 + h^2 - r = 0, products of (k + c cos + s sin) taken apart into cos 2t and sin 2t.
  TrigonometricPolynomial f{-r0, -rc, -rs, 0, 0};
  const auto addSquare = [&](double k, double c, double s) {
    f.constant += k * k + 0.5 * (c * c + s * s);
    f.cos1 += 2.0 * k * c;
    f.sin1 += 2.0 * k * s;
    f.cos2 += 0.5 * (c * c - s * s);
    f.sin2 += c * s;
  };
  addSquare(x0, xc, xs);
  addSquare(y0, yc, ys);
  addSquare(h0, hc, hs);
  return realRoots(f, theta_3);
}

int SphericalArm::wristAngles(const dmat3& R_36, const double* previous, double (*angles)[3]) const {
  const dvec3 target = R_36 * z_[5];
  const dvec3 less = z_[3] - target, more = z_[3] + target;
  // h - D and h + D of  D = z4 . target - cos cos = h cos(theta_5 - middle), without cancellation.
  const double below = 0.5 * glm::dot(less, less) - below_offset_;
  const double above = 0.5 * glm::dot(more, more) - above_offset_;
  const double product = below * above;
  if (product < -kStretched) return 0;
  const double swing = std::atan2(std::sqrt(std::max(product, 0.0)), 0.5 * (above - below));
  for (int k = 0; k < 2; ++k) {
    const double theta_5 = theta_5_middle_ + (k == 0 ? swing : -swing);
    const double c5 = std::cos(theta_5), s5 = std::sin(theta_5);
    const dvec3 z6 = turned(z_[5], z_[4], c5, s5);
    const bool free = glm::length(glm::cross(z_[3], target)) < kFree;
    const double theta_4 = free ? previous[3] : angleAbout(z_[3], z6, target);
    const dvec3 before = turned(R_36 * reference_, z_[3], std::cos(theta_4), -std::sin(theta_4));
    angles[k][0] = theta_4;
    angles[k][1] = theta_5;
    angles[k][2] = angleAbout(z_[5], reference_, turned(before, z_[4], c5, -s5));
  }
  return 2;
}

void SphericalArm::solve(const dmat3& R_BT, const dvec3& p_BT, double, const double* previous,
                         kernels::Solutions& solutions) const {
  solutions.valid = 0;
  double before[6];
  for (std::size_t i = 0; i < 6; ++i) before[i] = from_base_ ? -previous[5 - i] : previous[i];
  dmat3 R = R_BT * glm::transpose(R_home_);
  dvec3 p = p_BT - R * p_home_;
  if (from_base_) {
    // N = X_home X_BT^-1 in place of X_BT X_home^-1
    R = R_home_ * glm::transpose(R_BT);
    p = p_home_ - R * p_BT;
  }
  const dvec3 W = R * wrist_ + p - foot_1_;
  const double height = glm::dot(W, z_[0]);
  std::array<double, 4> theta_3{};
  const int count = thirdJoint(height, glm::dot(W, W), theta_3);
  int slot = 0;
  const auto put = [&](double t1, double t2, double t3) {
    // R_36 = e_3^-1 e_2^-1 e_1^-1 N, column by column.
    const double c[3] = {std::cos(t1), std::cos(t2), std::cos(t3)}, s[3] = {std::sin(t1), std::sin(t2), std::sin(t3)};
    dmat3 R_36 = R;
    for (int column = 0; column < 3; ++column) {
      for (std::size_t i = 0; i < 3; ++i) R_36[column] = turned(R_36[column], z_[i], c[i], -s[i]);
    }
    double wrist[2][3];
    const int flips = wristAngles(R_36, before, wrist);
    for (int k = 0; k < flips && slot < kernels::kMaxSolutions; ++k, ++slot) {
      const double q[6] = {t1, t2, t3, wrist[k][0], wrist[k][1], wrist[k][2]};
      for (std::size_t i = 0; i < 6; ++i) solutions.q[from_base_ ? 5 - i : i][slot] = from_base_ ? -q[i] : q[i];
      solutions.valid |= 1u << slot;
    }
  };
  for (int i = 0; i < count; ++i) {
    const double t3 = theta_3[static_cast<std::size_t>(i)];
    const dvec3 v = middle_ + std::cos(t3) * U_ + std::sin(t3) * V_;
    const double flat = v.x * v.x + v.y * v.y, r = flat + v.z * v.z;
    const bool meeting = std::abs(a1_) < kMeeting, parallel = std::abs(sin_12_) < kParallel;
    double x = meeting ? 0.0 : 0.5 * (glm::dot(W, W) - a1_ * a1_ - r) / a1_;
    double y = parallel ? 0.0 : (height - cos_12_ * v.z) / sin_12_;
    const double other = flat - (meeting ? y * y : x * x);
    if ((meeting || parallel) && other < -kStretched) continue;
    for (int k = 0; k < (meeting || parallel ? 2 : 1); ++k) {
      const double root = (k == 0 ? 1.0 : -1.0) * std::sqrt(std::max(other, 0.0));
      if (meeting) x = root;
      if (parallel) y = root;
      const double t2 = flat < kFree * kFree ? before[1] : std::atan2(v.x * y - v.y * x, v.x * x + v.y * y);
      const dvec3 u = foot_2_ - foot_1_ + x * n_ + y * m_ + v.z * z_[1];
      const dvec3 off_u = glm::cross(z_[0], u);
      const double t1 = glm::dot(off_u, off_u) < kFree * kFree ? before[0] : angleAbout(z_[0], u, W);
      put(t1, t2, t3);
    }
  }
}

}  // namespace

std::unique_ptr<const ClosedForm> makeSphericalArm(const ArmAxes& axes, bool from_base) {
  return std::make_unique<SphericalArm>(axes, from_base);
}

}  // namespace hapticell::kinematics
