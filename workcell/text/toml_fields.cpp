// SPDX-License-Identifier: Apache-2.0
#include "workcell/text/toml_fields.h"

#include <cmath>
#include <numbers>

#include "geometry/system/listed.h"

namespace hapticell::workcell {

namespace {

Text kindOf(const toml::node& node) {
  if (node.is_string()) return Text("a text");
  if (node.is_number()) return Text("a number");
  if (node.is_boolean()) return Text("true or false");
  if (node.is_array()) return Text("a list");
  return node.is_table() ? Text("a table") : Text("another format");
}

std::string fewDigits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

}  // namespace

void TomlFields::fail(const toml::node* node, Text found, Text expected, Text fix) {
  if (error_) return;
  Text place = section_;
  const toml::node& at = node ? *node : static_cast<const toml::node&>(table_);
  if (const auto line = at.source().begin.line; line > 0)
    place = section_.empty() ? Text("line %1", line) : Text("line %1, %2", line, section_);
  error_ = Error{
      .place = std::move(place), .found = std::move(found), .expected = std::move(expected), .fix = std::move(fix)};
}

const toml::node* TomlFields::find(const char* key) {
  asked_.insert(key);
  return error_ ? nullptr : table_.get(key);
}

std::optional<double> TomlFields::numberOf(const toml::node& node, const Text& what) {
  const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
  if (value && std::isfinite(*value)) return value;
  fail(&node, value ? Text("%1 is not finite", what) : Text("%1 is %2", what, kindOf(node)), Text("a finite number"));
  return std::nullopt;
}

void TomlFields::read(const char* key, std::string& target) {
  const toml::node* node = find(key);
  if (!node) return;
  if (!node->is_string()) return fail(node, Text("%1 is %2", key, kindOf(*node)), Text("a text in quotes"));
  target = *node->value<std::string>();
}

void TomlFields::read(const char* key, bool& target) {
  const toml::node* node = find(key);
  if (!node) return;
  if (!node->is_boolean()) return fail(node, Text("%1 is %2", key, kindOf(*node)), Text("true or false"));
  target = *node->value<bool>();
}

void TomlFields::read(const char* key, double& target, double unit, double least, double most) {
  const toml::node* node = find(key);
  const auto value = node ? numberOf(*node, std::string(key)) : std::nullopt;
  if (!value) return;
  if (*value < least || *value > most) {
    return fail(node, std::string(key) + " = " + fewDigits(*value),
                Text("%1 to %2", fewDigits(least), fewDigits(most)));
  }
  target = *value * unit;
}

void TomlFields::readList(const char* key, std::vector<double>& target, double unit) {
  const toml::node* node = find(key);
  if (!node) return;
  if (!node->is_array()) return fail(node, Text("%1 is %2", key, kindOf(*node)), Text("a list of numbers"));
  target.clear();
  for (const toml::node& element : *node->as_array()) {
    const auto value = numberOf(element, Text("%1, number %2,", key, target.size() + 1));
    if (!value) return;
    target.push_back(*value * unit);
  }
}

void TomlFields::readList(const char* key, std::vector<std::string>& target) {
  const toml::node* node = find(key);
  if (!node) return;
  if (!node->is_array()) return fail(node, Text("%1 is %2", key, kindOf(*node)), Text("a list of texts"));
  target.clear();
  for (const toml::node& element : *node->as_array()) {
    if (!element.is_string())
      return fail(&element, Text("%1 contains %2", key, kindOf(element)), Text("a list of texts in quotes"));
    target.push_back(*element.value<std::string>());
  }
}

void TomlFields::readPoint(const char* key, dvec3& target, double unit) {
  const toml::node* node = find(key);
  if (!node) return;
  std::vector<double> numbers;
  readList(key, numbers, unit);
  if (error_) return;
  if (numbers.size() != 3) return fail(node, Text("%1 has %2 numbers", key, numbers.size()), "3");
  target = {numbers[0], numbers[1], numbers[2]};
}

void TomlFields::readWord(const char* key, const std::vector<std::string>& words, int& target) {
  std::string word;
  read(key, word);
  if (error_ || !has(key)) return;
  std::string known;
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (words[k] == word) {
      target = static_cast<int>(k);
      return;
    }
    known += (k > 0 ? ", " : "") + words[k];
  }
  failKey(key, std::string(key) + " = \"" + word + "\"", Text("one of %1", known));
}

