// SPDX-License-Identifier: Apache-2.0
#include "app/agents/agent_setup.h"

#include <QCoreApplication>
#include <algorithm>
#include <cstdio>

#include "agents/task/agent_section.h"
#include "trajectory/motion/number_text.h"

namespace hapticell::app {

namespace {

const workcell::Entity* find(const workcell::DocumentState& state, workcell::EntityId id) {
  for (const auto& entity : state.entities) {
    if (entity->id == id) return entity.get();
  }
  return nullptr;
}

/// A basic string of TOML.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) < 0x20) {
      char code[8];
      std::snprintf(code, sizeof code, "\\u%04X", static_cast<unsigned>(static_cast<unsigned char>(c)));
      out += code;
      continue;
    }
    out += c;
  }
  return out + "\"";
}

/// What differs from the kinds' own values, as in the shipped tasks (config/agents).
std::string keysOf(const std::string& kind, bool figure) {
  if (kind == "goal" && figure) return "speed = 0.3\n";
  if (kind == "obstacles") return figure ? "within = 0.06\n" : "within = 0.10\n";
  if (kind == "balance") return "margin = 0.03\n";
  if (kind == "comfort") return "weight = 0.25\n";
  if (kind == "operator") return "weight = 3.0\n";
  return "";
}

}  // namespace

bool canBeMovedByAgents(const workcell::Entity& entity) {
  if (entity.locked) return false;
  return entity.figure() != nullptr || workcell::isMachine(entity) || entity.mesh() != nullptr;
}

std::vector<std::string> agentKindsFor(const workcell::Entity& entity) {
  if (entity.figure() != nullptr)
    return {"goal", "obstacles", "limits", "balance", "comfort", "sight", "reach", "operator"};
  if (entity.robot() != nullptr) return {"goal", "obstacles", "limits", "operator"};
  return {"goal", "obstacles", "operator"};
}

dvec3 middleOf(const workcell::Entity& entity) {
  return entity.mesh() != nullptr ? entity.X_WE * entity.mesh()->bounds().center() : entity.X_WE.p;
}

QString agentName(const std::string& kind) {
  struct Name {
    const char* kind;
    const char* shown;
  };
  static constexpr Name kNames[] = {
      {"goal", QT_TRANSLATE_NOOP("hapticell::app::AgentsPanel", "Goal")},
      {"obstacles", QT_TRANSLATE_NOOP("hapticell::app::AgentsPanel", "Obstacles")},
      {"limits", QT_TRANSLATE_NOOP("hapticell::app::AgentsPanel", "Limits")},
      {"balance", QT_TRANSLATE_NOOP("hapticell::app::AgentsPanel", "Balance")},
      {"comfort", QT_TRANSLATE_NOOP("hapticell::app::AgentsPanel", "Comfort")},
      {"sight", QT_TRANSLATE_NOOP("hapticell::app::AgentsPanel", "Sight")},
      {"reach", QT_TRANSLATE_NOOP("hapticell::app::AgentsPanel", "Reach")},
      {"operator", QT_TRANSLATE_NOOP("hapticell::app::AgentsPanel", "Hand")},
  };
  for (const Name& name : kNames) {
    if (kind == name.kind) return QCoreApplication::translate("hapticell::app::AgentsPanel", name.shown);
  }
  return QString::fromStdString(kind);
}

Expected<agents::AgentTask> taskOf(const AgentSetup& setup, const workcell::DocumentState& state) {
  const workcell::Entity* moved = find(state, setup.entity);
  if (moved == nullptr)
    return makeError({.found = "no entity is chosen", .expected = "a robot, a mannequin or a solid of the cell"});
  const bool figure = moved->figure() != nullptr;
  const auto number = [](double value) {
    const std::string text = trajectory::shortestText(value);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
  };
  std::string text = "cell = \"-\"\nentity = " + quoted(moved->name) + "\n";
  if (figure) text += setup.left_hand ? "moved_by = \"left_hand\"\n" : "moved_by = \"right_hand\"\n";
  text += "clearance = " + number(setup.clearance) + "\n[goal]\nposition = [" + number(setup.p_WG.x) + ", " +
          number(setup.p_WG.y) + ", " + number(setup.p_WG.z) + "]\ntolerance = 0.02\n";
  const workcell::Entity* seen = figure ? find(state, setup.look_at) : nullptr;
  if (seen != nullptr) text += "look_at = " + quoted(seen->name) + "\n";
  for (const std::string& kind : agentKindsFor(*moved)) {
    if (kind == "sight" && seen == nullptr) continue;
    text += "[[agent]]\nwhat = \"" + kind + "\"\n" + keysOf(kind, figure);
  }
  return agents::AgentTask::parse(text, moved->name);
}

}  // namespace hapticell::app
