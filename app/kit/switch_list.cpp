// SPDX-License-Identifier: Apache-2.0
#include "app/kit/switch_list.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QStyleOption>
#include <algorithm>
#include <utility>

#include "app/kit/typed_key.h"
#include "app/style/fonts.h"
#include "app/style/key_step.h"
#include "app/style/style_painting.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

constexpr int kSetRow = 26;
constexpr int kSwitchRoom = 48;  // From the left: the switch and its surroundings.

}  // namespace

SwitchList::SwitchList(const QString& empty, QWidget* parent) : QWidget(parent), empty_(empty) {
  setFocusPolicy(Qt::StrongFocus);
  setProperty("list", true);
}

QSize SwitchList::sizeHint() const {
  return {180, kSetRow * std::max(1, static_cast<int>(rows_.size()))};
}

void SwitchList::setRows(std::vector<Row> rows) {
  endRename(false);
  rows_ = std::move(rows);
  current_ = rows_.empty() ? -1 : std::clamp(current_, 0, static_cast<int>(rows_.size()) - 1);
  updateGeometry();
  update();
}

void SwitchList::setAlerts(const std::map<QString, int>& alerts) {
  if (alerts == alerts_) return;
  alerts_ = alerts;
  update();
}

void SwitchList::setCurrent(int index) {
  if (index < 0 || index >= static_cast<int>(rows_.size()) || index == current_) return;
  current_ = index;
  setAccessibleDescription(rows_[static_cast<std::size_t>(index)].name);
  update();
  emit chosen(index);
}

void SwitchList::paintEvent(QPaintEvent*) {
  const Theme& theme = themeOf(palette());
  QPainter painter(this);
  painter.setFont(textFont(TextRole::kText));
  if (rows_.empty()) {
    painter.setPen(theme.text2);
    painter.drawText(rect().adjusted(12, 0, -4, 0), Qt::AlignVCenter, empty_);
  }
  for (int i = 0; i < static_cast<int>(rows_.size()); ++i) {
    const Row& row = rows_[static_cast<std::size_t>(i)];
    const QRect line(0, i * kSetRow, width(), kSetRow);
    if (i == current_) {
      painter.fillRect(line, theme.selected_row);
      painter.fillRect(QRect(0, line.top(), 2, kSetRow), theme.selection);
    }
    QStyleOption option;
    option.rect = QRect(12, line.center().y() - 7, 30, 16);
    option.palette = palette();
    option.state = QStyle::State_Enabled | (row.on ? QStyle::State_On : QStyle::State_Off);
    drawSwitch(&painter, &option);
    painter.setPen(row.on ? theme.text1 : theme.text3);
    QRect words = line.adjusted(52, 0, -12, 0);
    if (const auto alerts = alerts_.find(row.name); alerts != alerts_.end() && alerts->second > 0) {
      painter.setPen(theme.text2);
      painter.drawText(words, Qt::AlignVCenter | Qt::AlignRight, QString::number(alerts->second));
      words.adjust(0, 0, -22, 0);
      painter.setPen(row.on ? theme.text1 : theme.text3);
    }
    painter.drawText(words, Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(row.name, Qt::ElideRight, words.width()));
  }
}

void SwitchList::mousePressEvent(QMouseEvent* event) {
  const int row = event->pos().y() / kSetRow;
  if (event->button() != Qt::LeftButton || row < 0 || row >= static_cast<int>(rows_.size())) return;
  setCurrent(row);
  if (event->pos().x() < kSwitchRoom) emit switched(row, !rows_[static_cast<std::size_t>(row)].on);
}

void SwitchList::mouseDoubleClickEvent(QMouseEvent* event) {
  const int row = event->pos().y() / kSetRow;
  const bool on_name = event->button() == Qt::LeftButton && event->pos().x() >= kSwitchRoom;
  if (!on_name || row < 0 || row >= static_cast<int>(rows_.size())) return mousePressEvent(event);
  rename(row);
}

void SwitchList::rename(int index) {
  endRename(false);
  renamed_row_ = index;
  field_ = new QLineEdit(rows_[static_cast<std::size_t>(index)].name, this);
  field_->setObjectName("fieldRename");
  field_->setAccessibleName(tr("Name"));
  field_->setGeometry(kSwitchRoom, index * kSetRow, width() - kSwitchRoom - 4, kSetRow);
  field_->selectAll();
  field_->installEventFilter(this);
  field_->show();
  field_->setFocus();
}

void SwitchList::endRename(bool keep) {
  QLineEdit* const field = std::exchange(field_, nullptr);
  if (!field) return;
  const QString name = field->text().trimmed();
  field->hide();
  field->deleteLater();
  const bool there = renamed_row_ < static_cast<int>(rows_.size());
  if (keep && there && !name.isEmpty() && name != rows_[static_cast<std::size_t>(renamed_row_)].name)
    emit renamed(renamed_row_, name);
}

bool SwitchList::eventFilter(QObject* watched, QEvent* event) {
  if (watched != field_) return QWidget::eventFilter(watched, event);
  if (event->type() == QEvent::FocusOut) endRename(true);
  if (event->type() != QEvent::KeyPress) return false;
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (key != Qt::Key_Return && key != Qt::Key_Enter && key != Qt::Key_Escape) return false;
  endRename(key != Qt::Key_Escape);
  setFocus();
  return true;  // Enter must not switch the row too.
}

/// As lists of Qt do: what is typed in one go is the beginning of a name.
void SwitchList::search(const QString& typed) {
  const bool goes_on = since_typed_.isValid() && since_typed_.elapsed() < QApplication::keyboardInputInterval();
  searched_ = goes_on ? searched_ + typed : typed;
  since_typed_.start();
  const int count = static_cast<int>(rows_.size());
  for (int step = goes_on ? 0 : 1; step <= count && count > 0; ++step) {
    const int row = (std::max(0, current_) + step) % count;
    if (rows_[static_cast<std::size_t>(row)].name.startsWith(searched_, Qt::CaseInsensitive)) return setCurrent(row);
  }
}

void SwitchList::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_F2 && current_ >= 0) return rename(current_);
  if (isTypedKey(event->key(), event->modifiers()) && !event->text().trimmed().isEmpty()) return search(event->text());
  const int step = keyStep(event->key(), Qt::Key_Up, Qt::Key_Down);
  if (step != 0) return setCurrent(current_ + step);
  if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && current_ >= 0)
    return emit switched(current_, !rows_[static_cast<std::size_t>(current_)].on);
  QWidget::keyPressEvent(event);
}

}  // namespace hapticell::app
