// SPDX-License-Identifier: Apache-2.0
#include "mannequin/shape/skin_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mannequin/body/girths.h"
#include "mannequin/body/rotations.h"
#include "mannequin/posture/posture.h"
#include "mannequin/shape/blob_distance.h"
#include "mannequin/shape/body_sections.h"

namespace hapticell::mannequin {

namespace {

using S = Segment;
using D = Dimension;

// rad of the posture in which the skin is shaped: arms and legs do not flow into the trunk there. Half: armpits grow
// together; twice: folds at shoulders that hang.
constexpr double kArmsApart = 46.0 * std::numbers::pi / 180.0, kLegsApart = 9.0 * std::numbers::pi / 180.0;
// m over the bare surface, our choice, drawn only. Half: skin comes through; twice: clothes look thick, farther from
// what is felt.
constexpr double kCloth = 0.0030, kTrouserCloth = 0.0040, kBeltCloth = 0.0075;
constexpr double kBeltHalf = 0.017;  // m
/// m that hands and head go on under cuff and collar (docs/dev/mannequin.md). Half: gaps when wrists bend; twice: skin
/// comes through the cloth.
constexpr double kReachesUnder = 0.035;

/// Which way a limb points in the bind posture.
dvec3 downOf(const std::vector<SegmentPlace>& places, S segment) {
  return -places[indexOf(segment)].R_WS[2];
}

}  // namespace

Posture bindPosture() {
  Posture posture;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    posture[armDof(side, Dof::kLeftShoulderAbduction)] = kArmsApart;
    posture[legDof(side, Dof::kLeftHipAbduction)] = kLegsApart;
    posture[armDof(side, Dof::kLeftThumbAbduction)] = 0.35;
  }
  return posture;
}

std::vector<SegmentPlace> bindPlaces(const Figure& figure) {
  Posture posture = bindPosture();
  posture.X_WR.p.z = figure.p_PS[0].z;
  const FigurePose pose = forwardKinematics(figure, posture);
  std::vector<SegmentPlace> places(pose.segments.begin(), pose.segments.end());
  places.resize(kBodies);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const SegmentPlace& hand = pose[armSegment(side, S::kLeftHand)];
    const auto fingers = phalanxPlaces(figure, posture, side, hand);
    for (std::size_t d = 0; d < kDigits; ++d) {
      constexpr std::array<double, kDigits> kSpread = {0.0, 0.15, 0.04, -0.07, -0.19};  // rad
      const dmat3 spread = hand.R_WS * aboutY(-kSpread[d]) * glm::transpose(hand.R_WS);
      const dvec3 about = fingers[d][0].p_WS;
      for (std::size_t i = 0; i < kPhalanges; ++i)
        places[phalanxBody(side, d, i)] = {spread * fingers[d][i].R_WS, about + spread * (fingers[d][i].p_WS - about)};
    }
  }
  return places;
}

