// SPDX-License-Identifier: Apache-2.0
#include "app/shell/window_keys.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <algorithm>
#include <vector>

#include "app/kit/action_face.h"
#include "app/kit/command_finder.h"
#include "app/kit/key_overlay.h"

namespace hapticell::app {
namespace {

/// Docks that are seen, from top left to bottom right, then the scene.
std::vector<QWidget*> panels(const QMainWindow& window, QWidget& scene) {
  std::vector<QWidget*> result;
  for (QDockWidget* dock : window.findChildren<QDockWidget*>())
    if (dock->isVisible() && !dock->visibleRegion().isEmpty()) result.push_back(dock);
  const auto place = [&](const QWidget* widget) { return widget->mapTo(&window, QPoint(0, 0)); };
  std::sort(result.begin(), result.end(), [&](const QWidget* a, const QWidget* b) {
    const QPoint p = place(a), q = place(b);
    return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y();
  });
  result.push_back(&scene);
  return result;
}

bool takesFocus(const QWidget* widget) {
  return widget->isVisible() && widget->isEnabled() && (widget->focusPolicy() & Qt::TabFocus) == Qt::TabFocus;
}

void focusOn(QWidget& panel) {
  if (takesFocus(&panel)) return panel.setFocus(Qt::ShortcutFocusReason);
  for (QWidget* child : panel.findChildren<QWidget*>()) {
    if (!takesFocus(child) || child->visibleRegion().isEmpty()) continue;
    return child->setFocus(Qt::ShortcutFocusReason);
  }
}

void goToPanel(const QMainWindow& window, QWidget& scene, int step) {
  const std::vector<QWidget*> all = panels(window, scene);
  const int count = static_cast<int>(all.size());
  const QWidget* focus = QApplication::focusWidget();
  int now = count - 1;
  for (int i = 0; i < count; ++i)
    if (focus && (all[static_cast<std::size_t>(i)] == focus || all[static_cast<std::size_t>(i)]->isAncestorOf(focus)))
      now = i;
  focusOn(*all[static_cast<std::size_t>((now + step + count) % count)]);
}

}  // namespace

void addWindowKeys(QMainWindow& window, QWidget& scene) {
  auto* finder = new CommandFinder(window);
  auto* keys = new KeyOverlay(window, scene);
  const auto add = [&window](const ActionFace& face, auto&& slot) {
    QAction* action = makeAction(&window, face);
    window.addAction(action);
    QObject::connect(action, &QAction::triggered, &window, slot);
    return action;
  };
  add({"actionFindCommand", QObject::tr("Find a command"), "search", QKeySequence(Qt::CTRL | Qt::Key_K), {}},
      [finder] { finder->open(); });
  // With Shift on most keyboards, without it on some.
  add({"actionKeys", QObject::tr("Show keyboard shortcuts"), {}, QKeySequence(Qt::Key_Question), {}}, [keys] {
    keys->toggle();
  })->setShortcuts({QKeySequence(Qt::Key_Question), QKeySequence(Qt::SHIFT | Qt::Key_Question)});
  add({"actionNextPanel", QObject::tr("Next panel"), {}, QKeySequence(Qt::Key_F6), {}},
      [&window, &scene] { goToPanel(window, scene, 1); });
  add({"actionLastPanel", QObject::tr("Previous panel"), {}, QKeySequence(Qt::SHIFT | Qt::Key_F6), {}},
      [&window, &scene] { goToPanel(window, scene, -1); });
}

}  // namespace hapticell::app
