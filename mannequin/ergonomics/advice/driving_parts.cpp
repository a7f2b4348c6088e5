// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/advice/driving_parts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/system/text.h"
#include "mannequin/ergonomics/advice/advice_words.h"
#include "mannequin/ergonomics/scores/figure_measurement.h"

namespace hapticell::ergonomics {
namespace {

using mannequin::FigurePose;
using mannequin::Segment;
using mannequin::Side;

/// A part with what decides its place in the list.
struct Ranked {
  DrivingPart part;
  double score_without = 0.0;
  double share = 0.0;  ///< Of its range.
};

std::vector<DrivingPart> best(std::vector<Ranked> ranked, std::size_t most) {
  std::erase_if(ranked, [](const Ranked& one) { return one.share <= 0.0; });
  std::stable_sort(ranked.begin(), ranked.end(), [](const Ranked& a, const Ranked& b) {
    return a.score_without != b.score_without ? a.score_without < b.score_without : a.share > b.share;
  });
  std::vector<DrivingPart> parts;
  for (std::size_t i = 0; i < std::min(most, ranked.size()); ++i) parts.push_back(ranked[i].part);
  return parts;
}

double angleOf(const MeasuredPosture& measured, BodyPart part) {
  switch (part) {
    case BodyPart::kUpperArm:
      return measured.upper_arm_flexion;
    case BodyPart::kLowerArm:
      return measured.lower_arm_flexion;
    case BodyPart::kWrist:
      return measured.wrist_flexion;
    case BodyPart::kNeck:
      return measured.neck_flexion;
    case BodyPart::kTrunk:
      return measured.trunk_flexion;
    case BodyPart::kLegs:
      return measured.knee_flexion;
  }
  return 0.0;
}

Side bentKnee(const PostureScores& scores) {
  return scores.owas_posture.left_knee_flexion > scores.owas_posture.right_knee_flexion ? Side::kLeft : Side::kRight;
}

template <std::size_t kCount>
std::vector<Ranked> rankedParts(const ScoredMethod& method, const std::array<std::optional<int>, kCount>& given,
                                const std::array<std::pair<std::size_t, BodyPart>, 6>& parts,
                                const PostureScores& scores, Side side) {
  std::array<int, kCount> values{};
  for (std::size_t i = 0; i < kCount; ++i) values[i] = given[i].value_or(method.subScores()[i].least);
  const int now = method.score(values);
  std::vector<Ranked> ranked;
  for (const auto& [index, part] : parts) {
    const SubScore& sub = method.subScores()[index];
    const int had = values[index];
    values[index] = sub.least;
    const int without = method.score(values);
    values[index] = had;
    const Side of = part == BodyPart::kLegs ? bentKnee(scores) : side;
    const double angle = angleOf(scores.sides[static_cast<std::size_t>(side)].measured, part);
    ranked.push_back({{part, of, angle, bandOfSubScore(sub, had), without < now},
                      static_cast<double>(without),
                      static_cast<double>(had - sub.least) / std::max(1, sub.greatest - sub.least)});
  }
  return ranked;
}

std::vector<Ranked> owasParts(const PostureScores& scores) {
  const Owas method;
  std::array<int, Owas::kCount> values{};
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = scores.owas[i].value_or(1);
  const auto higher = scores.sides[0].measured.upper_arm_flexion > scores.sides[1].measured.upper_arm_flexion
                          ? Side::kLeft
                          : Side::kRight;
  constexpr int kStraightLegs = 2;
  const std::array<std::tuple<std::size_t, int, BodyPart, Side>, 3> parts{
      {{Owas::kBack, 1, BodyPart::kTrunk, higher},
       {Owas::kArms, 1, BodyPart::kUpperArm, higher},
       {Owas::kLegs, kStraightLegs, BodyPart::kLegs, bentKnee(scores)}}};
  std::vector<Ranked> ranked;
  for (const auto& [index, easy, part, side] : parts) {
    const int had = values[index];
    if (had == easy || (index == Owas::kLegs && (had == 1 || had == 7))) continue;
    values[index] = easy;
    const int without = method.score(values);
    values[index] = had;
    const double angle = angleOf(scores.sides[static_cast<std::size_t>(side)].measured, part);
    const bool lowers = without < scores.owas_category;
    ranked.push_back({{part, side, angle, lowers ? bandOfOwas(scores.owas_category) : 1, lowers},
                      static_cast<double>(without),
                      1.0});
  }
  return ranked;
}

BodyPart bodyPartOf(std::string_view judged) {
  if (judged.starts_with("trunk")) return BodyPart::kTrunk;
  if (judged == "line of sight" || judged == "head inclination") return BodyPart::kNeck;
  return BodyPart::kUpperArm;
}

std::vector<Ranked> zoneParts(const PartVerdicts& verdicts, Side side) {
  std::vector<Ranked> ranked;
  const auto worst = std::count_if(verdicts.parts.begin(), verdicts.parts.end(),
                                   [&](const PartVerdict& part) { return part.zone == verdicts.worst; });
  for (const PartVerdict& judged : verdicts.parts) {
    const BodyPart part = bodyPartOf(judged.part);
    const bool known = std::any_of(ranked.begin(), ranked.end(), [&](const Ranked& r) { return r.part.part == part; });
    if (judged.zone == Zone::kAcceptable || known) continue;
    const bool is_worst = judged.zone == verdicts.worst;
    ranked.push_back({{part, side, judged.angle, judged.zone == Zone::kConditional ? 1 : 3, is_worst && worst == 1},
                      is_worst ? 0.0 : 1.0,
                      std::max(1e-6, std::abs(judged.angle))});
  }
  return ranked;
}

constexpr std::array<std::pair<std::size_t, BodyPart>, 6> kRulaParts{{{Rula::kUpperArm, BodyPart::kUpperArm},
                                                                      {Rula::kTrunk, BodyPart::kTrunk},
                                                                      {Rula::kNeck, BodyPart::kNeck},
                                                                      {Rula::kLowerArm, BodyPart::kLowerArm},
                                                                      {Rula::kWrist, BodyPart::kWrist},
                                                                      {Rula::kLegs, BodyPart::kLegs}}};
constexpr std::array<std::pair<std::size_t, BodyPart>, 6> kRebaParts{{{Reba::kUpperArm, BodyPart::kUpperArm},
                                                                      {Reba::kTrunk, BodyPart::kTrunk},
                                                                      {Reba::kNeck, BodyPart::kNeck},
                                                                      {Reba::kLowerArm, BodyPart::kLowerArm},
                                                                      {Reba::kWrist, BodyPart::kWrist},
                                                                      {Reba::kLegs, BodyPart::kLegs}}};

/// m, about a hand's length: fingers point along -z of the hand's frame. Half, twice: drawn angle lines only.
constexpr double kHand = 0.1;

JointAngle between(const dvec3& joint, const dvec3& zero, const dvec3& end) {
  const dvec3 limb = end - joint;
  const double length = std::max(1e-6, glm::length(limb));
  return {joint, glm::normalize(zero), limb / length, length};
}

/// In the plane that the pelvis faces, where it is measured.
JointAngle trunkAngle(const FigurePose& pose, const dvec3& hip, double length) {
  const ViewPlanes planes = pelvisPlanes(pose);
  const double flexion = glm::radians(trunkAngles(planes, trunkLine(pose)).flexion);
  return {hip, planes.up, std::sin(flexion) * planes.forward + std::cos(flexion) * planes.up, length};
}

}  // namespace

std::vector<DrivingPart> drivingParts(const PostureScores& scores, PostureMethod method, std::size_t most) {
  const Side side = worseSide(scores, method);
  const SideScores& one = scores.sides[static_cast<std::size_t>(side)];
  switch (method) {
    case PostureMethod::kRula:
      return best(rankedParts(Rula(), one.rula, kRulaParts, scores, side), most);
    case PostureMethod::kReba:
      return best(rankedParts(Reba(), one.reba, kRebaParts, scores, side), most);
    case PostureMethod::kOwas:
    case PostureMethod::kEaws:
      return best(owasParts(scores), most);
    case PostureMethod::kEn1005:
      return best(zoneParts(one.en1005, side), most);
    case PostureMethod::kIso11226:
      return best(zoneParts(one.iso11226, side), most);
  }
  return {};
}

std::string jointWords(const DrivingPart& part, Language language) {
  using Sides = std::array<std::string_view, 2>;  // Left, right.
  constexpr std::array<Sides, 6> kNames{{{HAPTICELL_TRANSLATED("left shoulder", "right shoulder")},
                                         {HAPTICELL_TRANSLATED("left elbow", "right elbow")},
                                         {HAPTICELL_TRANSLATED("left wrist", "right wrist")},
                                         {HAPTICELL_TRANSLATED("neck", "neck")},
                                         {HAPTICELL_TRANSLATED("trunk", "trunk")},
                                         {HAPTICELL_TRANSLATED("left knee", "right knee")}}};
  return word(kNames[static_cast<std::size_t>(part.part)][static_cast<std::size_t>(part.side)], language);
}

std::string drivingWords(const PostureScores& scores, PostureMethod method, const DrivingPart& part,
                         Language language) {
  std::string text;
  const auto add = [&](const std::optional<bool>& flag, std::string_view words) {
    if (flag.value_or(false)) text += word(words, language) + ", ";
  };
  const PostureAngles& angles = scores.sides[static_cast<std::size_t>(worseSide(scores, method))].angles;
  if (part.part == BodyPart::kUpperArm) {
    add(angles.shoulder_raised, HAPTICELL_TRANSLATED("raised"));
    add(angles.upper_arm_abducted, HAPTICELL_TRANSLATED("abducted"));
  } else if (part.part == BodyPart::kTrunk) {
    add(angles.trunk_twisted, HAPTICELL_TRANSLATED("twisted"));
    add(angles.trunk_side_bent, HAPTICELL_TRANSLATED("bent sideways"));
  } else if (part.part == BodyPart::kNeck) {
    add(angles.neck_twisted, HAPTICELL_TRANSLATED("twisted"));
    add(angles.neck_side_bent, HAPTICELL_TRANSLATED("bent sideways"));
  }
  const std::string score = scoreWords(method, scoreBy(scores, method), language);
  return text + word(part.lowers ? "drives" : "counts in", language) + " " + score;
}

JointAngle jointAngle(const FigurePose& pose, const DrivingPart& part) {
  const dvec3 hip = middleOfHips(pose), neck = pose[Segment::kLowerNeck].p_WS;
  const dvec3 shoulder = pose[armSegment(part.side, Segment::kLeftUpperArm)].p_WS;
  const dvec3 elbow = pose[armSegment(part.side, Segment::kLeftForearm)].p_WS;
  const dvec3 wrist = pose[armSegment(part.side, Segment::kLeftHand)].p_WS;
  const dvec3 knee = pose[legSegment(part.side, Segment::kLeftShank)].p_WS;
  switch (part.part) {
    case BodyPart::kUpperArm:
      return between(shoulder, -trunkLine(pose), elbow);
    case BodyPart::kLowerArm:
      return between(elbow, elbow - shoulder, wrist);
    case BodyPart::kWrist:
      return between(wrist, wrist - elbow, mannequin::handPose(pose, part.side) * dvec3(0.0, 0.0, -kHand));
    case BodyPart::kNeck:
      return between(neck, neck - hip, pose[Segment::kHead].p_WS);
    case BodyPart::kTrunk:
      return trunkAngle(pose, hip, glm::length(neck - hip));
    case BodyPart::kLegs:
      return between(knee, knee - pose[legSegment(part.side, Segment::kLeftThigh)].p_WS,
                     pose[legSegment(part.side, Segment::kLeftFoot)].p_WS);
  }
  return {};
}

}  // namespace hapticell::ergonomics
