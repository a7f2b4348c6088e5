// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/device_check_panel.h"

#include <QPainter>

#include "app/style/fonts.h"
#include "app/style/icon.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

constexpr int kCheckRow = 72;

}  // namespace

DeviceCheckPanel::DeviceCheckPanel(QWidget* parent) : QWidget(parent) {
  setObjectName("deviceCheck");
  setMinimumWidth(320);
}

void DeviceCheckPanel::setChecks(std::vector<DeviceCheck> checks) {
  checks_ = std::move(checks);
  setMinimumHeight(static_cast<int>(checks_.size()) * kCheckRow + 8);
  QStringList words;
  for (const DeviceCheck& check : checks_) words << check.title + QStringLiteral(": ") + check.detail;
  setAccessibleDescription(words.join(QStringLiteral(". ")));
  update();
}

QSize DeviceCheckPanel::sizeHint() const {
  return {340, static_cast<int>(checks_.size()) * kCheckRow + 8};
}

void DeviceCheckPanel::paintEvent(QPaintEvent*) {
  const Theme& theme = themeOf(palette());
  QPainter painter(this);
  int top = 4;
  for (const DeviceCheck& check : checks_) {
    using Result = DeviceCheck::Result;
    const char* mark = check.result == Result::kGood      ? "check"
                       : check.result == Result::kProblem ? "crossed"
                       : check.result == Result::kWarning ? "warning"
                                                          : "info";
    const QColor color = check.result == Result::kGood      ? theme.axis_z
                         : check.result == Result::kProblem ? theme.contact
                         : check.result == Result::kWarning ? theme.near_miss
                                                            : theme.text3;
    icon(mark, color).paint(&painter, QRect(12, top + 10, 20, 20));
    painter.setFont(textFont(TextRole::kSection));
    painter.setPen(theme.text1);
    painter.drawText(QRect(44, top + 6, width() - 56, 20), Qt::AlignVCenter, check.title);
    painter.setFont(textFont(TextRole::kSecond));
    painter.setPen(theme.text2);
    painter.drawText(QRect(44, top + 26, width() - 56, 44), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap,
                     check.detail);
    painter.fillRect(QRect(12, top + kCheckRow - 1, width() - 24, 1), theme.line);
    top += kCheckRow;
  }
}

}  // namespace hapticell::app
