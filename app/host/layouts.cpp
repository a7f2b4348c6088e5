// SPDX-License-Identifier: Apache-2.0
#include "app/host/layouts.h"

#include <QComboBox>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QTimer>

#include "app/host/user_settings.h"
#include "app/style/fonts.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

constexpr int kVersion = 1;  // Of the blobs: a new one where docks were renamed.

/// How a layout stands until it was touched. Docks that are not there are passed over.
struct Drawn {
  QString name;
  QStringList left, bottom, right;  // Shown; the first of bottom and right lies in front.
  int left_width, bottom_height, right_width;
};

const std::vector<Drawn>& drawn() {
  static const std::vector<Drawn> all{
      {"move",
       {"dockWorkcell", "dockProperties"},
       {"dockCollisions", "dockTrajectory", "dockCurves", "dockErgonomicsTime", "dockMessages", "dockHistory"},
       {"dockVirtualDesktop", "dockSolid", "dockRobot", "dockMannequin", "dockGuides"},
       296,
       272,
       344},
      {"teach",
       {"dockWorkcell", "dockProperties"},
       {"dockTrajectory", "dockCurves", "dockCollisions", "dockMessages", "dockHistory"},
       {"dockRobot", "dockVirtualDesktop", "dockGuides", "dockTools"},
       296,
       360,
       344},
      {"ergonomics",
       {},
       {"dockErgonomicsTime", "dockTrajectory", "dockCollisions", "dockMessages", "dockHistory"},
       {"dockErgonomics", "dockMannequin", "dockReport"},
       0,
       262,
       480},
      {"device",
       {"dockWorkcell"},
       {"dockCurves", "dockMessages"},
       {"dockDeviceCheck", "dockVirtualDesktop"},
       240,
       240,
       440}};
  return all;
}

const Drawn& drawnAs(const QString& name) {
  for (const Drawn& one : drawn())
    if (one.name == name) return one;
  return drawn().front();
}

}  // namespace

Layouts::Layouts(QMainWindow& window, UserSettings& settings)
    : QObject(&window), window_(window), settings_(settings) {}

QStringList Layouts::names() {
  QStringList names;
  for (const Drawn& one : drawn()) names << one.name;
  return names;
}

QString Layouts::title(const QString& name) {
  if (name == QLatin1String("teach")) return tr("Teach");
  if (name == QLatin1String("ergonomics")) return tr("Ergonomics");
  if (name == QLatin1String("device")) return tr("Check device");
  return tr("Move");
}

void Layouts::choose(const QString& name) {
  if (name == current_ || !names().contains(name)) return;
  settings_.setValue("layout/" + current_, window_.saveState(kVersion));
  current_ = name;
  emit chosen(name);  // Docks that are made when they are first wanted are made now.
  const QByteArray state = settings_.value("layout/" + name).toByteArray();
  if (state.isEmpty() || !window_.restoreState(state, kVersion)) arrange(name);
}

void Layouts::reset() {
  settings_.remove("layout/" + current_);
  arrange(current_);
}

void Layouts::arrange(const QString& name) {
  const Drawn& want = drawnAs(name);
  const auto find = [this](const QString& dock) { return window_.findChild<QDockWidget*>(dock); };
  for (QDockWidget* dock : window_.findChildren<QDockWidget*>()) {
    const QString& id = dock->objectName();
    if (dock->isFloating()) continue;
    dock->setVisible(want.left.contains(id) || want.bottom.contains(id) || want.right.contains(id));
  }
  const auto size = [&](const QStringList& docks, int pixels, Qt::Orientation way) {
    for (const QString& id : docks)
      if (QDockWidget* dock = find(id)) return window_.resizeDocks({dock}, {pixels}, way);
  };
  size(want.left, want.left_width, Qt::Horizontal);
  size(want.right, want.right_width, Qt::Horizontal);
  size(want.bottom, want.bottom_height, Qt::Vertical);
  // Queued: Qt forgets a tab that is raised before its docks were laid out.
  QTimer::singleShot(0, this, [this, want] {
    raiseAll(want.right);
    raiseAll(want.bottom);
  });
}

void Layouts::raiseAll(const QStringList& docks) {
  for (const QString& id : docks) {
    auto* dock = window_.findChild<QDockWidget*>(id);
    if (!dock || dock->isHidden()) continue;
    dock->raise();
    return;
  }
}

bool Layouts::restore() {
  const QByteArray geometry = settings_.value("window/geometry").toByteArray();
  if (!geometry.isEmpty()) window_.restoreGeometry(geometry);
  const QString name = settings_.value("window/layout").toString();
  if (!names().contains(name)) return false;
  current_ = name;
  emit chosen(name);
  const QByteArray state = settings_.value("layout/" + name).toByteArray();
  return !state.isEmpty() && window_.restoreState(state, kVersion);
}

void Layouts::store() {
  settings_.setValue("window/geometry", window_.saveGeometry());
  settings_.setValue("window/layout", current_);
  settings_.setValue("layout/" + current_, window_.saveState(kVersion));
  settings_.flush();
}

QWidget* Layouts::makeChoice(QWidget* parent) {
  auto* holder = new QWidget(parent);
  auto* row = new QHBoxLayout(holder);
  row->setContentsMargins(0, 0, 8, 0);
  row->setSpacing(8);
  auto* word = new QLabel(tr("Layout"));
  word->setFont(textFont(TextRole::kSecond));
  word->setForegroundRole(kQuietText);
  auto* choice = new QComboBox;
  choice->setFont(textFont(TextRole::kText));
  word->setBuddy(choice);
  row->addWidget(word);
  row->addWidget(choice);
  choice->setObjectName("comboLayout");
  choice->setAccessibleName(tr("Layout"));
  choice->setFixedWidth(128);
  choice->setFocusPolicy(Qt::TabFocus);
  for (const QString& name : names()) choice->addItem(title(name), name);
  connect(choice, &QComboBox::activated, this,
          [this, choice](int index) { choose(choice->itemData(index).toString()); });
  connect(this, &Layouts::chosen, choice,
          [choice](const QString& name) { choice->setCurrentIndex(choice->findData(name)); });
  return holder;
}

}  // namespace hapticell::app
