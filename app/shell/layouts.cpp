// SPDX-License-Identifier: Apache-2.0
#include "app/shell/layouts.h"

#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QTimer>
#include <algorithm>
#include <vector>

#include "app/host/user_settings.h"
#include "app/kit/dock_front.h"
#include "app/style/fonts.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

constexpr int kVersion = 2;  // Of the blobs: a new one where docks were renamed, or arranged by other rules.

/// How a layout stands until it was touched. Docks that are not there are passed over.
struct Drawn {
  QString name;
  QStringList left, bottom, right;  // Shown; the first of bottom and right lies in front.
  struct Sizes {
    int left, bottom, right;  // Pixels.
  };
  Sizes wide, narrow;
  QString beside = {};  // One of the right ones that has a column of its own where the window is wide enough.
  int beside_width = 0;
};

// px; below, all docks of the right share one place, columns are narrower, and the bottom goes to the left edge: its
// tables need the width more than the tree needs the height.
constexpr int kWideWindow = 1500;

const std::vector<Drawn>& drawn() {
  static const std::vector<Drawn> all{
      {"move",
       {"dockWorkcell", "dockProperties"},
       {"dockCollisions", "dockTrajectory", "dockCurves", "dockErgonomicsTime", "dockMessages", "dockHistory"},
       {"dockVirtualDesktop", "dockSolid", "dockRobot", "dockMannequin", "dockGuides"},
       {296, 272, 344},
       {240, 172, 332}},
      {"teach",
       {"dockWorkcell", "dockProperties"},
       {"dockTrajectory", "dockCurves", "dockCollisions", "dockMessages", "dockHistory"},
       {"dockTraining", "dockVirtualDesktop", "dockRobot", "dockGuides"},
       {296, 360, 344},
       {240, 240, 332}},
      {"ergonomics",
       {},
       {"dockErgonomicsTime", "dockTrajectory", "dockCollisions", "dockMessages", "dockHistory"},
       {"dockErgonomics", "dockMannequin", "dockReport"},
       {0, 262, 540},
       {0, 224, 440},
       "dockReport",
       360},
      {"device",
       {"dockWorkcell"},
       {"dockCurves", "dockMessages"},
       {"dockDeviceCheck", "dockVirtualDesktop"},
       {240, 240, 440},
       {240, 190, 332}}};
  return all;
}

const Drawn& drawnAs(const QString& name) {
  for (const Drawn& one : drawn())
    if (one.name == name) return one;
  return drawn().front();
}

}  // namespace

Layouts::Layouts(QMainWindow& window, UserSettings& settings) : QObject(&window), window_(window), settings_(settings) {
  qApp->installEventFilter(this);  // The window's own filters hear of a new size when its docks are squeezed already.
}

bool Layouts::isWide() const {
  return window_.width() >= kWideWindow;
}

QString Layouts::key(const char* what) const {
  return QLatin1String(what) + (wide_ ? QLatin1String("/") : QLatin1String("_narrow/")) + current_;
}

/// Wide and narrow windows each keep their own arrangement: one that was squeezed is not what the other shall have.
bool Layouts::eventFilter(QObject* watched, QEvent* event) {
  if (watched != &window_ || event->type() != QEvent::Resize || !stands_ || isWide() == wide_) return false;
  keep();
  wide_ = isWide();
  QTimer::singleShot(0, this, [this] {
    sides_.clear();
    setCorners();
    if (!bringBack()) arrange(current_);
  });
  return false;
}

void Layouts::setCorners() {
  window_.setCorner(Qt::BottomLeftCorner, wide_ ? Qt::LeftDockWidgetArea : Qt::BottomDockWidgetArea);
}

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
  wide_ = isWide();
  setCorners();
  keep();
  current_ = name;
  stands_ = true;
  sides_.clear();
  emit chosen(name);  // Docks that are made when they are first wanted are made now.
  if (!bringBack()) arrange(name);
}

void Layouts::keep() {
  settings_.setValue(key("layout"), window_.saveState(kVersion));
  const QStringList front = inFront();
  if (!front.isEmpty()) settings_.setValue(key("layout_front"), front);
}

bool Layouts::bringBack() {
  const QByteArray state = settings_.value(key("layout")).toByteArray();
  if (state.isEmpty()) return false;
  // Docks that were made since it was kept are not in it, and Qt would leave them as the layout before had them.
  for (QDockWidget* dock : window_.findChildren<QDockWidget*>())
    if (!dock->isFloating()) dock->hide();
  if (!window_.restoreState(state, kVersion)) return false;
  addNewDocks(state);
  raiseLater(settings_.value(key("layout_front")).toStringList());
  return true;
}

