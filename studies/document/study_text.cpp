// SPDX-License-Identifier: Apache-2.0
#include "studies/document/study_text.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cstdio>
#include <optional>

#include "geometry/system/nesting_limit.h"
#include "geometry/system/overloaded.h"
#include "trajectory/motion/number_text.h"

namespace hapticell::studies {

namespace {

/// Where a line begins; lines count from 1. Behind the last one: the end of the text.
std::size_t offsetOf(const std::string& text, std::size_t line) {
  std::size_t at = 0;
  for (std::size_t i = 1; i < line; ++i) {
    const std::size_t end = text.find('\n', at);
    if (end == std::string::npos) return text.size();
    at = end + 1;
  }
  return at;
}

/// toml++ counts columns in characters, from 1.
std::size_t offsetOf(const std::string& text, const toml::source_position& place) {
  std::size_t at = offsetOf(text, place.line);
  for (std::size_t i = 1; i < place.column && at < text.size(); ++i) {
    ++at;
    while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U) ++at;
  }
  return at;
}

std::string quoted(const std::string& word) {
  std::string text = "\"";
  for (const char c : word) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') text += '\\';
    if (code < 0x20U || code == 0x7FU) {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04X", code);
      text += escape;
    } else {
      text += c;
    }
  }
  return text + "\"";
}

template <typename T, typename Shown>
std::string listText(const std::vector<T>& values, Shown shown) {
  std::string text = "[";
  for (const T& value : values) text += (text.size() > 1 ? ", " : "") + shown(value);
  return text + "]";
}

/// One parse of the text, with what a place means in it.
class Parsed {
 public:
  explicit Parsed(const std::string& text) : root_(toml::parse(text)) {}

  const toml::table& root() const { return root_; }
  const toml::table* find(const StudyPlace& place) const {
    if (place.table.empty()) return &root_;
    const toml::node* node = root_.get(place.table);
    if (node == nullptr) return nullptr;
    if (const toml::array* list = node->as_array())
      return place.index < list->size() ? list->get(place.index)->as_table() : nullptr;
    return place.index == 0 ? node->as_table() : nullptr;
  }
  /// First lines of all headers, in their order.
  std::vector<std::size_t> headers() const {
    std::vector<std::size_t> lines;
    for (auto&& entry : root_) {
      const toml::node& node = entry.second;
      if (const toml::table* table = node.as_table(); table != nullptr && !table->is_inline())
        lines.push_back(table->source().begin.line);
      const toml::array* list = node.as_array();
      for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
        const toml::table* table = list->get(i)->as_table();
        if (table != nullptr && !table->is_inline()) lines.push_back(table->source().begin.line);
      }
    }
    std::sort(lines.begin(), lines.end());
    return lines;
  }

 private:
  toml::table root_;
};

/// Keys of a table that stand in it as `key = value`, by their places.
std::vector<std::pair<std::string, const toml::node*>> entriesOf(const toml::table& table) {
  std::vector<std::pair<std::string, const toml::node*>> entries;
  for (auto&& entry : table) entries.emplace_back(std::string(entry.first.str()), &entry.second);
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    const auto& first = a.second->source().begin;
    const auto& second = b.second->source().begin;
    return std::pair(first.line, first.column) < std::pair(second.line, second.column);
  });
  return entries;
}

bool isHeaded(const toml::node& node) {
  if (const toml::table* table = node.as_table()) return !table->is_inline();
  const toml::array* list = node.as_array();
  if (list == nullptr || list->empty()) return false;
  const toml::table* first = list->get(0)->as_table();
  return first != nullptr && !first->is_inline();
}

/// Behind the last key of a table that has a header (or of the top): where the next one belongs.
std::size_t lineBehind(const toml::table& table, bool top) {
  std::size_t line = top ? 1 : table.source().begin.line + 1;
  for (const auto& [key, node] : entriesOf(table)) {
    if (!isHeaded(*node)) line = std::max<std::size_t>(line, node->source().end.line + 1);
  }
  return line;
}

