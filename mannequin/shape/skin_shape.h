// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "mannequin/shape/body_shape.h"
#include "mannequin/shape/section_tube.h"

namespace hapticell::mannequin {

/// What a figure wears, and what of it is bare: each a separate closed surface that extends under the next one.
enum class Layer : std::uint8_t { kShirt, kTrousers, kBelt, kShoes, kHands, kHead };
inline constexpr std::size_t kLayers = 6;

/// The posture in which the skin is shaped, arms and legs apart, and where all bodies are in it (fleshOf()'s order).
/// Fingers are spread there, beyond what their joints do, so that their surfaces do not run into each other.
Posture bindPosture();
std::vector<SegmentPlace> bindPlaces(const Figure& figure);

/// The outer shape of a figure in the bind posture, from published breadths, depths and girths (girths.h); what no
/// table has (profiles between the sections, muscles) is our own choice.
class SkinShape {
 public:
  explicit SkinShape(const Figure& figure);

  /// About the distance (m) to the bare surface, negative inside; without hands, head and feet.
  double body(const dvec3& p) const;
  /// The same without the limbs and the neck.
  double torso(const dvec3& p) const;
  /// The same to a layer's surface, as if it went on a little beyond its hems.
  double layer(Layer layer, const dvec3& p) const;
  /// How far (m) a point lies within the hems that a layer is cut off at; negative beyond.
  double withinHems(Layer layer, const dvec3& p) const;
  geometry::Bounds bounds(Layer layer) const;

  const SectionTube& trunk() const { return trunk_; }
  const SectionTube& arm(Side side) const { return arms_[static_cast<std::size_t>(side)]; }
  const SectionTube& leg(Side side) const { return legs_[static_cast<std::size_t>(side)]; }
  const SectionTube& neck() const { return neck_; }
  /// About the distance to the head's surface, m.
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
