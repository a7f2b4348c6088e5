// SPDX-License-Identifier: Apache-2.0
#include "cli/ergonomics/ergonomics_posture_input.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/ergonomics/ergonomics_advice_report.h"
#include "cli/ergonomics/ergonomics_input.h"
#include "cli/ergonomics/ergonomics_report.h"
#include "cli/kit/result_writer.h"
#include "geometry/system/listed.h"
#include "geometry/system/nesting_limit.h"
#include "mannequin/ergonomics/advice/better_place.h"
#include "mannequin/ergonomics/advice/method_advice.h"
#include "mannequin/ergonomics/advice/posture_advice.h"
#include "mannequin/ergonomics/methods/owas.h"
#include "mannequin/posture/posture_file.h"
#include "workcell/format/work_task_format.h"
#include "workcell/text/file_content.h"

namespace hapticell::cli {

namespace {

using nlohmann::ordered_json;
using namespace ergonomics;

/// Fields of the shares, in the order of EawsPosture.
constexpr std::array<const char*, kEawsPostureCount> kEawsNames{"stand_walk",
                                                                "stand",
                                                                "stand_bent",
                                                                "stand_bent_far",
                                                                "stand_elbow_at_shoulder",
                                                                "stand_hands_above_head",
                                                                "sit_back_support",
                                                                "sit_upright",
                                                                "sit_bent",
                                                                "sit_elbow_at_shoulder",
                                                                "sit_hands_above_head",
                                                                "kneel_upright",
                                                                "kneel_bent",
                                                                "lie",
                                                                "climb"};

/// Reads fields by name and refuses the rest.
class Fields {
 public:
  explicit Fields(const nlohmann::json& input) : input_(input) {
    if (!input.is_object()) fail("", shortText(input), Text("an object with fields"));
  }

  void number(const char* name, double& target, double least, double most, bool required) {
    asked_.emplace_back(name);
    if (error_ || !input_.is_object()) return;
    const auto found = input_.find(name);
    if (found == input_.end()) {
      if (required) fail(name, Text("not given"), Text("a number of degrees"));
      return;
    }
    const bool good = found->is_number() && std::isfinite(found->get<double>()) && found->get<double>() >= least &&
                      found->get<double>() <= most;
    if (!good) return fail(name, shortText(*found), Text("a number, %1 to %2", shortNumber(least), shortNumber(most)));
    target = found->get<double>();
  }

  void flag(const char* name, bool& target) {
    asked_.emplace_back(name);
    if (error_ || !input_.is_object()) return;
    const auto found = input_.find(name);
    if (found == input_.end()) return;
    if (!found->is_boolean()) return fail(name, shortText(*found), Text("true or false"));
    target = found->get<bool>();
  }

  std::optional<Error> finish() {
    if (error_ || !input_.is_object()) return error_;
    for (const auto& [name, value] : input_.items()) {
      if (std::find(asked_.begin(), asked_.end(), name) == asked_.end()) {
        fail(name, Text("no field has this name"), Text("one of %1", listed(asked_)));
      }
    }
    return error_;
  }

 private:
  void fail(const std::string& field, const Text& found, const Text& expected) {
    if (!error_) error_ = Error{.place = field, .found = found, .expected = expected};
  }

  const nlohmann::json& input_;
  std::vector<std::string> asked_;
  std::optional<Error> error_;
};

ordered_json partsOf(const PartVerdicts& verdicts) {
  ordered_json parts = ordered_json::array();
  for (const PartVerdict& part : verdicts.parts) {
    ordered_json entry{{"part", part.part}, {"angle_deg", part.angle}, {"zone", nameOf(part.zone)}};
    if (!part.condition.empty()) entry["condition"] = part.condition;
    if (part.holding_time_min) entry["holding_time_min"] = *part.holding_time_min;
    parts.push_back(std::move(entry));
  }
  return parts;
}

/// The angles and answers that a side's scores come from, by the names of `ergonomics rula --input`.
ordered_json inputsOf(const PostureAngles& angles) {
  ordered_json inputs = ordered_json::object();
  for (const PostureField& field : postureFields()) {
    ordered_json value;
    if (field.angle && angles.*field.angle) value = *(angles.*field.angle);
    if (field.flag && angles.*field.flag) value = *(angles.*field.flag);
    if (field.name == "wrist_twist" && value.is_boolean()) value = value.get<bool>() ? "end" : "mid";
    if (!value.is_null()) inputs[std::string(field.name)] = value;  // As it is given: what does not apply is left out.
  }
  return inputs;
}

/// The same as for sub-scores or angles that are given: tables, drivers, the next level. What is not known stays null.
template <typename Values>
ordered_json scoredSide(const ScoredMethod& method, const Values& values, const PostureAngles& angles) {
  ScoredInput input;
  input.values.assign(values.begin(), values.end());
  input.angles = angles;
  ordered_json report = scoredReport(method, input);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!values[i]) report["sub_scores"][std::string(method.subScores()[i].name)] = nullptr;
  }
  return report;
}

