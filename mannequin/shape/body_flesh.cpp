// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "mannequin/body/girths.h"
#include "mannequin/body/rotations.h"
#include "mannequin/shape/body_sections.h"
#include "mannequin/shape/body_shape.h"
#include "mannequin/shape/head_flesh.h"

namespace hapticell::mannequin {

namespace {

using S = Segment;

constexpr std::array<float, 3> kShirt{0.32f, 0.45f, 0.60f}, kTrousers{0.23f, 0.25f, 0.30f}, kShoes{0.16f, 0.15f, 0.15f};

/// m over which a limb goes on; more would swell it there. Half: seams at joints are seen; twice: swollen joints.
constexpr double kOn = 0.006;

/// Builds the flesh from ANSUR breadths and depths; lengths in shares of the stature's scale k, girths of limbs with
/// the square root of mass per stature. Shapes are our own choice.
class Sculptor {
 public:
  explicit Sculptor(const Figure& figure)
      : figure_(figure), flesh_(kBodies), trunk_({0, 0, 0}, {0, 0, 1}, {0, -1, 0}, trunkSections(figure)) {
    const BodyDimensions& b = figure.body;
    k_ = b[Dimension::kStature] / 1.755;
    g_ = k_ * std::clamp(std::sqrt(b[Dimension::kMass] / b[Dimension::kStature] / (84.6 / 1.755)), 0.7, 1.6);
    female_ = figure.sex == Sex::kFemale;
    hip_ = 0.5 * b[Dimension::kHipBreadth];
    for (std::size_t i = 0; i < kSegmentCount; ++i) {
      const auto parent = segmentInfo(static_cast<Segment>(i)).parent;
      origins_[i] = figure.p_PS[i] + (parent ? origins_[indexOf(*parent)] : dvec3(0.0));
    }
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
  /// Of a standing figure, over the floor.
  dvec3 originOf(Segment segment) const { return origins_[indexOf(segment)]; }
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

  /// Rolls about the sections of the trunk that lie between two heights (m over the floor), in a body's frame.
  void stack(Segment segment, double from, double to) {
    const dvec3 origin = origins_[indexOf(segment)];
    const double step = 0.030 * k_;
    const int count = std::max(1, static_cast<int>(std::lround((to - from) / step)));
    for (int i = 0; i <= count; ++i) {
      const TubeSection section = trunk_.at(from + (to - from) * i / count);
      const double depth = 0.5 * (section.front + section.back), x = section.v + 0.5 * (section.front - section.back);
      // So tall that neighbours run into each other over little, or they would be a pile of rolls.
      const double tall = 1.5 * (to - from) / count / depth;
      // Rounded off like the section: a roll is broader at its corners than an ellipse.
      const double breadth = section.half_breadth * (1.0 - 0.06 * std::clamp(2.8 - section.roundness, 0.0, 0.8));
      across(segment, x - origin.x, section.t - origin.z, breadth, depth, {1.0, 1.0, std::max(tall, 0.42)});
    }
  }

  void pelvis() {
    of(S::kPelvis) = {{}, 0.05 * k_, -1e9, kTrousers};
    const double crotch = trunk_.sections().front().t;
    stack(S::kPelvis, crotch + 0.052 * k_, originOf(S::kLowerBack).z + 0.010 * k_);
    // The seat, behind the tops of the legs.
    pair(S::kPelvis, {{-0.046 * k_, 0.45 * hip_, -0.001 * k_},
                      {-0.044 * k_, 0.45 * hip_, 0.030 * k_},
                      0.078 * g_,
                      0.074 * g_,
                      dvec3(1.0)});
  }

  void back() {
    of(S::kLowerBack) = {{}, 0.06 * k_, -1e9, kShirt};
    stack(S::kLowerBack, originOf(S::kLowerBack).z - 0.010 * k_, originOf(S::kUpperBack).z + 0.010 * k_);
    of(S::kUpperBack) = {{}, 0.06 * k_, -1e9, kShirt};
    stack(S::kUpperBack, originOf(S::kUpperBack).z - 0.010 * k_, originOf(S::kThorax).z + 0.010 * k_);
  }

  void thorax() {
    of(S::kThorax) = {{}, 0.06 * k_, -1e9, kShirt};
    const double neck = joint(S::kLowerNeck).z;
    stack(S::kThorax, originOf(S::kThorax).z - 0.010 * k_, trunk_.sections().back().t - 0.020 * k_);
    of(S::kThorax)
        .blobs.push_back(
            {{0.012 * k_, 0, 0.56 * neck}, {0.026 * k_, 0, 0.92 * neck}, 0.066 * g_, 0.056 * g_, dvec3(1.0)});
    if (!female_) return;
    const double depth = figure_.body[Dimension::kChestDepth],
                 z = girthOf(figure_.sex, figure_.body, Girth::kChestHeight);
    const TubeSection chest = trunk_.at(z);
    const dvec3 middle = dvec3(chest.v + chest.front + 0.140 * depth - 0.203 * depth, 0.43 * chest.half_breadth, z) -
                         originOf(S::kThorax);
    pair(S::kThorax, {middle + dvec3(-0.010 * k_, 0.0, 0.024 * k_),
                      middle,
                      0.239 * depth,
                      0.260 * depth,
                      {0.78, 1.0, 0.96},
                      0.030 * k_});
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

  /// The pieces of a limb between two places along it, from its sections; in the frame of a segment that begins at
  /// `origin` along it.
  void limb(Segment segment, const SectionTube& tube, double from, double to, double origin) {
    // m a piece of a limb that follows its girths. Half: twice the capsules, slower distances; twice: limbs look like
    // chains.
    constexpr double kPiece = 0.055;
    const int count = std::max(1, static_cast<int>(std::lround((to - from) / (kPiece * k_))));
    for (int i = 0; i < count; ++i) {
      const TubeSection a = tube.at(from + (to - from) * i / count), b = tube.at(from + (to - from) * (i + 1) / count);
      const double broad_a = a.half_breadth, deep_a = 0.5 * (a.front + a.back);
      const double broad_b = b.half_breadth, deep_b = 0.5 * (b.front + b.back);
      const double ra = std::sqrt(broad_a * deep_a), rb = std::sqrt(broad_b * deep_b);
      const double flat = std::sqrt((broad_a + broad_b) / (deep_a + deep_b));
      const dvec3 pa = tube.place(a.t - origin, a.u, a.v), pb = tube.place(b.t - origin, b.u, b.v);
      // A tube's axis points down; its u is either ahead (arms) or to the left (legs).
      const bool u_ahead = std::abs(tube.across().x) > 0.5;
      of(segment).blobs.push_back(
          {pa, pb, ra, rb, u_ahead ? dvec3(flat, 1.0 / flat, 1.0) : dvec3(1.0 / flat, flat, 1.0), kOn});
    }
  }

  void arm(Side side) {
    const double upper = figure_.upperArmLength(), fore = figure_.forearmLength();
    const SectionTube tube({0, 0, 0}, {0, 0, -1}, {1, 0, 0}, armSections(figure_, -outwardSign(side)));
    of(armSegment(side, S::kLeftUpperArm)) = {{}, 0.05 * k_, -1e9, kShirt};
    limb(armSegment(side, S::kLeftUpperArm), tube, -0.010 * k_, upper, 0.0);
    of(armSegment(side, S::kLeftForearm)) = {{}, 0.04 * k_, -1e9, kShirt};
    limb(armSegment(side, S::kLeftForearm), tube, upper, upper + 0.62 * fore, upper);
    Flesh& wrist = of(armSegment(side, S::kLeftWrist));
    wrist = {{}, 0.04 * k_, -1e9, kSkinColor};
    const double half = figure_.p_PS[indexOf(armSegment(side, S::kLeftWrist))].z;  // Below the elbow, negative.
    limb(armSegment(side, S::kLeftWrist), tube, upper + 0.42 * fore, upper + 0.98 * fore, upper - half);
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
    const double thigh = figure_.thighLength(), shank = figure_.shankLength();
    const SectionTube tube({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, legSections(figure_, outwardSign(side)));
    of(legSegment(side, S::kLeftThigh)) = {{}, 0.06 * k_, -1e9, kTrousers};
    limb(legSegment(side, S::kLeftThigh), tube, -0.010 * k_, thigh, 0.0);
    of(legSegment(side, S::kLeftShank)) = {{}, 0.05 * k_, -1e9, kTrousers};
    limb(legSegment(side, S::kLeftShank), tube, thigh, thigh + 0.97 * shank, thigh);
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
  const SectionTube trunk_;
  std::array<dvec3, kSegmentCount> origins_{};
  double k_ = 1.0, g_ = 1.0, hip_ = 0.0;
  bool female_ = false;
};

}  // namespace

std::vector<Flesh> fleshOf(const Figure& figure) {
  return Sculptor(figure).make();
}

}  // namespace hapticell::mannequin
