// SPDX-License-Identifier: Apache-2.0
#include "app/style/value_field.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>
#include <QPainter>
#include <QTimer>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "app/style/style_painting.h"
#include "app/style/theme.h"
#include "app/style/units.h"

namespace hapticell::app {

namespace {

using Quantity = ValueField::Quantity;
constexpr double kDegreesPerRadian = 57.29577951308232;
constexpr int kKeptDecimals = 7;  // Of lengths (mm) and angles (degrees): other units must not cost accuracy.

struct TypedUnit {
  const char* name;
  double factor;  // To mm, or to degrees.
};
constexpr TypedUnit kLengths[]{{"mm", 1.0}, {"cm", 10.0}, {"m", 1000.0}, {"in", 25.4}, {"\"", 25.4}};
constexpr TypedUnit kAngles[]{{"\u00b0", 1.0}, {"deg", 1.0}, {"rad", kDegreesPerRadian}};

/// "mm", "mm/s", "mm a turn": what is shown by the unit of length in force.
bool isOfMillimetres(const QString& unit) {
  return unit.startsWith(QLatin1String("mm")) && (unit.size() == 2 || unit[2] == '/' || unit[2] == ' ');
}

Quantity quantityOf(const QString& unit) {
  if (isOfMillimetres(unit)) return Quantity::kLength;
  return unit == QStringLiteral("°") ? Quantity::kAngle : Quantity::kPlain;
}

template <std::size_t kCount>
std::optional<double> withUnit(const QString& text, const TypedUnit (&units)[kCount]) {
  for (const TypedUnit& unit : units) {
    const QString name = QString::fromUtf8(unit.name);
    if (!text.endsWith(name)) continue;
    bool read = false;
    const double value = QLocale::c().toDouble(text.chopped(name.size()).trimmed(), &read);
    if (read) return unit.factor * value;
  }
  return std::nullopt;
}

/// Escape while a number is typed: what stood there before. A filter of the field, so that forces have gone off first.
class TypedBack final : public QObject {
 public:
  TypedBack(QObject& field, std::function<bool()> take_back) : QObject(&field), take_back_(std::move(take_back)) {
    field.installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    return event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape && take_back_();
  }

 private:
  std::function<bool()> take_back_;
};

/// The click that gives a field the focus chooses its whole number, so that one types the next; a drag or a further
/// click in it works as in any text.
class ChosenByClick final : public QObject {
 public:
  ChosenByClick(QObject& field, QLineEdit& edit) : QObject(&field), edit_(edit) {
    field.installEventFilter(this);
    edit.installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched != &edit_ && event->type() == QEvent::FocusIn)
      entered_ = static_cast<QFocusEvent*>(event)->reason() == Qt::MouseFocusReason;
    if (watched == &edit_ && event->type() == QEvent::MouseButtonRelease && std::exchange(entered_, false) &&
        !edit_.hasSelectedText())
      QMetaObject::invokeMethod(&edit_, &QLineEdit::selectAll, Qt::QueuedConnection);  // After the field's own.
    return false;
  }

 private:
  QLineEdit& edit_;
  bool entered_ = false;
};

}  // namespace

ValueField::ValueField(const Format& format, QWidget* parent)
    : QDoubleSpinBox(parent), unit_(format.unit), decimals_(format.decimals), quantity_(format.quantity) {
  if (quantity_ == Quantity::kByUnit) quantity_ = quantityOf(unit_);
  setButtonSymbols(NoButtons);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);  // It may be narrower than it likes.
  setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  setDecimals(quantity_ == Quantity::kPlain ? format.decimals : kKeptDecimals);
  setRange(format.minimum, format.maximum);
  setSingleStep(format.step);
  setKeyboardTracking(false);
  setFocusPolicy(Qt::StrongFocus);
  setFixedHeight(kFieldHeight);
  setLocale(QLocale::c());
  unitsChanged();
  // Not QLineEdit::isModified(): the box writes the typed number again before it reports that editing has ended.
  connect(lineEdit(), &QLineEdit::textEdited, this, [this] { typed_ = true; });
  connect(lineEdit(), &QLineEdit::textChanged, this, &ValueField::fitUnit);
  new ChosenByClick(*this, *lineEdit());
  new TypedBack(*this, [this] {
    if (!std::exchange(typed_, false)) return false;
    lineEdit()->setText(textFromValue(value()));
    lineEdit()->selectAll();
    return true;
  });
  connect(this, &QDoubleSpinBox::editingFinished, this, [this] {
    const auto beyond = std::exchange(beyond_, std::nullopt);
    if (!std::exchange(typed_, false)) return;
    if (beyond) sayEnd(*beyond);
    emit edited(value());
  });
}

void ValueField::unitsChanged() {
  if (!hasFocus()) lineEdit()->setText(textFromValue(value()));
  fitUnit();
  update();
}

void ValueField::fitUnit() {
  constexpr int kGap = 4, kEdge = 6;  // Pixels: before the unit; of the field itself.
  const QString unit = shownUnit();
  const int taken = unit.isEmpty() ? 0 : fontMetrics().horizontalAdvance(unit) + kGap;
  const int number = fontMetrics().horizontalAdvance(lineEdit()->text());
  unit_fits_ = number + taken + kEdge <= lineEdit()->width();
  const QMargins margins(0, 0, unit_fits_ ? taken : 0, 0);
  if (lineEdit()->textMargins() == margins) return;
  lineEdit()->setTextMargins(margins);
  update();
}