SkinShape::SkinShape(const Figure& figure)
    : flesh_(fleshOf(figure)),
      places_(bindPlaces(figure)),
      trunk_({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {{0.0}, {1.0}}),
      neck_(trunk_),
      arms_{trunk_, trunk_},
      legs_{trunk_, trunk_},
      trouser_legs_{trunk_, trunk_},
      k_(figure.body[D::kStature] / 1.755) {
  // v = axis x u: along the spine with u to the right it is ahead; the sections are alike on both sides.
  trunk_ = SectionTube({0, 0, 0}, {0, 0, 1}, {0, -1, 0}, trunkSections(figure));
  const dvec3 base = places_[indexOf(S::kLowerNeck)].p_WS + dvec3(0.016 * k_, 0.0, -0.012 * k_);
  const dvec3 skull = places_[indexOf(S::kHead)].p_WS + dvec3(0.006 * k_, 0.0, 0.030 * k_);
  const dvec3 up = glm::normalize(skull - base);
  neck_ = SectionTube(base, up, {0, -1, 0}, neckSections(figure, glm::length(skull - base)));
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const std::size_t i = static_cast<std::size_t>(side);
    const double out = outwardSign(side);
    const S arm = armSegment(side, S::kLeftUpperArm), leg = legSegment(side, S::kLeftThigh);
    // Along an arm, u ahead: v is towards the body on the left.
    arms_[i] = SectionTube(places_[indexOf(arm)].p_WS, downOf(places_, arm), places_[indexOf(arm)].R_WS[0],
                           armSections(figure, -out));
    const dvec3 left = places_[indexOf(leg)].R_WS[1];
    legs_[i] = SectionTube(places_[indexOf(leg)].p_WS, downOf(places_, leg), left, legSections(figure, out));
    trouser_legs_[i] = SectionTube(places_[indexOf(leg)].p_WS, downOf(places_, leg), left, trouserSections(figure));
  }
  for (std::size_t i = 0; i < kBodies; ++i)
    flesh_bounds_.push_back(geometry::transformed(places_[i].pose(), flesh_[i].bounds()));
  cuff_ = figure.upperArmLength() + 0.905 * figure.forearmLength();
  trouser_end_ = figure.thighLength() + figure.shankLength() - 0.018 * k_;
  waist_z_ = figure.body[D::kIliocristaleHeight] - 0.012 * k_;
  p_collar_ = base + dvec3(0.0, 0.0, -0.004 * k_);
  up_collar_ = glm::normalize(dvec3(0.42, 0.0, 1.0));
  // Trapezius, shoulder blades and what lies on the chest.
  const double shoulder = 0.5 * figure.body[D::kBiacromialBreadth], neck_z = figure.body[D::kCervicaleHeight];
  const double z = figure.body[D::kAcromialHeight];
  const double chest_z = girthOf(figure.sex, figure.body, Girth::kChestHeight);
  const TubeSection chest = trunk_.at(chest_z);
  const double front = chest.v + chest.front;
  for (const double side : {1.0, -1.0}) {
    muscles_.push_back({{-0.020 * k_, side * 0.030 * k_, neck_z - 0.010 * k_},
                        {-0.010 * k_, side * 0.82 * shoulder, z - 0.038 * k_},
                        0.034 * k_,
                        0.032 * k_,
                        dvec3(1.0),
                        0.060 * k_});
    if (figure.sex == Sex::kFemale) {
      const double depth = figure.body[D::kChestDepth], r = 0.26 * depth;
      const dvec3 middle(front + 0.140 * depth - 0.78 * r, side * 0.43 * chest.half_breadth, chest_z - 0.002 * k_);
      muscles_.push_back(
          {middle + dvec3(-0.010 * k_, 0.0, 0.024 * k_), middle, 0.92 * r, r, {0.78, 1.0, 0.96}, 0.042 * k_});
    } else {
      muscles_.push_back({{front - 0.057 * k_, side * 0.36 * chest.half_breadth, chest_z + 0.030 * k_},
                          {front - 0.070 * k_, side * 0.66 * chest.half_breadth, chest_z + 0.056 * k_},
                          0.052 * k_,
                          0.046 * k_,
                          dvec3(1.0),
                          0.030 * k_});
    }
  }
}

double SkinShape::fleshAt(std::size_t body, const dvec3& p) const {
  const geometry::Bounds& box = flesh_bounds_[body];
  const dvec3 off = glm::max(glm::max(box.min - p, p - box.max), dvec3(0.0));
  const double away = glm::length(off);
  if (away > 0.03) return away;
  const SegmentPlace& place = places_[body];
  return flesh_[body].distance(glm::transpose(place.R_WS) * (p - place.p_WS));
}

double SkinShape::torso(const dvec3& p) const {
  double d = trunk_.distance(p);
  for (const Blob& muscle : muscles_) d = blended(d, distanceTo(muscle, p), muscle.blend);
  return d;
}

double SkinShape::body(const dvec3& p) const {
  // m over which parts flow together, our choice, drawn only. Half: creases; twice: shoulders without arms.
  constexpr double kShoulder = 0.060, kHip = 0.018, kCrotch = 0.006, kNeck = 0.045;
  double d = torso(p);
  for (const SectionTube& arm : arms_) d = blended(d, arm.distance(p), kShoulder * k_);
  const double legs = blended(legs_[0].distance(p), legs_[1].distance(p), kCrotch * k_);
  d = blended(d, legs, kHip * k_);
  return blended(d, neck_.distance(p), kNeck * k_);
}

double SkinShape::hand(Side side, const dvec3& p) const {
  const std::size_t palm = indexOf(armSegment(side, S::kLeftHand));
  std::array<double, 1 + kDigits * kPhalanges> d{};
  d[0] = fleshAt(palm, p);
  double all = d[0];
  for (std::size_t i = 0; i < kDigits; ++i) {
    for (std::size_t j = 0; j < kPhalanges; ++j) {
      const std::size_t body = phalanxBody(side, i, j), own = 1 + i * kPhalanges + j;
      d[own] = fleshAt(body, p);
      // The knuckles of a hand are webbed, those of a finger hardly thicker than its bones.
      const double knuckle = i == 0 ? 0.014 : 0.007;
      const double over = j == 0 ? knuckle : 0.0025;
      all = std::min(all, blended(d[own], j == 0 ? d[0] : d[own - 1], over * k_));
    }
  }
  all = blended(all, arm(side).distance(p), 0.012 * k_);
  return std::max(all, cuff_ - kReachesUnder * k_ - along(armSegment(side, S::kLeftUpperArm), p));
}

