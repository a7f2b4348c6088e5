// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/advice/method_advice.h"

#include <algorithm>
#include <cmath>

#include "mannequin/ergonomics/advice/posture_advice.h"
#include "mannequin/ergonomics/methods/view_planes.h"

namespace hapticell::ergonomics {
namespace {

using mannequin::Side;

/// A field of something observed, and how it is set.
template <class Observed>
struct Place {
  ChangeField field;
  void (*set)(Observed&, double value);
};
template <class Observed>
using Places = std::vector<Place<Observed>>;

template <class Observed>
std::vector<ChangeField> fieldsOf(const Places<Observed>& places) {
  std::vector<ChangeField> fields;
  for (const auto& place : places) fields.push_back(place.field);
  return fields;
}

template <class Observed>
Observed changed(Observed observed, const Places<Observed>& places, std::span<const double> values) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (values[i] != places[i].field.from) places[i].set(observed, values[i]);
  }
  return observed;
}

ChangeField angle(std::string_view name, double from, std::vector<double> values) {
  return {name, false, 10.0, from, nearestFirst(std::move(values), from)};
}

/// An angle that counts either way, to smaller ones of its own sign.
ChangeField eitherWay(std::string_view name, double from, const std::vector<double>& sizes) {
  std::vector<double> values;
  for (const double size : sizes) {
    if (size < std::abs(from)) values.push_back(std::copysign(size, from));
  }
  return angle(name, from, std::move(values));
}

ChangeField flag(std::string_view name, bool from, bool good) {
  ChangeField field{name, true, 1.0, from ? 1.0 : 0.0, {}};
  if (from != good) field.values = {good ? 1.0 : 0.0};
  return field;
}

using LevelOfScore = int (*)(double);

int asItIs(double score) {
  return static_cast<int>(std::lround(score));
}

/// For methods that score the whole posture by one number.
template <class Observed>
MethodAdvice adviseWhole(PostureMethod method, const Observed& observed, const Places<Observed>& places,
                         double (*score_of)(const Observed&), LevelOfScore level_of) {
  const auto fields = fieldsOf(places);
  const ValuesScore score = [&](std::span<const double> values) -> std::optional<double> {
    return score_of(changed(observed, places, values));
  };
  MethodAdvice advice{method, {score_of(observed), level_of(score_of(observed))}};
  for (const PostureDriver& driver : singleChanges(fields, score))
    advice.drivers.push_back({{}, {driver.change}, driver.score, level_of(driver.score)});
  if (const auto goal = nearestLowerLevel(fields, score, level_of))
    advice.next = MethodAdvice::Goal{goal->changes, {goal->score, level_of(goal->score)}};
  return advice;
}

double owasScore(const OwasPosture& posture) {
  const auto values = owasValues(posture);
  std::array<int, Owas::kCount> complete{};
  for (std::size_t i = 0; i < values.size(); ++i) complete[i] = values[i].value_or(1);
  return Owas().score(complete);
}

double eawsScore(const EawsObservation& observed) {
  std::array<double, kEawsPostureCount> shares{};
  shares[static_cast<std::size_t>(eawsPosture(observed))] = 1.0;
  return eawsPosturePoints(shares);
}

/// How far the arm may go one way for an elevation, `other` being its angle the other way, degrees: see armElevation().
double sideOfElevation(double elevation, double other) {
  constexpr double kRadians = 0.017453292519943295;
  return std::acos(std::clamp(std::cos(elevation * kRadians) / std::cos(other * kRadians), -1.0, 1.0)) / kRadians;
}

/// The upper arm is judged by how far it is off the trunk, whichever way: what one of its angles may be beside the
/// other, to a tenth of a degree.
std::vector<double> armAngles(double other) {
  std::vector<double> sizes{0.0};
  for (const double elevation : {60.0, 20.0}) {
    const double least = armElevation(0.0, other);
    if (least < elevation) sizes.push_back(std::floor(10.0 * sideOfElevation(elevation, other) + 1e-6) / 10.0);
  }
  return sizes;
}

