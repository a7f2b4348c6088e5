// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "mannequin/shape/skin_shape.h"

namespace hapticell::mannequin {

/// Frames that can move a point of the skin: the bodies in the order of fleshOf(), then for each side the eye and the
/// upper arm swung without its twist.
inline constexpr std::size_t kEyeBones = kBodies, kSwungArms = kBodies + 2, kSkinBones = kBodies + 4;

/// The weights of a few bones for a point of the skin; the sum is 1, largest first.
struct SkinWeights {
  /// Bones per point, those with the largest weights (docs/dev/mannequin.md). Half: folds where trunk, neck and arm
  /// meet; twice: larger vertices for weights near 0.
  static constexpr std::size_t kMost = 5;
  std::array<std::uint8_t, kMost> bone{};
  std::array<float, kMost> share{};

  /// The weight of a body, including its swung frame.
  float of(std::size_t body) const;
  /// The body with the largest weight.
  std::size_t owner() const;
  /// How evenly an arm and the trunk share it: 0 not at all, up to 1 for equal weights. There linear blending keeps the
  /// armpit hollow; blending of rotations would inflate it.
  float straight() const;
};

/// The body of a bone; the head for eyes.
std::size_t bodyOfBone(std::size_t bone);

/// Weights of the bodies as a smooth function of the position in the bind posture, the same for all layers, so that
/// overlapping layers move together.
class SkinWeighing {
 public:
  SkinWeighing(const Figure& figure, const SkinShape& shape);
  SkinWeights at(const dvec3& p) const;

 private:
  using Shares = std::array<double, kSkinBones>;
  void addTrunk(const dvec3& p, double share, Shares& shares) const;
  void addArm(Side side, const dvec3& p, double share, Shares& shares) const;
  void addHand(Side side, const dvec3& p, double share, Shares& shares) const;
  void addLeg(Side side, const dvec3& p, double share, Shares& shares) const;
  double armShare(Side side, const dvec3& p) const;
  double legShare(Side side, const dvec3& p) const;
  dvec3 origin(Segment segment) const { return shape_.places()[indexOf(segment)].p_WS; }
  /// m along a limb from its first joint.
  double along(Segment first, const dvec3& p) const;

  const Figure& figure_;
  const SkinShape& shape_;
  std::array<std::array<Phalanx, kPhalanges>, kDigits> bones_[2];
  double k_ = 1.0;
};

}  // namespace hapticell::mannequin
