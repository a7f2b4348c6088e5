// SPDX-License-Identifier: Apache-2.0
#include "kinematics/closed_form/trigonometric_roots.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hapticell::kinematics {

namespace {

// Relative discriminant below which a complex pair of roots counts as a double one: rounding of 1e-16 is 1e-8 there, a
// thousand times that is allowed. Half: poses at a fold may be lost; twice: more candidates to refuse.
constexpr double kNearlyReal = 1e-5;

// The largest real root of x^3 + a x^2 + b x + c.
double largestCubicRoot(double a, double b, double c) {
  const double q = (a * a - 3.0 * b) / 9.0, r = (2.0 * a * a * a - 9.0 * a * b + 27.0 * c) / 54.0;
  double x;
  if (r * r < q * q * q) {
    const double angle = std::acos(std::clamp(r / std::sqrt(q * q * q), -1.0, 1.0));
    x = -2.0 * std::sqrt(q) * std::cos((angle + 2.0 * std::numbers::pi) / 3.0) - a / 3.0;
    x = std::max(x, -2.0 * std::sqrt(q) * std::cos((angle - 2.0 * std::numbers::pi) / 3.0) - a / 3.0);
  } else {
    const double s = -std::copysign(std::cbrt(std::abs(r) + std::sqrt(r * r - q * q * q)), r);
    x = s + (s == 0.0 ? 0.0 : q / s) - a / 3.0;
  }
  for (int i = 0; i < 2; ++i) {
    const double slope = (3.0 * x + 2.0 * a) * x + b;
    if (std::abs(slope) > 1e-12) x -= (((x + a) * x + b) * x + c) / slope;
  }
  return x;
}

// Real roots of x^2 + b x + c, or the middle of a pair that is complex by a little.
int quadraticRoots(double b, double c, double* roots) {
  const double discriminant = 0.25 * b * b - c;
  const double size = std::max({0.25 * b * b, std::abs(c), 1e-30});
  if (discriminant < -kNearlyReal * size) return 0;
  const double root = std::sqrt(std::max(discriminant, 0.0));
  const double far = b > 0.0 ? -0.5 * b - root : -0.5 * b + root;
  roots[0] = far;
  roots[1] = root == 0.0 || far == 0.0 ? -b - far : c / far;
  return 2;
}

// Ferrari: x^4 + b x^3 + c x^2 + d x + e as a product of two quadratics.
int quarticRoots(double b, double c, double d, double e, std::array<double, 4>& roots) {
  const double shift = 0.25 * b;
  const double P = c - 6.0 * shift * shift;
  const double Q = d - 2.0 * c * shift + 8.0 * shift * shift * shift;
  const double R = e - d * shift + c * shift * shift - 3.0 * shift * shift * shift * shift;
  const double m = std::max(0.0, largestCubicRoot(P, 0.25 * P * P - R, -0.125 * Q * Q));
  const double s = std::sqrt(2.0 * m);
  int count = 0;
  if (s > 1e-8) {
    count += quadraticRoots(s, 0.5 * P + m - 0.5 * Q / s, roots.data());
    count += quadraticRoots(-s, 0.5 * P + m + 0.5 * Q / s, roots.data() + count);
  } else {  // biquadratic
    std::array<double, 2> squares{};
    const int found = quadraticRoots(P, R, squares.data());
    for (int i = 0; i < found; ++i) {
      const double square = squares[static_cast<std::size_t>(i)];
      if (square < -kNearlyReal) continue;
      const double root = std::sqrt(std::max(square, 0.0));
      roots[static_cast<std::size_t>(count++)] = root;
      roots[static_cast<std::size_t>(count++)] = -root;
    }
  }
  for (int i = 0; i < count; ++i) roots[static_cast<std::size_t>(i)] -= shift;
  return count;
}

void polish(const TrigonometricPolynomial& f, double& t) {
  for (int i = 0; i < 3; ++i) {
    const double c = std::cos(t), s = std::sin(t), c2 = c * c - s * s, s2 = 2.0 * s * c;
    const double value = f.constant + f.cos1 * c + f.sin1 * s + f.cos2 * c2 + f.sin2 * s2;
    const double slope = -f.cos1 * s + f.sin1 * c + 2.0 * (f.sin2 * c2 - f.cos2 * s2);
    const double step = value / slope;
    if (!(std::abs(step) < 0.01)) return;
    t -= step;
    if (std::abs(step) < 1e-15) return;
  }
}

// constant + amplitude cos(t - phase)
int rootsOfOneWave(const TrigonometricPolynomial& f, std::array<double, 4>& roots) {
  const double amplitude = std::hypot(f.cos1, f.sin1);
  if (!(amplitude > 0.0)) return 0;
  const double squared = (amplitude - f.constant) * (amplitude + f.constant);
  if (squared < -1e-9 * amplitude * amplitude) return 0;
  const double phase = std::atan2(f.sin1, f.cos1);
  const double swing = std::atan2(std::sqrt(std::max(squared, 0.0)), -f.constant);
  roots[0] = std::remainder(phase + swing, 2.0 * std::numbers::pi);
  roots[1] = std::remainder(phase - swing, 2.0 * std::numbers::pi);
  return 2;
}

}  // namespace

double TrigonometricPolynomial::operator()(double t) const {
  return constant + cos1 * std::cos(t) + sin1 * std::sin(t) + cos2 * std::cos(2.0 * t) + sin2 * std::sin(2.0 * t);
}

int realRoots(const TrigonometricPolynomial& f, std::array<double, 4>& roots) {
  if (f.cos2 == 0.0 && f.sin2 == 0.0) return rootsOfOneWave(f, roots);
  // The leading coefficient of the quartic is f at the shift plus half a turn; five shifts, a fifth of a turn apart.
  constexpr double kCosines[] = {1.0, 0.30901699437494745, -0.8090169943749475, -0.8090169943749475,
                                 0.30901699437494745};
  constexpr double kSines[] = {0.0, 0.9510565162951535, 0.5877852522924731, -0.5877852522924731, -0.9510565162951535};
  double c = 1.0, s = 0.0, most = -1.0;
  for (int i = 0; i < 5; ++i) {
    const double ci = kCosines[i], si = kSines[i];
    const double size =
        std::abs(f.constant - f.cos1 * ci - f.sin1 * si + f.cos2 * (ci * ci - si * si) + f.sin2 * 2.0 * si * ci);
    if (size <= most) continue;
    most = size;
    c = ci;
    s = si;
  }
  if (!(most > 0.0)) return 0;
  const double shift = std::atan2(s, c), c2 = c * c - s * s, s2 = 2.0 * s * c;
  const double C1 = f.cos1 * c + f.sin1 * s, S1 = f.sin1 * c - f.cos1 * s;
  const double C2 = f.cos2 * c2 + f.sin2 * s2, S2 = f.sin2 * c2 - f.cos2 * s2;
  const double a4 = f.constant - C1 + C2, a3 = 2.0 * S1 - 4.0 * S2, a2 = 2.0 * f.constant - 6.0 * C2;
  const double a1 = 2.0 * S1 + 4.0 * S2, a0 = f.constant + C1 + C2;
  const int count = quarticRoots(a3 / a4, a2 / a4, a1 / a4, a0 / a4, roots);
  for (int i = 0; i < count; ++i) {
    double& root = roots[static_cast<std::size_t>(i)];
    root = std::remainder(2.0 * std::atan(root) + shift, 2.0 * std::numbers::pi);
    polish(f, root);
  }
  return count;
}

}  // namespace hapticell::kinematics
