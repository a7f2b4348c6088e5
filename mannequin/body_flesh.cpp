// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "mannequin/body_shape.h"
#include "mannequin/head_flesh.h"
#include "mannequin/rotations.h"

namespace hapticell::mannequin {

namespace {

using S = Segment;

constexpr std::array<float, 3> kShirt{0.32f, 0.45f, 0.60f}, kTrousers{0.23f, 0.25f, 0.30f}, kShoes{0.16f, 0.15f, 0.15f};

const dvec3 kTall(1.0, 1.0, 1.45);  ///< Stretch of a roll across the trunk.
constexpr double kOn = 0.010;       ///< m over which a limb goes on; more would swell it there.
constexpr double kMuscle = 0.022;   ///< m over which a muscle lies on a limb.

/// Builds the flesh from ANSUR breadths and depths; lengths in shares of the stature's scale k, girths of limbs with
/// the square root of mass per stature. Shapes are our own choice.
class Sculptor {
 public:
  explicit Sculptor(const Figure& figure) : figure_(figure), flesh_(kBodies) {
    const BodyDimensions& b = figure.body;
    k_ = b[Dimension::kStature] / 1.755;
    g_ = k_ * std::clamp(std::sqrt(b[Dimension::kMass] / b[Dimension::kStature] / (84.6 / 1.755)), 0.7, 1.6);
    female_ = figure.sex == Sex::kFemale;
    hip_ = 0.5 * b[Dimension::kHipBreadth];
    chest_ = 0.5 * b[Dimension::kChestDepth];
    belly_ = 0.5 * b[Dimension::kAbdominalDepth];
    shoulder_ = figure.p_PS[indexOf(S::kLeftClavicle)].y + figure.p_PS[indexOf(S::kLeftUpperArm)].y;
  }

  std::vector<Flesh> make() {
    pelvis();
    back();
    thorax();
    head();
    for (const Side side : {Side::kLeft, Side::kRight}) {
      girdle(side);
      arm(side);
      hand(side);
      leg(side);
      foot(side);
    }
    return std::move(flesh_);
  }

 private:
  Flesh& of(Segment segment) { return flesh_[indexOf(segment)]; }
  dvec3 joint(Segment segment) const { return figure_.p_PS[indexOf(segment)]; }
  /// The same blob left and right.
  void pair(Segment segment, Blob blob) {
    of(segment).blobs.push_back(blob);
    blob.a.y = -blob.a.y;
    blob.b.y = -blob.b.y;
    of(segment).blobs.push_back(blob);
  }
  /// A roll across the trunk. Tall ones that flow into each other over little make a flat front, not a pile of rolls.
  void across(Segment segment, double x, double z, double half_breadth, double radius, const dvec3& stretch) {
    const double reach = std::max(0.0, half_breadth - radius * stretch.y);
    of(segment).blobs.push_back({{x, -reach, z}, {x, reach, z}, radius, radius, stretch, 0.018 * k_});
  }

  void pelvis() {
    of(S::kPelvis) = {{}, 0.05 * k_, -1e9, kTrousers};
    const double depth = 0.62 * belly_ + 0.30 * chest_;
    across(S::kPelvis, 0.004 * k_, 0.000, 0.97 * hip_, depth, {0.92, 1.0, 0.86});
    across(S::kPelvis, 0.006 * k_, 0.070 * k_, 0.90 * hip_, 0.95 * depth, {0.96, 1.0, 1.05});
    pair(S::kPelvis, {{-0.050 * k_, 0.42 * hip_, -0.022 * k_},
                      {-0.048 * k_, 0.42 * hip_, 0.020 * k_},
                      0.082 * g_,
                      0.078 * g_,
                      dvec3(1.0)});
  }

  void back() {
    const double waist = (female_ ? 0.74 : 0.85) * hip_;
    of(S::kLowerBack) = {{}, 0.06 * k_, -1e9, kShirt};
    across(S::kLowerBack, 0.026 * k_, 0.020 * k_, 0.93 * hip_, 0.88 * belly_, kTall);
    across(S::kLowerBack, 0.026 * k_, 0.095 * k_, waist, 0.88 * belly_, kTall);
    of(S::kUpperBack) = {{}, 0.06 * k_, -1e9, kShirt};
    const double rib = (female_ ? 0.76 : 0.80) * shoulder_ + 0.008 * k_;
    across(S::kUpperBack, 0.018 * k_, -0.010 * k_, waist, 0.89 * belly_, kTall);
    across(S::kUpperBack, 0.016 * k_, 0.085 * k_, rib, 0.89 * chest_, kTall);
  }

