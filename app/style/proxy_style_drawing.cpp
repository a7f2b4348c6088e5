// SPDX-License-Identifier: Apache-2.0
// How the style draws.
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QHeaderView>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QScrollBar>
#include <QSlider>
#include <QStyleOption>
#include <QTabBar>

#include "app/style/proxy_style.h"
#include "app/style/style_painting.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

/// What is on or off is a switch everywhere; square boxes are for rows of a list that are taken or not.
bool drawsSwitch(const QWidget* widget) {
  return qobject_cast<const QCheckBox*>(widget);
}

bool drawsCompact(const QWidget* widget) {
  return widget && widget->property("compact").toBool();
}

QColor fieldFrame(const QStyleOption* option) {
  const Theme& theme = themeOf(option->palette);
  return option->state.testFlag(QStyle::State_HasFocus) ? theme.selection : theme.line;
}

}  // namespace

void ProxyStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                               const QWidget* widget) const {
  const Theme& theme = themeOf(option->palette);
  switch (element) {
    case PE_PanelButtonCommand:
    case PE_PanelButtonTool:
      drawButtonPanel(painter, option, widget);
      return;
    case PE_FrameDefaultButton:
      return;
    case PE_IndicatorCheckBox:
      if (drawsSwitch(widget))
        drawSwitch(painter, option);
      else
        drawIndicator(painter, option, false);
      return;
    case PE_IndicatorItemViewItemCheck:
      drawIndicator(painter, option, false);
      return;
    case PE_IndicatorRadioButton:
      drawIndicator(painter, option, true);
      return;
    case PE_PanelLineEdit:
      if (const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(option); frame && frame->lineWidth > 0)
        drawBox(painter, option->rect, theme.field, fieldFrame(option));
      return;
    case PE_FrameFocusRect:
      painter->save();
      painter->setRenderHint(QPainter::Antialiasing);
      painter->setPen(QPen(theme.selection, 2.0));
      painter->drawRoundedRect(QRectF(option->rect).adjusted(1, 1, -1, -1), kRadius, kRadius);
      painter->restore();
      return;
    case PE_PanelItemViewRow:
      return;
    case PE_PanelItemViewItem: {
      const auto* item = qstyleoption_cast<const QStyleOptionViewItem*>(option);
      const bool selected = option->state.testFlag(State_Selected);
      const bool hover = option->state.testFlag(State_MouseOver);
      if (selected)
        painter->fillRect(option->rect, theme.selected_row);
      else if (hover)
        painter->fillRect(option->rect, theme.header);
      else if (item && item->backgroundBrush.style() != Qt::NoBrush)
        painter->fillRect(option->rect, item->backgroundBrush);
      return;
    }
    case PE_IndicatorDockWidgetResizeHandle:
      painter->fillRect(option->rect, theme.line);
      return;
    case PE_FrameDockWidget:
      painter->setPen(theme.line);
      painter->setBrush(Qt::NoBrush);
      painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
      return;
    case PE_IndicatorTabClose:
    case PE_FrameStatusBarItem:
    case PE_FrameTabBarBase:
      return;
    case PE_PanelMenu:
      drawBox(painter, option->rect, theme.header, theme.line, 0.0);
      return;
    case PE_FrameMenu:
      return;
    case PE_PanelStatusBar:
    case PE_PanelMenuBar:
      painter->fillRect(option->rect, theme.window);
      return;
    case PE_IndicatorBranch: {
      if (!option->state.testFlag(State_Children)) return;
      painter->save();
      painter->translate(QRectF(option->rect).center());
      if (!option->state.testFlag(State_Open)) painter->rotate(-90);
      drawChevron(painter, QRect(-8, -8, 16, 16), theme.text2);
      painter->restore();
      return;
    }
    default:
      QProxyStyle::drawPrimitive(element, option, painter, widget);
  }
}

void ProxyStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                             const QWidget* widget) const {
  const Theme& theme = themeOf(option->palette);
  switch (element) {
    case CE_TabBarTabShape:
      if (const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option)) drawTabShape(painter, tab);
      return;
    case CE_TabBarTabLabel:
      if (const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option))
        drawTabLabel(painter, tab, drawsCompact(widget) && !tab->icon.isNull());
      return;
    case CE_ItemViewItem:
      if (const auto* item = qstyleoption_cast<const QStyleOptionViewItem*>(option)) {
        // The row that is chosen has a pale ground: its words keep their colour.
        QStyleOptionViewItem quiet(*item);
        quiet.palette.setColor(QPalette::HighlightedText, item->palette.color(QPalette::Text));
        QProxyStyle::drawControl(element, &quiet, painter, widget);
      }
      return;
    case CE_MenuBarEmptyArea:
      painter->fillRect(option->rect, theme.window);
      return;
    case CE_MenuBarItem: {
      const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option);
      const bool active = option->state.testFlag(State_Selected) || option->state.testFlag(State_Sunken);
      painter->fillRect(option->rect, active ? theme.selected_row : theme.window);
      painter->setPen(option->state.testFlag(State_Enabled) ? theme.text1 : theme.text3);
      painter->drawText(option->rect, Qt::AlignCenter | Qt::TextShowMnemonic | Qt::TextHideMnemonic,
                        item ? item->text : QString());
      return;
    }
    case CE_ToolBar: {
      painter->fillRect(option->rect, theme.window);
      painter->fillRect(QRect(option->rect.left(), option->rect.bottom(), option->rect.width(), 1), theme.line);
      return;
    }
    case CE_Splitter:
      painter->fillRect(option->rect, theme.line);
      return;
    case CE_PushButtonLabel: {
      const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
      if (!button) break;
      const QStyleOptionButton label = buttonLabel(*button, widget);
      QProxyStyle::drawControl(element, &label, painter, widget);
      return;
    }
    case CE_HeaderSection: {
      painter->fillRect(option->rect, theme.header);
      painter->fillRect(QRect(option->rect.left(), option->rect.bottom(), option->rect.width(), 1), theme.line);
      return;
    }
    case CE_HeaderLabel:
      if (const auto* header = qstyleoption_cast<const QStyleOptionHeader*>(option)) {
        QStyleOptionHeader label = *header;
        label.rect.adjust(kHeaderMargin, -4, -kHeaderMargin, 4);
        QProxyStyle::drawControl(element, &label, painter, widget);
        return;
      }
      break;
    case CE_ComboBoxLabel:
      if (const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option)) {
        QStyleOptionComboBox shown = *box;
        const int icon = box->currentIcon.isNull() ? 0 : box->iconSize.width() + 4;
        const int room = subControlRect(CC_ComboBox, box, SC_ComboBoxEditField, widget).width() - icon - 2;
        shown.currentText = box->fontMetrics.elidedText(box->currentText, Qt::ElideRight, room);
        QProxyStyle::drawControl(element, &shown, painter, widget);
        return;
      }
      break;
    case CE_ProgressBarGroove:
      drawBox(painter, option->rect, theme.field, theme.line, 2.0);
      return;
    default:
      break;
  }
  QProxyStyle::drawControl(element, option, painter, widget);
}

void ProxyStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                                    const QWidget* widget) const {
  const Theme& theme = themeOf(option->palette);
  if (control == CC_ComboBox) {
    const bool enabled = option->state.testFlag(State_Enabled);
    const bool hover = option->state.testFlag(State_MouseOver) && enabled;
    QColor fill = enabled ? theme.button : theme.dock;
    if (hover) fill = theme.dark ? fill.lighter(112) : fill.darker(104);
    drawBox(painter, option->rect, fill, fieldFrame(option));
    drawChevron(painter, subControlRect(control, option, SC_ComboBoxArrow, widget),
                enabled ? theme.text1 : theme.text3);
    return;
  }
  if (control == CC_SpinBox) {
    const auto* box = qstyleoption_cast<const QStyleOptionSpinBox*>(option);
    if (box && box->buttonSymbols == QAbstractSpinBox::NoButtons) {
      drawBox(painter, option->rect, option->state.testFlag(State_Enabled) ? theme.field : theme.dock,
              fieldFrame(option));
      return;
    }
  }
  if (control == CC_ScrollBar) {
    if (const auto* bar = qstyleoption_cast<const QStyleOptionSlider*>(option))
      drawScrollBar(painter, bar, subControlRect(control, option, SC_ScrollBarSlider, widget));
    return;
  }
  QProxyStyle::drawComplexControl(control, option, painter, widget);
}

}  // namespace hapticell::app
