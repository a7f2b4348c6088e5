// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/model/turns.h"

namespace hapticell::kinematics {

/// All numbers from `low` to `high`: what a quantity can be while another one goes through a range. Rounding is not
/// directed: whoever proves something with it keeps a reserve far above 1e-15.
struct Span {
  double low = 0.0, high = 0.0;

  Span() = default;
  Span(double value) : low(value), high(value) {}  // NOLINT(google-explicit-constructor): numbers stand for themselves
  Span(double from, double to) : low(from), high(to) {}
  double width() const { return high - low; }
  bool has(double value) const { return low <= value && value <= high; }
  Span wider(double by) const { return {low - by, high + by}; }
};

inline Span operator+(const Span& a, const Span& b) {
  return {a.low + b.low, a.high + b.high};
}
inline Span operator-(const Span& a) {
  return {-a.high, -a.low};
}
inline Span operator-(const Span& a, const Span& b) {
  return {a.low - b.high, a.high - b.low};
}
inline Span operator*(const Span& a, const Span& b) {
  const double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
  return {std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s))};
}
/// `b` does not have 0.
inline Span operator/(const Span& a, const Span& b) {
  return a * Span(1.0 / b.high, 1.0 / b.low);
}
inline Span squared(const Span& a) {
  const double p = a.low * a.low, q = a.high * a.high;
  return {a.has(0.0) ? 0.0 : std::min(p, q), std::max(p, q)};
}
/// Negative numbers count as 0.
inline Span squareRoot(const Span& a) {
  return {std::sqrt(std::max(a.low, 0.0)), std::sqrt(std::max(a.high, 0.0))};
}
/// Of angles, rad.
inline Span cosine(const Span& a) {
  if (a.width() >= kTurn) return {-1.0, 1.0};
  const double p = std::cos(a.low), q = std::cos(a.high);
  const auto passes = [&](double peak) {
    return std::floor((a.high - peak) / kTurn) >= std::ceil((a.low - peak) / kTurn);
  };
  return {passes(std::numbers::pi) ? -1.0 : std::min(p, q), passes(0.0) ? 1.0 : std::max(p, q)};
}
inline Span sine(const Span& a) {
  return cosine(a - Span(0.5 * std::numbers::pi));
}
/// What lies outside -1 to 1 counts as the end there.
inline Span arcCosine(const Span& a) {
  return {std::acos(std::clamp(a.high, -1.0, 1.0)), std::acos(std::clamp(a.low, -1.0, 1.0))};
}
inline Span arcSine(const Span& a) {
  return {std::asin(std::clamp(a.low, -1.0, 1.0)), std::asin(std::clamp(a.high, -1.0, 1.0))};
}
/// Of y over x, continuous over the box: beyond pi where that reaches across the half line of x < 0. All angles if the
/// box has the origin.
inline Span angleOf(const Span& y, const Span& x) {
  if (y.has(0.0) && x.low <= 0.0) {
    if (x.high >= 0.0) return {-std::numbers::pi, std::numbers::pi};
    // Seen from behind, where nothing jumps.
    const Span behind = angleOf(-y, -x);
    return behind + Span(std::numbers::pi);
  }
  const double a = std::atan2(y.low, x.low), b = std::atan2(y.low, x.high), c = std::atan2(y.high, x.low),
               d = std::atan2(y.high, x.high);
  return {std::min(std::min(a, b), std::min(c, d)), std::max(std::max(a, b), std::max(c, d))};
}

}  // namespace hapticell::kinematics
