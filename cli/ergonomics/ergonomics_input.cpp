// SPDX-License-Identifier: Apache-2.0
#include "cli/ergonomics/ergonomics_input.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iostream>
#include <iterator>

#include "cli/kit/result_writer.h"
#include "geometry/system/listed.h"
#include "geometry/system/nesting_limit.h"
#include "geometry/system/regular_file.h"
#include "mannequin/ergonomics/advice/posture_advice.h"
#include "mannequin/ergonomics/methods/owas.h"
#include "mannequin/ergonomics/methods/reba.h"
#include "mannequin/ergonomics/methods/rula.h"

namespace hapticell::cli {

std::string shortText(const nlohmann::json& value) {
  std::string text = value.dump();
  if (text.size() > 60) text = text.substr(0, 57) + "...";
  return text;
}

namespace {

using namespace ergonomics;
using Names = std::initializer_list<std::string_view>;

tl::unexpected<Error> refused(const std::string& field, const Text& found, const Text& expected) {
  return makeError({.place = field, .found = found, .expected = expected});
}

/// Refuses fields that are not among `known`: a misspelt field would else be a missing one.
Expected<void> checkNames(const nlohmann::json& object, const std::string& where,
                          const std::vector<std::string_view>& known) {
  if (!object.is_object()) return refused(where, shortText(object), Text("an object with fields"));
  for (const auto& [name, value] : object.items()) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      return refused(name, Text("no field has this name"), Text("one of %1", listed(known)));
    }
  }
  return {};
}

Expected<int> wholeNumber(const nlohmann::json& value, const SubScore& sub_score) {
  const bool is_whole = value.is_number() && value.get<double>() == std::floor(value.get<double>());
  if (!is_whole || value.get<double>() < sub_score.least || value.get<double>() > sub_score.greatest) {
    return refused(std::string(sub_score.name), shortText(value),
                   Text("a whole number, %1 to %2", sub_score.least, sub_score.greatest));
  }
  return static_cast<int>(value.get<double>());
}

/// Takes the method's sub-scores out of `object`, as far as they are there.
Expected<void> readSubScores(const nlohmann::json& object, const ScoredMethod& method, ScoredInput& result) {
  for (std::size_t i = 0; i < method.subScores().size(); ++i) {
    const SubScore& sub_score = method.subScores()[i];
    const auto field = object.find(sub_score.name);
    if (field == object.end()) continue;
    const auto value = wholeNumber(*field, sub_score);
    HAPTICELL_TRY(value);
    result.values[i] = *value;
  }
  return {};
}

Expected<bool> flagOf(const PostureField& field, const nlohmann::json& value) {
  if (field.name == "wrist_twist") {
    if (value == "mid") return false;
    if (value == "end") return true;
    return refused("wrist_twist", shortText(value), Text("\"mid\" or \"end\""));
  }
  if (!value.is_boolean()) return refused(std::string(field.name), shortText(value), Text("true or false"));
  return value.get<bool>();
}

Expected<PostureAngles> readAngles(const nlohmann::json& object) {
  std::vector<std::string_view> known;
  for (const PostureField& field : postureFields()) known.push_back(field.name);
  HAPTICELL_TRY(checkNames(object, "angles", known));
  PostureAngles angles;
  for (const PostureField& field : postureFields()) {
    const auto value = object.find(field.name);
    if (value == object.end()) continue;
    if (field.flag != nullptr) {
      const auto flag = flagOf(field, *value);
      HAPTICELL_TRY(flag);
      angles.*field.flag = *flag;
      continue;
    }
    const bool is_within =
        value->is_number() && value->get<double>() >= field.least && value->get<double>() <= field.greatest;
    if (!is_within) {
      return refused(std::string(field.name), shortText(*value),
                     Text("%1 to %2 degrees", shortNumber(field.least), shortNumber(field.greatest)));
    }
    angles.*field.angle = value->get<double>();
  }
  return angles;
}

