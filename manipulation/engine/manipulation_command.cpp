// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/manipulation_command.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace hapticell::manipulation {

namespace {

bool startsWith(const std::string& text, const std::string& head) {
  return text.compare(0, head.size(), head) == 0;
}

const std::string kFramePrefix = "frame:";

}  // namespace

Expected<ScaleChoice> parseScale(const std::string& text) {
  const std::pair<const char*, ScaleLevel> words[] = {{"rough", ScaleLevel::kRough},
                                                      {"medium", ScaleLevel::kMedium},
                                                      {"fine", ScaleLevel::kFine},
                                                      {"screen", ScaleLevel::kScreen}};
  for (const auto& [word, level] : words) {
    if (text == word) return ScaleChoice{level, 1.0};
  }
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  if (whole && std::isfinite(number) && number >= 1e-3 && number <= 1e3)
    return ScaleChoice{ScaleLevel::kNumber, number};
  return unknownWord("scale", text, Text("rough, medium, fine, screen or a number from 0.001 to 1000"));
}

Expected<AxesChoice> parseAxes(const std::string& text) {
  if (text == "screen") return AxesChoice{AxesMode::kScreen, {}};
  if (text == "cell") return AxesChoice{AxesMode::kCell, {}};
  if (startsWith(text, kFramePrefix) && text.size() > kFramePrefix.size()) {
    return AxesChoice{AxesMode::kFrame, text.substr(kFramePrefix.size())};
  }
  return unknownWord("axes", text, Text("screen, cell or frame:NAME"));
}

Expected<command::SetFilter> parseFilter(const std::string& text) {
  if (text == "all") return command::SetFilter{};
  if (text == "translation") return command::SetFilter{true, false};
  if (text == "rotation") return command::SetFilter{false, true};
  command::SetFilter filter{true, false, {false, false, false}};
  for (const char letter : text) {
    if (letter < 'x' || letter > 'z')
      return unknownWord("filter", text, Text("all, translation, rotation, or some of x y z"));
    filter.axes[static_cast<std::size_t>(letter - 'x')] = true;
  }
  if (text.empty()) return unknownWord("filter", text, Text("all, translation, rotation, or some of x y z"));
  return filter;
}

Expected<workcell::OnContact> parseOnContact(const std::string& text) {
  if (text == "stop") return workcell::OnContact::kStop;
  if (text == "slide") return workcell::OnContact::kSlide;
  if (text == "pass") return workcell::OnContact::kPass;
  return unknownWord("on_contact", text, Text("stop, slide or pass"));
}

Expected<workcell::ForceClass> parseForceClass(const std::string& text) {
  if (text == "constant") return workcell::ForceClass::kConstant;
  if (text == "contact") return workcell::ForceClass::kContact;
  if (text == "dynamics") return workcell::ForceClass::kDynamics;
  return unknownWord("force_class", text, Text("constant, contact or dynamics"));
}

}  // namespace hapticell::manipulation
