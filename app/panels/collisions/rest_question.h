// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>
#include <vector>

#include "workcell/entity/pair_policy.h"

class QLabel;

namespace hapticell::app {

class Host;

/// Asks what shall become of pairs that touch as the cell stands: left out of the check (a command that can be undone)
/// or kept. Hidden while there is nothing to ask.
class RestQuestion : public QFrame {
  Q_OBJECT
 public:
  explicit RestQuestion(Host& host, QWidget* parent = nullptr);
  void ask(std::vector<workcell::PairRule> touching);

 private:
  void leaveOut();

  Host& host_;
  QLabel* text_;
  std::vector<workcell::PairRule> touching_;
};

}  // namespace hapticell::app
