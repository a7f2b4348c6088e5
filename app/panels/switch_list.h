// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QWidget>
#include <map>
#include <vector>

namespace hapticell::app {

/// Names, one a row, each with a switch (pair sets, guides). A click on the switch asks for on or off, elsewhere it
/// chooses the row; arrow keys move, Enter switches.
class SwitchList : public QWidget {
  Q_OBJECT
 public:
  struct Row {
    QString name;
    bool on = true;
  };
  /// `empty` is said where there are no rows.
  explicit SwitchList(const QString& empty, QWidget* parent = nullptr);
  void setRows(std::vector<Row> rows);
  /// Numbers at the right of rows, by name; noughts are not shown.
  void setAlerts(const std::map<QString, int>& alerts);
  int current() const { return current_; }  ///< -1 without rows.
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
  QString empty_;
  std::vector<Row> rows_;
  std::map<QString, int> alerts_;
  int current_ = -1;
};

}  // namespace hapticell::app
