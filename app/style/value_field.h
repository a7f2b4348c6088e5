// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDoubleSpinBox>
#include <optional>

namespace hapticell::app {

/// A number with its unit inside the field, right-aligned, fixed decimals, never a minus zero.
///
/// The unit has the second text colour and is hidden if the number needs its room. Arrow keys and the wheel (while
/// focused) step the number; Enter or leaving the field ends the edit. Lengths and angles are set and read in mm and
/// degrees, and shown in the units that the user chose (units.h); a unit typed after the number ("2 in", "1.5rad") is
/// respected. A number typed beyond a limit becomes that limit, and a tip at the field says so.
class ValueField : public QDoubleSpinBox {
  Q_OBJECT
 public:
  enum class Quantity { kByUnit, kPlain, kLength, kAngle };  ///< kByUnit: "mm" and "mm/s" are lengths, "°" an angle.
  struct Format {
    QString unit;      ///< "mm"; empty for none.
    int decimals = 1;  ///< With default units; lengths and angles have as many more or fewer as this differs from 1.
    double minimum = -1e6, maximum = 1e6, step = 1.0;
    Quantity quantity = Quantity::kByUnit;
  };
  explicit ValueField(const Format& format, QWidget* parent = nullptr);

  /// Does not repaint if the shown number is the same, because panels set their numbers ten times a second.
  void setValue(double value);
  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& place) const override;
  void fixup(QString& text) const override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
  /// The user chose other units.
  void unitsChanged();

 signals:
  void edited(double value);  ///< The user typed or stepped a new value.

 protected:
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void stepBy(int steps) override;

 private:
  std::optional<double> read(const QString& text) const;
  QString withShownUnit(double value) const;
  void sayEnd(double typed);
  QString shownUnit() const;
  double shownPerValue() const;
  void fitUnit();
  int shownDecimals() const;
  QString unit_;
  int decimals_;
  Quantity quantity_;
  bool unit_fits_ = true;
  bool typed_ = false;                         ///< The user typed since editing began.
  mutable std::optional<double> beyond_ = {};  ///< What was typed beyond a limit; fixup() is const.
};

}  // namespace hapticell::app