  void thorax() {
    of(S::kThorax) = {{}, 0.06 * k_, -1e9, kShirt};
    const double neck = joint(S::kLowerNeck).z;
    const double chest = (female_ ? 0.80 : 0.84) * shoulder_ + 0.008 * k_;
    across(S::kThorax, 0.030 * k_, -0.045 * k_, chest, 0.92 * chest_, {1.0, 1.0, 1.3});
    across(S::kThorax, 0.030 * k_, 0.030 * k_, chest, 0.89 * chest_, {1.0, 1.0, 1.1});
    across(S::kThorax, 0.026 * k_, 0.50 * neck, 0.84 * shoulder_, 0.60 * chest_, {1.05, 1.0, 0.9});
    of(S::kThorax)
        .blobs.push_back(
            {{0.012 * k_, 0, 0.56 * neck}, {0.022 * k_, 0, 0.90 * neck}, 0.066 * g_, 0.050 * g_, dvec3(1.0)});
    // Trapezius, from the neck down to the shoulders.
    pair(S::kThorax, {{0.004 * k_, 0.022 * k_, 0.88 * neck},
                      {0.004 * k_, 0.66 * shoulder_, 0.60 * neck},
                      0.036 * g_,
                      0.036 * g_,
                      dvec3(1.0)});
    if (female_) {
      pair(S::kThorax, {{0.068 * k_, 0.42 * shoulder_, -0.028 * k_},
                        {0.090 * k_, 0.46 * shoulder_, -0.040 * k_},
                        0.056 * g_,
                        0.052 * g_,
                        dvec3(1.0)});
    } else {
      pair(S::kThorax, {{0.088 * k_, 0.38 * shoulder_, 0.030 * k_},
                        {0.080 * k_, 0.62 * shoulder_, 0.040 * k_},
                        0.046 * g_,
                        0.040 * g_,
                        {0.8, 1.1, 1.0}});
    }
  }

  void head() {
    const double neck = (female_ ? 0.047 : 0.055) * k_;
    of(S::kLowerNeck) = {{{{0.014 * k_, 0, -0.015 * k_}, {0.010 * k_, 0, 0.055 * k_}, 1.06 * neck, neck, dvec3(1.0)}},
                         0.03 * k_,
                         -1e9,
                         kSkinColor};
    of(S::kUpperNeck) = {{{{0.006 * k_, 0, -0.010 * k_}, {0.012 * k_, 0, 0.050 * k_}, neck, 0.98 * neck, dvec3(1.0)}},
                         0.03 * k_,
                         -1e9,
                         kSkinColor};
    of(S::kHead) = headFlesh(figure_);
  }

  void girdle(Side side) {
    const double out = outwardSign(side);
    const dvec3 shoulder = joint(armSegment(side, S::kLeftUpperArm));
    Flesh& flesh = of(armSegment(side, S::kLeftClavicle));
    flesh = {{}, 0.05 * k_, -1e9, kShirt};
    const dvec3 inner(-0.030 * k_, out * 0.050 * k_, -0.010 * k_);
    flesh.blobs.push_back(
        {inner, shoulder + dvec3(0.0, -out * 0.012 * k_, 0.006 * k_), 0.046 * g_, 0.048 * g_, dvec3(1.0)});
    flesh.blobs.push_back({inner + dvec3(-0.02 * k_, 0, -0.07 * k_),
                           shoulder + dvec3(-0.012 * k_, -out * 0.020 * k_, -0.020 * k_), 0.052 * g_, 0.046 * g_,
                           dvec3(1.0)});
  }

