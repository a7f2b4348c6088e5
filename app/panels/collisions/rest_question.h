// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>
#include <vector>

#include "app/panels/collisions/rest_check.h"

class QLabel;
class QPushButton;

namespace hapticell::app {

class Host;

/// Asks what to do about pairs that touch at rest: exclude them from the check (a command that can be undone) or keep
/// them. Pairs that overlap deeply are a question of its own, after the one about those that merely touch. Hidden while
/// there is nothing to ask.
class RestQuestion : public QFrame {
  Q_OBJECT
 public:
  explicit RestQuestion(Host& host, QWidget* parent = nullptr);
  /// Pairs that the user kept are not asked about again.
  void ask(RestCheck::Touching found);
  /// Another cell: nothing has been answered.
  void forget();
  /// The cell has changed since the question: nothing can be excluded until it is asked again.
  void setOutdated();

 private:
  void leaveOut();
  void keep();
  /// Asks about what is left to ask about; hides where nothing is.
  void showNext();

  Host& host_;
  QLabel* text_;
  QPushButton *leave_out_, *keep_;
  RestCheck::Touching left_;
  std::vector<workcell::PairRule> asked_, kept_;
  bool is_deep_ = false;  ///< What is asked about overlaps deeply.
};

}  // namespace hapticell::app
