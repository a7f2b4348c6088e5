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

/// Named arrangements of the docks: Move, Teach, Ergonomics, Check device. Each is as it was left; until it was touched
/// it stands as drawn, for a wide and for a narrow window. What is there now, and the window's place, come back at the
/// next start. GUI thread.
class Layouts : public QObject {
  Q_OBJECT
 public:
  Layouts(QMainWindow& window, UserSettings& settings);

  /// "move", "teach", "ergonomics", "device".
  static QStringList names();
  static QString title(const QString& name);
  const QString& current() const { return current_; }
  /// Keeps the arrangement that is left, then arranges the other.
  void choose(const QString& name);
  /// The current one as it is drawn, whatever was done to it.
  void reset();
  /// The docks of both sides away, and back those that were there, the same ones in front.
  void showSides(bool shown);
  /// At start, once all docks are there: window and layout of the last time. False where nothing is remembered.
  bool restore();
  /// At the end.
  void store();
  /// The choice for the tool bar.
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
  /// Gathers the right area's docks in one place; the one beside it gets a column of its own and is given back where
  /// the window is wide enough.
  QDockWidget* placeRight(const QStringList& docks, const QString& beside);
  /// The first of these that is shown.
  void raiseFirst(const QStringList& docks);
  /// The current arrangement, with what lies in front, into the settings; and out of them: false where none is kept.
  void keep();
  bool bringBack();
  QStringList inFront() const;
  void raiseLater(const QStringList& docks);
  QMainWindow& window_;
  UserSettings& settings_;
  QString current_ = QStringLiteral("move");
  bool wide_ = true, stands_ = false;  ///< What the docks are arranged for; whether they are.
  QStringList sides_, sides_front_;    // What showSides() took away.
};

}  // namespace hapticell::app