/// What RULA and REBA share: "scores" or "angles", and further fields at the top.
template <typename ValuesOf>
Expected<ScoredInput> scoredInput(const nlohmann::json& input, const ScoredMethod& method, const Names& at_top,
                                  const ValuesOf& values_of) {
  std::vector<std::string_view> known{"scores", "angles"};
  known.insert(known.end(), at_top.begin(), at_top.end());
  HAPTICELL_TRY(checkNames(input, "", known));
  if (input.contains("scores") == input.contains("angles")) {
    return refused("scores, angles", input.contains("scores") ? Text("both are given") : Text("neither is given"),
                   Text("one of the two"));
  }
  ScoredInput result;
  result.values.resize(method.subScores().size());
  if (input.contains("angles")) {
    auto angles = readAngles(input["angles"]);
    HAPTICELL_TRY(angles);
    std::vector<std::string_view> missing;
    result.values = values_of(*angles, missing);
    result.missing.assign(missing.begin(), missing.end());
    result.angles = *angles;
  } else {
    std::vector<std::string_view> names;
    for (const SubScore& sub_score : method.subScores()) names.push_back(sub_score.name);
    HAPTICELL_TRY(checkNames(input["scores"], "scores", names));
    HAPTICELL_TRY(readSubScores(input["scores"], method, result));
  }
  HAPTICELL_TRY(readSubScores(input, method, result));
  return result;
}

/// "muscle_use" and "force" count for the arm and for the body, where those are not given apart.
Expected<void> spreadOverBoth(const nlohmann::json& input, const Rula& method, ScoredInput& result) {
  const auto spread = [&](const char* name, std::size_t arm, std::size_t body) -> Expected<void> {
    if (!input.contains(name)) return {};
    SubScore named = method.subScores()[arm];
    named.name = name;
    const auto value = wholeNumber(input[name], named);
    HAPTICELL_TRY(value);
    for (const std::size_t i : {arm, body}) result.values[i] = result.values[i].value_or(*value);
    result.assumptions.push_back(std::string(name) + " counts for the arm and for the body.");
    return {};
  };
  if (auto done = spread("muscle_use", Rula::kMuscleUseArm, Rula::kMuscleUseBody); !done) return done;
  return spread("force", Rula::kForceArm, Rula::kForceBody);
}

template <typename Values>
std::vector<std::optional<int>> asVector(const Values& values) {
  return {values.begin(), values.end()};
}

std::string neutralWords(const PostureAngles& angles) {
  return angles.measured.value_or(false)
             ? "angles are measured: trunk, neck and wrist are neutral within 5 degrees of 0."
             : "the trunk is upright at 0 degrees only, and a neck or a wrist is neutral by the letter.";
}

struct NumberField {
  const char* name;
  double LiftingTask::*member;
};

constexpr NumberField kLiftingFields[] = {
    {"load_kg", &LiftingTask::load_kg},
    {"h_cm", &LiftingTask::h_cm},
    {"v_cm", &LiftingTask::v_cm},
    {"d_cm", &LiftingTask::d_cm},
    {"asymmetry_deg", &LiftingTask::asymmetry_deg},
    {"frequency_per_min", &LiftingTask::frequency_per_min},
    {"duration_h", &LiftingTask::duration_h},
};

struct ConditionField {
  const char* name;
  bool LiftingConditions::*member;
};

constexpr ConditionField kConditionFields[] = {
    {"one_handed", &LiftingConditions::one_handed},
    {"seated_or_kneeling", &LiftingConditions::seated_or_kneeling},
    {"restricted_space", &LiftingConditions::restricted_space},
    {"unstable_load", &LiftingConditions::unstable_load},
    {"pushing_pulling_or_carrying", &LiftingConditions::pushing_pulling_or_carrying},
    {"fast", &LiftingConditions::fast},
    {"hot_or_cold", &LiftingConditions::hot_or_cold},
    {"slippery_floor", &LiftingConditions::slippery_floor},
};

Expected<LiftingTask> liftingTask(const nlohmann::json& object) {
  LiftingTask task;
  task.load_kg = 1.0;
  const char* missing = nullptr;
  for (const NumberField& field : kLiftingFields) {
    const auto value = object.find(field.name);
    if (value == object.end()) {
      if (!missing) missing = field.name;
      continue;
    }
    if (!value->is_number()) return refused(field.name, shortText(*value), Text("a number"));
    task.*field.member = value->get<double>();
  }
  // What is there and wrong is told before what is not there.
  HAPTICELL_TRY(checkLiftingRanges(task));
  if (missing) return refused(missing, Text("it is missing"), Text("a number; the equation needs all fields"));
  const nlohmann::json coupling = object.value("coupling", nlohmann::json());
  if (coupling == "good") {
    task.coupling = Coupling::kGood;
  } else if (coupling == "fair") {
    task.coupling = Coupling::kFair;
  } else if (coupling == "poor") {
    task.coupling = Coupling::kPoor;
  } else {
    return refused("coupling", coupling.is_null() ? Text("it is missing") : Text(shortText(coupling)),
                   Text("good, fair or poor"));
  }
  return task;
}

}  // namespace

