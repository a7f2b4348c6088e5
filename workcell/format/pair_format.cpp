// SPDX-License-Identifier: Apache-2.0
#include "workcell/format/pair_format.h"

#include "workcell/format/document_io.h"
#include "workcell/format/entity_format.h"

namespace hapticell::workcell {

namespace {

void readColor(FieldReader& fields, const char* key, std::optional<std::array<float, 3>>& color) {
  std::vector<double> parts;
  if (!fields.readNumbers(key, 3, parts)) return;
  color.emplace();
  for (std::size_t i = 0; i < 3; ++i) (*color)[i] = static_cast<float>(parts[i]);
}

}  // namespace

Json jsonFromPairSet(const PairSet& set) {
  Json json;
  json["name"] = set.name;
  json["enabled"] = set.enabled;
  json["first"] = set.first;
  json["second"] = set.second;
  json["safety_distance"] = set.safety_distance;
  json["near_miss"] = set.near_miss;
  if (set.on_contact) json["on_contact"] = wordOf(*set.on_contact);
  if (set.contact_color) json["contact_color"] = *set.contact_color;
  if (set.near_miss_color) json["near_miss_color"] = *set.near_miss_color;
  return json;
}

Json jsonFromPairRule(const PairRule& rule) {
  Json json;
  json["first"] = rule.first;
  if (!rule.first_part.empty()) json["first_link"] = rule.first_part;
  json["second"] = rule.second;
  if (!rule.second_part.empty()) json["second_link"] = rule.second_part;
  json["checked"] = rule.checked;
  if (rule.on_contact) json["on_contact"] = wordOf(*rule.on_contact);
  return json;
}

PairSet pairSetFromJson(const Json& json, std::size_t index, std::optional<Error>& error, Diagnostics& diagnostics) {
  PairSet set;
  int on_contact = -1;
  FieldReader fields(json, Text("pair set %1", index + 1), error);
  fields.require("name");
  fields.read("name", set.name);
  fields.read("enabled", set.enabled);
  fields.read("first", set.first);
  fields.read("second", set.second);
  fields.read("safety_distance", set.safety_distance);
  fields.read("near_miss", set.near_miss);
  fields.readWord("on_contact", kOnContactWords, on_contact);
  readColor(fields, "contact_color", set.contact_color);
  readColor(fields, "near_miss_color", set.near_miss_color);
  if (error) return set;
  if (on_contact >= 0) set.on_contact = static_cast<OnContact>(on_contact);
  fields.warnAboutOthers(diagnostics);
  return set;
}

PairRule pairRuleFromJson(const Json& json, std::size_t index, std::optional<Error>& error, Diagnostics& diagnostics) {
  PairRule rule;
  int on_contact = -1;
  FieldReader fields(json, Text("pair rule %1", index + 1), error);
  fields.require("first");
  fields.require("second");
  fields.read("first", rule.first);
  fields.read("first_link", rule.first_part);
  fields.read("second", rule.second);
  fields.read("second_link", rule.second_part);
  fields.read("checked", rule.checked);
  fields.readWord("on_contact", kOnContactWords, on_contact);
  if (error) return rule;
  if (on_contact >= 0) rule.on_contact = static_cast<OnContact>(on_contact);
  fields.warnAboutOthers(diagnostics);
  return rule;
}

}  // namespace hapticell::workcell
