// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QDockWidget;

namespace hapticell::app {

/// A dock's title: name at the left, float and close at the right, a line below. Dragging it moves the dock as Qt does.
/// It takes no room while its property `folded` is true: the tab is then the title.
class DockTitleBar : public QWidget {
  Q_OBJECT
 public:
  explicit DockTitleBar(QDockWidget* dock);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QDockWidget* dock_;
};

/// A dock with the program's title bar: the one way to make docks, for the host and for modules.
/// `name` is its objectName (layouts are saved by it), `title` what stands in the bar and in the Window menu.
QDockWidget* makeDock(const QString& name, const QString& title, QWidget* content);

}  // namespace hapticell::app
