// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>

class QDockWidget;
class QMainWindow;
class QWidget;

namespace hapticell::app {

class UserSettings;

/// Named layouts of the docks: Move, Teach, Ergonomics, Check device. Each is kept as the user left it; an unchanged
/// one has its default, for a wide and for a narrow window. The last layout and the position of the window are restored
/// at the next start. GUI thread.
class Layouts : public QObject {
  Q_OBJECT
 public:
  Layouts(QMainWindow& window, UserSettings& settings);

  /// "move", "teach", "ergonomics", "device".
  static QStringList names();
  static QString title(const QString& name);
  const QString& current() const { return current_; }
  /// Stores the present layout, then applies the other one.
  void choose(const QString& name);
  /// Resets the present layout to its default.
  void reset();
  /// Hides the docks of both sides, or shows again those that were hidden, with the same ones in front.
  void showSides(bool shown);
  /// Restores window and layout of the last time; call it at start, when all docks exist. False if nothing is stored.
  bool restore();
  /// Stores window and layout; call it at the end.
  void store();
  /// Makes the layout chooser for the tool bar.
  QWidget* makeChoice(QWidget* parent);

 signals:
  void chosen(const QString& name);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool isWide() const;
  QString key(const char* what) const;
  void setCorners();
  void arrange(const QString& name);
  /// Puts all docks of the right area in one place; the dock `beside` gets a column of its own and is returned if the
  /// window is wide enough.
  QDockWidget* placeRight(const QStringList& docks, const QString& beside);
  /// Raises the first of these docks that is shown.
  void raiseFirst(const QStringList& docks);
  /// Writes the present layout, and which docks are in front, to the settings, or reads it; false if none is stored.
  void keep();
  bool bringBack();
  /// Docks that a kept state does not know, as after an update, become tabs of the others at the right.
  void addNewDocks(const QByteArray& state);
  QStringList inFront() const;
  void raiseLater(const QStringList& docks);
  QMainWindow& window_;
  UserSettings& settings_;
  QString current_ = QStringLiteral("move");
  bool wide_ = true, stands_ = false;  ///< Whether the docks are arranged for a wide window; whether they are arranged.
  QStringList sides_, sides_front_;    // The docks that showSides() hid.
};

}  // namespace hapticell::app
