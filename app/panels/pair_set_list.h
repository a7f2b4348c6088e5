// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QWidget>
#include <vector>

#include "workcell/entity.h"

namespace hapticell::app {

/// Pair sets, one a row: a switch, the name. A click on the switch asks for on or off, elsewhere it chooses the set.
class PairSetList : public QWidget {
  Q_OBJECT
 public:
  explicit PairSetList(QWidget* parent = nullptr);
  void setSets(const std::vector<workcell::PairSet>& sets);
  int current() const { return current_; }  ///< -1 without sets.
  void setCurrent(int index);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 signals:
  void chosen(int index);
  void switched(int index, bool on);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Row {
    QString name;
    bool on = true;
  };
  std::vector<Row> rows_;
  int current_ = -1;
};

}  // namespace hapticell::app
