// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/scores/posture_scores.h"

#include <algorithm>
#include <cmath>

#include "mannequin/ergonomics/scores/figure_measurement.h"
#include "mannequin/posture/support_polygon.h"
#include "mannequin/posture/vision.h"

namespace hapticell::ergonomics {
namespace {

using mannequin::Dof;
using mannequin::Figure;
using mannequin::FigurePose;
using mannequin::Posture;
using mannequin::Segment;
using mannequin::Side;

constexpr double kDegreesPerRadian = 57.295779513082323;
/// Degrees, of the seated: thighs nearly level, knees bent, shanks not far back. Our choice. Half: leaning stools are
/// standing; twice: squats are seated.
constexpr double kLevelThigh = 35.0, kBentKnee = 45.0, kUprightShank = 60.0;
/// m that the weight is outside the soles: then a seat bears it. Our choice. Half: working postures with rounding count
/// as seated; twice: on the edge of a stool one stands.
constexpr double kOffTheSoles = 0.03;
/// m of this counts as a degree, so that kOffSeat's 4.5 are 45 mm. Half, twice: the way from seated to standing is half
/// or twice as long.
constexpr double kSoleDegree = 0.01;
constexpr double kOverHead =
    0.03;  ///< m from which hands count as above the head; less: as an arm raised to the shoulder.

template <class Values>
auto complete(const Values& values) {
  std::array<int, std::tuple_size_v<Values>> all{};
  for (std::size_t i = 0; i < values.size(); ++i) all[i] = values[i].value_or(0);
  return all;
}

/// Modifiers that are missing count as the least they can be.
template <class Method, class Values>
int scoreOf(const Method& method, const Values& values) {
  auto all = complete(values);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = std::max(all[i], method.subScores()[i].least);
  return method.score(all);
}

void scoreSide(const WorkTask& task, Side side, SideScores& scores, std::vector<std::string_view>& scratch) {
  const std::size_t i = static_cast<std::size_t>(side);
  scores.angles = postureAngles(scores.measured);
  scores.angles.arm_supported = task.arm_supported[i];
  scores.angles.trunk_supported = task.trunk_supported;
  if (task.is_walking) scores.angles.legs_bilateral = true;
  scratch.clear();
  scores.rula = rulaValues(scores.angles, scratch);
  scores.rula[Rula::kMuscleUseArm] = scores.rula[Rula::kMuscleUseBody] = rulaMuscleUse(task);
  scores.rula[Rula::kForceArm] = rulaForce(task, task.load_kg[i]);
  scores.rula[Rula::kForceBody] = rulaForce(task, task.totalLoad());
  scores.reba = rebaValues(scores.angles, scratch);
  scores.reba[Reba::kLoad] = rebaLoad(task);
  scores.reba[Reba::kCoupling] = rebaCoupling(task);
  scores.reba[Reba::kActivity] = rebaActivity(task);
  const Rula rula;
  const Reba reba;
  scores.rula_score = scoreOf(rula, scores.rula);
  scores.rula_level = rula.levelOf(scores.rula_score);
  scores.reba_score = scoreOf(reba, scores.reba);
  scores.reba_level = reba.levelOf(scores.reba_score);
}

EawsObservation eawsObservation(const PostureScores& scores, const WorkTask& task, const FigurePose& pose) {
  double hands = -1e9, elbows = -1e9;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    hands = std::max(hands, pose[armSegment(side, Segment::kLeftHand)].p_WS.z);
    elbows = std::max(elbows, pose[armSegment(side, Segment::kLeftForearm)].p_WS.z);
  }
  EawsObservation observed;
  observed.trunk_flexion = scores.sides[0].measured.trunk_flexion;
  const double over_head = hands - pose[Segment::kHead].p_WS.z;
  observed.hands_above_head = over_head > kOverHead;
  observed.elbow_at_shoulder = over_head > 0.0 || elbows > pose[Segment::kLeftUpperArm].p_WS.z;
  observed.seated = scores.is_seated;
  observed.kneeling = scores.owas_posture.kneeling;
  observed.walking = task.is_walking;
  observed.trunk_supported = task.trunk_supported;
  return observed;
}

/// Of the head's long axis against the vertical, forward in the plane that its left side leaves level.
double headInclination(const FigurePose& pose) {
  const dmat3& head = pose[Segment::kHead].R_WS;
  ViewPlanes planes;
  planes.outward = glm::normalize(dvec3(head[1].x, head[1].y, 0.0) + dvec3(0.0, 1e-9, 0.0));
  planes.forward = glm::cross(planes.outward, planes.up);
  return trunkAngles(planes, head[2]).flexion;
}

double comfortOf(const Posture& posture) {
  int within = 0;
  for (std::size_t i = 0; i < mannequin::kDofCount; ++i) {
    const auto& info = mannequin::dofInfo(static_cast<Dof>(i));
    // rad: rounding, so that an angle on a limit is within. Half, twice: no effect.
    constexpr double kSlack = 1e-9;
    if (posture.angles[i] >= info.comfort_lower - kSlack && posture.angles[i] <= info.comfort_upper + kSlack) ++within;
  }
  return static_cast<double>(within) / mannequin::kDofCount;
}

void noteMissing(const WorkTask& task, std::vector<std::string_view>& missing) {
  if (!task.totalLoad()) missing.push_back("load");
  if (!task.repetitions_per_min) missing.push_back("repetitions");
  if (!task.is_static) missing.push_back("static");
  if (!task.grip) missing.push_back("grip");
}

}  // namespace

