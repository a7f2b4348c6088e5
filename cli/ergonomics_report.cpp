// SPDX-License-Identifier: Apache-2.0
#include "cli/ergonomics_report.h"

#include <algorithm>
#include <array>

#include "mannequin/ergonomics/owas.h"
#include "mannequin/ergonomics/posture_advice.h"

namespace hapticell::cli {

namespace {

using namespace ergonomics;
using nlohmann::ordered_json;

std::string heading(int first, int second) {
  std::string text = std::to_string(first);
  if (second != 0) text.append(".").append(std::to_string(second));
  return text;
}

ordered_json entriesOf(const Evaluation& evaluation) {
  ordered_json entries = ordered_json::array();
  for (const TableEntry& entry : evaluation.entries) {
    entries.push_back({{"table", entry.table},
                       {"row", heading(entry.row, entry.row_part)},
                       {"column", heading(entry.column, entry.column_part)},
                       {"value", entry.value}});
  }
  return entries;
}

ordered_json subScoresOf(const ScoredMethod& method, const Assessment& assessment, const ScoredInput& input) {
  ordered_json sub_scores = ordered_json::object();
  for (std::size_t i = 0; i < assessment.values.size(); ++i) {
    ordered_json& value = sub_scores[std::string(method.subScores()[i].name)];
    if (input.values[i] || !method.subScores()[i].required) value = assessment.values[i];
  }
  return sub_scores;
}

ordered_json driversOf(const Assessment& assessment) {
  ordered_json drivers = ordered_json::array();
  for (const Driver& driver : assessment.drivers) {
    drivers.push_back({{"input", driver.sub_score}, {"from", driver.from}, {"to", driver.to}, {"score", driver.score}});
  }
  return drivers;
}

ordered_json nextLevelOf(const ScoredMethod& method, const Assessment& assessment) {
  if (!assessment.next_level) return nullptr;
  ordered_json changes = ordered_json::array();
  for (const auto& change : assessment.next_level->changes) {
    changes.push_back({{"input", change.sub_score}, {"from", change.from}, {"to", change.to}});
  }
  return {{"score", assessment.next_level->score},
          {"level", assessment.next_level->level},
          {"level_meaning", method.levelName(assessment.next_level->level)},
          {"changes", std::move(changes)}};
}

ordered_json changeOf(const FieldChange& change) {
  ordered_json result{{"input", change.field}};
  if (change.is_flag) {
    result["from"] = change.from > 0.5;
    result["to"] = change.to > 0.5;
  } else {
    result["from"] = change.from;
    result["to"] = change.to;
  }
  return result;
}

/// What changes of the posture itself would do, where angles were given.
void addPostureAdvice(const ScoredMethod& method, const ScoredInput& input, ordered_json& report) {
  if (!input.angles) return;
  // Loads and activities came beside the angles and stay as they are.
  std::vector<std::string_view> ignored;
  const bool is_rula = method.name() == "RULA";
  const auto of_angles = [&](const PostureAngles& angles) {
    ignored.clear();
    return is_rula ? rulaValuesOf(angles, ignored) : rebaValuesOf(angles, ignored);
  };
  const PostureScore score = [&](const PostureAngles& angles) -> std::optional<int> {
    const auto values = of_angles(angles);
    std::vector<int> complete;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const SubScore& sub_score = method.subScores()[i];
      if (sub_score.required && !values[i]) return std::nullopt;
      complete.push_back(sub_score.required ? *values[i] : input.values[i].value_or(sub_score.least));
    }
    return method.score(complete);
  };
  ordered_json drivers = ordered_json::array();
  for (const PostureDriver& driver : postureDrivers(*input.angles, score)) {
    ordered_json entry = changeOf(driver.change);
    entry["score"] = driver.score;
    drivers.push_back(std::move(entry));
  }
  report["posture_drivers"] = std::move(drivers);
  const auto goal = nextLevelPosture(*input.angles, score, [&](int value) { return method.levelOf(value); });
  if (!goal) {
    report["nearest_better_posture"] = nullptr;
    return;
  }
  ordered_json changes = ordered_json::array();
  for (const FieldChange& change : goal->changes) changes.push_back(changeOf(change));
  report["nearest_better_posture"] = {
      {"score", goal->score}, {"level", method.levelOf(goal->score)}, {"changes", std::move(changes)}};
}

std::vector<std::string> missingOf(const Assessment& assessment, const ScoredInput& input) {
  std::vector<std::string> missing = input.missing;
  for (const std::string_view name : assessment.missing) missing.emplace_back(name);
  return missing;
}

void addMeanings(const ScoredMethod& method, const ScoredInput& input, ordered_json& report) {
  if (method.name() != "OWAS") return;
  ordered_json meanings = ordered_json::object();
  for (std::size_t i = 0; i < input.values.size(); ++i) {
    meanings[std::string(method.subScores()[i].name)] = Owas::meaning(static_cast<Owas::Index>(i), *input.values[i]);
  }
  report["meanings"] = std::move(meanings);
}

std::string_view couplingName(Coupling coupling) {
  constexpr std::array<std::string_view, 3> kNames{"good", "fair", "poor"};
  return kNames[static_cast<std::size_t>(coupling)];
}

/// The multipliers below 1, smallest first: what raising each to 1 would make of the index.
ordered_json liftingDrivers(const LiftingResult& result) {
  struct Named {
    const char* field;
    const char* multiplier;
    double value;
  };
  std::array<Named, 6> all{{{"h_cm", "HM", result.hm},
                            {"v_cm", "VM", result.vm},
                            {"d_cm", "DM", result.dm},
                            {"asymmetry_deg", "AM", result.am},
                            {"frequency_per_min", "FM", result.fm},
                            {"coupling", "CM", result.cm}}};
  std::stable_sort(all.begin(), all.end(), [](const Named& a, const Named& b) { return a.value < b.value; });
  ordered_json drivers = ordered_json::array();
  for (const Named& one : all) {
    if (one.value >= 1.0) continue;
    ordered_json entry{{"input", one.field}, {"multiplier", one.multiplier}, {"value", one.value}};
    if (result.lifting_index) entry["lifting_index"] = *result.lifting_index * one.value;
    drivers.push_back(std::move(entry));
  }
  return drivers;
}

ordered_json numberOrNull(const std::optional<double>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

struct LiftingLevel {
  int level;
  const char* meaning;
};

/// NIOSH names 1 and 3 as the indices that matter (manual, section 1.5).
LiftingLevel liftingLevel(const std::optional<double>& index) {
  if (index && *index <= 1.0) return {1, "acceptable for nearly all healthy workers"};
  if (index && *index <= 3.0) return {2, "raised risk for some; redesign"};
  return {3, "raised risk for many; redesign now"};
}

}  // namespace

ordered_json scoredReport(const ScoredMethod& method, const ScoredInput& input) {
  const Assessment assessment = assess(method, input.values);
  const auto missing = missingOf(assessment, input);
  ordered_json report{{"method", method.name()}, {"source", method.source()}};
  report["score"] = assessment.score ? ordered_json(*assessment.score) : ordered_json(nullptr);
  report["level"] = assessment.level ? ordered_json(*assessment.level) : ordered_json(nullptr);
  if (assessment.level) report["level_meaning"] = method.levelName(*assessment.level);
  report["partial"] = !missing.empty();
  report["missing"] = missing;
  report["score_range"] = {assessment.least_score, assessment.greatest_score};
  report["sub_scores"] = subScoresOf(method, assessment, input);
  report["tables"] = assessment.evaluation ? entriesOf(*assessment.evaluation) : ordered_json::array();
  if (assessment.evaluation) {
    for (const auto& sum : assessment.evaluation->sums) report[std::string(sum.name)] = sum.value;
  }
  addMeanings(method, input, report);
  report["drivers"] = driversOf(assessment);
  report["next_level"] = nextLevelOf(method, assessment);
  addPostureAdvice(method, input, report);
  std::vector<std::string> assumptions = input.assumptions;
  for (const std::string& name : missing) {
    assumptions.push_back(name + " was not given" +
                          (assessment.score ? " and is counted at its least: the true score may be higher." : "."));
  }
  report["assumptions"] = std::move(assumptions);
  return report;
}

ordered_json motionReport(MotionMethod method, const MotionScores& scores, const MotionTask& task) {
  const auto frameJson = [&](std::size_t i) {
    const FrameScore& frame = scores.frames[i];
    ordered_json json{{"frame", i},
                      {"t", static_cast<double>(i) * scores.frame_time},
                      {"score", frame.score},
                      {"level", frame.level}};
    if (method != MotionMethod::kOwas) {
      json["left"] = frame.left;
      json["right"] = frame.right;
    }
    json["trunk_flexion"] = frame.trunk_flexion;
    json["upper_arm_elevation"] = {{"left", frame.upper_arm_elevation[0]}, {"right", frame.upper_arm_elevation[1]}};
    return json;
  };
  const auto sharesOf = [](const std::map<int, double>& shares) {
    ordered_json json = ordered_json::object();
    for (const auto& [value, share] : shares) json[std::to_string(value)] = share;
    return json;
  };
  ordered_json report{{"method", method == MotionMethod::kRula   ? "RULA"
                                 : method == MotionMethod::kReba ? "REBA"
                                                                 : "OWAS"},
                      {"score", scores.frames[scores.worst].score},
                      {"level", scores.frames[scores.worst].level},
                      {"frame_time", scores.frame_time},
                      {"duration", static_cast<double>(scores.frames.size()) * scores.frame_time},
                      {"time_share_by_level", sharesOf(scores.share_by_level)},
                      {"time_share_by_score", sharesOf(scores.share_by_score)},
                      {"worst_frame", frameJson(scores.worst)}};
  if (method == MotionMethod::kRula) report["task"] = {{"muscle_use", task.muscle_use}, {"force", task.force}};
  if (method == MotionMethod::kReba) {
    report["task"] = {{"load", task.load}, {"coupling", task.coupling}, {"activity", task.activity}};
  }
  if (method == MotionMethod::kOwas) report["task"] = {{"load_kg", task.load_kg}};
  report["assumptions"] = {
      "Joint angles are those of a male figure of the 50th percentile that follows the recorded directions.",
      "The person stands (not seated, not walking), arms unsupported; task scores are the same in every frame.",
      "Twist and side bend count from 10 degrees, abduction from 45, a raised girdle from 10."};
  ordered_json frames = ordered_json::array();
  for (std::size_t i = 0; i < scores.frames.size(); ++i) frames.push_back(frameJson(i));
  report["frames"] = std::move(frames);
  return report;
}

ordered_json liftingReport(const LiftingTask& task, const LiftingResult& result) {
  const LiftingLevel level = liftingLevel(result.lifting_index);
  ordered_json report{{"method", "NIOSH"},
                      {"source", "Waters, Putz-Anderson & Garg, DHHS (NIOSH) 94-110, rev. 9/2021"},
                      {"score", numberOrNull(result.lifting_index)},
                      {"level", level.level},
                      {"level_meaning", level.meaning},
                      {"lifting_index", numberOrNull(result.lifting_index)},
                      {"recommended_weight_limit_kg", result.recommended_weight_limit_kg},
                      {"frequency_independent_limit_kg", result.frequency_independent_limit_kg},
                      {"frequency_independent_index", numberOrNull(result.frequency_independent_index)}};
  report["multipliers"] = {{"LC_kg", 23.0},   {"HM", result.hm}, {"VM", result.vm}, {"DM", result.dm},
                           {"AM", result.am}, {"FM", result.fm}, {"CM", result.cm}};
  report["inputs"] = {{"load_kg", task.load_kg},
                      {"h_cm", task.h_cm},
                      {"v_cm", task.v_cm},
                      {"d_cm", task.d_cm},
                      {"asymmetry_deg", task.asymmetry_deg},
                      {"frequency_per_min", task.frequency_per_min},
                      {"duration_h", task.duration_h},
                      {"coupling", couplingName(task.coupling)}};
  report["partial"] = false;
  report["drivers"] = liftingDrivers(result);
  report["assumptions"] = result.assumptions;
  return report;
}

ordered_json compositeReport(const LiftingInput& input, const CompositeLifting& result) {
  const LiftingLevel level = liftingLevel(result.index);
  ordered_json report{
      {"method", "NIOSH composite"},    {"source", "Waters, Putz-Anderson & Garg, DHHS (NIOSH) 94-110, rev. 9/2021"},
      {"score", result.index},          {"level", level.level},
      {"level_meaning", level.meaning}, {"composite_lifting_index", result.index}};
  report["tasks"] = ordered_json::array();
  for (std::size_t i = 0; i < input.tasks.size(); ++i) {
    report["tasks"].push_back(liftingReport(input.tasks[i], result.tasks[i]));
  }
  ordered_json order = ordered_json::array();
  for (const std::size_t i : result.order) order.push_back(i + 1);
  report["order"] = std::move(order);
  report["partial"] = false;
  report["drivers"] = {{{"input", "tasks"}, {"task", result.order.front() + 1}}};
  report["assumptions"] = result.tasks.front().assumptions;
  return report;
}

}  // namespace hapticell::cli
