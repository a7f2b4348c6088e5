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

/// What the robot carries at its flange against what its maker allows, in words that say what is not known. Keeps its
/// room when the robot carries nothing. GUI thread.
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
  std::vector<std::shared_ptr<const workcell::Entity>> weighed_;  ///< What the words are about; entities never change.
};

/// "Load 12 kg of 16 kg allowed, centre 85 mm from flange".
QString loadText(const workcell::CarriedLoad& load, double payload);

}  // namespace hapticell::app