/// By the names of `ergonomics en1005 --input` and `iso11226`.
ordered_json zoneInputs(const PostureScores& scores, PostureMethod method, mannequin::Side side, const WorkTask& task) {
  const ZonePosture posture = zonePosture(scores, side, task);
  const MeasuredPosture& measured = posture.measured;
  const PostureUse& use = posture.use;
  ordered_json inputs{{"trunk_flexion", measured.trunk_flexion},
                      {"trunk_twist", measured.trunk_twist},
                      {"trunk_side_bend", measured.trunk_side_bend},
                      {"upper_arm_flexion", measured.upper_arm_flexion},
                      {"upper_arm_abduction", measured.upper_arm_abduction}};
  if (method == PostureMethod::kEn1005) {
    inputs["gaze_below_horizontal"] = posture.gaze_below_horizontal;
  } else {
    inputs["head_inclination"] = posture.head_inclination;
    inputs["shoulder_raised_deg"] = measured.girdle_elevation;
  }
  inputs["movements_per_min"] = use.movements_per_min;
  inputs["static"] = use.is_static;
  inputs["trunk_supported"] = use.trunk_supported;
  inputs["arm_supported"] = use.arm_supported;
  return inputs;
}

ordered_json zonesOf(const PostureScores& scores, PostureMethod method, mannequin::Side side, const WorkTask& task) {
  const SideScores& one = scores.sides[static_cast<std::size_t>(side)];
  const PartVerdicts& verdicts = method == PostureMethod::kEn1005 ? one.en1005 : one.iso11226;
  ordered_json report{
      {"zone", nameOf(verdicts.worst)}, {"level", levelOf(verdicts.worst)}, {"parts", partsOf(verdicts)}};
  report["inputs"] = zoneInputs(scores, method, side, task);
  addAdvice(advise(scores, method, side, task), report);
  return report;
}

ordered_json sideOf(const PostureScores& scores, mannequin::Side which, const WorkTask& task) {
  const SideScores& side = scores.sides[static_cast<std::size_t>(which)];
  return {{"inputs", inputsOf(side.angles)},
          {"rula", scoredSide(Rula(), side.rula, side.angles)},
          {"reba", scoredSide(Reba(), side.reba, side.angles)},
          {"en1005", zonesOf(scores, PostureMethod::kEn1005, which, task)},
          {"iso11226", zonesOf(scores, PostureMethod::kIso11226, which, task)}};
}

ordered_json owasInputs(const OwasPosture& posture) {
  return {{"trunk_flexion", posture.trunk_flexion},
          {"trunk_twist", posture.trunk_twist},
          {"trunk_side_bend", posture.trunk_side_bend},
          {"arms_at_or_above_shoulder", posture.arms_at_or_above_shoulder},
          {"left_knee_flexion", posture.left_knee_flexion},
          {"right_knee_flexion", posture.right_knee_flexion},
          {"on_one_leg", posture.on_one_leg},
          {"kneeling", posture.kneeling},
          {"seated", posture.seated},
          {"walking", posture.walking}};
}

ordered_json eawsOf(const PostureScores& scores) {
  const EawsObservation& observed = scores.eaws_observation;
  ordered_json report{{"posture", nameOf(scores.eaws)},
                      {"points_if_held_all_the_time", scores.eaws_points},
                      {"level", eawsLevel(scores.eaws_points)},
                      {"complete", false}};
  report["inputs"] = {{"trunk_flexion", observed.trunk_flexion},
                      {"hands_above_head", observed.hands_above_head},
                      {"elbow_at_shoulder", observed.elbow_at_shoulder},
                      {"seated", observed.seated},
                      {"kneeling", observed.kneeling},
                      {"walking", observed.walking},
                      {"trunk_supported", observed.trunk_supported}};
  addAdvice(adviseEaws(observed), report);
  return report;
}