PostureUse postureUse(const WorkTask& task, Side side) {
  return {task.repetitions_per_min.value_or(0.0), task.is_static.value_or(false), task.trunk_supported,
          task.arm_supported[static_cast<std::size_t>(side)]};
}

ZonePosture zonePosture(const PostureScores& scores, Side side, const WorkTask& task) {
  return settledZones({scores.sides[static_cast<std::size_t>(side)].measured, scores.gaze_below_horizontal,
                       scores.head_inclination, postureUse(task, side)});
}

Side PostureScores::worseSide() const {
  const int left = 100 * sides[0].rula_score + sides[0].reba_score;
  const int right = 100 * sides[1].rula_score + sides[1].reba_score;
  return left > right ? Side::kLeft : Side::kRight;
}

int PostureScores::owasCode() const {
  int code = 0;
  for (const auto& digit : owas) code = 10 * code + digit.value_or(0);
  return code;
}

double offSeat(const Figure& figure, const FigurePose& pose) {
  const auto support = mannequin::supportPolygon(figure, {pose[Segment::kLeftFoot], pose[Segment::kRightFoot]});
  const double on_feet = support.margin(glm::dvec2(mannequin::centerOfMass(figure, pose)));
  double off = (on_feet + kOffTheSoles) / kSoleDegree;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const dvec3 hip = pose[legSegment(side, Segment::kLeftThigh)].p_WS;
    const dvec3 knee = pose[legSegment(side, Segment::kLeftShank)].p_WS;
    const dvec3 ankle = pose[legSegment(side, Segment::kLeftFoot)].p_WS;
    const dvec3 thigh = glm::normalize(knee - hip), shank = glm::normalize(ankle - knee);
    const auto inDegrees = [](double cosine) { return kDegreesPerRadian * std::acos(std::clamp(cosine, -1.0, 1.0)); };
    off =
        std::max({off, 90.0 - inDegrees(std::abs(thigh.z)) - kLevelThigh, kBentKnee - inDegrees(glm::dot(thigh, shank)),
                  inDegrees(-shank.z) - kUprightShank});  // Farther: kneeling.
  }
  return off;
}

bool looksSeated(const Figure& figure, const FigurePose& pose) {
  return offSeat(figure, pose) <= 0.0;
}

