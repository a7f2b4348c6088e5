// SPDX-License-Identifier: Apache-2.0
#include "app/import/remark_lines.h"

#include <algorithm>
#include <cctype>

#include "app/style/library_text.h"

namespace hapticell::app {

namespace {

const std::string kVarying = "…";

bool isPlain(const Text& text) {
  return text.id() == "%1" && std::holds_alternative<std::string>(text.arguments().front());
}

/// The text without what fills its places. A form without words, such as "%1: %2", keeps the texts in its places.
Text kindOf(const Text& text) {
  if (isPlain(text)) return text;
  const bool has_words =
      std::any_of(text.id().begin(), text.id().end(), [](unsigned char c) { return std::isalpha(c); });
  std::vector<Text::Argument> values;
  for (const Text::Argument& argument : text.arguments()) {
    const auto* inner = std::get_if<std::vector<Text>>(&argument);
    if (has_words || inner == nullptr) {
      values.emplace_back(kVarying);
      continue;
    }
    std::vector<Text> kinds;
    for (const Text& each : *inner) kinds.push_back(isPlain(each) ? Text(kVarying) : kindOf(each));
    values.emplace_back(std::move(kinds));
  }
  return Text::received(text.id(), std::move(values));
}

/// The names in "'a', 'b'", or the whole argument.
std::vector<std::string> namesIn(const std::string& argument) {
  if (argument.size() < 2 || argument.front() != '\'' || argument.back() != '\'') return {argument};
  std::vector<std::string> names;
  const std::string list = argument.substr(1, argument.size() - 2);
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find("', '", begin), list.size());
    names.push_back(list.substr(begin, end - begin));
    begin = end + 4;
  }
  return names;
}

void addParts(const Text& text, const NamedParts& parts, std::vector<workcell::EntityId>& found) {
  for (const Text::Argument& argument : text.arguments()) {
    if (const auto* inner = std::get_if<std::vector<Text>>(&argument)) {
      for (const Text& each : *inner) addParts(each, parts, found);
    } else if (const auto* words = std::get_if<std::string>(&argument)) {
      for (const std::string& name : namesIn(*words)) {
        const auto [begin, end] = parts.equal_range(name);
        for (auto part = begin; part != end; ++part)
          if (std::find(found.begin(), found.end(), part->second) == found.end()) found.push_back(part->second);
      }
    }
  }
}

}  // namespace

void addNames(const workcell::Entity& entity, workcell::EntityId id, NamedParts& parts) {
  parts.emplace(entity.name, id);
  if (!entity.robot()) return;
  for (const kinematics::Link& link : entity.robot()->links) parts.emplace(link.name, id);
  for (const kinematics::Joint& joint : entity.robot()->joints) parts.emplace(joint.name, id);
}

std::vector<RemarkLine> remarkLines(const std::vector<Text>& remarks, const NamedParts& parts) {
  std::vector<RemarkLine> lines;
  for (const Text& remark : remarks) {
    const QString kind = shownText(kindOf(remark));
    std::vector<workcell::EntityId> named;
    addParts(remark, parts, named);
    const auto last =
        std::find_if(lines.rbegin(), lines.rend(), [&](const RemarkLine& line) { return line.kind == kind; });
    lines.insert(last == lines.rend() ? lines.end() : last.base(), {kind, shownText(remark), std::move(named)});
  }
  return lines;
}

}  // namespace hapticell::app
