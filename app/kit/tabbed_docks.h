// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <vector>

class QDockWidget;
class QMainWindow;
class QTabBar;
class QWidget;

namespace hapticell::app {

/// Docks that share one area as tabs: the tab is the title, so their own title bars are hidden while they are tabbed,
/// and the buttons to undock and to close are at the right end of the tab bar.
class TabbedDocks : public QObject {
  Q_OBJECT
 public:
  explicit TabbedDocks(QMainWindow& window, const std::vector<QDockWidget*>& docks = {});
  void add(QDockWidget* dock);
  void remove(QDockWidget* dock);
  bool has(const QDockWidget* dock) const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void arrange();
  void placeCorner();
  QTabBar* findBar() const;
  QDockWidget* current() const;
  QMainWindow& window_;
  std::vector<QDockWidget*> docks_;
  QTabBar* bar_ = nullptr;
  QWidget* corner_;
  bool arranging_ = false;
};

/// A tab's text with a count, drawn as a badge: "Collisions (2)". A count of 0 has no badge, but its space is kept.
QString tabTextWithCount(const QString& text, int count);

}  // namespace hapticell::app
