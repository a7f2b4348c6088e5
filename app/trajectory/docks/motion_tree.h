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

/// The motions in the tree of the workcell: each below what it moves, its points below it. A click shows one, the menu,
/// keys and drags edit them: a program, all of whose points somebody set, in its place, a recording as a copy; names of
/// points in the place of either. Each is one step of undo. GUI thread.
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
  void editorWanted();                  ///< The dock with all that can be done with a motion.
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
