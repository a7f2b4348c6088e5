// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>
#include <vector>

#include "workcell/entity/pair_policy.h"

class QLabel;
class QPushButton;

namespace hapticell::app {

class Host;

/// Asks what to do about pairs that touch at rest: exclude them from the check (a command that can be undone) or keep
/// them. Hidden while there is nothing to ask.
class RestQuestion : public QFrame {
  Q_OBJECT
 public:
  explicit RestQuestion(Host& host, QWidget* parent = nullptr);
  void ask(std::vector<workcell::PairRule> touching);
  /// The cell has changed since the question: nothing can be excluded until it is asked again.
  void setOutdated();

 private:
  void leaveOut();

  Host& host_;
  QLabel* text_;
  QPushButton* leave_out_;
  std::vector<workcell::PairRule> touching_;
};

}  // namespace hapticell::app
