// SPDX-License-Identifier: Apache-2.0
#include "mannequin/body/figure.h"

#include <cmath>
#include <numbers>

#include "geometry/system/assertion.h"

namespace hapticell::mannequin {

namespace {

using D = Dimension;
using S = Segment;

/// Landmarks are not joint centres; what lies between them, metres at a stature of 1.755 m, scaled with it. The marked
/// figures of the sources' list for shoulder and hip, the rest our own choice (docs/dev/mannequin.md).
struct Offsets {
  double k;
  double hip_above_trochanterion = 0.020 * k;
  double shoulder_below_acromion = 0.040 * k;
  double shoulder_inside_acromion = 0.030 * k;
  double l5_below_iliocristale = 0.045 * k;
  double l1_above_tenth_rib = 0.050 * k;
  double skullbase_below_tragion = 0.010 * k;
  double sternoclavicular_below_suprasternale = 0.010 * k;
};

/// Joint centres at zero posture in the world: X forward of the hips, floor at 0; the left side's.
std::array<dvec3, kSegmentCount> jointCentres(const BodyDimensions& b) {
  const double k = b[D::kStature] / 1.755;
  const Offsets off{k};
  std::array<dvec3, kSegmentCount> p{};
  const auto at = [&](Segment segment) -> dvec3& { return p[indexOf(segment)]; };
  const double hip = b[D::kTrochanterionHeight] + off.hip_above_trochanterion;
  const double c7 = b[D::kCervicaleHeight];
  const double l1 = b[D::kTenthRibHeight] + off.l1_above_tenth_rib;
  const double skull = b[D::kStature] - b[D::kTragionToTopOfHead] - off.skullbase_below_tragion;
  at(S::kPelvis) = {0.0, 0.0, hip};
  at(S::kLowerBack) = {-0.025 * k, 0.0, b[D::kIliocristaleHeight] - off.l5_below_iliocristale};
  at(S::kUpperBack) = {-0.015 * k, 0.0, l1};
  at(S::kThorax) = {-0.030 * k, 0.0, l1 + 0.45 * (c7 - l1)};
  at(S::kLowerNeck) = {0.0, 0.0, c7};
  at(S::kUpperNeck) = {0.008 * k, 0.0, 0.5 * (c7 + skull)};
  at(S::kHead) = {0.016 * k, 0.0, skull};
  const double shoulder_y = 0.5 * b[D::kBiacromialBreadth] - off.shoulder_inside_acromion;
  const double elbow = b[D::kAcromialHeight] - b[D::kAcromionRadialeLength];
  const double wrist = elbow - b[D::kRadialeStylionLength];
  at(S::kLeftClavicle) = {0.050 * k, 0.020 * k, b[D::kSuprasternaleHeight] - off.sternoclavicular_below_suprasternale};
  at(S::kLeftUpperArm) = {0.005 * k, shoulder_y, b[D::kAcromialHeight] - off.shoulder_below_acromion};
  at(S::kLeftForearm) = {0.005 * k, shoulder_y, elbow};
  at(S::kLeftWrist) = {0.005 * k, shoulder_y, 0.5 * (elbow + wrist)};
  at(S::kLeftHand) = {0.005 * k, shoulder_y, wrist};
  const double hip_y = 0.31 * b[D::kBicristalBreadth];
  at(S::kLeftThigh) = {0.0, hip_y, hip};
  at(S::kLeftShank) = {0.0, hip_y, b[D::kLateralFemoralEpicondyleHeight]};
  at(S::kLeftFoot) = {0.0, hip_y, b[D::kLateralMalleolusHeight]};
  at(S::kLeftToes) = {b[D::kBallOfFootLength] - 0.24 * b[D::kFootLength], hip_y, 0.022 * k};
  for (const S left : {S::kLeftClavicle, S::kLeftUpperArm, S::kLeftForearm, S::kLeftWrist, S::kLeftHand}) {
    p[indexOf(armSegment(Side::kRight, left))] = at(left) * dvec3(1.0, -1.0, 1.0);
  }
  for (const S left : {S::kLeftThigh, S::kLeftShank, S::kLeftFoot, S::kLeftToes}) {
    p[indexOf(legSegment(Side::kRight, left))] = at(left) * dvec3(1.0, -1.0, 1.0);
  }
  return p;
}

/// de Leva (J. Biomechanics 29, 1996): mass as a fraction of the body, centre as a fraction from the proximal end.
struct Part {
  double mass, centre;
};
struct PartTable {
  Part head, upper_trunk, middle_trunk, lower_trunk, upper_arm, forearm, hand, thigh, shank, foot;
  double lower_length, middle_length;  ///< Of the trunk parts, fraction of cervicale to mid-hip.
};
constexpr std::array<PartTable, 2> kParts = {{
    {{.0694, .5002},
     {.1596, .5066},
     {.1633, .4502},
     {.1117, .6115},
     {.0271, .5772},
     {.0162, .4574},
     {.0061, .7900},
     {.1416, .4095},
     {.0433, .4395},
     {.0137, .4415},
     .2415,
     .3572},
    {{.0668, .4841},
     {.1545, .5050},
     {.1465, .4512},
     {.1247, .4920},
     {.0255, .5754},
     {.0138, .4559},
     {.0056, .7474},
     {.1478, .3612},
     {.0481, .4352},
     {.0129, .4014},
     .2952,
     .3339},
}};

/// Spreads the table's parts over the segments; centres in the world at zero posture.
class MassSpread {
 public:
  MassSpread(Sex sex, const BodyDimensions& body, const std::array<dvec3, kSegmentCount>& joints)
      : t_(kParts[static_cast<std::size_t>(sex)]), b_(body), p_(joints), k_(body[D::kStature] / 1.755) {
    spreadTrunk();
    spreadHead();
    for (const Side side : {Side::kLeft, Side::kRight}) {
      spreadArm(side);
      spreadLeg(side);
    }
  }

