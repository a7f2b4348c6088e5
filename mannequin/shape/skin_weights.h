// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "mannequin/shape/skin_shape.h"

namespace hapticell::mannequin {

/// Frames that a point of the skin may go along with: the bodies as fleshOf() counts them, then by sides the eyes and
/// the upper arms as they are swung without their twist.
inline constexpr std::size_t kEyeBones = kBodies, kSwungArms = kBodies + 2, kSkinBones = kBodies + 4;

/// How much each of a few bones carries a point of the skin along; shares add up to 1, largest first.
struct SkinWeights {
  /// Bones that carry a point, those with the largest shares (docs/dev/mannequin.md). Half: folds where trunk, neck and
  /// arm meet; twice: larger vertices for shares near 0.
  static constexpr std::size_t kMost = 5;
  std::array<std::uint8_t, kMost> bone{};
  std::array<float, kMost> share{};

  /// How much a body carries, its swung frame counted with it.
  float of(std::size_t body) const;
  /// The body that carries most.
  std::size_t owner() const;
  /// How far an arm and the trunk share it: 0 neither, up to 1 where they do evenly. There straight blending keeps the
  /// armpit hollow, where turns would blow it up.
  float straight() const;
};

/// The body that a bone belongs to; the head for eyes.
std::size_t bodyOfBone(std::size_t bone);

/// Shares of the bodies as a smooth function of the place in the bind posture, the same for all layers, so that what
/// lies over each other moves together.
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
