// SPDX-License-Identifier: Apache-2.0
#include "app/import/unit_question.h"

#include <QAbstractButton>
#include <QHBoxLayout>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "app/import/preview_picture.h"
#include "app/kit/form.h"
#include "app/style/theme.h"
#include "app/style/units.h"

namespace hapticell::app {

namespace {

constexpr std::array<double, 2> kCardUnits{1.0, 0.001};  // Metres per unit.
constexpr double kPerson = 1.75;                         // m
constexpr double kPersonWidth = 0.5;                     // m
constexpr int kCardHeight = 112, kTextHeight = 36, kCardMargin = 8;
constexpr double kLeastSeen = 3.0;  // px: smaller things get a ring.

/// A number of the file with at most three digits behind the point.
QString fileNumber(double value) {
  if (value >= 100.0) return numberText(value, 0);
  return numberText(value, value >= 10.0 ? 1 : 2);
}

void paintPerson(QPainter& painter, const QPointF& foot, double height) {
  const double head = 0.065 * height;
  QPainterPath person;
  person.addEllipse(foot - QPointF(0.0, height - head), head, head);
  person.addRoundedRect(QRectF(foot.x() - 0.11 * height, foot.y() - 0.85 * height, 0.22 * height, 0.40 * height),
                        0.06 * height, 0.06 * height);
  person.addRect(QRectF(foot.x() - 0.08 * height, foot.y() - 0.47 * height, 0.07 * height, 0.47 * height));
  person.addRect(QRectF(foot.x() + 0.01 * height, foot.y() - 0.47 * height, 0.07 * height, 0.47 * height));
  painter.drawPath(person.simplified());
}

}  // namespace

/// One of the sizes, drawn to scale, to be chosen.
class SizeCard : public QAbstractButton {
 public:
  SizeCard() {
    setCheckable(true);
    setFixedHeight(kCardHeight);
    setMinimumWidth(120);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
  }

  /// The picture shows a box of `size` (m).
  void setPart(const QImage& picture, const dvec3& size, const QString& length) {
    picture_ = picture;
    size_ = size;
    length_ = length;
    update();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    const Theme& theme = themeOf(palette());
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    const QColor quiet_edge = underMouse() ? theme.text3 : theme.line;
    const QColor edge = isChecked() || hasFocus() ? theme.selection : quiet_edge;
    painter.setPen(QPen(edge, isChecked() ? 2.0 : 1.0));
    painter.setBrush(isChecked() ? theme.selected_row : QColor(Qt::transparent));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0), 4.0, 4.0);
    paintSizes(painter, theme);
    const QRect text(kCardMargin, height() - kTextHeight, width() - 2 * kCardMargin, kTextHeight - 4);
    painter.setPen(theme.text1);
    painter.setFont(textFont(TextRole::kSection));
    painter.drawText(text, Qt::AlignTop | Qt::AlignHCenter, length_);
    painter.setPen(theme.text2);
    painter.setFont(textFont(TextRole::kSecond));
    painter.drawText(text, Qt::AlignBottom | Qt::AlignHCenter, this->text());
  }

 private:
  void paintSizes(QPainter& painter, const Theme& theme) const {
    if (picture_.isNull()) return;
    const double pixels = previewPixelsPerMetre(size_, picture_.size());
    const double wide = picture_.width() / pixels, high = picture_.height() / pixels;  // m
    const QRectF room(kCardMargin, kCardMargin, width() - 2 * kCardMargin, height() - kTextHeight - kCardMargin - 4);
    const double scale =
        std::min({room.height() / kPerson, room.height() / high, room.width() / (kPersonWidth + wide)});
    const double left = room.center().x() - 0.5 * scale * (kPersonWidth + wide);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.text2);
    const QPointF foot(left + 0.5 * scale * kPersonWidth, room.bottom());
    paintPerson(painter, foot, scale * kPerson);
    const QRectF part(left + scale * kPersonWidth, room.bottom() - scale * high, scale * wide, scale * high);
    painter.drawImage(part, picture_);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.selection, 1.5));
    if (std::max(part.width(), part.height()) < kLeastSeen) painter.drawEllipse(part.center(), 6.0, 6.0);
    if (scale * kPerson < kLeastSeen) painter.drawEllipse(foot, 6.0, 6.0);
  }

  QImage picture_;
  dvec3 size_{0.0};
  QString length_;
};

UnitQuestion::UnitQuestion(QWidget* parent) : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  const std::array<QString, 2> names{tr("Metres"), tr("Millimetres")};
  for (std::size_t i = 0; i < cards_.size(); ++i) {
    cards_[i] = new SizeCard;
    cards_[i]->setObjectName(i == 0 ? QStringLiteral("unitMetres") : QStringLiteral("unitMillimetres"));
    cards_[i]->setText(names[i]);
    row->addWidget(cards_[i], 1);
    connect(cards_[i], &QAbstractButton::clicked, this, [this, i] { emit chosen(kCardUnits[i]); });
  }
}

void UnitQuestion::setFile(const ImportFacts& facts, std::optional<double> metres_per_unit) {
  const dvec3 in_units = facts.size / facts.metres_per_unit;
  const QString number = fileNumber(std::max({in_units.x, in_units.y, in_units.z}));
  for (std::size_t i = 0; i < cards_.size(); ++i) {
    const QString length = number + (i == 0 ? QStringLiteral(" m") : QStringLiteral(" mm"));
    cards_[i]->setPart(facts.picture, kCardUnits[i] * in_units, length);
    cards_[i]->setAccessibleName(tr("%1 long").arg(length));
    cards_[i]->setChecked(metres_per_unit && std::abs(*metres_per_unit / kCardUnits[i] - 1.0) < 1e-9);
  }
}

}  // namespace hapticell::app