void Layouts::addNewDocks(const QByteArray& state) {
  const auto isKept = [&](const QDockWidget* dock) {
    // As QMainWindow::saveState() writes a name: the number of bytes, then UTF-16, both with the high byte first.
    const QString id = dock->objectName();
    QByteArray name;
    for (const int shift : {24, 16, 8, 0}) name.append(static_cast<char>(2 * id.size() >> shift));
    for (const QChar letter : id) name.append(static_cast<char>(letter.row())).append(static_cast<char>(letter.cell()));
    return state.contains(name);
  };
  QDockWidget* onto = nullptr;
  std::vector<QDockWidget*> added;
  for (QDockWidget* dock : window_.findChildren<QDockWidget*>()) {
    if (dock->isFloating() || window_.dockWidgetArea(dock) != Qt::RightDockWidgetArea) continue;
    if (!isKept(dock))
      added.push_back(dock);
    else if (!onto || (onto->isHidden() && !dock->isHidden()))
      onto = dock;
  }
  if (!onto) return;
  for (QDockWidget* dock : added) {
    const bool shown = !dock->isHidden();
    window_.removeDockWidget(dock);
    window_.tabifyDockWidget(onto, dock);
    dock->setVisible(shown);
  }
}

QStringList Layouts::inFront() const {
  QStringList front;
  for (const QDockWidget* dock : window_.findChildren<QDockWidget*>())
    if (isInFront(*dock)) front << dock->objectName();
  return front;
}

void Layouts::raiseLater(const QStringList& docks) {
  // Queued: Qt forgets a tab that is raised before its docks were laid out.
  QTimer::singleShot(0, this, [this, docks] {
    for (const QString& id : docks) raiseFirst({id});
  });
}

void Layouts::reset() {
  settings_.remove(key("layout"));
  settings_.remove(key("layout_front"));
  arrange(current_);
}

void Layouts::arrange(const QString& name) {
  const Drawn& want = drawnAs(name);
  wide_ = isWide();
  stands_ = true;
  setCorners();
  const Drawn::Sizes& sizes = wide_ ? want.wide : want.narrow;
  const auto find = [this](const QString& dock) { return window_.findChild<QDockWidget*>(dock); };
  for (QDockWidget* dock : window_.findChildren<QDockWidget*>()) {
    const QString& id = dock->objectName();
    if (dock->isFloating()) continue;
    dock->setVisible(want.left.contains(id) || want.bottom.contains(id) || want.right.contains(id));
  }
  QDockWidget* beside = placeRight(want.right, want.beside);
  const auto size = [&](const QStringList& docks, int pixels, Qt::Orientation way) {
    for (const QString& id : docks)
      if (QDockWidget* dock = find(id)) return window_.resizeDocks({dock}, {pixels}, way);
  };
  size(want.left, sizes.left, Qt::Horizontal);
  QDockWidget* first = want.right.isEmpty() ? nullptr : find(want.right.front());
  if (beside && first)
    window_.resizeDocks({first, beside}, {sizes.right, want.beside_width}, Qt::Horizontal);
  else
    size(want.right, sizes.right, Qt::Horizontal);
  size(want.bottom, sizes.bottom, Qt::Vertical);
  // Queued: Qt forgets a tab that is raised before its docks were laid out.
  QTimer::singleShot(0, this, [this, want] {
    raiseFirst(want.right);
    raiseFirst(want.bottom);
  });
}

QDockWidget* Layouts::placeRight(const QStringList& docks, const QString& beside) {
  std::vector<QDockWidget*> all;
  const auto take = [&](QDockWidget* dock) {
    const bool is_right = dock && !dock->isFloating() && window_.dockWidgetArea(dock) == Qt::RightDockWidgetArea;
    if (is_right && std::find(all.begin(), all.end(), dock) == all.end()) all.push_back(dock);
  };
  for (const QString& id : docks) take(window_.findChild<QDockWidget*>(id));
  for (QDockWidget* dock : window_.findChildren<QDockWidget*>()) take(dock);
  if (all.empty()) return nullptr;
  // All are taken out first: Qt would keep one that is moved in both places.
  std::vector<bool> shown;
  for (QDockWidget* dock : all) {
    shown.push_back(!dock->isHidden());
    window_.removeDockWidget(dock);
  }
  QDockWidget* aside = nullptr;
  window_.addDockWidget(Qt::RightDockWidgetArea, all.front());
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0 && all[i]->objectName() == beside && isWide())
      aside = all[i];
    else if (i > 0)
      window_.tabifyDockWidget(all.front(), all[i]);
  }
  if (aside) window_.addDockWidget(Qt::RightDockWidgetArea, aside, Qt::Horizontal);
  for (std::size_t i = 0; i < all.size(); ++i) all[i]->setVisible(shown[i]);
  return aside;
}

void Layouts::showSides(bool shown) {
  if (!shown) {
    sides_.clear();
    sides_front_ = inFront();
  }
  for (QDockWidget* dock : window_.findChildren<QDockWidget*>()) {
    const auto area = window_.dockWidgetArea(dock);
    const bool aside = area == Qt::LeftDockWidgetArea || area == Qt::RightDockWidgetArea;
    if (!aside || dock->isFloating()) continue;
    if (!shown && !dock->isHidden()) {
      sides_ << dock->objectName();
      dock->hide();
    } else if (shown && sides_.contains(dock->objectName())) {
      dock->show();
    }
  }
  if (!shown) return;
  if (sides_.isEmpty()) return arrange(current_);
  raiseLater(sides_front_);
}

void Layouts::raiseFirst(const QStringList& docks) {
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
  wide_ = isWide();
  setCorners();
  emit chosen(name);
  stands_ = bringBack();
  return stands_;
}

void Layouts::store() {
  settings_.setValue("window/geometry", window_.saveGeometry());
  settings_.setValue("window/layout", current_);
  keep();
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
