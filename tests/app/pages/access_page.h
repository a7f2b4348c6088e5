// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QComboBox>
#include <QListWidget>
#include <QSlider>
#include <QTemporaryDir>

#include "app/trajectory/motions/motion_list.h"
#include "config/configuration.h"
#include "tests/app/pages/robot_page.h"

namespace hapticell::app {

/// What a user does in the dock Access, with a copy of the shipped gearbox.
class AccessPage : public RobotPage {
 public:
  static constexpr int kAnswerPatience = 240000;  // ms; the search shares the machine with other tests.

  bool openGearbox() {
    const auto shipped = config::findShippedFile("access");
    EXPECT_TRUE(shipped.has_value());
    const auto copy = std::filesystem::path(folder_.path().toStdString()) / "gearbox.hcell";
    std::filesystem::copy_file(std::filesystem::path(*shipped) / "gearbox.hcell", copy);
    return open(QString::fromStdString(copy.string()));
  }
  void choosePart(const char* name) {
    trigger("actionAccess");
    window().selection().set(document().document().findByName(name)->id);
    settle();
    click("buttonAccessPart");
  }
  void choosePersons(int index) {
    find<QComboBox>("choiceAccessPersons")->setCurrentIndex(index);
    settle();
  }
  /// Presses the button and waits for the end of the search.
  bool ask() {
    click("buttonAccessAsk");
    auto* button = find<QAbstractButton>("buttonAccessAsk");
    return until([&] { return button->text() == "Find the way out"; }, kAnswerPatience);
  }
  QListWidget& steps() { return *find<QListWidget>("listAccessSteps"); }
  QString stepLine(int row) { return steps().item(row)->text(); }
  void chooseStep(int row) {
    steps().setCurrentRow(row);
    settle();
  }
  MotionList& motions() { return *window().findChild<MotionList*>(); }
  /// Where the ghost stands; empty: there is none.
  std::optional<Pose> ghost() {
    const auto ghosts = window().viewport().scene().ghosts();
    return ghosts.empty() ? std::nullopt : std::optional(ghosts.front().X_WE);
  }
  std::filesystem::path folder() const { return folder_.path().toStdString(); }

 private:
  QTemporaryDir folder_;
};

}  // namespace hapticell::app