PostureScores scorePosture(const Figure& figure, const Posture& posture, const FigurePose& pose, const WorkTask& task) {
  PostureScores scores;
  const double off_seat = offSeat(figure, pose);
  scores.is_seated = off_seat <= 0.0;
  std::vector<std::string_view> scratch;
  scratch.reserve(16);
  OwasPosture& whole = scores.owas_posture;
  whole = owasPosture(figure, posture, pose);
  whole.seated = scores.is_seated;
  whole.walking = task.is_walking;
  whole.load_kg = task.totalLoad().value_or(0.0);
  scores.head_inclination = headInclination(pose);
  const Pose eyes = mannequin::eyePose(figure, pose, posture.gaze);
  scores.gaze_below_horizontal = kDegreesPerRadian * std::asin(std::clamp(eyes.rotate({0.0, 0.0, 1.0}).z, -1.0, 1.0));
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const std::size_t i = static_cast<std::size_t>(side);
    SideScores& one = scores.sides[i];
    one.measured = measure(figure, posture, pose, side);
    one.measured.seated = scores.is_seated;
    one.measured.off_seat = off_seat;
    scoreSide(task, side, one, scratch);
    const ZonePosture zones = zonePosture(scores, side, task);
    one.en1005 = en1005(zones.measured, zones.gaze_below_horizontal, zones.use);
    one.iso11226 = iso11226(zones.measured, zones.head_inclination, zones.use);
  }
  scores.owas = owasValues(whole);
  scores.owas_category = Owas().score(complete(scores.owas));
  scores.eaws_observation = eawsObservation(scores, task, pose);
  scores.eaws = eawsPosture(scores.eaws_observation);
  std::array<double, kEawsPostureCount> shares{};
  shares[static_cast<std::size_t>(scores.eaws)] = 1.0;
  scores.eaws_points = eawsPosturePoints(shares);
  scores.comfort = comfortOf(posture);
  noteMissing(task, scores.missing);
  return scores;
}

Expected<LiftingTask> liftOf(const Figure& figure, const FigurePose& pose, const PostureScores& scores,
                             const WorkTask& task) {
  const auto missing = [](const char* what) {
    return makeError(
        {.place = Text::plain(what), .found = "not entered", .expected = "a value for this field of the task data"});
  };
  if (!task.totalLoad()) return missing("load_kg");
  if (!task.repetitions_per_min) return missing("repetitions_per_min");
  if (!task.duration_h) return missing("duration_h");
  if (!task.grip) return missing("grip");
  if (*task.grip == Grip::kUnacceptable)
    return makeError({.place = Text::plain("grip"),
                      .found = "unacceptable",
                      .expected = "good, fair or poor: the equation has no other classes"});
  dvec3 hands(0.0), ankles(0.0);
  double floor = 1e9;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    hands += 0.5 * (mannequin::handPose(pose, side) * figure.p_HandGrip[static_cast<std::size_t>(side)]);
    const Pose foot = mannequin::footPose(pose, side);
    ankles += 0.5 * foot.p;
    floor = std::min(floor, foot.p.z + figure.sole.z);
  }
  LiftingTask lift_task;
  lift_task.load_kg = *task.totalLoad();
  lift_task.h_cm = 100.0 * std::hypot(hands.x - ankles.x, hands.y - ankles.y);
  lift_task.v_cm = 100.0 * (hands.z - floor);
  lift_task.d_cm = 100.0 * task.lift_distance_m;
  lift_task.asymmetry_deg = task.asymmetry_deg;
  lift_task.frequency_per_min = *task.repetitions_per_min;
  lift_task.duration_h = *task.duration_h;
  lift_task.coupling = static_cast<Coupling>(*task.grip);
  LiftingConditions conditions;
  conditions.one_handed = !task.load_kg[0] || !task.load_kg[1] || *task.load_kg[0] <= 0.0 || *task.load_kg[1] <= 0.0;
  conditions.seated_or_kneeling = scores.is_seated || scores.owas[Owas::kLegs].value_or(0) == 6;
  HAPTICELL_TRY(lift(lift_task, conditions));
  return lift_task;
}

Expected<LiftingResult> scoreLift(const Figure& figure, const FigurePose& pose, const PostureScores& scores,
                                  const WorkTask& task) {
  const auto lift_task = liftOf(figure, pose, scores, task);
  HAPTICELL_TRY(lift_task);
  return lift(*lift_task);
}

int bandOfSubScore(const SubScore& sub_score, int value) {
  if (value <= sub_score.least) return 0;
  if (sub_score.greatest - sub_score.least <= 1) return 1;
  const double share =
      static_cast<double>(value - sub_score.least) / static_cast<double>(sub_score.greatest - sub_score.least);
  if (share <= 0.5) return 1;
  return share <= 0.75 ? 2 : 3;
}

int bandOfRula(int score) {
  return std::clamp((score - 1) / 2, 0, 3);
}
int bandOfReba(int score) {
  return std::max(0, Reba().levelOf(score) - 1);
}
int bandOf(Zone zone) {
  if (zone == Zone::kAcceptable) return 0;
  return zone == Zone::kConditional ? 1 : 3;
}
int bandOfOwas(int category) {
  return std::clamp(category - 1, 0, 3);
}

