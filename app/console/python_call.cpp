// SPDX-License-Identifier: Apache-2.0
#include "app/console/python_call.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <utility>
#include <variant>
#include <vector>

#include "trajectory/motion/number_text.h"
#include "workcell/format/document_io.h"

namespace hapticell::app {

using trajectory::shortestText;
using workcell::DocumentState;
using workcell::Entity;

std::string pythonText(const std::string& text) {
  std::string made = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') made += '\\';
    if (letter == '\n') {
      made += "\\n";
    } else {
      made += letter;
    }
  }
  return made + '"';
}

namespace {

template <class Numbers>
std::string listText(const Numbers& numbers) {
  std::string made = "[";
  for (const double number : numbers) made += (made.size() > 1 ? ", " : "") + shortestText(number);
  return made + "]";
}

std::string namesText(const std::vector<std::string>& names) {
  std::string made = "[";
  for (const std::string& name : names) made += (made.size() > 1 ? ", " : "") + pythonText(name);
  return made + "]";
}

std::string poseText(const Pose& X) {
  return listText(std::initializer_list<double>{X.p.x, X.p.y, X.p.z, X.q.w, X.q.x, X.q.y, X.q.z});
}

bool isIdentity(const Pose& X) {
  return X.p == dvec3(0.0) && X.q.w == 1.0;
}

const char* wordOf(bool value) {
  return value ? "True" : "False";
}

/// Each function gives the lines of one command; nothing: there is no method for it.
class Writer {
 public:
  explicit Writer(const DocumentState& before) : before_(before) {}

  std::string operator()(const workcell::SetPlacement& c) const { return moved(c.id, c.X_WE); }
  std::string operator()(const workcell::SetJoints& c) const { return bent(c.id, c.joints); }
  std::string operator()(const workcell::SetConfiguration& c) const {
    return moved(c.id, c.X_WE) + (c.joints.empty() ? "" : bent(c.id, c.joints));
  }
  std::string operator()(const workcell::RenameEntity& c) const {
    return "cell.rename(" + name(c.id) + ", " + pythonText(c.name) + ")\n";
  }
  std::string operator()(const workcell::RemoveEntity& c) const { return "cell.remove(" + name(c.id) + ")\n"; }
  std::string operator()(const workcell::Detach& c) const { return "cell.detach(" + name(c.id) + ")\n"; }
  std::string operator()(const workcell::Attach& c) const {
    const std::string link = c.link.empty() ? "" : ", " + pythonText(c.link);
    return "cell.attach(" + name(c.id) + ", " + name(c.to) + link + ")\n";
  }
  std::string operator()(const workcell::SetTool& c) const {
    return "cell.set_tool(" + name(c.id) + ", " + pythonText(c.tip_link) + ", " + poseText(c.X_LT) + ")\n";
  }
  std::string operator()(const workcell::RemovePairSet& c) const {
    return "cell.remove_check(" + pythonText(c.name) + ")\n";
  }
  std::string operator()(const workcell::AddPairSet& c) const {
    if (!c.set.enabled || c.set.on_contact || c.set.contact_color || c.set.near_miss_color) return {};
    return "cell.add_check(" + pythonText(c.set.name) + ", " + namesText(c.set.first) + ", " + namesText(c.set.second) +
           ", safety_distance=" + shortestText(c.set.safety_distance) + ", near_miss=" + shortestText(c.set.near_miss) +
           ")\n";
  }
  std::string operator()(const workcell::SetPairRules& c) const {
    std::string lines;
    for (const workcell::PairRule& rule : c.rules) {
      if (rule.checked || rule.on_contact || !rule.first_part.empty() || !rule.second_part.empty()) return {};
      lines += "cell.leave_out(" + pythonText(rule.first) + ", " + pythonText(rule.second) + ")\n";
    }
    return lines;
  }
  std::string operator()(const workcell::SetProperties& c) const {
    std::string values;
    const auto add = [&values](const char* key, const std::string& value) { values += std::string(", ") + key + "=" + value; };
    if (c.color) add("color", colorText(*c.color));
    if (c.visible) add("visible", wordOf(*c.visible));
    if (c.locked) add("locked", wordOf(*c.locked));
    if (c.checked) add("checked", wordOf(*c.checked));
    if (c.on_contact) add("on_contact", pythonText(workcell::wordOf(*c.on_contact)));
    if (c.force_class) add("force_class", pythonText(workcell::wordOf(*c.force_class)));
    if (c.material) add("material", pythonText(*c.material));
    if (c.mass) add("mass", shortestText(*c.mass));
    if (c.parent) add("parent", pythonText(*c.parent));
    return "cell.set(" + name(c.id) + values + ")\n";
  }
  /// Only what a file or a word stands for as a whole: parts of an assembly come by the file they are in.
  std::string operator()(const workcell::AddEntity& c) const {
    const Entity& entity = c.entity;
    const workcell::SourceFile& source = entity.source;
    const bool whole = source.part.empty() && !source.up_axis && source.tessellation == workcell::Tessellation{} &&
                       source.arguments.empty() && !source.oriented && source.simplified == 0.0 &&
                       (source.scale == 1.0 || source.scale == 0.0);
    if (source.path.empty() || !whole || entity.mechanism() || !entity.frames.empty() || entity.motion) return {};
    const std::string own = pythonText(entity.name);
    std::string lines = "cell.add(" + pythonText(source.path) + ", name=" + own +
                        (isIdentity(entity.X_WE) ? "" : ", pose=" + poseText(entity.X_WE)) + ")\n";
    if (!entity.joints().empty()) lines += "cell.set_joints(" + own + ", " + listText(entity.joints()) + ")\n";
    return lines + "cell.set(" + own + ", color=" + colorText(entity.color) +
           (entity.parent.empty() ? "" : ", parent=" + pythonText(entity.parent)) + ")\n";
  }
  template <class Other>
  std::string operator()(const Other& /*command*/) const {
    return {};
  }

 private:
  std::string name(workcell::EntityId id) const {
    const Entity* const entity = before_.find(id);
    return pythonText(entity ? entity->name : "");
  }
  std::string moved(workcell::EntityId id, const Pose& X_WE) const {
    return "cell.move(" + name(id) + ", " + poseText(X_WE) + ")\n";
  }
  std::string bent(workcell::EntityId id, const std::vector<double>& joints) const {
    return "cell.set_joints(" + name(id) + ", " + listText(joints) + ")\n";
  }
  /// To four decimals, as documents have it.
  static std::string colorText(const std::array<float, 3>& color) {
    std::vector<double> parts;
    for (const float part : color) parts.push_back(std::round(static_cast<double>(part) * 1e4) / 1e4);
    return listText(parts);
  }

  const DocumentState& before_;
};

}  // namespace

std::string pythonCall(const workcell::Command& command, const DocumentState& before) {
  std::string lines = std::visit(Writer(before), command);
  if (!lines.empty()) return lines;
  std::string text = workcell::commandText(command, before);
  std::replace(text.begin(), text.end(), '\n', ' ');
  return "# Not written, because Python has no method for it: " + text + "\n";
}

}  // namespace hapticell::app
