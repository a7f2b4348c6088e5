// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "mannequin/shape/body_shape.h"
#include "mannequin/shape/section_tube.h"

namespace hapticell::mannequin {

/// Layers of clothing and bare skin of a figure: each a separate closed surface that extends under the next one.
enum class Layer : std::uint8_t { kShirt, kTrousers, kBelt, kShoes, kHands, kHead };
inline constexpr std::size_t kLayers = 6;

/// The posture in which the skin is shaped, arms and legs apart, and the poses of all bodies in it (fleshOf()'s order).
/// Fingers are spread there, beyond the range of their joints, so that their surfaces do not intersect.
Posture bindPosture();
std::vector<SegmentPlace> bindPlaces(const Figure& figure);

/// The outer shape of a figure in the bind posture, from published breadths, depths and girths (girths.h); profiles
/// between the sections and muscles are our own choice.
class SkinShape {
 public:
  explicit SkinShape(const Figure& figure);

  /// Approximate distance (m) to the bare surface, negative inside; without hands, head and feet.
  double body(const dvec3& p) const;
  /// The same without the limbs and the neck.
  double torso(const dvec3& p) const;
  /// The same to the surface of a layer, as if it continued a little beyond its hems.
  double layer(Layer layer, const dvec3& p) const;
  /// Distance (m) of a point inside the hems of a layer; negative beyond.
  double withinHems(Layer layer, const dvec3& p) const;
  geometry::Bounds bounds(Layer layer) const;

  const SectionTube& trunk() const { return trunk_; }
  const SectionTube& arm(Side side) const { return arms_[static_cast<std::size_t>(side)]; }
  const SectionTube& leg(Side side) const { return legs_[static_cast<std::size_t>(side)]; }
  const SectionTube& neck() const { return neck_; }
  /// Approximate distance to the head's surface, m.
  double skull(const dvec3& p) const { return fleshAt(indexOf(Segment::kHead), p); }
  const std::vector<SegmentPlace>& places() const { return places_; }

 private:
  double fleshAt(std::size_t body, const dvec3& p) const;
  double hand(Side side, const dvec3& p) const;
  double head(const dvec3& p) const;
  double shoes(const dvec3& p) const;
  /// m over the collar's plane.
  double overCollar(const dvec3& p) const { return glm::dot(p - p_collar_, up_collar_); }
  /// m along a limb from its first joint.
  double along(Segment first, const dvec3& p) const {
    return -glm::dot(places_[indexOf(first)].R_WS[2], p - places_[indexOf(first)].p_WS);
  }

  std::vector<Flesh> flesh_;
  std::vector<SegmentPlace> places_;
  std::vector<geometry::Bounds> flesh_bounds_;
  SectionTube trunk_, neck_;
  std::array<SectionTube, 2> arms_, legs_, trouser_legs_;
  std::vector<Blob> muscles_;  ///< On the trunk, in W of the bind posture.
  double k_ = 1.0, cuff_ = 0.0, trouser_end_ = 0.0, waist_z_ = 0.0;
  dvec3 p_collar_{0.0}, up_collar_{0.0, 0.0, 1.0};
};

}  // namespace hapticell::mannequin
