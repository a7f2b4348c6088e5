// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QModelIndex>
#include <QObject>

class QMenu;

namespace hapticell::app {

class MotionList;
class MotionPlayer;
class MotionWork;
class WorkcellPanel;
struct Motion;

/// The motions in the tree of the workcell: each below the entity that it moves, with its frames below it. A click
/// shows a motion; menu, keys and drags edit it: a program (all frames set by hand) in place, a recording as a copy;
/// names of waypoints in place for both. Each edit is one undo step. GUI thread.
class MotionTree : public QObject {
  Q_OBJECT
 public:
  struct Parts {
    MotionList& list;
    MotionPlayer& player;
    MotionWork& work;
  };
  MotionTree(const Parts& parts, WorkcellPanel& tree, QObject* parent = nullptr);

 signals:
  void frameChosen(std::size_t frame);  ///< Of the current motion.
  void editorWanted();                  ///< Asks for the dock with everything that can be done with a motion.
  void told(const QString& line, bool careful);

 private:
  void choose(const QModelIndex& index);
  void fillMenu(QMenu* menu, const QModelIndex& index);
  void fillPointMenu(QMenu& menu, const Motion& motion, std::size_t frame);
  void remove(const QModelIndex& index);
  void step(const QModelIndex& index, int rows);
  void insertAfter(std::size_t frame);
  void deletePoint(std::size_t frame);
  void namePoint(const QString& motion, qulonglong frame, const QString& name);
  void movePoint(const QString& motion, qulonglong frame, qulonglong to);
  void showRows();
  MotionList& list_;
  MotionPlayer& player_;
  MotionWork& work_;
  WorkcellPanel& tree_;
};

}  // namespace hapticell::app
