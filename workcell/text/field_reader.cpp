// SPDX-License-Identifier: Apache-2.0
#include "workcell/text/field_reader.h"

#include <algorithm>
#include <cmath>

#include "geometry/system/listed.h"

namespace hapticell::workcell {

namespace {

/// What stands there, short enough for a message.
Text excerpt(const Json& value) {
  constexpr std::size_t kLongest = 60;
  if (value.is_structured()) return value.is_array() ? Text("a list") : Text("an object");
  std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
  if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
  return text;
}

void startLine(int depth, std::string& text) {
  text += '\n';
  text.append(2 * static_cast<std::size_t>(depth), ' ');
}

void print(const Json& value, int depth, std::string& text) {
  const bool plain = std::none_of(value.begin(), value.end(), [](const Json& item) { return item.is_structured(); });
  if (!value.is_structured() || value.empty()) {
    text += value.dump(-1, ' ', false, Json::error_handler_t::replace);
    return;
  }
  const bool one_line = value.is_array() && plain;
  text += value.is_array() ? '[' : '{';
  bool first = true;
  for (auto it = value.begin(); it != value.end(); ++it) {
    if (!first) text += one_line ? ", " : ",";
    first = false;
    if (!one_line) startLine(depth + 1, text);
    if (value.is_object()) text += Json(it.key()).dump(-1, ' ', false, Json::error_handler_t::replace) + ": ";
    print(*it, depth + 1, text);
  }
  if (!one_line) startLine(depth, text);
  text += value.is_array() ? ']' : '}';
}

}  // namespace

FieldReader::FieldReader(const Json& object, Text place, std::optional<Error>& error)
    : object_(object), place_(std::move(place)), error_(error) {
  if (!object_.is_object() && !error_)
    error_ = Error{.place = place_, .found = excerpt(object_), .expected = "a JSON object in braces"};
}

void FieldReader::fail(const std::string& key, Text found, Text expected) {
  if (!error_)
    error_ =
        Error{.place = Text("%1, \"%2\"", place_, key), .found = std::move(found), .expected = std::move(expected)};
}

const Json* FieldReader::member(const char* key) {
  asked_.insert(key);
  if (error_ || !object_.is_object()) return nullptr;
  const auto it = object_.find(key);
  return it == object_.end() ? nullptr : &*it;
}

void FieldReader::require(const char* key) {
  if (!error_ && !member(key))
    error_ = Error{.place = place_, .found = Text("\"%1\" is missing", key), .expected = "one"};
}

void FieldReader::read(const char* key, std::string& target) {
  const Json* value = member(key);
  if (value && !value->is_string()) fail(key, excerpt(*value), Text("text in quotes"));
  if (value && value->is_string()) target = value->get<std::string>();
}

void FieldReader::read(const char* key, bool& target) {
  const Json* value = member(key);
  if (value && !value->is_boolean()) fail(key, excerpt(*value), Text("true or false"));
  if (value && value->is_boolean()) target = value->get<bool>();
}

void FieldReader::read(const char* key, double& target) {
  const Json* value = member(key);
  if (!value) return;
  if (!value->is_number() || !std::isfinite(value->get<double>())) return fail(key, excerpt(*value), Text("a number"));
  target = value->get<double>();
}

void FieldReader::read(const char* key, std::map<std::string, std::string>& target) {
  const Json* value = member(key);
  if (!value) return;
  target.clear();
  if (!value->is_object()) return fail(key, excerpt(*value), Text("a JSON object in braces"));
  for (const auto& [name, item] : value->items()) {
    if (!item.is_string()) return fail(key, excerpt(item), Text("a list of texts in quotes"));
    target[name] = item.get<std::string>();
  }
}

void FieldReader::read(const char* key, std::vector<std::string>& target) {
  const Json* value = array(key);
  if (!value) return;
  target.clear();
  for (const Json& item : *value) {
    if (!item.is_string()) return fail(key, excerpt(item), Text("a list of texts in quotes"));
    target.push_back(item.get<std::string>());
  }
}

bool FieldReader::readNumbers(const char* key, std::size_t count, std::vector<double>& target) {
  const Json* value = member(key);
  if (!value) return false;
  const bool numbers =
      value->is_array() && value->size() == count && std::all_of(value->begin(), value->end(), [](const Json& item) {
        return item.is_number() && std::isfinite(item.get<double>());
      });
  if (!numbers) {
    fail(key, excerpt(*value), Text("%1 numbers in brackets", count));
    return false;
  }
  target = value->get<std::vector<double>>();
  return true;
}

void FieldReader::read(const char* key, Pose& target) {
  const Json* value = object(key);
  if (!value) return;
  FieldReader fields(*value, Text("%1, \"%2\"", place_, key), error_);
  std::vector<double> p, q;
  if (fields.readNumbers("position", 3, p)) {
    target.p = {p[0], p[1], p[2]};
    if (!Pose::translation(target.p).isValid())
      return fields.fail("position", Text("a position that is too far away"), Text("metres, at most 1e12"));
  }
  if (!fields.readNumbers("quaternion", 4, q)) return;
  dquat turned(q[0], q[1], q[2], q[3]);
  // Of the length: hand-written ones are rounded to two digits; others are mistakes. Half: those are refused; twice:
  // some mistakes of 2 % pass, made unit.
  constexpr double kNearlyUnit = 0.01;
  const double length = glm::length(turned);
  if (!(std::abs(length - 1.0) < kNearlyUnit)) {
    return fields.fail("quaternion", Text("the length %1", std::to_string(length)),
                       Text("a quaternion w, x, y, z of length 1"));
  }
  target.q = turned;
  if (!target.isValid()) target.q = turned / length;
}

void FieldReader::readWord(const char* key, const std::vector<std::string>& words, int& target) {
  const Json* value = member(key);
  if (!value) return;
  const auto it = value->is_string() ? std::find(words.begin(), words.end(), value->get<std::string>()) : words.end();
  if (it != words.end()) {
    target = static_cast<int>(it - words.begin());
    return;
  }
  fail(key, excerpt(*value), Text("one of %1", listed(words)));
}

const Json* FieldReader::array(const char* key) {
  const Json* value = member(key);
  if (value && !value->is_array()) fail(key, excerpt(*value), Text("a list in brackets"));
  return value && value->is_array() ? value : nullptr;
}

const Json* FieldReader::object(const char* key) {
  const Json* value = member(key);
  if (value && !value->is_object()) fail(key, excerpt(*value), Text("a JSON object in braces"));
  return value && value->is_object() ? value : nullptr;
}

void FieldReader::warnAboutOthers(Diagnostics& diagnostics) const {
  if (!object_.is_object()) return;
  for (auto it = object_.begin(); it != object_.end(); ++it) {
    if (asked_.contains(it.key())) continue;
    diagnostics.warn(Text("%1: the key \"%2\" is unknown and was left out", place_, it.key()));
  }
}

std::string prettyText(const Json& value) {
  std::string text;
  print(value, 0, text);
  return text + "\n";
}

Json toJson(const Pose& pose) {
  return {{"position", {pose.p.x, pose.p.y, pose.p.z}}, {"quaternion", {pose.q.w, pose.q.x, pose.q.y, pose.q.z}}};
}

}  // namespace hapticell::workcell