double SkinShape::head(const dvec3& p) const {
  const double d = blended(fleshAt(indexOf(S::kHead), p), body(p), 0.016 * k_);
  return std::max(d, -overCollar(p) - kReachesUnder * k_);
}

double SkinShape::shoes(const dvec3& p) const {
  double all = 1e9;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const double foot = fleshAt(indexOf(legSegment(side, S::kLeftFoot)), p);
    const double toes = fleshAt(indexOf(legSegment(side, S::kLeftToes)), p);
    double shoe = blended(foot, toes, 0.012 * k_);
    const double under = trouser_end_ - kReachesUnder * k_ - along(legSegment(side, S::kLeftThigh), p);
    const double ankle = std::max(leg(side).distance(p) - 0.002, under);
    shoe = blended(shoe, ankle, 0.018 * k_);
    all = std::min(all, shoe);
  }
  return all;
}

double SkinShape::withinHems(Layer which, const dvec3& p) const {
  const auto limbs = [&](S first, double end) {
    const S right = static_cast<S>(indexOf(first) + (first == S::kLeftUpperArm ? 5 : 4));
    return end - std::max(along(first, p), along(right, p));
  };
  switch (which) {
    case Layer::kShirt:
      return std::min({limbs(S::kLeftUpperArm, cuff_), -overCollar(p), p.z - waist_z_ + 0.030 * k_});
    case Layer::kTrousers:
      return std::min(limbs(S::kLeftThigh, trouser_end_), waist_z_ - p.z);
    case Layer::kBelt:
      return kBeltHalf * k_ - std::abs(p.z - waist_z_ + 0.010 * k_);
    default:
      return 1e9;
  }
}

double SkinShape::layer(Layer which, const dvec3& p) const {
  // m that a layer goes on under the next one, a little less than kReachesUnder. Half: gaps in bent postures; twice:
  // cloth comes through.
  constexpr double kBeyond = 0.030;
  double d = 1e9;
  switch (which) {
    case Layer::kShirt:
      d = body(p) - kCloth;
      break;
    case Layer::kTrousers:
      d = body(p) - kTrouserCloth;
      for (const SectionTube& leg : trouser_legs_) d = blended(d, leg.distance(p), 0.020 * k_);
      break;
    case Layer::kBelt:
      d = trunk_.distance(p) - kBeltCloth;
      break;
    case Layer::kShoes:
      return shoes(p);
    case Layer::kHands:
      return hand(p.y > 0.0 ? Side::kLeft : Side::kRight, p);
    case Layer::kHead:
      return head(p);
  }
  return std::max(d, -withinHems(which, p) - kBeyond);
}

geometry::Bounds SkinShape::bounds(Layer which) const {
  geometry::Bounds bounds;
  const auto add = [&](S segment) { bounds.add(flesh_bounds_[indexOf(segment)]); };
  switch (which) {
    case Layer::kShirt:
      bounds.add(trunk_.bounds());
      bounds.add(arms_[0].bounds());
      bounds.add(arms_[1].bounds());
      bounds.min.z = waist_z_ - 0.08 * k_;
      break;
    case Layer::kTrousers:
      bounds.add(legs_[0].bounds());
      bounds.add(legs_[1].bounds());
      bounds.add(trunk_.bounds());
      bounds.max.z = waist_z_ + 0.05 * k_;
      break;
    case Layer::kBelt:
      bounds.add(trunk_.bounds());
      bounds.min.z = waist_z_ - 0.08 * k_;
      bounds.max.z = waist_z_ + 0.06 * k_;
      break;
    case Layer::kShoes:
      for (const S s : {S::kLeftFoot, S::kLeftToes, S::kRightFoot, S::kRightToes}) add(s);
      bounds.max.z += 0.05 * k_;
      break;
    case Layer::kHands:
      for (std::size_t body = kSegmentCount; body < kBodies; ++body) bounds.add(flesh_bounds_[body]);
      for (const S s : {S::kLeftHand, S::kRightHand, S::kLeftWrist, S::kRightWrist}) add(s);
      break;
    case Layer::kHead:
      for (const S s : {S::kHead, S::kUpperNeck, S::kLowerNeck}) add(s);
      bounds.min.z -= 0.06 * k_;
      break;
  }
  bounds.min -= dvec3(0.01);
  bounds.max += dvec3(0.01);
  return bounds;
}

}  // namespace hapticell::mannequin
