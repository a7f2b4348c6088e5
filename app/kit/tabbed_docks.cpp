// SPDX-License-Identifier: Apache-2.0
#include "app/kit/tabbed_docks.h"

#include <QDockWidget>
#include <QEvent>
#include <QHBoxLayout>
#include <QHash>
#include <QMainWindow>
#include <QTabBar>
#include <QTimer>
#include <QToolButton>
#include <algorithm>

#include "app/style/icon.h"

namespace hapticell::app {
namespace {

constexpr int kTabMargins = 28;  // Pixels, both together, as the style has them.

QToolButton* cornerButton(QWidget* parent, const QString& icon_name, const QString& tip) {
  auto* button = new QToolButton(parent);
  button->setIcon(icon(icon_name));
  button->setIconSize(QSize(14, 14));
  button->setFixedSize(20, 20);
  button->setAutoRaise(true);
  button->setProperty("quiet", true);
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

/// What a dock is known by where there is no room for its name.
QString iconNameOf(const QString& dock) {
  static const QHash<QString, QString> names{{"dockVirtualDesktop", "stylus"},
                                             {"dockSolid", "cube"},
                                             {"dockRobot", "robot"},
                                             {"dockMannequin", "person"},
                                             {"dockGuides", "guide_line"},
                                             {"dockMove", "move"},
                                             {"dockMeasure", "measure"},
                                             {"dockDeviceCheck", "device"},
                                             {"dockTools", "hand"},
                                             {"dockMechanism", "guide_hinge"},
                                             {"dockAddRobot", "plus"},
                                             {"dockImport", "import"},
                                             {"dockMesh", "grid"},
                                             {"dockErgonomics", "mannequin"},
                                             {"dockErgonomicsTime", "mannequin"},
                                             {"dockWorkTask", "check"},
                                             {"dockWorkplace", "layout"},
                                             {"dockMarkers", "guide_point"},
                                             {"dockMotion", "trajectory"},
                                             {"dockTraining", "hands"},
                                             {"dockSettings", "settings"},
                                             {"dockReport", "text"},
                                             {"dockStudy", "grid"},
                                             {"dockStudyResults", "grid"},
                                             {"dockTrajectory", "record"},
                                             {"dockCurves", "contrast"},
                                             {"dockCollisions", "contact"},
                                             {"dockMessages", "message"},
                                             {"dockHistory", "history"},
                                             {"dockHelp", "help"}};
  return names.value(dock, "apps");
}

/// How wide tabs are that have no room for their names: icons stand closer before the chosen one's name is cut.
void setTabWidths(QTabBar& bar, int room) {
  constexpr int kIconTab = 34, kLeastIconTab = 22, kLeastName = 60;  // Pixels.
  const int others = std::max(1, bar.count() - 1);
  const int name = bar.currentIndex() < 0
                       ? kLeastName
                       : bar.fontMetrics().horizontalAdvance(bar.tabText(bar.currentIndex())) + kTabMargins;
  const int icon_tab = std::clamp((room - name) / others, kLeastIconTab, kIconTab);
  const int chosen = std::max(kLeastName, room - others * icon_tab);
  if (bar.property("iconTab").toInt() == icon_tab && bar.property("chosenTab").toInt() == chosen) return;
  bar.setProperty("iconTab", icon_tab);
  bar.setProperty("chosenTab", chosen);
  if (bar.count() > 0) bar.setTabText(0, bar.tabText(0));  // Lays it out again.
}

/// Names in place of icons, and icons where there is no room for all names (the chosen tab keeps its name).
void fitTabs(QTabBar& bar, int room) {
  int wanted = 0;
  for (int i = 0; i < bar.count(); ++i) wanted += bar.fontMetrics().horizontalAdvance(bar.tabText(i)) + kTabMargins;
  const bool compact = wanted > room;
  bar.setProperty("compact", compact);
  bar.setElideMode(Qt::ElideNone);
  for (int i = 0; i < bar.count(); ++i) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): so Qt keeps the docks of its tabs.
    const auto* dock = reinterpret_cast<const QDockWidget*>(bar.tabData(i).value<quintptr>());
    if (bar.tabToolTip(i) != bar.tabText(i)) bar.setTabToolTip(i, bar.tabText(i));
    // Each icon that is set lays the bar out again.
    const bool wants_icon = compact && dock;
    if (bar.tabIcon(i).isNull() == wants_icon)
      bar.setTabIcon(i, wants_icon ? icon(iconNameOf(dock->objectName())) : QIcon());
  }
  if (compact) setTabWidths(bar, room);
}

}  // namespace