  void giveTo(Figure& figure) const {
    double sum = 0.0;
    for (const double m : mass_) sum += m;
    for (std::size_t i = 0; i < kSegmentCount; ++i) {
      figure.mass[i] = mass_[i] * b_[D::kMass] / sum;
      figure.p_SC[i] = centre_[i] - p_[i];
    }
  }

 private:
  dvec3 joint(Segment segment) const { return p_[indexOf(segment)]; }
  void set(Segment segment, double mass, const dvec3& p_WC) {
    mass_[indexOf(segment)] = mass;
    centre_[indexOf(segment)] = p_WC;
  }
  /// The last part of a group gets what makes the whole group's centre `p_WC`.
  void setRest(Segment segment, double mass, const dvec3& p_WC, std::initializer_list<Segment> others) {
    double whole = mass;
    dvec3 moment(0.0);
    for (const Segment s : others) {
      whole += mass_[indexOf(s)];
      moment += mass_[indexOf(s)] * centre_[indexOf(s)];
    }
    set(segment, mass, (whole * p_WC - moment) / mass);
  }

  void spreadTrunk() {
    const double hip = joint(S::kPelvis).z, trunk = b_[D::kCervicaleHeight] - hip;
    const double lower = t_.lower_length * trunk, middle = t_.middle_length * trunk, upper = trunk - lower - middle;
    set(S::kPelvis, t_.lower_trunk.mass, {0.0, 0.0, hip + (1.0 - t_.lower_trunk.centre) * lower});
    const dvec3 mid(0.015 * k_, 0.0, hip + lower + (1.0 - t_.middle_trunk.centre) * middle);
    const dvec3 half(0.0, 0.0, 0.22 * middle);
    set(S::kLowerBack, 0.5 * t_.middle_trunk.mass, mid - half);
    set(S::kUpperBack, 0.5 * t_.middle_trunk.mass, mid + half);
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const S clavicle = armSegment(side, S::kLeftClavicle);
      const dvec3 p_WC = 0.5 * (joint(clavicle) + joint(armSegment(side, S::kLeftUpperArm)));
      set(clavicle, 0.1 * t_.upper_trunk.mass, p_WC - dvec3(0.03 * k_, 0.0, 0.02 * k_));
    }
    setRest(S::kThorax, 0.8 * t_.upper_trunk.mass,
            {0.010 * k_, 0.0, b_[D::kCervicaleHeight] - t_.upper_trunk.centre * upper},
            {S::kLeftClavicle, S::kRightClavicle});
  }

  void spreadHead() {
    const dvec3 c7 = joint(S::kLowerNeck), c4 = joint(S::kUpperNeck), skull = joint(S::kHead);
    set(S::kLowerNeck, 0.09 * t_.head.mass, 0.5 * (c7 + c4));
    set(S::kUpperNeck, 0.09 * t_.head.mass, 0.5 * (c4 + skull));
    const double height = b_[D::kStature] - b_[D::kCervicaleHeight];
    setRest(S::kHead, 0.82 * t_.head.mass, {0.025 * k_, 0.0, b_[D::kStature] - t_.head.centre * height},
            {S::kLowerNeck, S::kUpperNeck});
  }

