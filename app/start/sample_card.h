// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractButton>
#include <QPixmap>

namespace hapticell::app {

/// A sample cell as a button: its picture, its name, one sentence.
class SampleCard : public QAbstractButton {
  Q_OBJECT
 public:
  SampleCard(const QPixmap& picture, const QString& title, const QString& sentence, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {248, 232}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QPixmap picture_;
  QString sentence_;
};

}  // namespace hapticell::app
