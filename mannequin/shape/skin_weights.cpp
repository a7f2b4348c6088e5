// SPDX-License-Identifier: Apache-2.0
#include "mannequin/shape/skin_weights.h"

#include <algorithm>
#include <cmath>

#include "mannequin/body/rotations.h"

namespace hapticell::mannequin {

namespace {

using S = Segment;

/// 0 up to `from`, 1 from `to` on, smooth between.
double rising(double x, double from, double to) {
  const double s = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

bool isOfArm(std::size_t body) {
  return body >= kSegmentCount || (body >= indexOf(S::kLeftUpperArm) && body <= indexOf(S::kLeftHand)) ||
         (body >= indexOf(S::kRightUpperArm) && body <= indexOf(S::kRightHand));
}

}  // namespace

std::size_t bodyOfBone(std::size_t bone) {
  if (bone < kBodies) return bone;
  if (bone < kSwungArms) return indexOf(S::kHead);
  return indexOf(bone == kSwungArms ? S::kLeftUpperArm : S::kRightUpperArm);
}

float SkinWeights::of(std::size_t body) const {
  float sum = 0.0f;
  for (std::size_t i = 0; i < kMost; ++i) sum += bodyOfBone(bone[i]) == body ? share[i] : 0.0f;
  return sum;
}

std::size_t SkinWeights::owner() const {
  std::size_t owner = bodyOfBone(bone[0]);
  for (std::size_t i = 1; i < kMost; ++i) {
    const std::size_t body = bodyOfBone(bone[i]);
    if (share[i] > 0.0f && of(body) > of(owner)) owner = body;
  }
  return owner;
}

float SkinWeights::straight() const {
  float arm = 0.0f;
  for (std::size_t i = 0; i < kMost; ++i) arm += isOfArm(bodyOfBone(bone[i])) ? share[i] : 0.0f;
  return 4.0f * arm * (1.0f - arm);
}

SkinWeighing::SkinWeighing(const Figure& figure, const SkinShape& shape)
    : figure_(figure), shape_(shape), k_(figure.body[Dimension::kStature] / 1.755) {
  for (const Side side : {Side::kLeft, Side::kRight})
    bones_[static_cast<std::size_t>(side)] = phalangesOf(figure, side);
}

double SkinWeighing::along(Segment first, const dvec3& p) const {
  const SegmentPlace& place = shape_.places()[indexOf(first)];
  return -glm::dot(place.R_WS[2], p - place.p_WS);
}

/// Beyond the armpit and the top of the shoulder a point belongs to the arm.
double SkinWeighing::armShare(Side side, const dvec3& p) const {
  if (outwardSign(side) * p.y < 0.0) return 0.0;
  const double nearer = shape_.trunk().distance(p) - shape_.arm(side).distance(p);
  const double t = along(armSegment(side, S::kLeftUpperArm), p);
  return rising(nearer, -0.026 * k_, 0.050 * k_) * rising(t, -0.050 * k_, 0.070 * k_);
}

/// Under the groin and the fold of the buttock it belongs to a leg.
double SkinWeighing::legShare(Side side, const dvec3& p) const {
  const double t = along(legSegment(side, S::kLeftThigh), p);
  const double out = outwardSign(side) * p.y;
  // Behind, the fold lies lower than the groin in front.
  const double ahead = (p.x - origin(legSegment(side, S::kLeftThigh)).x) / k_;
  const double lower = std::clamp(-0.18 * ahead, -0.015, 0.025) * k_;
  return rising(t - lower, -0.060 * k_, 0.085 * k_) * rising(out, 0.0, 0.034 * k_);
}

void SkinWeighing::addTrunk(const dvec3& p, double share, Shares& shares) const {
  struct Joint {
    S above;
    double half;  ///< m, to both sides, of a man of 1.755 m.
  };
  constexpr std::array<Joint, 5> kSpine = {{{S::kLowerBack, 0.065},
                                            {S::kUpperBack, 0.065},
                                            {S::kThorax, 0.070},
                                            {S::kLowerNeck, 0.040},
                                            {S::kUpperNeck, 0.035}}};
  // The head keeps its shape: what is nearer to it than to the neck is its own.
  const dvec3 skull = origin(S::kHead);
  const double from_neck = shape_.neck().distance(p) - shape_.skull(p);
  const double head =
      rising(from_neck, -0.016 * k_, 0.020 * k_) * rising(p.z, skull.z - 0.11 * k_, skull.z - 0.05 * k_);
  shares[indexOf(S::kHead)] += share * head;
  double rest = share * (1.0 - head);
  for (std::size_t i = kSpine.size(); i-- > 0;) {
    const double z = origin(kSpine[i].above).z, half = kSpine[i].half * k_;
    // Necks lean: their joints' planes do too.
    const double lean = i >= 3 ? 0.35 * (p.x - origin(kSpine[i].above).x) : 0.0;
    const double above = rest * rising(p.z + lean, z - half, z + half);
    rest -= above;
    if (kSpine[i].above == S::kThorax) {
      // Collar bones take the sides of the shoulders with them.
      const double shoulder = std::abs(origin(S::kLeftUpperArm).y), top = origin(S::kLeftUpperArm).z;
      const double girdle =
          rising(std::abs(p.y), 0.25 * shoulder, 1.02 * shoulder) * rising(p.z, top - 0.16 * k_, top - 0.01 * k_);
      shares[indexOf(p.y > 0.0 ? S::kLeftClavicle : S::kRightClavicle)] += above * girdle;
      shares[indexOf(S::kThorax)] += above * (1.0 - girdle);
    } else {
      shares[indexOf(kSpine[i].above)] += above;
    }
  }
  shares[indexOf(S::kPelvis)] += rest;
}

void SkinWeighing::addArm(Side side, const dvec3& p, double share, Shares& shares) const {
  const double upper = figure_.upperArmLength(), fore = figure_.forearmLength();
  const double t = along(armSegment(side, S::kLeftUpperArm), p);
  const double below_elbow = rising(t, upper - 0.045 * k_, upper + 0.045 * k_);
  const double pronates = rising(t, upper + 0.12 * fore, upper + 0.88 * fore);
  const double hand = rising(t, upper + fore - 0.020 * k_, upper + fore + 0.020 * k_);
  // The twist of an upper arm goes up its length, or the shoulder would be wrung.
  const double twists = rising(t, 0.10 * upper, 0.85 * upper);
  shares[kSwungArms + static_cast<std::size_t>(side)] += share * (1.0 - below_elbow) * (1.0 - twists);
  shares[indexOf(armSegment(side, S::kLeftUpperArm))] += share * (1.0 - below_elbow) * twists;
  shares[indexOf(armSegment(side, S::kLeftForearm))] += share * below_elbow * (1.0 - pronates);
  shares[indexOf(armSegment(side, S::kLeftWrist))] += share * below_elbow * pronates * (1.0 - hand);
  if (hand > 0.0) addHand(side, p, share * below_elbow * pronates * hand, shares);
}

void SkinWeighing::addHand(Side side, const dvec3& p, double share, Shares& shares) const {
  const auto& bones = bones_[static_cast<std::size_t>(side)];
  std::array<double, kDigits> nearness{}, whole{};
  std::array<std::array<double, kPhalanges>, kDigits> past{};  // How much each phalanx carries of its digit.
  double nearest = 1e9;
  for (std::size_t d = 0; d < kDigits; ++d) {
    nearness[d] = 1e9;
    for (std::size_t i = 0; i < kPhalanges; ++i) {
      const Phalanx& bone = bones[d][i];
      const SegmentPlace& place = shape_.places()[phalanxBody(side, d, i)];
      const dvec3 local = glm::transpose(place.R_WS) * (p - place.p_WS);
      const double t = glm::dot(local, bone.along), on = std::clamp(t, 0.0, bone.length);
      nearness[d] = std::min(nearness[d], glm::length(local - on * bone.along) - bone.radius);
      const double r = bone.radius;
      if (i > 0)
        past[d][i] = rising(t, -0.75 * r, 0.75 * r);
      else
        past[d][i] = d == 0 ? rising(t, -0.2 * r, 2.4 * r) : rising(t, -0.9 * r, 1.3 * r);
    }
    nearest = std::min(nearest, nearness[d]);
  }
  double sum = 0.0;
  for (std::size_t d = 0; d < kDigits; ++d) sum += whole[d] = std::exp(-(nearness[d] - nearest) / (0.0018 * k_));
  for (std::size_t d = 0; d < kDigits; ++d) {
    // What lies far from every finger is the palm's, however far along.
    double rest = share * whole[d] / sum;
    const double own = rest * past[d][0] * (1.0 - rising(nearness[d], 0.006 * k_, 0.016 * k_));
    shares[indexOf(armSegment(side, S::kLeftHand))] += rest - own;
    rest = own;
    for (std::size_t i = kPhalanges; i-- > 1;) {
      const double above = rest * past[d][i];
      shares[phalanxBody(side, d, i)] += above;
      rest -= above;
    }
    shares[phalanxBody(side, d, 0)] += rest;
  }
}

void SkinWeighing::addLeg(Side side, const dvec3& p, double share, Shares& shares) const {
  const double thigh = figure_.thighLength(), whole = thigh + figure_.shankLength();
  const double t = along(legSegment(side, S::kLeftThigh), p);
  const double below_knee = rising(t, thigh - 0.065 * k_, thigh + 0.065 * k_);
  const double foot = rising(t, whole - 0.052 * k_, whole + 0.004 * k_);
  const SegmentPlace& toes = shape_.places()[indexOf(legSegment(side, S::kLeftToes))];
  const double ahead = glm::dot(toes.R_WS[0], p - toes.p_WS);
  const double toe = rising(ahead, -0.022 * k_, 0.022 * k_);
  shares[indexOf(legSegment(side, S::kLeftThigh))] += share * (1.0 - below_knee);
  shares[indexOf(legSegment(side, S::kLeftShank))] += share * below_knee * (1.0 - foot);
  shares[indexOf(legSegment(side, S::kLeftFoot))] += share * below_knee * foot * (1.0 - toe);
  shares[indexOf(legSegment(side, S::kLeftToes))] += share * below_knee * foot * toe;
}

SkinWeights SkinWeighing::at(const dvec3& p) const {
  Shares shares{};
  double trunk = 1.0;
  const bool high = p.z > origin(S::kLowerBack).z - 0.02 * k_ || std::abs(p.y) > 0.36 * k_;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const double limb = high ? armShare(side, p) : legShare(side, p);
    if (limb <= 0.0) continue;
    high ? addArm(side, p, limb, shares) : addLeg(side, p, limb, shares);
    trunk -= limb;
  }
  if (trunk > 0.0) addTrunk(p, trunk, shares);
  SkinWeights weights;
  float sum = 0.0f;
  for (std::size_t i = 0; i < SkinWeights::kMost; ++i) {
    const auto largest = std::max_element(shares.begin(), shares.end());
    weights.bone[i] = static_cast<std::uint8_t>(largest - shares.begin());
    weights.share[i] = static_cast<float>(*largest);
    sum += weights.share[i];
    *largest = 0.0;
  }
  for (float& share : weights.share) share /= sum;
  return weights;
}

}  // namespace hapticell::mannequin