  void spreadArm(Side side) {
    const S forearm = armSegment(side, S::kLeftForearm), wrist = armSegment(side, S::kLeftWrist);
    const dvec3 shoulder = joint(armSegment(side, S::kLeftUpperArm)), elbow = joint(forearm);
    const dvec3 hand = joint(armSegment(side, S::kLeftHand));
    set(armSegment(side, S::kLeftUpperArm), t_.upper_arm.mass, shoulder + t_.upper_arm.centre * (elbow - shoulder));
    set(forearm, 0.6 * t_.forearm.mass, elbow + 0.27 * (hand - elbow));
    setRest(wrist, 0.4 * t_.forearm.mass, elbow + t_.forearm.centre * (hand - elbow), {forearm});
    // The third knuckle lies at about 0.45 of the hand's length.
    set(armSegment(side, S::kLeftHand), t_.hand.mass, hand - dvec3(0, 0, t_.hand.centre * 0.45 * b_[D::kHandLength]));
  }

  void spreadLeg(Side side) {
    const S thigh = legSegment(side, S::kLeftThigh), shank = legSegment(side, S::kLeftShank);
    const S foot = legSegment(side, S::kLeftFoot), toes = legSegment(side, S::kLeftToes);
    set(thigh, t_.thigh.mass, joint(thigh) + t_.thigh.centre * (joint(shank) - joint(thigh)));
    set(shank, t_.shank.mass, joint(shank) + t_.shank.centre * (joint(foot) - joint(shank)));
    const double heel = joint(foot).x - 0.24 * b_[D::kFootLength];
    const double tip = heel + b_[D::kFootLength];
    set(toes, 0.12 * t_.foot.mass, {0.5 * (joint(toes).x + tip), joint(toes).y, 0.015 * k_});
    setRest(foot, 0.88 * t_.foot.mass, {heel + t_.foot.centre * b_[D::kFootLength], joint(foot).y, 0.5 * joint(foot).z},
            {toes});
  }

  const PartTable& t_;
  const BodyDimensions& b_;
  const std::array<dvec3, kSegmentCount>& p_;
  double k_;
  std::array<double, kSegmentCount> mass_{};
  std::array<dvec3, kSegmentCount> centre_{};
};

/// Heights that must rise from the floor to the vertex, with room for a joint between them.
Expected<void> checkOrder(const std::array<dvec3, kSegmentCount>& p, double stature) {
  const std::array<std::pair<Text, double>, 10> heights = {{HAPTICELL_TRANSLATED(
      {"the ankle", p[indexOf(S::kLeftFoot)].z}, {"the knee", p[indexOf(S::kLeftShank)].z},
      {"the hip", p[indexOf(S::kLeftThigh)].z}, {"the joint L5", p[indexOf(S::kLowerBack)].z},
      {"the joint L1", p[indexOf(S::kUpperBack)].z}, {"the joint T6", p[indexOf(S::kThorax)].z},
      {"the joint C7", p[indexOf(S::kLowerNeck)].z}, {"the joint C4", p[indexOf(S::kUpperNeck)].z},
      {"the base of the skull", p[indexOf(S::kHead)].z}, {"the top of the head", stature})}};
  for (std::size_t i = 1; i < heights.size(); ++i) {
    if (heights[i].second - heights[i - 1].second > 0.01) continue;
    return makeError({.place = "your own measures",
                      .found = Text("%1 is not above %2", heights[i].first, heights[i - 1].first),
                      .expected = "measures that fit one body",
                      .fix = "Change your own measures together, or leave some of them to the regressions."});
  }
  return {};
}

void placeLandmarks(const BodyDimensions& b, const std::array<dvec3, kSegmentCount>& p, Figure& figure) {
  const double k = b[D::kStature] / 1.755;
  const double foot = b[D::kFootLength];
  figure.sole = {-0.24 * foot,
                 b[D::kBallOfFootLength] - 0.24 * foot,
                 0.76 * foot,
                 -p[indexOf(S::kLeftFoot)].z,
                 0.62 * b[D::kFootBreadth],
                 b[D::kFootBreadth]};
  const dvec3& head = p[indexOf(S::kHead)];
  const double eye_height = b[D::kStature] - (b[D::kSittingHeight] - b[D::kEyeHeightSitting]);
  const double head_centre_x = head.x + 0.012 * k;
  figure.p_HeadEyes = dvec3(head_centre_x + 0.42 * b[D::kHeadLength], 0.0, eye_height) - head;
  figure.p_HeadVertex = dvec3(head_centre_x, 0.0, b[D::kStature]) - head;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const double outward = side == Side::kLeft ? 1.0 : -1.0;
    const std::size_t i = side == Side::kLeft ? 0 : 1;
    const dvec3 acromion(p[indexOf(S::kLeftUpperArm)].x, outward * 0.5 * b[D::kBiacromialBreadth],
                         b[D::kAcromialHeight]);
    figure.p_ClavicleAcromion[i] = acromion - p[indexOf(armSegment(side, S::kLeftClavicle))];
    // A bar in the fist lies on the palm side, below the knuckles.
    figure.p_HandGrip[i] = {0.0, -outward * 0.20 * b[D::kHandLength], -0.40 * b[D::kHandLength]};
  }
}

}  // namespace