ordered_json comfortDriversOf(const mannequin::Posture& posture) {
  ordered_json drivers = ordered_json::array();
  for (const FieldChange& change : comfortDrivers(posture)) drivers.push_back(toJson(change));
  return drivers;
}

ordered_json owasOf(const PostureScores& scores) {
  ScoredInput input;
  input.values.assign(scores.owas.begin(), scores.owas.end());
  ordered_json report = scoredReport(Owas(), input);
  if (std::find(scores.missing.begin(), scores.missing.end(), "load") != scores.missing.end()) {
    report["partial"] = true;
    report["missing"] = {"load"};
    report["sub_scores"]["load"] = nullptr;
    report["assumptions"] = {"load was not given and is counted at its least: the true category may be higher."};
  }
  report["code"] = scores.owasCode();
  report["category"] = scores.owas_category;
  report["category_meaning"] = Owas().levelName(scores.owas_category);
  report["inputs"] = owasInputs(scores.owas_posture);
  addAdvice(adviseOwas(scores.owas_posture), report);
  return report;
}

}  // namespace

Expected<WorkTask> workTaskInput(const nlohmann::json& input) {
  std::optional<Error> error;
  Diagnostics diagnostics;
  ordered_json named = input;
  if (named.is_object() && !named.contains("name")) named["name"] = "Task";
  WorkTask task = workcell::workTaskFromJson(named, 0, error, diagnostics);
  if (error) return makeError(*error);
  if (!diagnostics.warnings.empty())
    return makeError(
        {.place = "task", .found = diagnostics.warnings.front(), .expected = "the fields of docs/user/formats.md"});
  HAPTICELL_TRY(checkWorkTask(task));
  return task;
}

Expected<ordered_json> zonesReport(const std::string& method, const nlohmann::json& input) {
  MeasuredPosture posture;
  PostureUse use;
  double gaze = 0.0, head = 0.0;
  const bool is_en = method == "en1005";
  Fields fields(input);
  fields.number("trunk_flexion", posture.trunk_flexion, -90.0, 180.0, true);
  fields.number("trunk_twist", posture.trunk_twist, -180.0, 180.0, true);
  fields.number("trunk_side_bend", posture.trunk_side_bend, -90.0, 90.0, true);
  fields.number("upper_arm_flexion", posture.upper_arm_flexion, -120.0, 240.0, true);
  fields.number("upper_arm_abduction", posture.upper_arm_abduction, -90.0, 180.0, false);
  if (is_en) {
    fields.number("gaze_below_horizontal", gaze, -90.0, 90.0, true);
  } else {
    fields.number("head_inclination", head, -90.0, 180.0, true);
    fields.number("shoulder_raised_deg", posture.girdle_elevation, -20.0, 60.0, false);
  }
  fields.number("movements_per_min", use.movements_per_min, 0.0, 300.0, false);
  fields.flag("static", use.is_static);
  fields.flag("trunk_supported", use.trunk_supported);
  fields.flag("arm_supported", use.arm_supported);
  if (const auto error = fields.finish()) return makeError(*error);
  const PartVerdicts verdicts = is_en ? en1005(posture, gaze, use) : iso11226(posture, head, use);
  ordered_json report{{"method", is_en ? "EN 1005-4" : "ISO 11226"},
                      {"source", is_en ? "EN 1005-4:2005" : "ISO 11226:2000"},
                      {"score", nameOf(verdicts.worst)},
                      {"level", levelOf(verdicts.worst)},
                      {"parts", partsOf(verdicts)}};
  addAdvice(adviseZones(is_en ? PostureMethod::kEn1005 : PostureMethod::kIso11226, {posture, gaze, head, use}), report);
  report["assumptions"] = {"a boundary angle belongs to the lower zone",
                           "an arm more than 20 deg behind the body counts as raised over 60 deg",
                           "flexion is seen from the side, abduction is out of that plane: the arm's elevation is the "
                           "angle whose cosine is the product of their cosines"};
  return report;
}

