// SPDX-License-Identifier: Apache-2.0
#include "kinematics/closures/hexapod.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hapticell::kinematics {

namespace {

using Row = std::array<double, 7>;  // Six coefficients and the right-hand side.
using System = std::array<Row, 6>;

/// Elimination with row pivots; the determinant, 0 where it is singular. The solution stands in the last column.
double eliminate(System& m) {
  double determinant = 1.0;
  for (std::size_t k = 0; k < 6; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < 6; ++i) {
      if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
    }
    if (pivot != k) {
      std::swap(m[pivot], m[k]);
      determinant = -determinant;
    }
    determinant *= m[k][k];
    if (!(std::abs(m[k][k]) > 1e-14)) return 0.0;
    const double inverse = 1.0 / m[k][k];
    for (std::size_t i = k + 1; i < 6; ++i) {
      const double factor = m[i][k] * inverse;
      for (std::size_t j = k + 1; j < 7; ++j) m[i][j] -= factor * m[k][j];
    }
  }
  for (std::size_t k = 6; k-- > 0;) {
    double sum = m[k][6];
    for (std::size_t j = k + 1; j < 6; ++j) sum -= m[k][j] * m[j][6];
    m[k][6] = sum / m[k][k];
  }
  return determinant;
}

/// R' = C(w) R for the rotation vector w of a step, by the Cayley map: orthonormal for any step.
dmat3 cayley(const dvec3& w) {
  const dvec3 h = 0.5 * w;
  const double s = 1.0 / (1.0 + glm::dot(h, h));
  const dmat3 cross(dvec3(0, h.z, -h.y), dvec3(-h.z, 0, h.x), dvec3(h.y, -h.x, 0));
  return dmat3(1.0) + 2.0 * s * (cross + cross * cross);
}

struct Legs {
  std::array<dvec3, 6> arm;        // R c
  std::array<dvec3, 6> direction;  // unit, base to platform
  std::array<double, 6> length;
};

void measure(const HexapodGeometry& geometry, const dmat3& R, const dvec3& p, Legs& legs) {
  for (std::size_t i = 0; i < 6; ++i) {
    legs.arm[i] = R * geometry.p_PC[i];
    const dvec3 leg = p + legs.arm[i] - geometry.p_BA[i];
    legs.length[i] = std::sqrt(glm::dot(leg, leg));
    legs.direction[i] = leg / legs.length[i];
  }
}

System systemOf(const Legs& legs, const LegLengths& wanted) {
  System m;
  for (std::size_t i = 0; i < 6; ++i) {
    const dvec3 u = legs.direction[i], c = glm::cross(legs.arm[i], u);
    m[i] = {u.x, u.y, u.z, c.x, c.y, c.z, wanted[i] - legs.length[i]};
  }
  return m;
}

}  // namespace

HexapodKinematics::HexapodKinematics(const HexapodGeometry& geometry) : geometry_(geometry) {
  double largest = 0.0;
  for (const dvec3& c : geometry.p_PC) largest = std::max(largest, glm::length(c));
  if (largest > 0.0) radius_ = largest;
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < 8; ++i) {
      hinges_.base[axis][i] = geometry.p_BA[std::min<std::size_t>(i, 5)][axis];
      hinges_.top[axis][i] = geometry.p_PC[std::min<std::size_t>(i, 5)][axis];
    }
  }
}

LegLengths HexapodKinematics::lengths(const dmat3& R, const dvec3& p) const {
  alignas(32) double all[8];
  const dmat3 rows = glm::transpose(R);
  kernels_->legLengths(hinges_, &rows[0][0], &p.x, all);
  LegLengths result{};
  std::copy_n(all, 6, result.begin());
  return result;
}

double HexapodKinematics::regularity(const Pose& X_BP) const {
  Legs legs;
  measure(geometry_, X_BP.R(), X_BP.p, legs);
  System m = systemOf(legs, legs.length);
  for (Row& row : m) {
    for (std::size_t j = 3; j < 6; ++j) row[j] /= radius_;
  }
  return eliminate(m);
}

HexapodCertificate HexapodKinematics::certify(const LegLengths& wanted, const Pose& X_BP) const {
  Legs legs;
  measure(geometry_, X_BP.R(), X_BP.p, legs);
  const System system = systemOf(legs, wanted);
  double squares = 0.0, step = 0.0;  // Of the inverse's entries, and of J^-1 f.
  for (std::size_t column = 0; column <= 6; ++column) {
    System m = system;
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 3; j < 6; ++j) m[i][j] /= radius_;
      if (column < 6) m[i][6] = i == column ? 1.0 : 0.0;
    }
    if (eliminate(m) == 0.0) return {};
    for (std::size_t i = 0; i < 6; ++i) (column < 6 ? squares : step) += m[i][6] * m[i][6];
  }
  const double beta = std::sqrt(squares), eta = std::sqrt(step);
  const double shortest = *std::min_element(legs.length.begin(), legs.length.end());
  const double curvature = std::sqrt(6.0) * (2.0 / (0.5 * shortest) + 1.0 / radius_);  // While legs stay over a half.
  const double h = beta * curvature * eta;
  if (!(h <= 0.5)) return {};
  const double root = std::sqrt(1.0 - 2.0 * h);
  HexapodCertificate certificate{true, 2.0 * eta / (1.0 + root), (1.0 + root) / (beta * curvature)};
  certificate.unique_within = std::min(certificate.unique_within, 0.5 * shortest / std::sqrt(2.0));
  return certificate;
}

HexapodForward HexapodKinematics::forward(const LegLengths& wanted, const Pose& X_BStart, int max_iterations) const {
  // m, largest error of a leg; some thousand roundings of a leg of 1 m. Half: the last step may be made for nothing;
  // twice: the same, Newton's error is squared by each step.
  constexpr double kDone = 1e-12;
  HexapodForward result;
  dmat3 R = X_BStart.R();
  dvec3 p = X_BStart.p;
  alignas(32) double legs[8], step[6];
  for (std::size_t i = 0; i < 8; ++i) legs[i] = wanted[std::min<std::size_t>(i, 5)];
  double determinant = 0.0, error = 0.0;
  for (;; ++result.iterations) {
    const dmat3 rows = glm::transpose(R);
    error = kernels_->hexapodStep(hinges_, &rows[0][0], &p.x, legs, step, &determinant);
    if (!(error >= kDone) || result.iterations >= max_iterations || determinant == 0.0) break;
    dvec3 v(step[0], step[1], step[2]), w(step[3], step[4], step[5]);
    // Newton's first steps may be far too long near a singular surface.
    const double length = std::max(glm::length(v), radius_ * glm::length(w));
    const double longest = 0.5 * (radius_ + legs[0]);
    if (length > longest) {
      v *= longest / length;
      w *= longest / length;
    }
    p += v;
    R = cayley(w) * R;
  }
  result.X_BP = {p, glm::normalize(glm::quat_cast(R))};
  result.converged = error < kDone;
  result.handedness = (determinant > 0.0 ? 1 : 0) - (determinant < 0.0 ? 1 : 0);
  return result;
}

}  // namespace hapticell::kinematics
