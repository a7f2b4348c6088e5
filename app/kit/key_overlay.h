// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QWidget>
#include <vector>

class QMainWindow;

namespace hapticell::app {

/// One key and what it does.
struct KeyLine {
  QString key, does;
};

/// All keys that work now: those of the window's actions, and held keys and mouse buttons that are not actions (Space,
/// Esc, the mouse).
std::vector<KeyLine> keyLines(const QMainWindow& window);

/// `?`: shows the keys over the scene until any key or a click. GUI thread.
class KeyOverlay : public QWidget {
  Q_OBJECT
 public:
  /// Covers `scene` and becomes its child.
  KeyOverlay(const QMainWindow& window, QWidget& scene);
  void toggle();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void close();
  const QMainWindow& window_;
  QWidget& scene_;
  std::vector<KeyLine> lines_;
};

}  // namespace hapticell::app
