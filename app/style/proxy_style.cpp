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
      if (isLargeSwitch(widget)) return 54;
      return isSwitch(widget) ? kSwitchWidth : 16;
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

}  // namespace hapticell::app
