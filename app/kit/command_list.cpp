// SPDX-License-Identifier: Apache-2.0
#include "app/kit/command_list.h"

#include <QAbstractButton>
#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QListWidget>
#include <QMainWindow>
#include <QMenu>
#include <QScrollArea>
#include <QStackedWidget>
#include <set>

#include "app/kit/dock_front.h"
#include "app/style/dock_title_bar.h"

namespace hapticell::app {
namespace {

QString withoutMarks(QString text) {
  return text.remove('&').remove(QChar(0x2026)).simplified();
}

/// The pages of a dock that are chosen in a list beside them; else null: what chooses a page is found itself.
QListWidget* listOfPages(const QStackedWidget& pages) {
  for (QListWidget* list : pages.parentWidget()->findChildren<QListWidget*>(Qt::FindDirectChildrenOnly))
    if (list->count() == pages.count()) return list;
  return nullptr;
}

/// It is seen when its dock is, or when its page is chosen in the list beside it.
bool canBeShown(const QWidget& widget, const QDockWidget& dock) {
  const QWidget* at = &widget;
  for (; at != &dock; at = at->parentWidget()) {
    if (!at) return false;
    if (at->parentWidget() == &dock) return true;
    // What was never shown counts as hidden, too; only what was hidden on purpose is meant.
    if (!at->isHidden() || !at->testAttribute(Qt::WA_WState_ExplicitShowHide)) continue;
    const auto* pages = qobject_cast<const QStackedWidget*>(at->parentWidget());
    if (!pages || !listOfPages(*pages)) return false;
  }
  return true;
}

bool isOfTitleBar(const QWidget& widget) {
  if (widget.objectName().startsWith(QLatin1String("qt_dockwidget_"))) return true;  // Qt's own, of a dock without ours.
  for (const QWidget* at = &widget; at; at = at->parentWidget())
    if (qobject_cast<const DockTitleBar*>(at)) return true;
  return false;
}

QString nameOf(const QAbstractButton& button) {
  for (const QString& name : {button.text(), button.accessibleName(), button.toolTip().section('\n', 0, 0)})
    if (const QString plain = withoutMarks(name); !plain.isEmpty()) return plain;
  return {};
}

void appendActions(const QMainWindow& window, std::vector<Command>& commands) {
  std::set<const QAction*> of_docks;
  for (const QDockWidget* dock : window.findChildren<QDockWidget*>()) of_docks.insert(dock->toggleViewAction());
  for (QAction* action : window.findChildren<QAction*>()) {
    const QString words = withoutMarks(action->text());
    if (!action->isEnabled() || !action->isVisible() || action->isSeparator() || action->menu() || words.isEmpty() ||
        of_docks.count(action))
      continue;
    commands.push_back({words, {}, action->shortcut().toString(QKeySequence::NativeText), action->icon(), action});
  }
}

void appendPanel(QDockWidget& dock, std::vector<Command>& commands) {
  const QString title = withoutMarks(dock.windowTitle());
  if (title.isEmpty()) return;
  commands.push_back({title, QObject::tr("Panel"), {}, dock.windowIcon(), &dock});
  for (QAbstractButton* button : dock.findChildren<QAbstractButton*>()) {
    if (!button->isEnabled() || isOfTitleBar(*button) || !canBeShown(*button, dock)) continue;
    if (const QString name = nameOf(*button); !name.isEmpty())
      commands.push_back({name, title, {}, button->icon(), button});
  }
  for (const QLabel* label : dock.findChildren<QLabel*>()) {
    QWidget* field = label->buddy();
    if (!field || qobject_cast<QAbstractButton*>(field) || !field->isEnabled() || !canBeShown(*field, dock)) continue;
    if (const QString name = withoutMarks(label->text()); !name.isEmpty())
      commands.push_back({name, title, {}, {}, field});
  }
}

void showWidget(QMainWindow& window, QWidget& widget) {
  for (QWidget* at = &widget; at && at != &window; at = at->parentWidget()) {
    if (auto* pages = qobject_cast<QStackedWidget*>(at->parentWidget()))
      if (QListWidget* list = listOfPages(*pages)) list->setCurrentRow(pages->indexOf(at));
    if (auto* dock = qobject_cast<QDockWidget*>(at)) {
      bringToFront(dock);
      if (dock->isFloating()) dock->activateWindow();
    }
  }
  for (QWidget* at = widget.parentWidget(); at && at != &window; at = at->parentWidget())
    if (auto* scroll = qobject_cast<QScrollArea*>(at)) scroll->ensureWidgetVisible(&widget);
  if (widget.focusPolicy() != Qt::NoFocus) widget.setFocus(Qt::ShortcutFocusReason);
}

}  // namespace

std::vector<Command> commandsNow(const QMainWindow& window) {
  std::vector<Command> commands;
  appendActions(window, commands);
  for (QDockWidget* dock : window.findChildren<QDockWidget*>()) appendPanel(*dock, commands);
  return commands;
}

void runCommand(QMainWindow& window, QObject& target) {
  if (auto* action = qobject_cast<QAction*>(&target)) return action->trigger();
  auto* widget = qobject_cast<QWidget*>(&target);
  if (!widget) return;
  showWidget(window, *widget);
  if (auto* dock = qobject_cast<QDockWidget*>(widget); dock && dock->widget()) dock->widget()->setFocus();
  if (auto* button = qobject_cast<QAbstractButton*>(widget); button && button->isEnabled()) button->click();
}

}  // namespace hapticell::app
