// SPDX-License-Identifier: Apache-2.0
#include "cli/ergonomics/ergonomics_report.h"

#include <algorithm>
#include <array>

#include "cli/ergonomics/ergonomics_advice_report.h"
#include "mannequin/ergonomics/advice/lifting_advice.h"
#include "mannequin/ergonomics/advice/method_advice.h"
#include "mannequin/ergonomics/methods/owas.h"
#include "mannequin/ergonomics/methods/reba.h"
#include "mannequin/ergonomics/methods/rula.h"

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

ordered_json numberOrNull(const std::optional<double>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

const ScoredMethod& methodOf(MotionMethod method) {
  static const Rula rula;
  static const Reba reba;
  static const Owas owas;
  if (method == MotionMethod::kRula) return rula;
  if (method == MotionMethod::kReba) return reba;
  return owas;
}

/// What the worst frame's score is made of, and what would bring it down.
void addWorstFrame(MotionMethod method, const MotionScores& scores, ordered_json& frame) {
  ordered_json& sub_scores = frame["sub_scores"] = ordered_json::object();
  for (std::size_t i = 0; i < scores.worst_values.size(); ++i) {
    const auto& value = scores.worst_values[i];
    sub_scores[std::string(methodOf(method).subScores()[i].name)] =
        value ? ordered_json(*value) : ordered_json(nullptr);
  }
  addAdvice(scores.worst_advice, frame);
}

/// Each task with the index that is left without it, the greatest fall first; and for the whole the changes of single
/// tasks that each bring it down a level.
void addCompositeAdvice(const LiftingInput& input, const CompositeLifting& result, ordered_json& report) {
  std::vector<std::pair<double, std::size_t>> without;
  ordered_json any_of = ordered_json::array();
  double target = 1.0;
  for (std::size_t i = 0; i < input.tasks.size(); ++i) {
    auto others = input.tasks;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    const auto rest = compositeLift(others, input.conditions);
    without.emplace_back(rest ? rest->index : 0.0, i);
    const LiftingIndex index_of = [&, tasks = input.tasks](const LiftingTask& task) mutable -> std::optional<double> {
      tasks[i] = task;
      const auto whole = compositeLift(tasks, input.conditions);
      return whole ? std::optional<double>(whole->index) : std::nullopt;
    };
    const LiftingAdvice advice = adviseLift(input.tasks[i], result.tasks[i], index_of);
    target = advice.target;
    for (const LiftingChange& change : advice.alone) {
      any_of.push_back(toJson(change));
      any_of.back()["task"] = i + 1;
    }
  }
  std::stable_sort(without.begin(), without.end());
  report["drivers"] = ordered_json::array();
  for (const auto& [index, task] : without)
    report["drivers"].push_back({{"input", "tasks"}, {"task", task + 1}, {"lifting_index", index}});
  report["next_level"] = nullptr;
  if (liftingLevel(result.index) > 1)
    report["next_level"] = {{"lifting_index_at_most", target}, {"any_of", std::move(any_of)}};
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
  // Loads and activities came beside the angles and stay as they are.
  if (input.angles) addAdvice(adviseAngles(method, *input.angles, input.values), report);
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
    json["trunk_side_bend"] = frame.trunk_side_bend;
    json["trunk_inclination"] = frame.trunk_inclination;
    json["upper_arm_elevation"] = {{"left", frame.upper_arm_elevation[0]}, {"right", frame.upper_arm_elevation[1]}};
    return json;
  };
  const auto sharesOf = [](const std::map<int, double>& shares) {
    ordered_json json = ordered_json::object();
    for (const auto& [value, share] : shares) json[std::to_string(value)] = share;
    return json;
  };
  ordered_json report{{"method", std::string(methodOf(method).name())},
                      {"score", scores.frames[scores.worst].score},
                      {"level", scores.frames[scores.worst].level},
                      {"frame_time", scores.frame_time},
                      {"duration", static_cast<double>(scores.frames.size()) * scores.frame_time},
                      {"time_share_by_level", sharesOf(scores.share_by_level)},
                      {"time_share_by_score", sharesOf(scores.share_by_score)},
                      {"worst_frame", frameJson(scores.worst)}};
  addWorstFrame(method, scores, report["worst_frame"]);
  std::vector<int> frame_scores;
  for (const FrameScore& frame : scores.frames) frame_scores.push_back(frame.score);
  const auto phase = ergonomics::worstPhase(frame_scores, scores.frame_time);
  report["worst_phase"] = {{"from", static_cast<double>(phase.first) * scores.frame_time},
                           {"to", static_cast<double>(phase.last + 1) * scores.frame_time},
                           {"score", phase.score},
                           {"shown_frame", phase.shown}};
  if (method == MotionMethod::kRula) report["task"] = {{"muscle_use", task.muscle_use}, {"force", task.force}};
  if (method == MotionMethod::kReba) {
    report["task"] = {{"load", task.load}, {"coupling", task.coupling}, {"activity", task.activity}};
  }
  if (method == MotionMethod::kOwas) report["task"] = {{"load_kg", task.load_kg}};
  report["assumptions"] = {
      "Joint angles are those of a male figure of the 50th percentile that follows the recorded directions; the "
      "trunk's "
      "forward and side bend and the upper arms are of the recorded joints' places.",
      "The person stands (not seated, not walking), arms unsupported; task scores are the same in every frame.",
      "Twist and side bend count from 10 degrees, abduction from 45, a raised girdle from 10.",
      "Measured angles of trunk, neck and wrist within 5 degrees of 0 are neutral; RULA's neck is class 2 up to 6.5 "
      "degrees of extension, 3 up to 8, beyond 4."};
  ordered_json frames = ordered_json::array();
  for (std::size_t i = 0; i < scores.frames.size(); ++i) frames.push_back(frameJson(i));
  report["frames"] = std::move(frames);
  return report;
}

ordered_json liftingReport(const LiftingTask& task, const LiftingResult& result) {
  const int level = liftingLevel(result.lifting_index);
  ordered_json report{{"method", "NIOSH"},
                      {"source", "Waters, Putz-Anderson & Garg, DHHS (NIOSH) 94-110, rev. 9/2021"},
                      {"score", numberOrNull(result.lifting_index)},
                      {"level", level},
                      {"level_meaning", liftingLevelName(level)},
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
  addAdvice(adviseLift(task, result), report);
  report["assumptions"] = result.assumptions;
  return report;
}

ordered_json compositeReport(const LiftingInput& input, const CompositeLifting& result) {
  const int level = liftingLevel(result.index);
  ordered_json report{{"method", "NIOSH composite"},
                      {"source", "Waters, Putz-Anderson & Garg, DHHS (NIOSH) 94-110, rev. 9/2021"},
                      {"score", result.index},
                      {"level", level},
                      {"level_meaning", liftingLevelName(level)},
                      {"composite_lifting_index", result.index}};
  report["tasks"] = ordered_json::array();
  for (std::size_t i = 0; i < input.tasks.size(); ++i) {
    report["tasks"].push_back(liftingReport(input.tasks[i], result.tasks[i]));
  }
  ordered_json order = ordered_json::array();
  for (const std::size_t i : result.order) order.push_back(i + 1);
  report["order"] = std::move(order);
  report["partial"] = false;
  addCompositeAdvice(input, result, report);
  report["assumptions"] = result.tasks.front().assumptions;
  return report;
}

}  // namespace hapticell::cli
