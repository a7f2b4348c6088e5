// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCheckBox>
#include <QSlider>
#include <QTemporaryDir>
#include <filesystem>
#include <set>

#include "agents/wishes/agent.h"
#include "app/agents/agent_setup.h"
#include "app/agents/agents_panel.h"
#include "config/configuration.h"
#include "tests/app/pages/robot_page.h"

namespace hapticell::app {

/// What a user does with agents in the window, on the shipped cells.
class AgentsPage : public RobotPage {
 public:
  static constexpr int kRunPatience = 120000;  // ms; a run is no faster than real time.

  bool openCell(const char* name) {
    // A copy of the shipped cells: motions that are kept are written beside the cell.
    const auto shipped = config::findShippedFile("agents");
    EXPECT_TRUE(shipped.has_value());
    const std::filesystem::path here = std::filesystem::path(folder_.path().toStdString()) / "agents";
    std::filesystem::copy(*shipped, here, std::filesystem::copy_options::recursive);
    const bool is_open = open(QString::fromStdString((here / name).string()));
    trigger("actionAgents");
    return is_open;
  }
  void select(const char* name) {
    window().selection().set(document().document().findByName(name)->id);
    settle();
  }
  /// Moves this entity to a point (mm).
  void setUp(const char* entity, const dvec3& goal_mm) {
    select(entity);
    click("buttonAgentEntity");
    const char* fields[] = {"fieldAgentGoalX", "fieldAgentGoalY", "fieldAgentGoalZ"};
    for (int k = 0; k < 3; ++k) type(fields[k], QString::number(goal_mm[k]));
  }
  void setSlider(const char* name, int value) {
    auto* slider = find<QSlider>(name);
    slider->setFocus();
    slider->setValue(value);
    settle();
  }
  std::optional<agents::AgentSession::State> state() {
    auto* panel = find<AgentsPanel>("agentsPanel");
    if (panel == nullptr || panel->session() == nullptr) return std::nullopt;
    return panel->session()->state();
  }
  bool untilPhase(agents::AgentSession::Phase phase) {
    const bool reached = until([&] { return state() && state()->phase == phase; }, kRunPatience);
    rest();
    return reached;
  }
  /// The panel has looked at the run once more.
  static void rest() {
    until([] { return false; }, 150);
  }
  /// Saves a picture of the window to HAPTICELL_LOOK_FOLDER, where that is given.
  void keepLook(const char* name) {
    const QString folder = qEnvironmentVariable("HAPTICELL_LOOK_FOLDER");
    if (!folder.isEmpty()) window().grab().save(folder + '/' + QLatin1String(name) + ".png");
  }
  /// Arrows of agents; frames and guides of the cell have labels too.
  std::size_t arrows() {
    std::set<std::string> names;
    for (const agents::AgentKind& kind : agents::agentKinds()) names.insert(agentName(kind.name).toStdString());
    const auto curves = window().viewport().allCurves();
    return static_cast<std::size_t>(
        std::count_if(curves.begin(), curves.end(), [&](const SceneCurve& curve) { return names.contains(curve.text); }));
  }

 private:
  QTemporaryDir folder_;
};

}  // namespace hapticell::app
