// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDoubleSpinBox>
#include <optional>

namespace hapticell::app {

/// A number with its unit inside the field, right-aligned, fixed decimals, never a minus zero.
///
/// The unit stands in the second text colour; where the number needs its room it goes. Arrow keys and the wheel (while
/// focused) step it; Enter or leaving the field ends the edit. Lengths and angles are set and shown in mm and degrees,
/// and shown in the units in force (units.h); typed with a unit behind them ("2 in", "1.5rad") they are taken as that.
/// A number typed beyond an end becomes that end, and a tip at the field says so.
class ValueField : public QDoubleSpinBox {
  Q_OBJECT
 public:
  enum class Quantity { kByUnit, kPlain, kLength, kAngle };  ///< kByUnit: "mm" and "mm/s" are lengths, "°" an angle.
  struct Format {
    QString unit;      ///< "mm"; empty for none.
    int decimals = 1;  ///< With the usual units; of lengths and angles as many more or less than 1 as those have.
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
  /// The units in force are others.
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
  bool typed_ = false;                         ///< Since editing began.
  mutable std::optional<double> beyond_ = {};  ///< What was typed beyond an end; fixup() is const.
};

}  // namespace hapticell::app
