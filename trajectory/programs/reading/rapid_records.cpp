// SPDX-License-Identifier: Apache-2.0
#include "trajectory/programs/reading/rapid_records.h"

#include <array>
#include <cmath>

namespace hapticell::trajectory {

namespace {

/// The fields of the records that motion is made of, with their types.
struct RapidField {
  const char* record;
  std::array<std::pair<const char*, const char*>, 6> fields;
};
constexpr std::array<RapidField, 9> kRecords{{
    {"robtarget", {{{"trans", "pos"}, {"rot", "orient"}, {"robconf", ""}, {"extax", ""}, {"", ""}, {"", ""}}}},
    {"jointtarget", {{{"robax", "robjoint"}, {"extax", ""}, {"", ""}, {"", ""}, {"", ""}, {"", ""}}}},
    {"robjoint", {{{"rax_1", ""}, {"rax_2", ""}, {"rax_3", ""}, {"rax_4", ""}, {"rax_5", ""}, {"rax_6", ""}}}},
    {"pos", {{{"x", ""}, {"y", ""}, {"z", ""}, {"", ""}, {"", ""}, {"", ""}}}},
    {"orient", {{{"q1", ""}, {"q2", ""}, {"q3", ""}, {"q4", ""}, {"", ""}, {"", ""}}}},
    {"pose", {{{"trans", "pos"}, {"rot", "orient"}, {"", ""}, {"", ""}, {"", ""}, {"", ""}}}},
    {"wobjdata", {{{"robhold", ""}, {"ufprog", ""}, {"ufmec", ""}, {"uframe", "pose"}, {"oframe", "pose"}, {"", ""}}}},
    {"tooldata", {{{"robhold", ""}, {"tframe", "pose"}, {"tload", ""}, {"", ""}, {"", ""}, {"", ""}}}},
    {"speeddata", {{{"v_tcp", ""}, {"v_ori", ""}, {"v_leax", ""}, {"v_reax", ""}, {"", ""}, {"", ""}}}},
}};

}  // namespace

std::optional<std::pair<std::size_t, std::string>> rapidField(const std::string& type, const std::string& field) {
  for (const RapidField& record : kRecords) {
    // A list without a type: the first record that has the field.
    if (!type.empty() && type != record.record) continue;
    for (std::size_t i = 0; i < record.fields.size(); ++i)
      if (!field.empty() && field == record.fields[i].first) return std::pair(i, std::string(record.fields[i].second));
  }
  return std::nullopt;
}

std::optional<Pose> rapidPose(const Value& value) {
  if (value.kind != Value::Kind::kList || value.items.size() < 2) return std::nullopt;
  const auto p = value.items[0].numbers(3), q = value.items[1].numbers(4);
  if (!p || !q) return std::nullopt;
  const dquat turn((*q)[0], (*q)[1], (*q)[2], (*q)[3]);
  const double norm = glm::length(turn);
  if (!(std::abs(norm - 1.0) < 0.01)) return std::nullopt;
  return Pose{kRapidMillimetre * dvec3((*p)[0], (*p)[1], (*p)[2]), turn / norm};
}

Value rapidTarget(const Pose& X, const Value& like) {
  Value target = like;
  const dvec3 p = X.p / kRapidMillimetre;
  if (target.kind != Value::Kind::kList || target.items.size() < 2)
    target = Value::list("robtarget", std::vector<Value>(4, Value::unknown(Text("a configuration"))));
  target.items[0] = Value::list("pos", {p.x, p.y, p.z});
  target.items[1] = Value::list("orient", {X.q.w, X.q.x, X.q.y, X.q.z});
  return target;
}

}  // namespace hapticell::trajectory