Expected<ordered_json> eawsReport(const nlohmann::json& input) {
  std::array<double, kEawsPostureCount> shares{};
  Fields fields(input);
  for (std::size_t i = 0; i < kEawsPostureCount; ++i) fields.number(kEawsNames[i], shares[i], 0.0, 1.0, false);
  if (const auto error = fields.finish()) return makeError(*error);
  double sum = 0.0;
  for (const double share : shares) sum += share;
  if (sum > 1.0 + 1e-9) {
    return makeError({.place = "shares",
                      .found = Text("%1 in total", std::to_string(sum)),
                      .expected = "shares of the cycle with a sum of at most 1"});
  }
  const double points = eawsPosturePoints(shares);
  ordered_json report{{"method", "EAWS posture section (outline)"},
                      {"source", "EAWS form 1.3.6, posture lines only; line 14 left out"},
                      {"score", points},
                      {"level", eawsLevel(points)},
                      {"complete", false}};
  addEawsAdvice(shares, report);
  report["assumptions"] = {"forces, loads, extra points and upper limbs are not covered",
                           "an easier posture is one of the same kind: standing and walking in turn, sitting with back "
                           "support, kneeling upright"};
  return report;
}

ordered_json postureScoresReport(const PostureReportInput& input, const PostureScores& scores) {
  ordered_json report{{"method", "all"}, {"score", scores.rula()}, {"level", scores.worse().rula_level}};
  report["stature"] = input.figure.body[mannequin::Dimension::kStature];
  report["mass"] = input.figure.totalMass();
  report["left"] = sideOf(scores, mannequin::Side::kLeft, input.task);
  report["right"] = sideOf(scores, mannequin::Side::kRight, input.task);
  report["owas"] = owasOf(scores);
  report["eaws_outline"] = eawsOf(scores);
  report["joint_comfort"] = scores.comfort;
  report["joint_comfort_drivers"] = comfortDriversOf(input.posture);
  report["partial"] = !scores.missing.empty();
  report["missing"] = scores.missing;
  const MainDriver driver = mainDriver(scores, Language::kEnglish);
  report["drivers"] = {{{"input", driver.part}, {"reason", driver.reason}, {"score", driver.score}}};
  report["better_places"] = toJson(betterPlaces(input.figure, input.posture, input.task));
  report["assumptions"] = assumptionsOf(scores, input.task, Language::kEnglish);
  return report;
}

ordered_json liftOfPosture(const mannequin::Figure& figure, const mannequin::FigurePose& pose,
                           const PostureScores& scores, const WorkTask& task) {
  const auto lift_task = liftOf(figure, pose, scores, task);
  if (!lift_task) return {{"refused", lift_task.error().message()}};
  const auto result = lift(*lift_task);
  if (!result) return {{"refused", result.error().message()}};
  return liftingReport(*lift_task, *result);
}

ordered_json workplaceReport(const studies::WorkplaceMap& map) {
  ordered_json report{{"bodies", {"P5F", "P50F", "P50M", "P95M"}}};
  const auto cellJson = [](const studies::WorkplaceCell& cell) {
    ordered_json entry{{"rise", cell.rise},
                       {"away", cell.away},
                       {"seated", cell.is_seated},
                       {"worst", cell.worst},
                       {"rula", cell.rula}};
    if (!cell.why.empty()) entry["why_not"] = cell.why;
    return entry;
  };
  report["best"] = nullptr;
  if (map.best >= 0) {
    const studies::WorkplaceCell& best = map.cells[static_cast<std::size_t>(map.best)];
    report["best"] = cellJson(best);
    for (const mannequin::Posture& posture : best.postures)
      report["best"]["postures"].push_back(ordered_json::parse(mannequin::postureText(posture)));
  }
  report["placements"] = ordered_json::array();
  for (const auto& cell : map.cells) report["placements"].push_back(cellJson(cell));
  return report;
}

Expected<studies::WorkplaceCell> bestPlaceIn(const std::filesystem::path& file) {
  const auto text = workcell::readFileContent(file);
  HAPTICELL_TRY(text);
  auto flat = geometry::checkNesting(*text, geometry::NestedText::kJson, file.string());
  HAPTICELL_TRY(flat);
  const nlohmann::json report = nlohmann::json::parse(*text, nullptr, false);
  studies::WorkplaceCell place;
  try {
    const nlohmann::json& best = report.at("best");
    place.rise = best.at("rise");
    place.away = best.at("away");
    place.is_seated = best.at("seated");
    place.worst = best.at("worst");
    place.rula = best.at("rula");
    for (const nlohmann::json& posture : best.at("postures")) {
      auto read = mannequin::parsePosture(posture.dump(), "posture");
      HAPTICELL_TRY(read);
      place.postures.push_back(std::move(*read));
    }
  } catch (const nlohmann::json::exception&) {
    return makeError({.file = file.string(),
                      .place = "best",
                      .found = "it is missing or invalid",
                      .expected = "the best place and its four postures"});
  }
  return place;
}

}  // namespace hapticell::cli
