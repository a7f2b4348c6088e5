// SPDX-License-Identifier: Apache-2.0
#include "mannequin/shape/figure_outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hapticell::mannequin {
namespace {

// Corners of a capsule's outline: 18 degrees each, off by 1.2 % of its radius. Half: 4.9 %; twice: 0.3 %, twice the
// time.
constexpr std::size_t kCorners = 20;

/// The blob's point that lies furthest along `u` (unit, in the body's frame): an end's stretched sphere touches there.
dvec3 furthest(const Blob& blob, const dvec3& u) {
  const dvec3 s = blob.stretch * u;
  const double length = glm::length(s);
  const dvec3 touch = blob.stretch * s / std::max(length, 1e-12);
  const dvec3 a = blob.a + blob.ra * touch, b = blob.b + blob.rb * touch;
  return glm::dot(a, u) > glm::dot(b, u) ? a : b;
}

std::vector<glm::dvec2> shapeOf(const Blob& blob, const SegmentPlace& place, const OutlineView& view) {
  std::vector<glm::dvec2> shape;
  shape.reserve(kCorners);
  const dmat3 R_SW = glm::transpose(place.R_WS);
  for (std::size_t i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / kCorners;
    const dvec3 u_W = std::cos(angle) * view.right_W + std::sin(angle) * view.up_W;
    const dvec3 p_W = place.point(furthest(blob, R_SW * u_W));
    shape.emplace_back(glm::dot(p_W, view.right_W), glm::dot(p_W, view.up_W));
  }
  return shape;
}

}  // namespace

OutlineView OutlineView::besides(const Posture& posture, double turn) {
  const dvec3 ahead = posture.X_WR.rotate({1.0, 0.0, 0.0});
  const double heading = std::atan2(ahead.y, ahead.x);
  OutlineView view;
  view.right_W = {std::cos(heading + turn), std::sin(heading + turn), 0.0};
  return view;
}

std::vector<OutlinePart> outlineOf(const Figure& figure, const Posture& posture, const std::vector<Flesh>& flesh,
                                   const OutlineView& view) {
  const FigurePose pose = forwardKinematics(figure, posture);
  const dvec3 towards = glm::cross(view.right_W, view.up_W);
  std::vector<OutlinePart> parts;
  parts.reserve(kSegmentCount);
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    OutlinePart part;
    part.body = i;
    const SegmentPlace& place = pose.segments[i];
    part.depth = glm::dot(place.point(flesh[i].bounds().center()), towards);
    for (const Blob& blob : flesh[i].blobs) part.shapes.push_back(shapeOf(blob, place, view));
    parts.push_back(std::move(part));
  }
  std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) {
    return a.depth < b.depth || (a.depth == b.depth && a.body < b.body);
  });
  return parts;
}

}  // namespace hapticell::mannequin