Places<ZonePosture> zonePlaces(PostureMethod method, const ZonePosture& posture) {
  using P = ZonePosture;
  const MeasuredPosture& m = posture.measured;
  const auto trunk = m.trunk_flexion < 0.0 ? std::vector<double>{0.0} : std::vector<double>{60.0, 20.0};
  auto arm = armAngles(m.upper_arm_abduction);
  if (m.upper_arm_flexion < 0.0) arm.push_back(20.0);  // No longer behind the body.
  Places<P> places{
      {angle("trunk_flexion", m.trunk_flexion, trunk), [](P& p, double v) { p.measured.trunk_flexion = v; }},
      {flag("trunk_supported", posture.use.trunk_supported, true), [](P& p, double) { p.use.trunk_supported = true; }},
      {eitherWay("trunk_twist", m.trunk_twist, {10.0, 9.9}), [](P& p, double v) { p.measured.trunk_twist = v; }},
      {eitherWay("trunk_side_bend", m.trunk_side_bend, {10.0, 9.9}),
       [](P& p, double v) { p.measured.trunk_side_bend = v; }},
      {eitherWay("upper_arm_flexion", m.upper_arm_flexion, arm),
       [](P& p, double v) {
         p.measured.upper_arm_flexion = v;
         p.measured.upper_arm_elevation.reset();
       }},
      {eitherWay("upper_arm_abduction", m.upper_arm_abduction, armAngles(m.upper_arm_flexion)), [](P& p, double v) {
         p.measured.upper_arm_abduction = v;
         p.measured.upper_arm_elevation.reset();
       }}};
  if (method == PostureMethod::kEn1005) {
    places.push_back({angle("gaze_below_horizontal", posture.gaze_below_horizontal, {0.0, 40.0}),
                      [](P& p, double v) { p.gaze_below_horizontal = v; }});
  } else {
    places.push_back({angle("head_inclination", posture.head_inclination, {0.0, 25.0, 85.0}),
                      [](P& p, double v) { p.head_inclination = v; }});
    places.push_back({eitherWay("shoulder_raised_deg", m.girdle_elevation, {9.9}),
                      [](P& p, double v) { p.measured.girdle_elevation = v; }});
    places.push_back(
        {flag("arm_supported", posture.use.arm_supported, true), [](P& p, double) { p.use.arm_supported = true; }});
  }
  return places;
}

PartVerdicts verdictsOf(PostureMethod method, const ZonePosture& posture) {
  return method == PostureMethod::kEn1005 ? en1005(posture.measured, posture.gaze_below_horizontal, posture.use)
                                          : iso11226(posture.measured, posture.head_inclination, posture.use);
}

/// The zones' values with these changes in them.
std::vector<double> valuesWith(const std::vector<ChangeField>& fields, const std::vector<FieldChange>& changes) {
  std::vector<double> values;
  for (const ChangeField& field : fields) {
    values.push_back(field.from);
    for (const FieldChange& change : changes) {
      if (change.field == field.name) values.back() = change.to;
    }
  }
  return values;
}

}  // namespace

MethodAdvice adviseAngles(const ScoredMethod& method, const PostureAngles& angles,
                          std::span<const std::optional<int>> values) {
  const PostureScore score = scoreOfAngles(method, values);
  MethodAdvice advice;
  advice.method = method.name() == "RULA" ? PostureMethod::kRula : PostureMethod::kReba;
  const auto now = score(angles);
  if (!now) return advice;
  const auto levelOf = [&](double found) { return method.levelOf(asItIs(found)); };
  advice.now = {static_cast<double>(*now), method.levelOf(*now)};
  for (const PostureDriver& driver : postureDrivers(angles, score))
    advice.drivers.push_back({{}, {driver.change}, driver.score, levelOf(driver.score)});
  if (const auto goal = nextLevelPosture(angles, score, levelOf))
    advice.next = MethodAdvice::Goal{goal->changes, {goal->score, levelOf(goal->score)}};
  return advice;
}

MethodAdvice adviseOwas(const OwasPosture& posture) {
  using P = OwasPosture;
  Places<P> places{
      {eitherWay("trunk_flexion", posture.trunk_flexion, {20.0}), [](P& p, double v) { p.trunk_flexion = v; }},
      {eitherWay("trunk_twist", posture.trunk_twist, {20.0}), [](P& p, double v) { p.trunk_twist = v; }},
      {eitherWay("trunk_side_bend", posture.trunk_side_bend, {20.0}), [](P& p, double v) { p.trunk_side_bend = v; }}};
  ChangeField arms{"arms_at_or_above_shoulder", false, 1.0, static_cast<double>(posture.arms_at_or_above_shoulder), {}};
  for (int count = posture.arms_at_or_above_shoulder - 1; count >= 0; --count) arms.values.push_back(count);
  places.push_back({arms, [](P& p, double v) { p.arms_at_or_above_shoulder = asItIs(v); }});
  if (posture.kneeling && !posture.seated) {
    places.push_back({flag("kneeling", true, false), [](P& p, double) {
                        p.kneeling = false;
                        p.left_knee_flexion = p.right_knee_flexion = 0.0;
                      }});
  } else if (!posture.seated && !posture.walking) {
    const double knee = std::max(posture.left_knee_flexion, posture.right_knee_flexion);
    places.push_back({eitherWay("knee_flexion", knee, {30.0}), [](P& p, double v) {
                        p.left_knee_flexion = std::min(p.left_knee_flexion, v);
                        p.right_knee_flexion = std::min(p.right_knee_flexion, v);
                      }});
    places.push_back({flag("on_one_leg", posture.on_one_leg, false), [](P& p, double) { p.on_one_leg = false; }});
  }
  return adviseWhole(PostureMethod::kOwas, posture, places, owasScore, asItIs);
}

