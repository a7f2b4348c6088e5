// SPDX-License-Identifier: Apache-2.0
#include "mannequin/shape/section_tube.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/system/assertion.h"

namespace hapticell::mannequin {

namespace {

/// Distance of the section's curve from its centre in the direction (c, s).
double reachOf(const TubeSection& section, double c, double s) {
  const double deep = s >= 0.0 ? section.front : section.back;
  const double n = section.roundness;
  if (n < 2.0 + 1e-9) {
    const double x = c / section.half_breadth, y = s / deep;
    return 1.0 / std::sqrt(x * x + y * y);
  }
  return std::pow(std::pow(std::abs(c) / section.half_breadth, n) + std::pow(std::abs(s) / deep, n), -1.0 / n);
}

/// Slope at a knot of a curve through three values that does not overshoot (F. N. Fritsch and J. Butland, 1984).
double slopeAt(double before, double after) {
  if (before * after <= 0.0) return 0.0;
  return 2.0 * before * after / (before + after);
}

/// m from which on a cheap bound will do: nothing blends over so much (kShoulder is 0.060). Half: shoulders get a step;
/// twice: slower.
constexpr double kFar = 0.08;

constexpr double TubeSection::*kParameters[] = {&TubeSection::u,     &TubeSection::v,    &TubeSection::half_breadth,
                                                &TubeSection::front, &TubeSection::back, &TubeSection::roundness};

}  // namespace

double perimeterOf(const TubeSection& section) {
  // Of a perimeter; the sum of chords is too short by 3e-5. Half: by 1e-4; twice: by 7e-6. All far below a girth's
  // error.
  constexpr int kPieces = 240;
  double length = 0.0;
  glm::dvec2 last(0.0);
  for (int i = 0; i <= kPieces; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kPieces, c = std::cos(angle), s = std::sin(angle);
    const glm::dvec2 here = reachOf(section, c, s) * glm::dvec2(c, s);
    if (i > 0) length += glm::length(here - last);
    last = here;
  }
  return length;
}

TubeSection withGirth(TubeSection section, double girth) {
  double low = 1.9, high = 3.6;
  for (int i = 0; i < 24; ++i) {
    section.roundness = 0.5 * (low + high);
    (perimeterOf(section) < girth ? low : high) = section.roundness;
  }
  const double rest = girth / perimeterOf(section);
  section.half_breadth *= rest;
  section.front *= rest;
  section.back *= rest;
  return section;
}

TubeSection asBroadAs(TubeSection section, double girth) {
  double low = 0.25 * (section.front + section.back), high = 1.5 * (section.front + section.back);
  for (int i = 0; i < 24; ++i) {
    section.half_breadth = 0.5 * (low + high);
    (perimeterOf(section) < girth ? low : high) = section.half_breadth;
  }
  return section;
}

SectionTube::SectionTube(const dvec3& origin, const dvec3& axis, const dvec3& across, std::vector<TubeSection> sections)
    : origin_(origin), axis_(axis), u_(across), v_(glm::cross(axis, across)), sections_(std::move(sections)) {
  HAPTICELL_DEMAND(sections_.size() >= 2);
  for (const TubeSection& s : sections_)
    most_ = std::max(most_, std::max({s.half_breadth, s.front, s.back}) + std::hypot(s.u, s.v));
}

TubeSection SectionTube::at(double t) const {
  if (t <= sections_.front().t) return sections_.front();
  if (t >= sections_.back().t) return sections_.back();
  std::size_t i = 1;
  while (sections_[i].t < t) ++i;
  const TubeSection &a = sections_[i - 1], &b = sections_[i];
  const double width = b.t - a.t, x = (t - a.t) / width, x2 = x * x, x3 = x2 * x;
  TubeSection section;
  section.t = t;
  for (const auto member : kParameters) {
    const double slope = (b.*member - a.*member) / width;
    double at_a = 0.0, at_b = 0.0;
    if (i > 1) at_a = slopeAt((a.*member - sections_[i - 2].*member) / (a.t - sections_[i - 2].t), slope);
    if (i + 1 < sections_.size())
      at_b = slopeAt(slope, (sections_[i + 1].*member - b.*member) / (sections_[i + 1].t - b.t));
    section.*member = (2 * x3 - 3 * x2 + 1) * (a.*member) + (x3 - 2 * x2 + x) * width * at_a +
                      (3 * x2 - 2 * x3) * (b.*member) + (x3 - x2) * width * at_b;
  }
  return section;
}

double SectionTube::distance(const dvec3& p) const {
  const dvec3 off = p - origin_;
  const double t = glm::dot(off, axis_);
  const dvec3 beside_axis = off - std::clamp(t, sections_.front().t, sections_.back().t) * axis_;
  const double away = glm::length(beside_axis) - 1.3 * most_;
  if (away > kFar) return away;
  const TubeSection section = at(t);
  const double u = glm::dot(off, u_) - section.u, v = glm::dot(off, v_) - section.v, r = std::hypot(u, v);
  const double reach = r > 1e-9 ? reachOf(section, u / r, v / r) : std::min(section.half_breadth, section.front);
  const double beside = r - reach;
  const double beyond = std::max(sections_.front().t - t, t - sections_.back().t);
  if (beyond <= 0.0) return beside;
  // Round ends: half as far as the tube is thick.
  const double round = 0.5 * std::min(section.half_breadth, std::min(section.front, section.back));
  const double out = std::max(0.0, beside + round);
  return std::hypot(out, beyond) - round;
}

geometry::Bounds SectionTube::bounds() const {
  geometry::Bounds bounds;
  for (const TubeSection& s : sections_) {
    const double most = std::max({s.half_breadth, s.front, s.back}) + std::hypot(s.u, s.v);
    bounds.add(origin_ + s.t * axis_ - dvec3(most));
    bounds.add(origin_ + s.t * axis_ + dvec3(most));
  }
  return bounds;
}

}  // namespace hapticell::mannequin
