// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>

#include "studies/document/study_section.h"
#include "studies/questions/question_kinds.h"
#include "studies/questions/robot_targets.h"

namespace hapticell::studies {

namespace {

using kinematics::InverseStatus;
using manipulation::FreeAnswer;

Answer whole(std::size_t count) {
  return static_cast<std::int64_t>(count);
}

double shareOf(std::size_t count, const std::vector<FreeAnswer>& targets) {
  return static_cast<double>(count) / static_cast<double>(targets.size());
}

/// How many targets are reached free of contact, and why the others are not.
class Reach : public Question {
 public:
  Reach(std::string name, TargetList list) : Question(std::move(name)), list_(std::move(list)) {}

  std::vector<Column> columns() const override {
    return {{"targets", Column::Kind::kWhole, ""},   {"reached", Column::Kind::kWhole, ""},
            {"share", Column::Kind::kNumber, ""},    {"colliding", Column::Kind::kWhole, ""},
            {"beyond_limits", Column::Kind::kWhole, ""}, {"unreachable", Column::Kind::kWhole, ""}};
  }

  Expected<std::vector<Answer>> answer(VariantCell& cell) const override {
    const auto solved = solvedTargets(cell, list_);
    HAPTICELL_TRY(solved);
    const std::vector<FreeAnswer>& targets = (*solved)->targets;
    std::size_t colliding = 0, limit = 0, unreachable = 0;
    for (const FreeAnswer& target : targets) {
      if (target.isFree()) continue;
      if (target.status == InverseStatus::kSolved) ++colliding;
      if (target.status == InverseStatus::kLimit) ++limit;
      if (target.status == InverseStatus::kUnreachable) ++unreachable;
    }
    const std::size_t reached = (*solved)->reached();
    return std::vector<Answer>{whole(targets.size()), whole(reached),     shareOf(reached, targets),
                               whole(colliding),      whole(limit), whole(unreachable)};
  }

 private:
  TargetList list_;
};

/// The one configuration of the arm that reaches most targets.
class BestConfiguration : public Question {
 public:
  BestConfiguration(std::string name, TargetList list) : Question(std::move(name)), list_(std::move(list)) {}

  std::vector<Column> columns() const override {
    return {{"configuration", Column::Kind::kText, ""},
            {"reached", Column::Kind::kWhole, ""},
            {"share", Column::Kind::kNumber, ""}};
  }

  Expected<std::vector<Answer>> answer(VariantCell& cell) const override {
    const auto solved = solvedTargets(cell, list_);
    HAPTICELL_TRY(solved);
    std::map<std::string, std::size_t> counts;
    for (const FreeAnswer& target : (*solved)->targets) {
      std::map<std::string, bool> of_target;
      for (const auto& solution : target.free) of_target[solution.configuration] = true;
      for (const auto& one : of_target) ++counts[one.first];
    }
    if (counts.empty()) return std::vector<Answer>{std::monostate(), whole(0), 0.0};
    // Of equal ones the first by name.
    const auto best = std::max_element(counts.begin(), counts.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    return std::vector<Answer>{best->first, whole(best->second), shareOf(best->second, (*solved)->targets)};
  }

 private:
  TargetList list_;
};

}  // namespace

MadeQuestion makeReach(const StudySection& section, StudyInputs& inputs) {
  SectionReader reader(section);
  auto list = readTargetList(reader, section, inputs);
  HAPTICELL_TRY(list);
  HAPTICELL_TRY(reader.end());
  return std::make_unique<Reach>(section.name, std::move(*list));
}

MadeQuestion makeConfiguration(const StudySection& section, StudyInputs& inputs) {
  SectionReader reader(section);
  auto list = readTargetList(reader, section, inputs);
  HAPTICELL_TRY(list);
  HAPTICELL_TRY(reader.end());
  return std::make_unique<BestConfiguration>(section.name, std::move(*list));
}

}  // namespace hapticell::studies