  void arm(Side side) {
    const double out = outwardSign(side), upper = figure_.upperArmLength(), fore = figure_.forearmLength();
    const double r = (female_ ? 0.92 : 1.0) * g_;
    Flesh& top = of(armSegment(side, S::kLeftUpperArm));
    top = {{}, 0.05 * k_, -1e9, kShirt};
    top.blobs.push_back(
        {{0, out * 0.008 * k_, 0.002 * k_}, {0, out * 0.010 * k_, -0.085 * k_}, 0.053 * r, 0.050 * r, dvec3(1.0)});
    top.blobs.push_back({{0, 0, -0.07 * k_}, {0, 0, -upper}, 0.0490 * r, 0.0410 * r, dvec3(1.0), 0.020 * k_});
    top.blobs.push_back(
        {{0.014 * k_, 0, -0.42 * upper}, {0.008 * k_, 0, -0.72 * upper}, 0.040 * r, 0.036 * r, dvec3(1.0), kMuscle});
    top.blobs.push_back(
        {{-0.014 * k_, 0, -0.34 * upper}, {-0.010 * k_, 0, -0.72 * upper}, 0.040 * r, 0.036 * r, dvec3(1.0), kMuscle});
    Flesh& forearm = of(armSegment(side, S::kLeftForearm));
    forearm = {{}, 0.04 * k_, -1e9, kShirt};
    forearm.blobs.push_back({{0, 0, 0}, {0, 0, -0.24 * fore}, 0.0410 * r, 0.0445 * r, dvec3(1.0)});
    forearm.blobs.push_back({{0, 0, -0.24 * fore}, {0, 0, -0.62 * fore}, 0.0445 * r, 0.0365 * r, dvec3(1.0), kOn});
    Flesh& wrist = of(armSegment(side, S::kLeftWrist));
    wrist = {{{{0, 0, 0.08 * fore}, {0, 0, -0.30 * fore}, 0.0385 * r, 0.0295 * r, dvec3(1.0)},
              {{0, 0, -0.30 * fore}, {0, 0, -0.50 * fore}, 0.0280 * r, 0.0225 * r, {1.20, 0.96, 1.0}, kOn}},
             0.04 * k_,
             -1e9,
             kSkinColor};
  }

  void hand(Side side) {
    const double out = outwardSign(side);
    const double length = figure_.body[Dimension::kHandLength], breadth = figure_.body[Dimension::kHandBreadth];
    Flesh& palm = of(armSegment(side, S::kLeftHand));
    palm = {{}, 0.010 * k_, -1e9, kSkinColor};
    const double thick = 0.150 * breadth;
    palm.blobs.push_back({{0, 0, 0.004}, {0, 0, -0.10 * length}, 0.200 * breadth, 0.180 * breadth, {1.30, 0.92, 1.0}});
    const auto bones = phalangesOf(figure_, side);
    const std::array<double, 4> wrist = {0.17, 0.06, -0.07, -0.18};
    for (std::size_t f = 0; f < 4; ++f) {
      const dvec3 knuckle = bones[f + 1][0].p_Joint;
      palm.blobs.push_back(
          {{wrist[f] * breadth, 0, -0.08 * length}, knuckle, 1.05 * thick, bones[f + 1][0].radius * 1.08, dvec3(1.0)});
    }
    palm.blobs.push_back({{0.16 * breadth, -out * 0.09 * breadth, -0.12 * length},
                          {0.24 * breadth, -out * 0.10 * breadth, -0.30 * length},
                          0.150 * breadth,
                          0.110 * breadth,
                          dvec3(1.0)});
    palm.blobs.push_back({{-0.20 * breadth, -out * 0.07 * breadth, -0.12 * length},
                          {-0.28 * breadth, -out * 0.05 * breadth, -0.34 * length},
                          0.135 * breadth,
                          0.105 * breadth,
                          dvec3(1.0)});
    for (std::size_t d = 0; d < kDigits; ++d) {
      for (std::size_t k = 0; k < kPhalanges; ++k) {
        const Phalanx& bone = bones[d][k];
        const double end = k + 1 < kPhalanges ? bones[d][k + 1].radius : 0.86 * bone.radius;
        const double reach = bone.length - (k + 1 < kPhalanges ? 0.0 : end);
        flesh_[phalanxBody(side, d, k)] = {
            {{dvec3(0.0), reach * bone.along, bone.radius, end, dvec3(1.0)}}, 0.006 * k_, -1e9, kSkinColor};
      }
    }
  }

