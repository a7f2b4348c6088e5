// SPDX-License-Identifier: Apache-2.0
#include "app/style/dock_title_bar.h"

#include <QDockWidget>
#include <QHBoxLayout>
#include <QPainter>
#include <QToolButton>

#include "app/style/fonts.h"
#include "app/style/icon.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

constexpr int kTitleHeight = 28;

QToolButton* makeButton(QWidget* parent, const QString& icon_name, const QString& name, const QString& tip) {
  auto* button = new QToolButton(parent);
  button->setIcon(icon(icon_name));
  button->setIconSize(QSize(14, 14));
  button->setFixedSize(20, 20);
  button->setAutoRaise(true);
  button->setProperty("quiet", true);
  button->setObjectName(name);
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

}  // namespace

DockTitleBar::DockTitleBar(QDockWidget* dock) : QWidget(dock), dock_(dock) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 0, 6, 0);
  row->setSpacing(2);
  row->addStretch(1);
  auto* floating = makeButton(this, "float", "buttonFloat", tr("Undock or dock"));
  auto* close = makeButton(this, "close", "buttonClose", tr("Close the panel; the Window menu opens it again"));
  row->addWidget(floating);
  row->addWidget(close);
  connect(floating, &QToolButton::clicked, dock, [dock] { dock->setFloating(!dock->isFloating()); });
  connect(close, &QToolButton::clicked, dock, &QDockWidget::close);
  connect(dock, &QDockWidget::windowTitleChanged, this, [this] { update(); });
}

QSize DockTitleBar::sizeHint() const { return {120, property("folded").toBool() ? 0 : kTitleHeight}; }
QSize DockTitleBar::minimumSizeHint() const { return {80, property("folded").toBool() ? 0 : kTitleHeight}; }

void DockTitleBar::paintEvent(QPaintEvent*) {
  const Theme& theme = themeOf(palette());
  QPainter painter(this);
  painter.fillRect(rect(), theme.header);
  painter.fillRect(QRect(0, height() - 1, width(), 1), theme.line);
  painter.setPen(theme.text1);
  painter.setFont(textFont(TextRole::kDockTitle));
  const QRect text_rect = rect().adjusted(12, 0, -52, 0);
  painter.drawText(text_rect, Qt::AlignVCenter | Qt::AlignLeft,
                   painter.fontMetrics().elidedText(dock_->windowTitle(), Qt::ElideRight, text_rect.width()));
}

QDockWidget* makeDock(const QString& name, const QString& title, QWidget* content) {
  auto* dock = new QDockWidget(title);
  dock->setObjectName(name);
  dock->setWidget(content);
  dock->setTitleBarWidget(new DockTitleBar(dock));
  dock->setAccessibleName(title);
  return dock;
}

}  // namespace hapticell::app