Expected<Figure> makeFigure(const BodyRequest& request) {
  const Expected<BodyDimensions> body = bodyDimensions(request);
  HAPTICELL_TRY(body);
  const auto joints = jointCentres(*body);
  HAPTICELL_TRY(checkOrder(joints, request.stature));
  Figure figure;
  figure.sex = request.sex;
  figure.body = *body;
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    const auto parent = segmentInfo(static_cast<Segment>(i)).parent;
    figure.p_PS[i] = joints[i] - (parent ? joints[indexOf(*parent)] : dvec3(0.0));
  }
  MassSpread(request.sex, *body, joints).giveTo(figure);
  placeLandmarks(*body, joints, figure);
  return figure;
}

std::vector<NamedFigure> boundaryFigures() {
  struct Wanted {
    const char* name;
    Sex sex;
    double percentile;
  };
  std::vector<NamedFigure> figures;
  for (const Wanted& wanted : {Wanted{"P5F", Sex::kFemale, 5.0}, Wanted{"P50F", Sex::kFemale, 50.0},
                               Wanted{"P50M", Sex::kMale, 50.0}, Wanted{"P95M", Sex::kMale, 95.0}}) {
    Expected<Figure> figure = makeFigure({wanted.sex, *statureOfPercentile(wanted.sex, wanted.percentile)});
    HAPTICELL_DEMAND(figure.has_value());
    figures.push_back({wanted.name, std::move(*figure)});
  }
  return figures;
}

std::map<std::string, double> measuresOf(const Figure& figure) {
  std::array<dvec3, kSegmentCount> p{};
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    const auto parent = segmentInfo(static_cast<Segment>(i)).parent;
    p[i] = figure.p_PS[i] + (parent ? p[indexOf(*parent)] : dvec3(0.0));
  }
  const auto at = [&](Segment segment) { return p[indexOf(segment)]; };
  const double k = figure.body[D::kStature] / 1.755;
  const Offsets off{k};
  const dvec3 acromion = at(S::kLeftClavicle) + figure.p_ClavicleAcromion[0];
  const double hand = figure.body[D::kHandLength];
  // Arms sideways: the girdle drawn back by 15 deg about the sternoclavicular joint (raising it hardly matters).
  const dvec3 girdle = figure.p_PS[indexOf(S::kLeftUpperArm)];
  const double back = 15.0 * std::numbers::pi / 180.0;
  const double shoulder_y = at(S::kLeftClavicle).y + girdle.y * std::cos(back) + girdle.x * std::sin(back);
  const double knee = at(S::kLeftShank).z, stature = (at(S::kHead) + figure.p_HeadVertex).z;
  return {{"stature", stature},
          {"span", 2.0 * (shoulder_y + figure.upperArmLength() + figure.forearmLength() + hand)},
          {"acromial_height", acromion.z},
          {"elbow_height", at(S::kLeftForearm).z},
          {"wrist_height", at(S::kLeftHand).z},
          {"trochanter_height", at(S::kLeftThigh).z - off.hip_above_trochanterion},
          {"knee_height", knee},
          {"tibial_height", knee - 0.0165 * stature},
          {"ankle_height", at(S::kLeftFoot).z},
          {"cervicale_height", at(S::kLowerNeck).z},
          {"eye_height", (at(S::kHead) + figure.p_HeadEyes).z},
          {"sitting_height", figure.body[D::kSittingHeight]},
          {"biacromial_breadth", 2.0 * acromion.y},
          {"bideltoid_breadth", figure.body[D::kBideltoidBreadth]},
          {"hip_breadth", figure.body[D::kHipBreadth]},
          {"upper_arm_length", acromion.z - at(S::kLeftForearm).z},
          {"forearm_length", figure.forearmLength()},
          {"hand_length", hand},
          {"foot_length", figure.sole.toe_x - figure.sole.heel_x}};
}

}  // namespace hapticell::mannequin
