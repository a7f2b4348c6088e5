// SPDX-License-Identifier: Apache-2.0
#include "cli/ergonomics/ergonomics_advice_report.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hapticell::cli {
namespace {

using namespace ergonomics;
using nlohmann::ordered_json;

/// Whole numbers as such: a score of 4 is no 4.0.
ordered_json scoreJson(double score) {
  if (score == std::round(score)) return static_cast<int>(std::lround(score));
  return score;
}

ordered_json changesJson(const std::vector<FieldChange>& changes) {
  ordered_json list = ordered_json::array();
  for (const FieldChange& change : changes) list.push_back(toJson(change));
  return list;
}

bool judgesParts(PostureMethod method) {
  return method == PostureMethod::kEn1005 || method == PostureMethod::kIso11226;
}

std::string_view zoneName(double score) {
  return nameOf(ergonomics::zoneOfLevel(score));
}

ordered_json partDrivers(const MethodAdvice& advice) {
  ordered_json drivers = ordered_json::array();
  for (const MethodDriver& driver : advice.drivers) {
    drivers.push_back({{"input", driver.part},
                       {"changes", changesJson(driver.changes)},
                       {"zone", zoneName(driver.score)},
                       {"level", driver.level}});
  }
  return drivers;
}

ordered_json wholeDrivers(const MethodAdvice& advice) {
  ordered_json drivers = ordered_json::array();
  for (const MethodDriver& driver : advice.drivers) {
    ordered_json entry = toJson(driver.changes.front());
    entry["score"] = scoreJson(driver.score);
    entry["level"] = driver.level;
    drivers.push_back(std::move(entry));
  }
  return drivers;
}

ordered_json listJson(const std::vector<LiftingChange>& changes) {
  ordered_json list = ordered_json::array();
  for (const LiftingChange& change : changes) list.push_back(toJson(change));
  return list;
}

ordered_json limitJson(const ForceLimit& limit) {
  constexpr std::array<const char*, 2> kSides{"left", "right"};
  const bool own = limit.method == "own";
  ordered_json entry{{"method", limit.method},
                     {"hand", limit.hand < 0 ? "both" : kSides[static_cast<std::size_t>(limit.hand)]},
                     {"force_n", limit.force_n}};
  if (own) {
    entry["limit_n"] = *limit.limit_n;
    entry["share"] = limit.force_n / *limit.limit_n;
  } else {
    entry["next_class_n"] = limit.limit_n ? ordered_json(*limit.limit_n) : ordered_json();
  }
  return entry;
}

/// The limits in the highest class, with the force under which each falls.
ordered_json forceDrivers(const HandForces& forces) {
  int worst = 0;
  for (const ForceLimit& limit : forces.limits) worst = std::max(worst, limit.band);
  ordered_json drivers = ordered_json::array();
  for (const ForceLimit& limit : forces.limits) {
    if (limit.band < worst || !limit.lower_n) continue;
    ordered_json entry = limitJson(limit);
    entry["lower_class_n"] = *limit.lower_n;
    drivers.push_back(std::move(entry));
  }
  return drivers;
}

}  // namespace

ordered_json toJson(const FieldChange& change) {
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

ordered_json toJson(const LiftingChange& change) {
  constexpr std::array<const char*, 3> kCouplings{"good", "fair", "poor"};
  const auto valueOf = [&](double value) -> ordered_json {
    if (change.field == "coupling") return kCouplings[static_cast<std::size_t>(value)];
    return value;
  };
  ordered_json entry{{"input", change.field}, {"from", valueOf(change.from)}, {"to", valueOf(change.to)}};
  entry["lifting_index"] = change.index ? ordered_json(*change.index) : ordered_json(nullptr);
  return entry;
}

void addAdvice(const MethodAdvice& advice, ordered_json& report) {
  const bool parts = judgesParts(advice.method);
  if (parts) {
    report["drivers"] = partDrivers(advice);
  } else {
    report["posture_drivers"] = wholeDrivers(advice);
  }
  if (!advice.next) {
    report["nearest_better_posture"] = nullptr;
    return;
  }
  ordered_json better{{"score", scoreJson(advice.next->score.score)}, {"level", advice.next->score.level}};
  if (parts) better["zone"] = zoneName(advice.next->score.score);
  better["changes"] = changesJson(advice.next->changes);
  report["nearest_better_posture"] = std::move(better);
}

void addAdvice(const LiftingAdvice& advice, ordered_json& report) {
  report["drivers"] = ordered_json::array();
  for (const LiftingDriver& driver : advice.drivers) {
    ordered_json entry{{"input", driver.field}, {"multiplier", driver.multiplier}, {"value", driver.value}};
    if (driver.index) entry["lifting_index"] = *driver.index;
    report["drivers"].push_back(std::move(entry));
  }
  report["next_level"] = nullptr;
  if (advice.level <= 1) return;
  report["next_level"] = {{"lifting_index_at_most", advice.target},
                          {"any_of", listJson(advice.alone)},
                          {"together", listJson(advice.together)}};
}

ordered_json toJson(const BetterPlaces& places) {
  ordered_json report = ordered_json::object();
  for (const PostureMethod method : kPostureMethods) {
    const auto& place = places[static_cast<std::size_t>(method)];
    ordered_json& entry = report[std::string(nameOf(method))];
    if (!place) continue;
    entry = {{"shift", {place->shift_W.x, place->shift_W.y, place->shift_W.z}},
             {"score", scoreJson(place->score.score)},
             {"level", place->score.level}};
  }
  return report;
}

void addEawsAdvice(const std::array<double, kEawsPostureCount>& shares, ordered_json& report) {
  report["drivers"] = ordered_json::array();
  for (const EawsDriver& driver : eawsDrivers(shares)) {
    report["drivers"].push_back({{"input", nameOf(driver.posture)},
                                 {"share", driver.share},
                                 {"points", driver.points},
                                 {"score", driver.score}});
  }
  const auto shifts = eawsNextLevel(shares);
  report["next_level"] = nullptr;
  if (shifts.empty()) return;
  ordered_json changes = ordered_json::array();
  for (const EawsShift& shift : shifts) {
    changes.push_back({{"from", nameOf(shift.from)}, {"to", nameOf(shift.to)}, {"share", shift.share}});
  }
  const double points = shifts.back().score;
  report["next_level"] = {{"score", points}, {"level", eawsLevel(points)}, {"changes", std::move(changes)}};
}

ordered_json handForcesReport(const HandForces& forces) {
  ordered_json document;
  const std::array<const char*, 2> sides{"left", "right"};
  for (std::size_t i = 0; i < 2; ++i) {
    ordered_json& side = document[sides[i]];
    side["force_n"] = forces.force_n[i] ? ordered_json(*forces.force_n[i]) : ordered_json();
    side["elbow_moment_nm"] = forces.elbow_nm[i];
    side["shoulder_moment_nm"] = forces.shoulder_nm[i];
  }
  document["lumbar_moment_nm"] = forces.lumbar_nm;
  document["partial"] = !forces.missing.empty();
  document["missing"] = forces.missing;
  document["limits"] = ordered_json::array();
  for (const ForceLimit& limit : forces.limits) document["limits"].push_back(limitJson(limit));
  document["drivers"] = forceDrivers(forces);
  return document;
}

}  // namespace hapticell::cli
