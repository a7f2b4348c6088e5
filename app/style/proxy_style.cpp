// SPDX-License-Identifier: Apache-2.0
#include "app/style/proxy_style.h"

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
#include <QStyleFactory>
#include <QStyleOption>
#include <QTabBar>

#include "app/style/icon.h"
#include "app/style/style_painting.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

constexpr int kSwitchWidth = 30;
constexpr int kSwitchHeight = 16;

/// What is on or off is a switch everywhere; square boxes are for rows of a list that are taken or not.
bool isSwitch(const QWidget* widget) {
  return qobject_cast<const QCheckBox*>(widget);
}

bool isLargeSwitch(const QWidget* widget) {
  return widget && widget->property("switch").toString() == "large";
}

bool isCompact(const QWidget* widget) {
  return widget && widget->property("compact").toBool();
}

QColor fieldFrame(const QStyleOption* option) {
  const Theme& theme = themeOf(option->palette);
  return option->state.testFlag(QStyle::State_HasFocus) ? theme.selection : theme.line;
}

}  // namespace

ProxyStyle::ProxyStyle() : QProxyStyle(QStyleFactory::create("Fusion")) {}

void ProxyStyle::polish(QWidget* widget) {
  QProxyStyle::polish(widget);
  if (qobject_cast<QAbstractButton*>(widget) || qobject_cast<QComboBox*>(widget) || qobject_cast<QScrollBar*>(widget) ||
      qobject_cast<QTabBar*>(widget))
    widget->setAttribute(Qt::WA_Hover);
  if (qobject_cast<QSlider*>(widget) || qobject_cast<QComboBox*>(widget)) widget->installEventFilter(this);
  // A wheel that gave the focus first would set what it only passes over.
  if (widget->focusPolicy() == Qt::WheelFocus) widget->setFocusPolicy(Qt::StrongFocus);
  // Above the words of its column, where the model does not say otherwise.
  if (auto* header = qobject_cast<QHeaderView*>(widget)) header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

bool ProxyStyle::eventFilter(QObject* watched, QEvent* event) {
  const auto* widget = qobject_cast<const QWidget*>(watched);
  if (event->type() != QEvent::Wheel || !widget || widget->hasFocus()) return QProxyStyle::eventFilter(watched, event);
  event->ignore();  // What holds it gets it.
  return true;
}

/// Qt's own dialogs have the program's icons.
QIcon ProxyStyle::standardIcon(StandardPixmap which, const QStyleOption* option, const QWidget* widget) const {
  const Theme& theme = themeOf(QApplication::palette());
  switch (which) {
    case SP_MessageBoxQuestion:
      return icon("help", theme.selection);
    case SP_MessageBoxInformation:
      return icon("info", theme.selection);
    case SP_MessageBoxWarning:
      return icon("warning", theme.near_miss);
    case SP_MessageBoxCritical:
      return icon("crossed", theme.contact);
    case SP_FileDialogBack:
    case SP_ArrowBack:
    case SP_ArrowLeft:
      return icon("left");
    case SP_ArrowForward:
    case SP_ArrowRight:
      return icon("right");
    case SP_FileDialogToParent:
    case SP_ArrowUp:
      return icon("up");
    case SP_FileDialogNewFolder:
      return icon("plus");
    case SP_FileDialogListView:
      return icon("grid");
    case SP_FileDialogDetailedView:
      return icon("text");
    case SP_DirIcon:
    case SP_DirOpenIcon:
    case SP_DirClosedIcon:
    case SP_DirLinkIcon:
      return icon("folder");
    case SP_FileIcon:
    case SP_FileLinkIcon:
      return icon("new");
    case SP_DirHomeIcon:
    case SP_DesktopIcon:
      return icon("home");
    case SP_ComputerIcon:
    case SP_DriveHDIcon:
    case SP_DriveNetIcon:
      return icon("cell");
    default:
      return QProxyStyle::standardIcon(which, option, widget);
  }
}

int ProxyStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const {
  switch (metric) {
    case PM_SmallIconSize:
      return 16;
    case PM_ToolBarIconSize:
      return 20;
    case PM_IndicatorWidth:
      return isLargeSwitch(widget) ? 54 : isSwitch(widget) ? kSwitchWidth : 16;
    case PM_IndicatorHeight:
      return isLargeSwitch(widget) ? 28 : kSwitchHeight;
    case PM_CheckBoxLabelSpacing:
      return 8;
    case PM_MessageBoxIconSize:
      return 32;
    case PM_DockWidgetSeparatorExtent:
    case PM_SplitterWidth:
      return 1;
    case PM_ScrollBarExtent:
      return 12;
    case PM_ScrollBarSliderMin:
      return 28;
    case PM_DockWidgetFrameWidth:
      return 1;  // Of floating ones.
    case PM_FocusFrameHMargin:
      return qobject_cast<const QListView*>(widget) ? 7 : 3;
    case PM_ToolBarFrameWidth:
    case PM_TabBarTabShiftVertical:
    case PM_TabBarTabShiftHorizontal:
    case PM_TabBarTabOverlap:
    case PM_TabBarBaseHeight:
    case PM_TabBarBaseOverlap:
      return 0;
    case PM_ToolBarItemSpacing:
      return 2;
    case PM_ToolBarItemMargin:
      return 4;
    case PM_TabBarTabHSpace:
      return 28;
    case PM_TabBarTabVSpace:
      return 12;
    case PM_DefaultFrameWidth:
      return qobject_cast<const QAbstractItemView*>(widget) ? 0 : 1;
    case PM_ButtonShiftHorizontal:
    case PM_ButtonShiftVertical:
      return 0;
    case PM_TreeViewIndentation:
      return 18;
    default:
      return QProxyStyle::pixelMetric(metric, option, widget);
  }
}

int ProxyStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                          QStyleHintReturn* data) const {
  switch (hint) {
    case SH_UnderlineShortcut:
      return 0;
    case SH_ToolTip_WakeUpDelay:
      return 500;
    case SH_ComboBox_Popup:
      return 0;
    case SH_TabBar_Alignment:
      return Qt::AlignLeft;
    case SH_DialogButtonBox_ButtonsHaveIcons:
    case SH_EtchDisabledText:
    case SH_DitherDisabledText:
      return 0;
    default:
      return QProxyStyle::styleHint(hint, option, widget, data);
  }
}

