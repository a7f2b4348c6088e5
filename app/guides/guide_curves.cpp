// SPDX-License-Identifier: Apache-2.0
#include "app/guides/guide_curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hapticell::app {
namespace {

using workcell::Guide;
using workcell::GuideKind;

constexpr double kHalfAxis = 0.2;      // m of an axis without stops to either side.
constexpr double kHalfPlane = 0.15;    // m
constexpr double kTick = 0.012;        // m: half length of the mark at a stop.
constexpr double kLeastRadius = 0.03;  // m of a hinge's arc.
constexpr int kSteps = 48;             // Chords of a whole circle.

class Drawer {
 public:
  Drawer(const Guide& guide, const dvec3& p_WMoved) : guide_(guide), moved_(p_WMoved), o_(guide.X_WG.p) {
    for (int i = 0; i < 3; ++i) axis_[i] = guide.X_WG.rotate(dvec3(i == 0, i == 1, i == 2));
  }
  std::vector<SceneCurve> make();

 private:
  void line(std::vector<dvec3> points, SceneCurve::Style style = SceneCurve::Style::kDashDot, double width = 2.0) {
    const auto role = guide_.enabled ? SceneCurve::Role::kGuide : SceneCurve::Role::kGuideOff;
    curves_.push_back({std::move(points), role, style, width, {}});
  }
  void disc(const dvec3& p) { line({p}, SceneCurve::Style::kSolid); }
  /// A stop is a limit and looks like one.
  void stop(const dvec3& p, const dvec3& across) {
    curves_.push_back(
        {{p - kTick * across, p + kTick * across}, SceneCurve::Role::kLimit, SceneCurve::Style::kSolid, 2.5, {}});
  }
  void detent(const dvec3& p, const dvec3& across) {
    line({p - 0.6 * kTick * across, p + 0.6 * kTick * across}, SceneCurve::Style::kSolid);
  }
  dvec3 onCircle(const dvec3& center, const dvec3& r, double angle) const {
    return center + quaternionFromRotationVector(angle * axis_[2]) * r;
  }
  void arc(const dvec3& center, const dvec3& r, double from, double to) {
    std::vector<dvec3> points;
    const int steps = std::max(4, static_cast<int>(std::ceil(std::abs(to - from) / (2.0 * std::numbers::pi) * kSteps)));
    for (int i = 0; i <= steps; ++i) points.push_back(onCircle(center, r, from + (to - from) * i / steps));
    line(std::move(points));
  }
  void straight();
  void plane();
  void hinge();
  void screw();
  void tube();
  void lock();

