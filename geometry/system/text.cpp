// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/text.h"

#include <cstdio>
#include <functional>
#include <mutex>
#include <numbers>
#include <set>

#include "geometry/system/overloaded.h"

namespace hapticell {
namespace {

std::string numberWords(const char* form, double value) {
  char text[48];
  std::snprintf(text, sizeof text, form, value);
  return text;
}

std::string englishArgument(const Text::Argument& argument) {
  return std::visit(Overloaded{[](const std::string& words) { return words; },
                               [](const Text::Length& length) {
                                 return numberWords(length.whole ? "%.0f mm" : "%.1f mm", length.metres * 1000.0);
                               },
                               [](const Text::Angle& angle) {
                                 return numberWords("%.1f deg", angle.radians * 180.0 / std::numbers::pi);
                               },
                               [](std::int64_t count) { return std::to_string(count); },
                               [](const std::vector<Text>& texts) { return english(texts); }},
                    argument);
}

}  // namespace

Text::Text(std::string words) {
  if (words.empty()) return;
  id_ = "%1";
  arguments_.emplace_back(std::move(words));
}

Text Text::received(std::string_view id, std::vector<Argument> arguments) {
  // Sentences kept; the program has some 2,500 of its own. Half: some of those are not translated; twice: memory a
  // broken child may take.
  constexpr std::size_t kMostIds = 4096;
  static std::mutex guard;
  static std::set<std::string, std::less<>> ids;  // Nodes stay where they are.
  Text text;
  text.arguments_ = std::move(arguments);
  text.id_ = id;
  const std::lock_guard lock(guard);
  auto known = ids.find(id);
  if (known == ids.end() && ids.size() >= kMostIds) return Text(english(text));
  if (known == ids.end()) known = ids.emplace(id).first;
  text.id_ = *known;
  return text;
}

std::string english(const Text& text) {
  std::vector<std::string> values;
  values.reserve(text.arguments().size());
  for (const Text::Argument& argument : text.arguments()) values.push_back(englishArgument(argument));
  return filled(text.id(), values);
}

std::string english(std::span<const Text> texts) {
  std::string all;
  for (const Text& text : texts) all += (all.empty() ? "" : "; ") + english(text);
  return all;
}

std::string filled(std::string_view form, std::span<const std::string> values) {
  std::string result;
  for (std::size_t i = 0; i < form.size(); ++i) {
    const bool place = form[i] == '%' && i + 1 < form.size() && form[i + 1] >= '1' && form[i + 1] <= '9';
    const std::size_t which = place ? static_cast<std::size_t>(form[i + 1] - '1') : 0;
    if (place && which < values.size()) {
      result += values[which];
      ++i;
    } else {
      result += form[i];
    }
  }
  return result;
}

}  // namespace hapticell