  void leg(Side side) {
    const double out = outwardSign(side), thigh = figure_.thighLength(), shank = figure_.shankLength();
    const double top = std::min(0.5 * figure_.body[Dimension::kThighClearance], 0.60 * hip_);
    Flesh& upper = of(legSegment(side, S::kLeftThigh));
    upper = {{}, 0.06 * k_, -1e9, kTrousers};
    upper.blobs.push_back(
        {{0, out * 0.004 * k_, -0.005 * k_}, {0.004 * k_, 0, -0.45 * thigh}, 0.98 * top, 0.84 * top, dvec3(1.0)});
    upper.blobs.push_back(
        {{0.004 * k_, 0, -0.45 * thigh}, {0.002 * k_, 0, -thigh}, 0.84 * top, 0.0580 * g_, dvec3(1.0), kOn});
    upper.blobs.push_back({{0.018 * k_, out * 0.008 * k_, -0.24 * thigh},
                           {0.016 * k_, 0, -0.70 * thigh},
                           0.80 * top,
                           0.064 * g_,
                           dvec3(1.0),
                           kMuscle});
    Flesh& lower = of(legSegment(side, S::kLeftShank));
    lower = {{}, 0.05 * k_, -1e9, kTrousers};
    lower.blobs.push_back({{0.004 * k_, 0, 0}, {0.002 * k_, 0, -0.34 * shank}, 0.0570 * g_, 0.0540 * g_, dvec3(1.0)});
    lower.blobs.push_back(
        {{0.002 * k_, 0, -0.34 * shank}, {0, 0, -0.97 * shank}, 0.0540 * g_, 0.0390 * g_, dvec3(1.0), kOn});
    lower.blobs.push_back({{-0.020 * k_, 0, -0.16 * shank},
                           {-0.014 * k_, 0, -0.52 * shank},
                           0.048 * g_,
                           0.040 * g_,
                           dvec3(1.0),
                           kMuscle});
  }

  void foot(Side side) {
    const Sole& sole = figure_.sole;
    const double out = outwardSign(side), ball = 0.5 * sole.ball_width;
    Flesh& flesh = of(legSegment(side, S::kLeftFoot));
    flesh = {{}, 0.03 * k_, sole.z, kShoes};
    const double heel = 0.56 * sole.heel_width;
    flesh.blobs.push_back({{0, 0, 0.02 * k_}, {-0.010 * k_, 0, -0.02 * k_}, 0.0400 * k_, 0.040 * k_, dvec3(1.0)});
    flesh.blobs.push_back({{sole.heel_x + heel, 0, sole.z + 0.62 * heel},
                           {0.02 * k_, 0, sole.z + 0.030 * k_},
                           heel,
                           heel,
                           {1.0, 1.0, 1.0}});
    flesh.blobs.push_back({{0.010 * k_, 0, -0.015 * k_},
                           {sole.ball_x, -out * 0.004 * k_, sole.z + 0.024 * k_},
                           0.040 * k_,
                           0.029 * k_,
                           {1.0, 1.15, 1.0}});
    flesh.blobs.push_back({{0.35 * sole.ball_x, 0, sole.z + 0.020 * k_},
                           {sole.ball_x, 0, sole.z + 0.020 * k_},
                           0.026 * k_,
                           0.026 * k_,
                           {1.0, ball / (0.027 * k_), 1.0}});
    Flesh& toes = of(legSegment(side, S::kLeftToes));
    const double below = sole.z - joint(legSegment(side, S::kLeftToes)).z, reach = sole.toe_x - sole.ball_x;
    toes = {{}, 0.02 * k_, below, kShoes};
    toes.blobs.push_back({{0, 0, below + 0.020 * k_},
                          {0.45 * reach, 0, below + 0.018 * k_},
                          0.026 * k_,
                          0.024 * k_,
                          {1.0, ball / (0.027 * k_), 1.0}});
    toes.blobs.push_back({{0.40 * reach, -out * 0.004 * k_, below + 0.018 * k_},
                          {reach - 0.026 * k_, -out * 0.006 * k_, below + 0.016 * k_},
                          0.026 * k_,
                          0.024 * k_,
                          {1.0, 1.45, 1.0}});
  }

  const Figure& figure_;
  std::vector<Flesh> flesh_;
  double k_ = 1.0, g_ = 1.0, hip_ = 0.0, chest_ = 0.0, belly_ = 0.0, shoulder_ = 0.0;
  bool female_ = false;
};

}  // namespace

std::vector<Flesh> fleshOf(const Figure& figure) {
  return Sculptor(figure).make();
}

}  // namespace hapticell::mannequin
