// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QComboBox>
#include <QLineEdit>

#include "tests/app/pages/robot_page.h"

namespace hapticell::app {

/// What a user does in the dock "Plan a path".
class PlanPage : public RobotPage {
 public:
  static constexpr int kPlanPatience = 120000;  // ms; searches share the machine with other tests.

  void openDock() { trigger("actionPlanPath"); }
  void chooseGoal(const QString& kind) { choose("choicePlanGoal", kind); }
  /// As the user picks an entry.
  void choose(const QString& list, const QString& entry) {
    auto* choice = find<QComboBox>(list);
    if (choice == nullptr) return;
    choice->setCurrentText(entry);
    EXPECT_EQ(choice->currentText(), entry);
    emit choice->activated(choice->currentIndex());
    settle();
  }
  double number(const QString& field) {
    auto* found = find<ValueField>(field);
    return found == nullptr ? 0.0 : found->value();
  }
  void typeJoints(const QString& joints) {
    auto* edit = find<QLineEdit>("editPlanJoints");
    if (edit == nullptr) return;
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, joints);
    settle();
  }
  /// Plans and waits for the end: what the dock then says.
  QString planned() {
    click("buttonPlanPath");
    EXPECT_TRUE(until([&] { return !find<QAbstractButton>("buttonPlanStop")->isEnabled(); }, kPlanPatience));
    return words("labelPlanResult");
  }
  std::size_t motions() { return document().document().state().trajectories.size(); }
};

}  // namespace hapticell::app
