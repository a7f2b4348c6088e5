// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <memory>
#include <string>
#include <vector>

#include "workcell/document/carried_load.h"

namespace hapticell::app {

class LiveLabel;
class RobotContext;

/// The robot's load compared with its payload, in words that also say what is unknown. Keeps its room when the robot
/// carries nothing. GUI thread.
class LoadLine : public QWidget {
  Q_OBJECT
 public:
  /// `name`: object name of the label.
  LoadLine(RobotContext& context, const char* name, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void showLoad();
  RobotContext& context_;
  LiveLabel* words_;
  std::vector<std::shared_ptr<const workcell::Entity>> weighed_;  ///< Parts of the shown text; entities never change.
};

/// "Load 12 kg of 16 kg allowed, centre 85 mm from flange".
QString loadText(const workcell::CarriedLoad& load, double payload);

}  // namespace hapticell::app
