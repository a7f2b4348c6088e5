// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <vector>

class QToolButton;
class QWidget;

namespace hapticell::app {

/// In a row that is too narrow, makes tool buttons show icons without words, instead of truncated words: first the last
/// group, then those before it. Tool tips and accessible names say the rest. Owned by the row.
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
