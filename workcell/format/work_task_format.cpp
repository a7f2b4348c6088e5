// SPDX-License-Identifier: Apache-2.0
#include "workcell/format/work_task_format.h"

#include <string>

namespace hapticell::workcell {
namespace {

const std::vector<std::string> kGripWords{"good", "fair", "poor", "unacceptable"};

template <class Value>
void readOptional(FieldReader& fields, const Json& json, const char* key, std::optional<Value>& target) {
  Value value{};
  fields.read(key, value);
  if (json.contains(key)) target = value;
}

template <class Value>
void write(Json& json, const char* key, const std::optional<Value>& value) {
  if (value) json[key] = *value;
}

}  // namespace

Json jsonFromWorkTask(const ergonomics::WorkTask& task) {
  Json json;
  json["name"] = task.name;
  if (!task.mannequin.empty()) json["mannequin"] = task.mannequin;
  write(json, "load_left_kg", task.load_kg[0]);
  write(json, "load_right_kg", task.load_kg[1]);
  write(json, "repetitions_per_min", task.repetitions_per_min);
  write(json, "static", task.is_static);
  if (task.grip) json["grip"] = kGripWords[static_cast<std::size_t>(*task.grip)];
  write(json, "duration_h", task.duration_h);
  write(json, "shock", task.has_shock);
  write(json, "rapid_changes", task.has_rapid_changes);
  json["walking"] = task.is_walking;
  json["trunk_supported"] = task.trunk_supported;
  json["left_arm_supported"] = task.arm_supported[0];
  json["right_arm_supported"] = task.arm_supported[1];
  json["lift"] = task.is_lift;
  if (task.is_lift) json["lift_distance_m"] = task.lift_distance_m;
  if (task.is_lift) json["asymmetry_deg"] = task.asymmetry_deg;
  if (!task.note.empty()) json["note"] = task.note;
  return json;
}

ergonomics::WorkTask workTaskFromJson(const Json& json, std::size_t index, std::optional<Error>& error,
                                      Diagnostics& diagnostics) {
  ergonomics::WorkTask task;
  FieldReader fields(json, Text("task %1", index + 1), error);
  if (error) return task;
  fields.require("name");
  fields.read("name", task.name);
  fields.read("mannequin", task.mannequin);
  readOptional(fields, json, "load_left_kg", task.load_kg[0]);
  readOptional(fields, json, "load_right_kg", task.load_kg[1]);
  readOptional(fields, json, "repetitions_per_min", task.repetitions_per_min);
  readOptional(fields, json, "static", task.is_static);
  int grip = -1;
  fields.readWord("grip", kGripWords, grip);
  if (grip >= 0) task.grip = static_cast<ergonomics::Grip>(grip);
  readOptional(fields, json, "duration_h", task.duration_h);
  readOptional(fields, json, "shock", task.has_shock);
  readOptional(fields, json, "rapid_changes", task.has_rapid_changes);
  fields.read("walking", task.is_walking);
  fields.read("trunk_supported", task.trunk_supported);
  fields.read("left_arm_supported", task.arm_supported[0]);
  fields.read("right_arm_supported", task.arm_supported[1]);
  fields.read("lift", task.is_lift);
  fields.read("lift_distance_m", task.lift_distance_m);
  fields.read("asymmetry_deg", task.asymmetry_deg);
  fields.read("note", task.note);
  if (!error) fields.warnAboutOthers(diagnostics);
  return task;
}

}  // namespace hapticell::workcell
