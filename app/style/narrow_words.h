// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <vector>

class QToolButton;
class QWidget;

namespace hapticell::app {

/// In a row that is too narrow its tool buttons show their icons without the words, instead of words cut short: first
/// the last group, then those before. Their tool tips and accessible names say the rest. Belongs to the row.
class NarrowWords : public QObject {
  Q_OBJECT
 public:
  NarrowWords(QWidget& row, std::vector<std::vector<QToolButton*>> groups);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fit();
  QWidget& row_;
  std::vector<std::vector<QToolButton*>> groups_;
  bool fitting_ = false;
};

}  // namespace hapticell::app
