// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QDockWidget;

namespace hapticell::app {

/// A dock's title bar: name on the left, float and close on the right, a line below. Dragging it moves the dock as in
/// Qt. It takes no room while its property `folded` is true, because the tab then shows the title.
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

/// A dock with the program's title bar; the host and modules make all docks with it. `name` is its objectName (layouts
/// are saved by it), `title` the text in the bar and in the Window menu.
QDockWidget* makeDock(const QString& name, const QString& title, QWidget* content);

}  // namespace hapticell::app