namespace {

using Bands = std::array<int, mannequin::kSegmentCount>;

void raise(Bands& bands, Segment segment, int band) {
  int& own = bands[mannequin::indexOf(segment)];
  own = std::max(own, band);
}

void raiseTrunk(Bands& bands, int band) {
  for (const Segment s : {Segment::kPelvis, Segment::kLowerBack, Segment::kUpperBack, Segment::kThorax}) {
    raise(bands, s, band);
  }
}

void raiseNeck(Bands& bands, int band) {
  for (const Segment s : {Segment::kLowerNeck, Segment::kUpperNeck, Segment::kHead}) raise(bands, s, band);
}

void raiseLegs(Bands& bands, int band) {
  for (std::size_t i = mannequin::indexOf(Segment::kLeftThigh); i < mannequin::kSegmentCount; ++i) {
    bands[i] = std::max(bands[i], band);
  }
}

void raiseArm(Bands& bands, Side side, const std::array<int, 3>& upper_lower_wrist) {
  for (const Segment s : {Segment::kLeftClavicle, Segment::kLeftUpperArm})
    raise(bands, armSegment(side, s), upper_lower_wrist[0]);
  for (const Segment s : {Segment::kLeftForearm, Segment::kLeftWrist})
    raise(bands, armSegment(side, s), upper_lower_wrist[1]);
  raise(bands, armSegment(side, Segment::kLeftHand), upper_lower_wrist[2]);
}

template <class Values>
int bandOf(const ScoredMethod& method, const Values& values, std::size_t index) {
  return values[index] ? bandOfSubScore(method.subScores()[index], *values[index]) : 0;
}

void addRula(Bands& bands, const SideScores& scores, Side side) {
  const Rula method;
  const auto band = [&](Rula::Index index) { return bandOf(method, scores.rula, index); };
  raiseArm(bands, side,
           {band(Rula::kUpperArm), band(Rula::kLowerArm), std::max(band(Rula::kWrist), band(Rula::kWristTwist))});
  raiseTrunk(bands, band(Rula::kTrunk));
  raiseNeck(bands, band(Rula::kNeck));
  raiseLegs(bands, band(Rula::kLegs));
}

void addReba(Bands& bands, const SideScores& scores, Side side) {
  const Reba method;
  const auto band = [&](Reba::Index index) { return bandOf(method, scores.reba, index); };
  raiseArm(bands, side, {band(Reba::kUpperArm), band(Reba::kLowerArm), band(Reba::kWrist)});
  raiseTrunk(bands, band(Reba::kTrunk));
  raiseNeck(bands, band(Reba::kNeck));
  raiseLegs(bands, band(Reba::kLegs));
}

void addOwas(Bands& bands, const PostureScores& scores) {
  raiseTrunk(bands, scores.owas[0].value_or(1) - 1);
  const int arms = scores.owas[1].value_or(1) - 1;
  for (const Side side : {Side::kLeft, Side::kRight}) raiseArm(bands, side, {arms, arms, arms});
  constexpr std::array<int, 8> kLegs{0, 0, 0, 1, 2, 3, 2, 1};
  raiseLegs(bands, kLegs[static_cast<std::size_t>(std::clamp(scores.owas[2].value_or(1), 0, 7))]);
}

void addEn1005(Bands& bands, const SideScores& scores, Side side) {
  for (const PartVerdict& part : scores.en1005.parts) {
    if (part.part.substr(0, 5) == "trunk") raiseTrunk(bands, bandOf(part.zone));
    if (part.part == "line of sight") raiseNeck(bands, bandOf(part.zone));
    if (part.part == "upper arm") raiseArm(bands, side, {bandOf(part.zone), 0, 0});
  }
}

}  // namespace

Bands segmentBands(const PostureScores& scores, ColourMethod method) {
  Bands bands{};
  if (method == ColourMethod::kOwas) {
    addOwas(bands, scores);
    return bands;
  }
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const SideScores& one = scores.sides[static_cast<std::size_t>(side)];
    if (method == ColourMethod::kRula) addRula(bands, one, side);
    if (method == ColourMethod::kReba) addReba(bands, one, side);
    if (method == ColourMethod::kEn1005) addEn1005(bands, one, side);
  }
  return bands;
}

}  // namespace hapticell::ergonomics