MethodAdvice adviseEaws(const EawsObservation& observed) {
  using P = EawsObservation;
  Places<P> places{
      {eitherWay("trunk_flexion", observed.trunk_flexion, {60.0, 20.0}), [](P& p, double v) { p.trunk_flexion = v; }},
      {flag("hands_above_head", observed.hands_above_head, false), [](P& p, double) { p.hands_above_head = false; }},
      {flag("elbow_at_shoulder", observed.elbow_at_shoulder, false), [](P& p, double) { p.elbow_at_shoulder = false; }},
      {flag("kneeling", observed.kneeling, false), [](P& p, double) { p.kneeling = false; }}};
  if (observed.seated)
    places.push_back(
        {flag("trunk_supported", observed.trunk_supported, true), [](P& p, double) { p.trunk_supported = true; }});
  return adviseWhole(PostureMethod::kEaws, observed, places, eawsScore, eawsLevel);
}

MethodAdvice adviseZones(PostureMethod method, const ZonePosture& posture) {
  const auto places = zonePlaces(method, posture);
  const auto fields = fieldsOf(places);
  const PartVerdicts now = verdictsOf(method, posture);
  // Advice leads to the standard's own limits, not to what a measurement is allowed beyond them.
  ZonePosture to_the_letter = posture;
  to_the_letter.use.measured = false;
  const auto levelWith = [&](const std::vector<FieldChange>& changes) {
    return levelOf(verdictsOf(method, changed(posture, places, valuesWith(fields, changes))).worst);
  };
  MethodAdvice advice{method, {static_cast<double>(levelOf(now.worst)), levelOf(now.worst)}};
  if (now.worst == Zone::kAcceptable) return advice;
  MethodAdvice::Goal goal;
  bool all_parts_help = true;
  for (std::size_t part = 0; part < now.parts.size(); ++part) {
    if (now.parts[part].zone != now.worst) continue;
    const ValuesScore score = [&](std::span<const double> values) -> std::optional<double> {
      return levelOf(verdictsOf(method, changed(to_the_letter, places, values)).parts[part].zone);
    };
    const auto lower = nearestLowerLevel(fields, score, asItIs, 2);
    all_parts_help = all_parts_help && lower.has_value();
    if (!lower) continue;
    goal.changes.insert(goal.changes.end(), lower->changes.begin(), lower->changes.end());
    const auto alone = singleChanges(fields, score);
    MethodDriver driver{now.parts[part].part, lower->changes, lower->score, levelWith(lower->changes)};
    if (!alone.empty())
      driver = {driver.part, {alone.front().change}, alone.front().score, levelWith({alone.front().change})};
    advice.drivers.push_back(std::move(driver));
  }
  std::stable_sort(advice.drivers.begin(), advice.drivers.end(),
                   [](const MethodDriver& a, const MethodDriver& b) { return a.score < b.score; });
  const int level = levelWith(goal.changes);
  goal.score = {static_cast<double>(level), level};
  if (all_parts_help && level < advice.now.level) advice.next = std::move(goal);
  return advice;
}

MethodAdvice advise(const PostureScores& scores, PostureMethod method, Side side, const WorkTask& task) {
  const SideScores& one = scores.sides[static_cast<std::size_t>(side)];
  switch (method) {
    case PostureMethod::kRula:
      return adviseAngles(Rula(), one.angles, one.rula);
    case PostureMethod::kReba:
      return adviseAngles(Reba(), one.angles, one.reba);
    case PostureMethod::kOwas:
      return adviseOwas(scores.owas_posture);
    case PostureMethod::kEn1005:
    case PostureMethod::kIso11226:
      return adviseZones(method, zonePosture(scores, side, task));
    case PostureMethod::kEaws:
      return adviseEaws(scores.eaws_observation);
  }
  return {};
}

MethodAdvice advise(const PostureScores& scores, PostureMethod method, const WorkTask& task) {
  return advise(scores, method, worseSide(scores, method), task);
}

std::vector<FieldChange> comfortDrivers(const mannequin::Posture& posture) {
  // rad: rounding, as withinComfort's in posture_scores.cpp. Half, twice: no effect.
  constexpr double kDegrees = 57.295779513082323, kSlack = 1e-9;
  std::vector<FieldChange> drivers;
  for (std::size_t i = 0; i < mannequin::kDofCount; ++i) {
    const auto& info = mannequin::dofInfo(static_cast<mannequin::Dof>(i));
    const double angle = posture.angles[i];
    if (angle >= info.comfort_lower - kSlack && angle <= info.comfort_upper + kSlack) continue;
    const double to = std::clamp(angle, info.comfort_lower, info.comfort_upper);
    drivers.push_back({info.name, false, kDegrees * angle, kDegrees * to});
  }
  std::stable_sort(drivers.begin(), drivers.end(), [](const FieldChange& a, const FieldChange& b) {
    return std::abs(a.to - a.from) > std::abs(b.to - b.from);
  });
  return drivers;
}

}  // namespace hapticell::ergonomics