void ValueField::resizeEvent(QResizeEvent* event) {
  QDoubleSpinBox::resizeEvent(event);
  fitUnit();
}

void ValueField::setValue(double value) {
  // It would be rounded to what is there: a pose that was computed again differs far behind the last kept decimal.
  const double same = 0.5 * std::pow(10.0, -decimals());
  if (std::abs(value - this->value()) <= same && lineEdit()->text() == textFromValue(this->value())) return;
  QDoubleSpinBox::setValue(value);
  fitUnit();  // The box writes its number without a word of its line.
}

QString ValueField::shownUnit() const {
  if (unit_.isEmpty() || quantity_ == Quantity::kPlain) return unit_;
  if (quantity_ == Quantity::kAngle) return unitsNow().angleUnit();
  return isOfMillimetres(unit_) ? unitsNow().lengthUnit() + unit_.mid(2) : unitsNow().lengthUnit();
}

double ValueField::shownPerValue() const {
  if (quantity_ == Quantity::kLength) return unitsNow().perMetre() / 1000.0;
  if (quantity_ == Quantity::kAngle) return unitsNow().perRadian() / kDegreesPerRadian;
  return 1.0;
}

int ValueField::shownDecimals() const {
  if (quantity_ == Quantity::kPlain) return decimals_;
  const Units units = unitsNow();
  const int chosen = quantity_ == Quantity::kLength ? units.length_decimals : units.angle_decimals;
  return std::max(0, chosen + decimals_ - 1);
}

QString ValueField::textFromValue(double value) const {
  return numberText(shownPerValue() * value, shownDecimals());
}

std::optional<double> ValueField::read(const QString& text) const {
  const QString plain = QString(text).replace(QLatin1Char(','), QLatin1Char('.')).trimmed();
  bool is_number = false;
  const double number = QLocale::c().toDouble(plain, &is_number);
  if (is_number) return number / shownPerValue();
  if (quantity_ == Quantity::kLength) return withUnit(plain, kLengths);
  if (quantity_ == Quantity::kAngle) return withUnit(plain, kAngles);
  return std::nullopt;
}

double ValueField::valueFromText(const QString& text) const {
  return read(text).value_or(value());
}

QValidator::State ValueField::validate(QString& text, int&) const {
  const auto typed = read(text);
  // An end itself may come back from its text by a rounding error beyond.
  const double slack = 0.5 * std::pow(10.0, -decimals());
  if (typed) {
    const bool inside = *typed >= minimum() - slack && *typed <= maximum() + slack;
    return inside ? QValidator::Acceptable : QValidator::Intermediate;
  }
  for (const QChar c : text) {
    const bool of_number = c.isDigit() || QStringLiteral("+-.,eE ").contains(c);
    const bool of_unit = quantity_ != Quantity::kPlain && QStringLiteral("mcinradeg\"°").contains(c);
    if (!of_number && !of_unit) return QValidator::Invalid;
  }
  return QValidator::Intermediate;
}

void ValueField::fixup(QString& text) const {
  const auto typed = read(text);
  if (!typed) return QDoubleSpinBox::fixup(text);
  beyond_ = typed;
  text = QLocale::c().toString(shownPerValue() * std::clamp(*typed, minimum(), maximum()), 'g', 17);
}

QString ValueField::withShownUnit(double value) const {
  const QString unit = shownUnit(), number = textFromValue(value);
  return unit.isEmpty() || unit == QStringLiteral("°") ? number + unit : number + QLatin1Char(' ') + unit;
}

void ValueField::sayEnd(double typed) {
  const QString text = typed > maximum()
                           ? tr("At most %1. You typed %2.").arg(withShownUnit(maximum()), withShownUnit(typed))
                           : tr("At least %1. You typed %2.").arg(withShownUnit(minimum()), withShownUnit(typed));
  // Not now: a tip goes where the focus leaves for the next field.
  QTimer::singleShot(0, this, [this, text] {
    // ms that the reason of a refused entry stays: two sentences to read. Half: too short for them; twice: it covers
    // what is below.
    constexpr int kShown = 6000;
    QToolTip::showText(mapToGlobal(rect().bottomLeft()), text, this, {}, kShown);
  });
}

QSize ValueField::sizeHint() const {
  return {76, kFieldHeight};
}
QSize ValueField::minimumSizeHint() const {
  return {44, kFieldHeight};
}

void ValueField::paintEvent(QPaintEvent* event) {
  fitUnit();  // The box's own ways (steps, ranges, what was typed and corrected) write numbers without a word, too.
  QDoubleSpinBox::paintEvent(event);
  const QString unit = shownUnit();
  if (unit.isEmpty() || !unit_fits_) return;
  QPainter painter(this);
  painter.setPen(isEnabled() ? themeOf(palette()).text2 : themeOf(palette()).text3);
  painter.drawText(rect().adjusted(0, 0, -6, 0), Qt::AlignRight | Qt::AlignVCenter, unit);
}

void ValueField::wheelEvent(QWheelEvent* event) {
  if (hasFocus())
    QDoubleSpinBox::wheelEvent(event);
  else
    event->ignore();
}

void ValueField::stepBy(int steps) {
  QDoubleSpinBox::stepBy(steps);
  emit edited(value());
}

}  // namespace hapticell::app
