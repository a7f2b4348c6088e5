// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDoubleSpinBox>

namespace hapticell::app {

/// A number with its unit inside the field, right-aligned, fixed decimals, never a minus zero.
///
/// The unit stands in the second text colour. Arrow keys and the wheel (while focused) step it; Enter or leaving the field ends the edit.
class ValueField : public QDoubleSpinBox {
  Q_OBJECT
 public:
  struct Format {
    QString unit;         ///< "mm"; empty for none.
    int decimals = 1;
    double minimum = -1e6, maximum = 1e6, step = 1.0;
  };
  explicit ValueField(const Format& format, QWidget* parent = nullptr);

  QString textFromValue(double value) const override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void edited(double value);  ///< The user typed or stepped a new value.

 protected:
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void stepBy(int steps) override;

 private:
  QString unit_;
  bool typed_ = false;  ///< Since editing began.
};

}  // namespace hapticell::app
