// SPDX-License-Identifier: Apache-2.0
#include "app/settings/settings_dock.h"

#include <QAction>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QListWidget>
#include <QScrollArea>
#include <QStackedWidget>

#include "app/kit/command_finder.h"
#include "app/host/host.h"
#include "app/kit/dock_front.h"
#include "app/kit/form.h"
#include "app/settings/key_map.h"
#include "app/settings/settings_pages.h"
#include "app/settings/user_choices.h"
#include "app/style/dock_title_bar.h"
#include "app/style/icon.h"

namespace hapticell::app {
namespace {

constexpr int kWidth = 640, kHeight = 520, kList = 148;

QWidget* makeSettings(Host& host, KeyMap& keys) {
  auto* all = new QWidget;
  auto* row = new QHBoxLayout(all);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  auto* list = new QListWidget;
  list->setObjectName("listSettings");
  list->setAccessibleName(QObject::tr("Pages of the settings"));
  list->setFixedWidth(kList);
  auto* pages = new QStackedWidget;
  const auto add = [&](const QString& title, QWidget* page) {
    list->addItem(title);
    pages->addWidget(scrolledPanel(page, 420));
  };
  add(QObject::tr("Appearance"), makeAppearancePage(host));
  add(QObject::tr("Units"), makeUnitsPage(host));
  add(QObject::tr("Mouse and view"), makeNavigationPage(host));
  add(QObject::tr("Keys"), makeKeysPage(keys));
  add(QObject::tr("Feel and files"), makeConfigurationPage(host));
  QObject::connect(list, &QListWidget::currentRowChanged, pages, &QStackedWidget::setCurrentIndex);
  list->setCurrentRow(0);
  row->addWidget(list);
  row->addWidget(pages, 1);
  all->setMinimumSize(kList + 440, 360);
  return all;
}

}  // namespace

void addSettings(Host& host, const std::function<void(bool dark)>& set_theme) {
  followSettings(host, set_theme);
  QMainWindow& window = host.window();
  auto* keys = new KeyMap(window, host.userSettings(), &window);
  auto* action = window.findChild<QAction*>("actionSettings");
  if (!action) return;
  const auto made = [&host, &window, keys] {
    auto* dock = window.findChild<QDockWidget*>("dockSettings");
    if (dock) return dock;
    dock = makeDock("dockSettings", QObject::tr("Settings"), makeSettings(host, *keys));
    dock->setWindowIcon(icon("settings"));
    dock->hide();
    window.addDockWidget(Qt::RightDockWidgetArea, dock);
    dock->setFloating(true);
    dock->hide();
    dock->resize(kWidth, kHeight);
    dock->move(window.geometry().center() - QPoint(kWidth / 2, kHeight / 2));
    return dock;
  };
  QObject::connect(action, &QAction::triggered, &window, [made] {
    QDockWidget* dock = made();
    bringToFront(dock);
    dock->activateWindow();
  });
  if (auto* finder = window.findChild<CommandFinder*>())
    QObject::connect(finder, &CommandFinder::opening, &window, made);
}

}  // namespace hapticell::app
