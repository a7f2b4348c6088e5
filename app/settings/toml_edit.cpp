// SPDX-License-Identifier: Apache-2.0
#include "app/settings/toml_edit.h"

#include <vector>

namespace hapticell::app {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string> linesOf(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const auto end = text.find('\n');
    lines.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 1);
  }
  return lines;
}

/// "[a.b]" gives "a.b"; anything else nothing.
std::string_view sectionOf(std::string_view line) {
  line = trimmed(line);
  if (line.empty() || line.front() != '[') return {};
  const auto end = line.find(']');
  return end == std::string_view::npos ? std::string_view() : trimmed(line.substr(1, end - 1));
}

bool setsKey(std::string_view line, std::string_view name) {
  line = trimmed(line);
  const auto equals = line.find('=');
  return equals != std::string_view::npos && line.front() != '#' && trimmed(line.substr(0, equals)) == name;
}

}  // namespace

std::string withTomlValue(std::string_view text, std::string_view key, std::string_view value) {
  const auto dot = key.rfind('.');
  const std::string_view section = dot == std::string_view::npos ? std::string_view() : key.substr(0, dot);
  const std::string_view name = dot == std::string_view::npos ? key : key.substr(dot + 1);
  const std::string wanted = std::string(name) + " = " + std::string(value);
  std::vector<std::string> lines = linesOf(text);
  std::string_view now;
  std::size_t last_of_section = section.empty() ? 0 : lines.size() + 1;  // Behind which line it is added.
  bool done = false;
  for (std::size_t i = 0; i < lines.size() && !done; ++i) {
    if (const auto opened = sectionOf(lines[i]); !opened.empty()) now = opened;
    if (now != section) continue;
    if (!trimmed(lines[i]).empty()) last_of_section = i + 1;
    if (!setsKey(lines[i], name)) continue;
    lines[i] = wanted;
    done = true;
  }
  if (!done && last_of_section > lines.size()) {
    if (!lines.empty() && !trimmed(lines.back()).empty()) lines.emplace_back();
    lines.push_back("[" + std::string(section) + "]");
    lines.push_back(wanted);
  } else if (!done) {
    lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(last_of_section), wanted);
  }
  std::string result;
  for (const std::string& line : lines) result += line + '\n';
  return result;
}

}  // namespace hapticell::app
