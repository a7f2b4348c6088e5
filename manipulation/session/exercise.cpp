// SPDX-License-Identifier: Apache-2.0
#include "manipulation/session/exercise.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>

#include "geometry/system/nesting_limit.h"
#include "workcell/text/file_content.h"

namespace hapticell::manipulation {

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr const char* kFormat = "hapticell-exercise";
constexpr int kVersion = 1;
// m of way that the guide reaches back, so that a hand that stops or slips is still led. Half: it may leave the tube
// backwards; twice: ways that cross themselves pull back.
constexpr double kBehind = 0.03;

struct NumberField {
  const char* name;
  double* value;
  double least, most;
};

std::vector<NumberField> numbersOf(Exercise& exercise) {
  return {{"tube_radius", &exercise.tube_radius, 1e-4, 10.0},
          {"lead", &exercise.lead, 0.0, 1.0},
          {"stiffness", &exercise.stiffness, 0.0, 500.0},
          {"pass", &exercise.pass, 0.0, 100.0},
          {"deviation_costs_all", &exercise.rule.deviation, 1e-5, 10.0},
          {"force_costs_all", &exercise.rule.force, 1e-3, 1000.0},
          {"slowness_costs_all", &exercise.rule.slowness, 1.0, 1000.0}};
}

}  // namespace

Expected<Exercise> readExercise(const fs::path& file) {
  const auto text = workcell::readFileContent(file);
  HAPTICELL_TRY(text);
  auto flat = geometry::checkNesting(*text, geometry::NestedText::kJson, file.string());
  HAPTICELL_TRY(flat);
  const json document = json::parse(*text, nullptr, false);
  const auto wrong = [&](const std::string& field, Text found, Text expected) {
    return makeError({.file = file.string(),
                      .place = Text("field '%1'", field),
                      .found = std::move(found),
                      .expected = std::move(expected)});
  };
  if (!document.is_object() || document.value("format", json()) != kFormat) {
    return wrong("format", Text("not an exercise"), std::string("\"") + kFormat + "\"");
  }
  const json version = document.value("version", json());
  if (!version.is_number_integer() || version.get<std::int64_t>() != kVersion) {
    return wrong("version", version.dump(), std::to_string(kVersion));
  }
  Exercise exercise;
  std::string cell, recording;
  for (const auto& [field, value] : {std::pair("name", &exercise.name), std::pair("text", &exercise.text),
                                     std::pair("workcell", &cell), std::pair("recording", &recording)}) {
    const auto found = document.find(field);
    if (found == document.end() || !found->is_string()) return wrong(field, Text("none"), Text("a text"));
    *value = found->get<std::string>();
  }
  const fs::path folder = fs::absolute(file).parent_path();
  exercise.workcell = (folder / cell).lexically_normal();
  exercise.recording = (folder / recording).lexically_normal();
  for (const NumberField& number : numbersOf(exercise)) {
    const auto found = document.find(number.name);
    if (found == document.end()) continue;
    const double value = found->is_number() ? found->get<double>() : std::nan("");
    if (!(value >= number.least && value <= number.most)) {
      return wrong(number.name, found->dump(),
                   Text("%1 to %2", std::to_string(number.least), std::to_string(number.most)));
    }
    *number.value = value;
  }
  return exercise;
}

namespace {

/// Relative where there is such a way.
std::string placeFrom(const fs::path& folder, const fs::path& file) {
  const fs::path relative = file.lexically_relative(folder);
  return (relative.empty() ? file : relative).generic_string();
}

}  // namespace

std::string exerciseText(const Exercise& exercise, const fs::path& folder) {
  nlohmann::ordered_json document{{"format", kFormat},
                                  {"version", kVersion},
                                  {"name", exercise.name},
                                  {"text", exercise.text},
                                  {"workcell", placeFrom(folder, exercise.workcell)},
                                  {"recording", placeFrom(folder, exercise.recording)}};
  Exercise copy = exercise;
  for (const NumberField& number : numbersOf(copy)) document[number.name] = *number.value;
  return document.dump(2) + "\n";
}

Expected<void> checkExercise(const Exercise& wanted, const fs::path& written) {
  const auto read = readExercise(written);
  HAPTICELL_TRY(read);
  const auto differs = [&](const std::string& field, const std::string& found, const std::string& expected) {
    return makeError({.file = written.string(),
                      .place = Text("field '%1'", field),
                      .found = Text("'%1' after saving", found),
                      .expected = "'" + expected + "'"});
  };
  const auto text = [](const fs::path& file) { return file.lexically_normal().string(); };
  const std::tuple<const char*, std::string, std::string> texts[] = {
      {"name", read->name, wanted.name},
      {"text", read->text, wanted.text},
      {"workcell", text(read->workcell), text(wanted.workcell)},
      {"recording", text(read->recording), text(wanted.recording)}};
  for (const auto& [field, is, was] : texts)
    if (is != was) return differs(field, is, was);
  const std::tuple<const char*, double, double> numbers[] = {
      {"tube_radius", read->tube_radius, wanted.tube_radius},
      {"lead", read->lead, wanted.lead},
      {"stiffness", read->stiffness, wanted.stiffness},
      {"pass", read->pass, wanted.pass},
      {"deviation_costs_all", read->rule.deviation, wanted.rule.deviation},
      {"force_costs_all", read->rule.force, wanted.rule.force},
      {"slowness_costs_all", read->rule.slowness, wanted.rule.slowness}};
  for (const auto& [field, is, was] : numbers)
    if (is != was) return differs(field, json(is).dump(), json(was).dump());
  return {};
}

std::vector<fs::path> exercisesIn(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code fault;
  for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end; entry.increment(fault)) {
    if (entry->path().extension() == ".hexercise") found.push_back(entry->path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

TrainingRun::TrainingRun(const Exercise& exercise, trajectory::Trajectory expert, double help)
    : exercise_(exercise), expert_(std::move(expert)), progress_(expert_), help_(std::clamp(help, 0.0, 1.0)) {}

void TrainingRun::follow(const Pose& X_WM) {
  progress_.follow(X_WM);
}

workcell::Guide TrainingRun::guide() const {
  workcell::Guide guide;
  guide.name = kGuideName;
  guide.kind = workcell::GuideKind::kTube;
  guide.entity = expert_.entity;
  guide.enabled = help_ > 0.0;
  guide.help = help_ * exercise_.stiffness;
  guide.lead = exercise_.lead;
  guide.path = progress_.window(kBehind, exercise_.lead + exercise_.tube_radius);
  // The less help, the wider the tube: at a tenth of the help it is ten times as wide.
  guide.radius = exercise_.tube_radius / std::max(help_, 0.1);
  return guide;
}

trajectory::TrainingAttempt TrainingRun::finish(const trajectory::Trajectory& run, const std::string& date) const {
  trajectory::TrainingAttempt attempt;
  attempt.date = date;
  attempt.help = help_;
  attempt.score = trajectory::scoreRun(expert_, run, exercise_.rule);
  attempt.success = attempt.score.completed >= 1.0 && attempt.score.points >= exercise_.pass;
  return attempt;
}

}  // namespace hapticell::manipulation