QSize ProxyStyle::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                                   const QWidget* widget) const {
  QSize result = QProxyStyle::sizeFromContents(type, option, size, widget);
  switch (type) {
    case CT_PushButton:
    case CT_ComboBox:
    case CT_LineEdit:
    case CT_SpinBox:
      result.setHeight(kFieldHeight);
      break;
    case CT_MenuBarItem:
      result = QSize(size.width() + 16, 28);
      break;
    case CT_MenuItem: {
      const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option);
      if (item && item->menuItemType != QStyleOptionMenuItem::Separator) result.setHeight(qMax(result.height(), 26));
      break;
    }
    case CT_TabBarTab: {
      const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option);
      if (!tab || tab->icon.isNull() || !isCompact(widget)) break;
      // Where there is no room for all names the chosen tab has its name, the others their icons.
      const bool chosen = tab->state.testFlag(State_Selected);
      const QString words = plainTabText(tab->text);
      const int name = tab->fontMetrics.horizontalAdvance(words) + 28;
      result.setWidth(chosen ? qMin(name, widget->property("chosenTab").toInt()) : widget->property("iconTab").toInt());
      break;
    }
    case CT_ItemViewItem:
      result.setHeight(qMax(result.height(), kRowHeight));
      break;
    case CT_HeaderSection:
      result = QSize(result.width() + 2 * kHeaderMargin, kFieldHeight);
      break;
    case CT_ToolButton: {
      const auto* button = qstyleoption_cast<const QStyleOptionToolButton*>(option);
      if (button && button->toolButtonStyle == Qt::ToolButtonTextUnderIcon)
        result = QSize(qMax(size.width() + 12, 52), 48);
      break;
    }
    default:
      break;
  }
  return result;
}

QRect ProxyStyle::subElementRect(SubElement element, const QStyleOption* option, const QWidget* widget) const {
  const QRect rect = QProxyStyle::subElementRect(element, option, widget);
  const auto* line = element == SE_LineEditContents ? qobject_cast<const QLineEdit*>(widget) : nullptr;
  // Words stand as far from the frame as in a combo box; numbers stand at the right, by their unit.
  return line && line->alignment().testFlag(Qt::AlignLeft) ? rect.adjusted(4, 0, 0, 0) : rect;
}

QRect ProxyStyle::subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part,
                                 const QWidget* widget) const {
  if (control == CC_ComboBox) {
    const QRect r = option->rect;
    if (part == SC_ComboBoxEditField) return r.adjusted(8, 1, -24, -1);
    if (part == SC_ComboBoxArrow) return QRect(r.right() - 23, r.top(), 22, r.height());
    if (part == SC_ComboBoxListBoxPopup) return choiceList(r, qobject_cast<const QComboBox*>(widget));
  }
  if (control == CC_ScrollBar) {
    const auto* bar = qstyleoption_cast<const QStyleOptionSlider*>(option);
    return bar ? scrollBarPart(*bar, part) : QRect();
  }
  return QProxyStyle::subControlRect(control, option, part, widget);
}

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
      if (isSwitch(widget))
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
        drawTabLabel(painter, tab, isCompact(widget) && !tab->icon.isNull());
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