Expected<nlohmann::json> readErgonomicsInput(const std::string& input) {
  std::string text = input;
  const auto first = input.find_first_not_of(" \t\r\n");
  const bool is_in_place = first != std::string::npos && (input[first] == '{' || input[first] == '[');
  if (input == "-") {
    text.assign(std::istreambuf_iterator<char>(std::cin), {});
  } else if (!is_in_place) {
    auto content = geometry::readRegularFile(input);
    if (!content)
      return makeError({.file = input, .found = content.error().found, .expected = "a JSON file or JSON text"});
    text = std::move(*content);
  }
  const std::string name = is_in_place || input == "-" ? "--input" : input;
  auto flat = geometry::checkNesting(text, geometry::NestedText::kJson, name);
  HAPTICELL_TRY(flat);
  nlohmann::json parsed = nlohmann::json::parse(text, nullptr, false);
  if (parsed.is_discarded()) {
    return makeError({.file = name, .found = "invalid JSON", .expected = "a JSON object in braces"});
  }
  return parsed;
}

std::vector<std::optional<int>> rulaValuesOf(const PostureAngles& angles, std::vector<std::string_view>& missing) {
  return asVector(rulaValues(angles, missing));
}

std::vector<std::optional<int>> rebaValuesOf(const PostureAngles& angles, std::vector<std::string_view>& missing) {
  return asVector(rebaValues(angles, missing));
}

Expected<ScoredInput> rulaInput(const nlohmann::json& input) {
  const Rula method;
  auto result = scoredInput(input, method,
                            {"muscle_use", "force", "muscle_use_arm", "force_arm", "muscle_use_body", "force_body"},
                            rulaValuesOf);
  if (!result) return result;
  HAPTICELL_TRY(spreadOverBoth(input, method, *result));
  if (result->angles) {
    result->assumptions.push_back(
        std::string(
            "An inner boundary belongs to the lower class, the last class includes its boundary (\"or more\"); ") +
        neutralWords(*result->angles));
  }
  return result;
}

Expected<ScoredInput> rebaInput(const nlohmann::json& input) {
  auto result = scoredInput(input, Reba(), {"load", "coupling", "activity"}, rebaValuesOf);
  if (result && result->angles) {
    result->assumptions.push_back("A boundary belongs to the lower class; " + neutralWords(*result->angles));
  }
  return result;
}

Expected<ScoredInput> owasInput(const nlohmann::json& input) {
  const Owas method;
  HAPTICELL_TRY(checkNames(input, "", {"code"}));
  const nlohmann::json code = input.value("code", nlohmann::json());
  std::string digits;
  if (code.is_string()) digits = code.get<std::string>();
  if (code.is_number_integer()) digits = code.dump();
  if (digits.size() != 4) {
    return refused("code", code.is_null() ? Text("it is missing") : Text(shortText(code)),
                   Text("four digits: back, arms, legs, load"));
  }
  ScoredInput result;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const SubScore& digit = method.subScores()[i];
    const int value = digits[i] - '0';
    if (value < digit.least || value > digit.greatest) {
      return refused("code", Text("digit %1 (%2) is '%3'", i + 1, digit.name, std::string(1, digits[i])),
                     Text("%1 to %2", digit.least, digit.greatest));
    }
    result.values.emplace_back(value);
  }
  return result;
}

Expected<LiftingInput> liftingInput(const nlohmann::json& input) {
  std::vector<std::string_view> known{"coupling", "tasks"};
  for (const NumberField& field : kLiftingFields) known.emplace_back(field.name);
  for (const ConditionField& field : kConditionFields) known.emplace_back(field.name);
  HAPTICELL_TRY(checkNames(input, "", known));
  LiftingInput result;
  for (const ConditionField& field : kConditionFields) {
    const auto value = input.find(field.name);
    if (value == input.end()) continue;
    if (!value->is_boolean()) return refused(field.name, shortText(*value), Text("true or false"));
    result.conditions.*field.member = value->get<bool>();
  }
  result.is_composite = input.contains("tasks");
  const nlohmann::json tasks = result.is_composite ? input["tasks"] : nlohmann::json::array({input});
  if (!tasks.is_array() || tasks.empty()) return refused("tasks", shortText(tasks), Text("a list of lifting tasks"));
  for (const nlohmann::json& task : tasks) {
    if (!task.is_object()) return refused("tasks", shortText(task), Text("a list of lifting tasks"));
    auto read = liftingTask(task);
    if (!read && result.is_composite) {
      read.error().place = Text("task %1, %2", result.tasks.size() + 1, read.error().place);
    }
    HAPTICELL_TRY(read);
    result.tasks.push_back(*read);
  }
  return result;
}

}  // namespace hapticell::cli