  const Guide& guide_;
  dvec3 moved_, o_;
  dvec3 axis_[3];
  std::vector<SceneCurve> curves_;
};

void Drawer::straight() {
  // A slider starts where its entity stands, a line at its own origin.
  const dvec3 from = guide_.kind == GuideKind::kSlider ? moved_ : o_;
  const double low = guide_.lower.value_or(-kHalfAxis), high = guide_.upper.value_or(kHalfAxis);
  line({from + low * axis_[2], from + high * axis_[2]});
  if (guide_.lower) stop(from + low * axis_[2], axis_[0]);
  if (guide_.upper) stop(from + high * axis_[2], axis_[0]);
  for (const double at : guide_.detents) detent(from + at * axis_[2], axis_[0]);
}

void Drawer::plane() {
  const dvec3 u = kHalfPlane * axis_[0], v = kHalfPlane * axis_[1];
  line({o_ - u - v, o_ + u - v, o_ + u + v, o_ - u + v, o_ - u - v});
  line({o_, o_ + 0.3 * kHalfPlane * axis_[2]}, SceneCurve::Style::kSolid);
}

void Drawer::hinge() {
  const double height = glm::dot(moved_ - o_, axis_[2]);
  const dvec3 center = o_ + height * axis_[2];
  dvec3 r = moved_ - center;
  if (glm::length(r) < kLeastRadius) r = kLeastRadius * axis_[0];
  line({o_ + std::min(-kHalfAxis, height - 0.05) * axis_[2], o_ + std::max(kHalfAxis, height + 0.05) * axis_[2]});
  const bool stops = guide_.lower || guide_.upper;
  const double low = guide_.lower.value_or(stops ? *guide_.upper - std::numbers::pi : 0.0);
  const double high = guide_.upper.value_or(stops ? *guide_.lower + std::numbers::pi : 2.0 * std::numbers::pi);
  arc(center, r, low, high);
  const auto outward = [&](double angle) { return glm::normalize(onCircle(dvec3(0.0), r, angle)); };
  if (guide_.lower) stop(onCircle(center, r, low), outward(low));
  if (guide_.upper) stop(onCircle(center, r, high), outward(high));
  for (const double at : guide_.detents) detent(onCircle(center, r, at), outward(at));
}

void Drawer::screw() {
  straight();
  std::vector<dvec3> helix;
  for (int i = 0; i <= 3 * kSteps; ++i) {
    const double turns = static_cast<double>(i) / kSteps;
    const dvec3 r = quaternionFromRotationVector(2.0 * std::numbers::pi * turns * axis_[2]) * (0.02 * axis_[0]);
    helix.push_back(o_ + r + turns * guide_.pitch * axis_[2]);
  }
  line(std::move(helix), SceneCurve::Style::kSolid, 1.2);
}

void Drawer::tube() {
  if (guide_.path.size() < 2) return;
  line(guide_.path);
  for (const std::size_t i : {std::size_t{0}, guide_.path.size() / 2, guide_.path.size() - 1}) {
    const std::size_t a = i > 0 ? i - 1 : 0, b = std::min(i + 1, guide_.path.size() - 1);
    const dvec3 along = glm::normalize(guide_.path[b] - guide_.path[a]);
    const dvec3 other = std::abs(along.z) < 0.9 ? dvec3(0, 0, 1) : dvec3(1, 0, 0);
    const dvec3 u = guide_.radius * glm::normalize(glm::cross(along, other)), v = glm::cross(along, u);
    std::vector<dvec3> ring;
    for (int k = 0; k <= kSteps; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / kSteps;
      ring.push_back(guide_.path[i] + std::cos(angle) * u + std::sin(angle) * v);
    }
    line(std::move(ring), SceneCurve::Style::kSolid, 1.2);
  }
}

void Drawer::lock() {
  for (std::size_t i = 0; i < 3; ++i) {
    const bool locked = guide_.locked[i];
    const dvec3 end = o_ + 0.1 * axis_[i];
    line({o_ - 0.1 * axis_[i], end}, locked ? SceneCurve::Style::kDashed : SceneCurve::Style::kDashDot);
    if (locked) stop(end, axis_[(i + 1) % 3]);
    curves_.back().text = std::string(1, "XYZ"[i]);
  }
  disc(o_);
}

std::vector<SceneCurve> Drawer::make() {
  switch (guide_.kind) {
    case GuideKind::kPoint:
      disc(o_);
      for (const dvec3& axis : axis_) line({o_ - 0.02 * axis, o_ + 0.02 * axis}, SceneCurve::Style::kSolid, 1.2);
      break;
    case GuideKind::kLine:
    case GuideKind::kSlider:
      straight();
      break;
    case GuideKind::kPlane:
      plane();
      break;
    case GuideKind::kCircle:
      arc(o_, guide_.radius * axis_[0], 0.0, 2.0 * std::numbers::pi);
      disc(o_);
      break;
    case GuideKind::kHinge:
      hinge();
      break;
    case GuideKind::kScrew:
      screw();
      break;
    case GuideKind::kTube:
      tube();
      break;
    case GuideKind::kSurface:
      line({o_, o_ + std::max(guide_.offset, 0.01) * axis_[2]});
      disc(o_ + guide_.offset * axis_[2]);
      break;
    case GuideKind::kLock:
      lock();
      break;
  }
  return std::move(curves_);
}

}  // namespace

std::vector<SceneCurve> guideCurves(const Guide& guide, const dvec3& p_WMoved, bool named) {
  std::vector<SceneCurve> curves = Drawer(guide, p_WMoved).make();
  if (named && !curves.empty()) curves.front().text = guide.name;
  return curves;
}

}  // namespace hapticell::app
