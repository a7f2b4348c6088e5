// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QString>
#include <QWidget>
#include <map>
#include <vector>

class QLineEdit;

namespace hapticell::app {

/// Names, one a row, each with a switch (pair sets, guides). A click on the switch asks for on or off; elsewhere it
/// chooses the row. A double click on the name or F2 renames, arrow keys move, Enter switches, letters search.
class SwitchList : public QWidget {
  Q_OBJECT
 public:
  struct Row {
    QString name;
    bool on = true;
  };
  /// `empty` is shown if there are no rows.
  explicit SwitchList(const QString& empty, QWidget* parent = nullptr);
  void setRows(std::vector<Row> rows);
  /// Numbers at the right of rows, by name; zeros are not shown.
  void setAlerts(const std::map<QString, int>& alerts);
  int current() const { return current_; }  ///< -1 without rows.
  void setCurrent(int index);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 signals:
  void chosen(int index);
  void switched(int index, bool on);
  /// The user typed another name for the row; never empty.
  void renamed(int index, const QString& name);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void rename(int index);
  void endRename(bool keep);
  void search(const QString& typed);
  QString empty_;
  std::vector<Row> rows_;
  std::map<QString, int> alerts_;
  int current_ = -1;
  QLineEdit* field_ = nullptr;  ///< While a name is edited.
  int renamed_row_ = -1;
  QString searched_;  ///< The letters typed so far.
  QElapsedTimer since_typed_;
};

}  // namespace hapticell::app