TabbedDocks::TabbedDocks(QMainWindow& window, const std::vector<QDockWidget*>& docks)
    : QObject(&window), window_(window), corner_(new QWidget(&window)) {
  auto* row = new QHBoxLayout(corner_);
  row->setContentsMargins(0, 0, 6, 0);
  row->setSpacing(2);
  auto* floating = cornerButton(corner_, "float", tr("Undock"));
  auto* close = cornerButton(corner_, "close", tr("Close the panel; the Window menu opens it again"));
  row->addWidget(floating);
  row->addWidget(close);
  corner_->hide();
  connect(floating, &QToolButton::clicked, this, [this] {
    if (QDockWidget* dock = current()) dock->setFloating(true);
  });
  connect(close, &QToolButton::clicked, this, [this] {
    if (QDockWidget* dock = current()) dock->close();
  });
  for (QDockWidget* dock : docks) add(dock);
}

void TabbedDocks::add(QDockWidget* dock) {
  docks_.push_back(dock);
  // Queued: the main window makes and moves its tab bars after it has told of the change.
  connect(dock, &QDockWidget::visibilityChanged, this, &TabbedDocks::arrange, Qt::QueuedConnection);
  connect(dock, &QDockWidget::topLevelChanged, this, &TabbedDocks::arrange, Qt::QueuedConnection);
  connect(dock, &QDockWidget::dockLocationChanged, this, &TabbedDocks::arrange, Qt::QueuedConnection);
  QTimer::singleShot(0, this, &TabbedDocks::arrange);
}

void TabbedDocks::remove(QDockWidget* dock) {
  docks_.erase(std::remove(docks_.begin(), docks_.end(), dock), docks_.end());
  QTimer::singleShot(0, this, &TabbedDocks::arrange);
}

bool TabbedDocks::has(const QDockWidget* dock) const {
  return std::find(docks_.begin(), docks_.end(), dock) != docks_.end();
}

QTabBar* TabbedDocks::findBar() const {
  for (QTabBar* bar : window_.findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly))
    for (int i = 0; i < bar->count(); ++i)
      for (const QDockWidget* dock : docks_)
        if (bar->tabText(i) == dock->windowTitle()) return bar;
  return nullptr;
}

QDockWidget* TabbedDocks::current() const {
  if (!bar_ || bar_->currentIndex() < 0) return nullptr;
  const QString title = bar_->tabText(bar_->currentIndex());
  const auto found =
      std::find_if(docks_.begin(), docks_.end(), [&](const QDockWidget* dock) { return dock->windowTitle() == title; });
  return found == docks_.end() ? nullptr : *found;
}

void TabbedDocks::arrange() {
  if (arranging_) return;
  arranging_ = true;
  for (QDockWidget* dock : docks_) {
    const auto others = window_.tabifiedDockWidgets(dock);
    const bool tabbed = !dock->isFloating() && std::any_of(others.begin(), others.end(),
                                                           [](const QDockWidget* other) { return !other->isHidden(); });
    if (QWidget* title = dock->titleBarWidget()) title->setMaximumHeight(tabbed ? 0 : QWIDGETSIZE_MAX);
    if (QWidget* title = dock->titleBarWidget(); title && title->property("folded").toBool() != tabbed) {
      title->setProperty("folded", tabbed);
      title->updateGeometry();
    }
  }
  QTabBar* bar = findBar();
  if (bar != bar_) {
    if (bar_) bar_->removeEventFilter(this);
    bar_ = bar;
    if (bar_) {
      bar_->installEventFilter(this);
      bar_->setAutoFillBackground(true);
      bar_->setBackgroundRole(QPalette::Light);
      bar_->setUsesScrollButtons(true);
    }
  }
  if (bar_) fitTabs(*bar_, bar_->width() - corner_->sizeHint().width());
  placeCorner();
  arranging_ = false;
}

void TabbedDocks::placeCorner() {
  const bool shown = bar_ && bar_->isVisible();
  corner_->setVisible(shown);
  if (!shown) return;
  const QSize size = corner_->sizeHint();
  const QPoint end = bar_->mapTo(&window_, QPoint(bar_->width(), 0));
  corner_->setGeometry(end.x() - size.width(), end.y(), size.width(), bar_->height());
  corner_->raise();
}

bool TabbedDocks::eventFilter(QObject* watched, QEvent* event) {
  if (watched == bar_) {
    const auto type = event->type();
    if (type == QEvent::Resize || type == QEvent::Move || type == QEvent::Show || type == QEvent::Hide)
      QTimer::singleShot(0, this, type == QEvent::Resize ? &TabbedDocks::arrange : &TabbedDocks::placeCorner);
    if (type == QEvent::Hide) QTimer::singleShot(0, this, &TabbedDocks::arrange);
  }
  return QObject::eventFilter(watched, event);
}

QString tabTextWithCount(const QString& text, int count) {
  return QStringLiteral("%1 (%2)").arg(text).arg(count);
}

}  // namespace hapticell::app