template <typename T>
std::optional<std::vector<T>> listOf(const toml::array& list) {
  std::vector<T> values;
  for (const toml::node& node : list) {
    const auto value = node.value<T>();
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

StudyValue valueOf(const toml::node& node) {
  if (const auto* word = node.as_string()) return word->get();
  if (const auto* flag = node.as_boolean()) return flag->get();
  if (node.is_number()) return *node.value<double>();
  const toml::array* list = node.as_array();
  if (list == nullptr) return {};
  if (list->is_homogeneous(toml::node_type::string)) return *listOf<std::string>(*list);
  const bool numbers = std::all_of(list->begin(), list->end(), [](const toml::node& one) { return one.is_number(); });
  if (numbers) return *listOf<double>(*list);
  return {};
}

Error cannotEdit(const StudyPlace& place) {
  return {.place = Text("table '%1'", place.table),
          .found = "no table of its own in the document",
          .expected = "a table with a header such as [[vary]]",
          .fix = "Edit the study as text."};
}

std::string withBreak(std::string text) {
  if (!text.empty() && text.back() != '\n') text += '\n';
  return text;
}

}  // namespace

std::string tomlText(const StudyValue& value) {
  return std::visit(Overloaded{[](std::monostate) { return std::string(); },
                               [](bool flag) { return std::string(flag ? "true" : "false"); },
                               [](double number) { return trajectory::shortestText(number); },
                               [](const std::string& word) { return quoted(word); },
                               [](const std::vector<double>& numbers) { return listText(numbers, trajectory::shortestText); },
                               [](const std::vector<std::string>& words) { return listText(words, quoted); }},
                    value);
}

Expected<StudyText> StudyText::parse(std::string text, const std::string& file) {
  StudyText made;
  const auto read = made.replace(std::move(text));
  if (read) return made;
  Error error = read.error();
  error.file = file;
  return makeError(std::move(error));
}

Expected<void> StudyText::replace(std::string text) {
  HAPTICELL_TRY(geometry::checkNesting(text, geometry::NestedText::kToml, ""));
  try {
    const toml::table checked = toml::parse(text);
  } catch (const toml::parse_error& problem) {
    return makeError({.place = Text("line %1", problem.source().begin.line),
                      .found = Text("text that is not TOML (%1)", problem.description()),
                      .expected = "a study (.hstudy)"});
  }
  text_ = std::move(text);
  return {};
}

std::size_t StudyText::count(const std::string& table) const {
  const Parsed parsed(text_);
  const toml::node* node = parsed.root().get(table);
  if (node == nullptr) return 0;
  const toml::array* list = node->as_array();
  if (list != nullptr) return list->size();
  return node->is_table() ? 1 : 0;
}

std::vector<std::string> StudyText::keys(const StudyPlace& place) const {
  const Parsed parsed(text_);
  std::vector<std::string> keys;
  const toml::table* table = parsed.find(place);
  if (table == nullptr) return keys;
  for (auto& [key, node] : entriesOf(*table)) keys.push_back(key);
  return keys;
}

StudyValue StudyText::value(const StudyPlace& place, std::string_view key) const {
  const Parsed parsed(text_);
  const toml::table* table = parsed.find(place);
  const toml::node* node = table != nullptr ? table->get(key) : nullptr;
  return node != nullptr ? valueOf(*node) : StudyValue();
}

std::string StudyText::word(const StudyPlace& place, std::string_view key) const {
  const StudyValue found = value(place, key);
  const auto* text = std::get_if<std::string>(&found);
  return text != nullptr ? *text : std::string();
}

std::string StudyText::written(const StudyPlace& place, std::string_view key) const {
  const Parsed parsed(text_);
  const toml::table* table = parsed.find(place);
  const toml::node* node = table != nullptr ? table->get(key) : nullptr;
  if (node == nullptr) return {};
  const std::size_t begin = offsetOf(text_, node->source().begin);
  return text_.substr(begin, offsetOf(text_, node->source().end) - begin);
}

Expected<void> StudyText::set(const StudyPlace& place, std::string_view key, const StudyValue& value) {
  const Parsed parsed(text_);
  const toml::table* table = parsed.find(place);
  const bool removes = std::holds_alternative<std::monostate>(value);
  const bool single = place.table == "sampling" || place.table == "search";
  if (table == nullptr && single) {
    if (removes) return {};
    return replace(withBreak(text_) + "\n[" + place.table + "]\n" + std::string(key) + " = " + tomlText(value) + "\n");
  }
  if (table == nullptr) return makeError(cannotEdit(place));
  std::string text = text_;
  if (const toml::node* node = table->get(key)) {
    const std::size_t begin = offsetOf(text_, node->source().begin), end = offsetOf(text_, node->source().end);
    if (!removes) return replace(text.replace(begin, end - begin, tomlText(value)));
    if (table->is_inline() || isHeaded(*node)) return makeError(cannotEdit(place));
    const std::size_t from = offsetOf(text_, node->source().begin.line);
    return replace(text.erase(from, offsetOf(text_, node->source().end.line + 1) - from));
  }
  if (removes) return {};
  if (table->is_inline()) return makeError(cannotEdit(place));
  text = withBreak(std::move(text));
  const std::size_t at = offsetOf(text, lineBehind(*table, place.table.empty()));
  return replace(text.insert(at, std::string(key) + " = " + tomlText(value) + "\n"));
}

Expected<void> StudyText::add(const std::string& table,
                              const std::vector<std::pair<std::string, StudyValue>>& keys) {
  const Parsed parsed(text_);
  std::string block = "[[" + table + "]]\n";
  for (const auto& [key, value] : keys) {
    if (!std::holds_alternative<std::monostate>(value)) block += key + " = " + tomlText(value) + "\n";
  }
  std::string text = withBreak(text_);
  const std::size_t before = count(table);
  const toml::table* last = before > 0 ? parsed.find({table, before - 1}) : nullptr;
  if (last == nullptr || last->is_inline()) return replace(text + (text.empty() ? "" : "\n") + block);
  return replace(text.insert(offsetOf(text, lineBehind(*last, false)), "\n" + block));
}

Expected<void> StudyText::remove(const StudyPlace& place) {
  const Parsed parsed(text_);
  const toml::table* table = parsed.find(place);
  if (table == nullptr || table->is_inline() || place.table.empty()) return makeError(cannotEdit(place));
  const std::size_t header = table->source().begin.line;
  std::size_t first = header;
  // Comments right above a table are about it, and so is one empty line before them.
  const auto lineAt = [&](std::size_t line) {
    const std::size_t begin = offsetOf(text_, line);
    return text_.substr(begin, offsetOf(text_, line + 1) - begin);
  };
  while (first > 1 && lineAt(first - 1).starts_with("#")) --first;
  if (first > 1 && first < header && lineAt(first - 1) != "\n") first = header;  // It ends what stands before.
  if (first > 1 && lineAt(first - 1) == "\n") --first;
  std::string text = withBreak(text_);
  const std::size_t from = offsetOf(text, first);
  return replace(text.erase(from, offsetOf(text, lineBehind(*table, false)) - from));
}

}  // namespace hapticell::studies
