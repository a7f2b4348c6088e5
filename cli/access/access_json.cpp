// SPDX-License-Identifier: Apache-2.0
#include "cli/access/access_json.h"

#include <bit>

#include "access/access_report.h"
#include "cli/kit/result_writer.h"
#include "mannequin/posture/vision.h"

namespace hapticell::cli {

namespace {

using namespace access;
using nlohmann::ordered_json;

ordered_json waysJson(const AccessAnswer& answer) {
  ordered_json ways = ordered_json::array();
  const auto& units = answer.removal->units();
  for (const StraightWay& way : answer.ways) {
    ordered_json blockers = ordered_json::array();
    for (UnitSet left = way.blockers; left != 0; left &= left - 1)
      blockers.push_back(units[static_cast<std::size_t>(std::countr_zero(left))].name);
    for (const std::size_t unit : way.fixed) blockers.push_back(units[unit].name);
    ways.push_back({{"direction", toJson(way.direction_W)},
                    {"length_m", way.length},
                    {"blocked_by", std::move(blockers)},
                    {"by_fixed", !way.fixed.empty()}});
  }
  return ways;
}

ordered_json clearancesJson(const RemovalStep& step) {
  ordered_json list = ordered_json::array();
  for (const NeighbourClearance& one : step.clearances) {
    list.push_back({{"to", one.name},
                    {"clearance_m", finiteOrNull(one.least_m)},
                    {"at_m", one.at_m},
                    {"touches_at_rest", one.touches_at_rest},
                    {"slides_m", one.slides_m}});
  }
  return list;
}

ordered_json stepsJson(const AccessAnswer& answer) {
  ordered_json steps = ordered_json::array();
  for (const RemovalStep& step : answer.order) {
    const Pose& first = step.way.X_WE.front();
    const Pose& second = step.way.X_WE[1];
    const double length = glm::length(second.p - first.p);
    const dvec3 direction = length > 0.0 ? (second.p - first.p) / length : dvec3(0.0);
    ordered_json one{{"part", step.name},
                     {"way", toString(step.way.kind)},
                     {"direction", toJson(direction)},
                     {"length_m", step.way.length()},
                     {"pieces", step.way.X_WE.size() - 1}};
    one["clearances"] = clearancesJson(step);
    steps.push_back(std::move(one));
  }
  return steps;
}

const char* handWord(mannequin::Side side) {
  return side == mannequin::Side::kLeft ? "left" : "right";
}

ordered_json reachJson(const BodyAccess& person) {
  const double stature = person.figure.body[mannequin::Dimension::kStature];
  return {{"body", person.name},
          {"sex", person.figure.sex == mannequin::Sex::kMale ? "male" : "female"},
          {"percentile", mannequin::percentileOfStature(person.figure.sex, stature)},
          {"stature_m", stature},
          {"reached", person.reached},
          {"why", person.why},
          {"short_m", person.short_m},
          {"hand", handWord(person.hand)},
          {"grasp", person.grasp},
          {"place", toJson(person.place.p_WPart)},
          {"into", toJson(person.place.target.into_W)},
          {"hand_fits", person.sweep.fits},
          {"hand_clearance_m", person.sweep.clearance_m},
          {"hand_meets", person.sweep.blocked_by},
          {"body_touches", person.touched},
          {"along", person.along}};
}

ordered_json sightJson(const BodyAccess& person) {
  return {{"seen", person.sight.seen},
          {"zone", mannequin::wordOf(person.sight.zone)},
          {"distance_m", person.sight.distance},
          {"hidden_by", person.sight.hidden_by}};
}

ordered_json scoresJson(const ergonomics::PostureScores& scores) {
  return {{"rula", scores.rula()},
          {"reba", scores.reba()},
          {"owas", scores.owas_category},
          {"eaws", scores.eaws_points},
          {"comfort", scores.comfort},
          {"missing", scores.missing}};
}

}  // namespace

ordered_json accessJson(const AccessQuestion& question, const AccessAnswer& answer) {
  ordered_json json{{"part", question.part},
                    {"removable", answer.removable},
                    {"result", english(resultText(question.part, answer))}};
  const NeighbourClearance* nearest = answer.nearest();
  json["clearance_min_m"] = nearest != nullptr ? ordered_json(nearest->least_m) : ordered_json(nullptr);
  json["clearance_to"] = nearest != nullptr ? nearest->name : std::string();
  json["blocked_by"] = answer.blocked_by;
  ordered_json& order = json["order"] = ordered_json::array();
  for (const RemovalStep& step : answer.order) order.push_back(step.name);
  json["order_is_shortest"] = answer.is_shortest;
  json["steps"] = stepsJson(answer);
  json["straight_ways"] = waysJson(answer);
  json["overlaps_at_rest"] = answer.overlaps;
  ordered_json reach = ordered_json::array(), sight = ordered_json::object(), scores = ordered_json::object();
  ordered_json ends = ordered_json::object();
  for (const BodyAccess& person : answer.people) {
    reach.push_back(reachJson(person));
    sight[person.name] = sightJson(person);
    // What a posture that does not get there scores says nothing.
    const bool there = person.short_m <= 2e-3;
    scores[person.name] = there ? scoresJson(person.scores) : ordered_json(nullptr);
    ends[person.name] = person.along > 0.0 ? scoresJson(person.scores_end) : ordered_json(nullptr);
  }
  json["reach"] = std::move(reach);
  json["sight"] = std::move(sight);
  json["scores"] = std::move(scores);
  json["scores_at_end"] = std::move(ends);
  json["notes"] = answer.removal->notes();
  return json;
}

}  // namespace hapticell::cli