void TomlFields::readColor(const char* key, std::array<float, 4>& target) {
  std::string text;
  read(key, text);
  if (error_ || !has(key)) return;
  const bool good =
      text.size() == 7 && text[0] == '#' && text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
  if (!good) return failKey(key, std::string(key) + " = \"" + text + "\"", Text("a colour such as \"#ff6600\""));
  for (std::size_t k = 0; k < 3; ++k)
    target[k] = static_cast<float>(std::stoi(text.substr(1 + 2 * k, 2), nullptr, 16)) / 255.0f;
}

void TomlFields::readPose(Pose& target, double unit) {
  readPoint("position", target.p, unit);
  std::vector<double> quaternion, rpy;
  readList("quaternion", quaternion);
  readList("rpy", rpy, std::numbers::pi / 180.0);
  if (error_) return;
  if (has("quaternion")) {
    const dquat q =
        quaternion.size() == 4 ? dquat(quaternion[0], quaternion[1], quaternion[2], quaternion[3]) : dquat(0, 0, 0, 0);
    if (!(std::abs(glm::length(q) - 1.0) < 1e-3))
      return failKey("quaternion", Text("an invalid quaternion"), Text("w, x, y, z with length 1"));
    target.q = glm::normalize(q);
  } else if (has("rpy")) {
    if (rpy.size() != 3) return failKey("rpy", Text("%1 has %2 numbers", "rpy", rpy.size()), "3");
    target.q = glm::normalize(glm::angleAxis(rpy[2], dvec3(0, 0, 1)) * glm::angleAxis(rpy[1], dvec3(0, 1, 0)) *
                              glm::angleAxis(rpy[0], dvec3(1, 0, 0)));
  }
  if (!target.isValid()) failKey("position", Text("a position that is too far away"), Text("at most 1e12 m"));
}

void TomlFields::readRows(const char* key, std::size_t count, std::vector<std::vector<double>>& rows) {
  const toml::node* node = find(key);
  if (!node) return;
  if (!node->is_array()) return fail(node, Text("%1 is %2", key, kindOf(*node)), Text("a list of rows"));
  for (const toml::node& element : *node->as_array()) {
    const Text row("%1, row %2", key, rows.size() + 1);
    const toml::array* numbers = element.as_array();
    if (!numbers || numbers->size() != count)
      return fail(&element, numbers ? Text("%1 has %2 numbers", row, numbers->size()) : Text("%1 is not a list", row),
                  std::to_string(count));
    rows.emplace_back();
    for (const toml::node& number : *numbers) {
      const auto value = numberOf(number, row);
      if (!value) return;
      rows.back().push_back(*value);
    }
  }
}

const toml::table* TomlFields::table(const char* key) {
  const toml::node* node = find(key);
  if (node && !node->is_table()) fail(node, Text("%1 is %2", key, kindOf(*node)), Text("a table [%1]", key));
  return node ? node->as_table() : nullptr;
}

const toml::array* TomlFields::tables(const char* key) {
  const toml::node* node = find(key);
  if (!node) return nullptr;
  if (!node->is_array_of_tables()) {
    fail(node, Text("%1 is %2", key, kindOf(*node)), Text("tables [[%1]]", key));
    return nullptr;
  }
  return node->as_array();
}

void TomlFields::require(const char* key) {
  if (!error_ && !table_.contains(key)) fail(nullptr, Text("%1 is missing", key), std::string(key) + " = …");
}

void TomlFields::refuseOthers() {
  if (error_) return;
  for (const auto& [key, node] : table_) {
    if (asked_.count(std::string(key.str()))) continue;
    return fail(&node, Text("the unknown key '%1'", key.str()), Text("one of %1", listed(asked_)));
  }
}

}  // namespace hapticell::workcell
