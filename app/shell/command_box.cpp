// SPDX-License-Identifier: Apache-2.0
#include "app/shell/command_box.h"

#include <QAction>
#include <QPainter>

#include "app/style/fonts.h"
#include "app/style/icon.h"
#include "app/style/style_painting.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

constexpr int kWidth = 220, kBoxHeight = 22, kIcon = 14, kBoxPadding = 8;

}  // namespace

CommandBox::CommandBox(QAction& action, QWidget* parent) : QAbstractButton(parent) {
  setObjectName("buttonFindCommand");
  setFocusPolicy(Qt::NoFocus);  // Its key does the same.
  setAttribute(Qt::WA_Hover);
  setCursor(Qt::IBeamCursor);
  setFont(textFont(TextRole::kSecond));
  setFixedSize(kWidth, kBoxHeight);
  const auto show = [this, &action] {
    setText(action.iconText());
    setAccessibleName(action.iconText());
    setToolTip(action.toolTip());
    key_ = action.shortcut().toString(QKeySequence::NativeText);
    update();
  };
  connect(&action, &QAction::changed, this, show);
  connect(this, &QAbstractButton::clicked, &action, &QAction::trigger);
  show();
}

QSize CommandBox::sizeHint() const {
  return {kWidth, kBoxHeight};
}

void CommandBox::paintEvent(QPaintEvent*) {
  const Theme& theme = themeOf(palette());
  QPainter painter(this);
  drawBox(&painter, rect(), theme.field, underMouse() ? theme.text3 : theme.line);
  app::icon("search", theme.text2).paint(&painter, QRect(kBoxPadding, (height() - kIcon) / 2, kIcon, kIcon));
  painter.setFont(font());
  painter.setPen(theme.text2);
  painter.drawText(rect().adjusted(kBoxPadding + kIcon + 6, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, text());
  if (key_.isEmpty()) return;
  painter.setFont(textFont(TextRole::kKeyCap));
  painter.setPen(theme.text3);
  painter.drawText(rect().adjusted(0, 0, -kBoxPadding, 0), Qt::AlignVCenter | Qt::AlignRight, key_);
}

}  // namespace hapticell::app
