// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/docks/motion_tree.h"

#include <QAction>
#include <QMenu>

#include "app/panels/cell/workcell_panel.h"
#include "app/style/icon.h"
#include "app/style/library_text.h"
#include "app/trajectory/motions/motion_list.h"
#include "app/trajectory/motions/motion_player.h"
#include "app/trajectory/motions/motion_work.h"
#include "app/trajectory/motions/track_rows.h"

namespace hapticell::app {
namespace {

// Frames of a motion listed as rows: more are not looked at one by one. Half, twice: fewer or more, and their time.
constexpr std::size_t kFrameRows = 200;

using Trajectories = Expected<std::vector<trajectory::Trajectory>>;

Trajectories alone(Expected<trajectory::Trajectory> made) {
  HAPTICELL_TRY(made);
  return std::vector<trajectory::Trajectory>{std::move(*made)};
}

QString motionOf(const QModelIndex& index) {
  return index.data(WorkcellTreeModel::kMotionRole).toString();
}

std::optional<std::size_t> frameOf(const QModelIndex& index) {
  const QVariant frame = index.data(WorkcellTreeModel::kMotionFrameRole);
  return frame.isValid() ? std::optional<std::size_t>(frame.toULongLong()) : std::nullopt;
}

/// Nothing of it is left out of the tree, so that an order can be seen and changed there.
bool showsAllPoints(const Motion& motion) {
  return motion.trajectory->isTaught() || motion.trajectory->size() <= kFrameRows;
}

}  // namespace

MotionTree::MotionTree(const Parts& parts, WorkcellPanel& tree, QObject* parent)
    : QObject(parent), list_(parts.list), player_(parts.player), work_(parts.work), tree_(tree) {
  connect(&tree.tree(), &QTreeView::clicked, this, &MotionTree::choose);
  connect(&tree, &WorkcellPanel::menuFilled, this, &MotionTree::fillMenu);
  connect(&tree, &WorkcellPanel::pointStepWanted, this, &MotionTree::step);
  connect(&tree, &WorkcellPanel::motionRemoveWanted, this, &MotionTree::remove);
  connect(&tree.model(), &WorkcellTreeModel::motionRenameWanted, this,
          [this](const QString& name, const QString& fresh) { list_.rename(name.toStdString(), fresh); });
  connect(&tree.model(), &WorkcellTreeModel::pointRenameWanted, this, &MotionTree::namePoint);
  connect(&tree.model(), &WorkcellTreeModel::pointMoveWanted, this, &MotionTree::movePoint);
  connect(&list_, &MotionList::changed, this, &MotionTree::showRows);
  showRows();
}

/// The row of a motion: it becomes the current one and is played; that of a point: it is chosen and shown.
void MotionTree::choose(const QModelIndex& index) {
  const std::string name = motionOf(index).toStdString();
  if (name.empty() || !list_.find(name)) return;
  list_.setCurrent(name);
  list_.setPlayed(name, true);
  const auto frame = frameOf(index);
  const Motion* motion = list_.current();
  if (!frame || !motion->trajectory || *frame >= motion->trajectory->size()) return;
  emit frameChosen(*frame);
  player_.seek((*motion->trajectory)[*frame].t);
}

void MotionTree::fillMenu(QMenu* menu, const QModelIndex& index) {
  const std::string name = motionOf(index).toStdString();
  const Motion* motion = name.empty() ? nullptr : list_.find(name);
  if (!motion || !motion->trajectory) return;
  choose(index);
  if (const auto frame = frameOf(index)) return fillPointMenu(*menu, *motion, *frame);
  menu->addAction(icon("check"), tr("Check the motion"), menu, [this] { work_.check(); });
  menu->addAction(tr("Edit and export motions…"), menu, [this] { emit editorWanted(); });
  menu->addAction(tr("Remove"), menu, [this, name] { list_.remove(name); });
}

void MotionTree::fillPointMenu(QMenu& menu, const Motion& motion, std::size_t frame) {
  const QString name = QString::fromStdString(motion.name);
  const std::size_t count = motion.trajectory->size();
  QAction* insert = menu.addAction(tr("Insert a frame after this one"), &menu, [this, frame] { insertAfter(frame); });
  QAction* up = menu.addAction(tr("Move up"), &menu, [this, name, frame] { movePoint(name, frame, frame - 1); });
  QAction* down = menu.addAction(tr("Move down"), &menu, [this, name, frame] { movePoint(name, frame, frame + 1); });
  QAction* remove = menu.addAction(tr("Delete this frame"), &menu, [this, frame] { deletePoint(frame); });
  up->setShortcut(Qt::ALT | Qt::Key_Up);
  down->setShortcut(Qt::ALT | Qt::Key_Down);
  insert->setEnabled(frame + 1 < count);
  up->setEnabled(showsAllPoints(motion) && frame > 0);
  down->setEnabled(showsAllPoints(motion) && frame + 1 < count);
  remove->setEnabled(count > 1);
}

void MotionTree::remove(const QModelIndex& index) {
  const std::string name = motionOf(index).toStdString();
  const auto frame = frameOf(index);
  if (!frame) return void(list_.remove(name));
  list_.setCurrent(name);
  deletePoint(*frame);
}

void MotionTree::step(const QModelIndex& index, int rows) {
  const auto frame = frameOf(index);
  if (frame && (rows > 0 || *frame > 0)) movePoint(motionOf(index), *frame, rows > 0 ? *frame + 1 : *frame - 1);
}

void MotionTree::insertAfter(std::size_t frame) {
  work_.editPoints(tr("with a frame"), [frame](const trajectory::Trajectory& given) {
    const double t = 0.5 * (given[frame].t + given[frame + 1].t);
    return alone(trajectory::withFrame(given, t, given.poseAt(t)));
  });
}

void MotionTree::deletePoint(std::size_t frame) {
  work_.editPoints(tr("without a frame"), [frame](const trajectory::Trajectory& given) {
    return alone(trajectory::withoutFrames(given, frame, frame));
  });
}

void MotionTree::namePoint(const QString& name, qulonglong frame, const QString& point) {
  const Motion* motion = list_.find(name.toStdString());
  if (!motion || !motion->trajectory) return;
  auto named = trajectory::withName(*motion->trajectory, frame, point.toStdString());
  if (!named) return emit told(shownText(named.error()), true);
  list_.replace(tr("Name a point of %1").arg(name), motion->name, std::move(*named), true);
  tree_.chooseFrame(name, frame);
}

void MotionTree::movePoint(const QString& name, qulonglong frame, qulonglong to) {
  const Motion* motion = list_.find(name.toStdString());
  if (!motion || !motion->trajectory || to >= motion->trajectory->size()) return;
  if (!showsAllPoints(*motion))
    return emit told(tr("%1 has too many frames to reorder here. Simplify it first.").arg(name), true);
  const bool in_place = motion->trajectory->isTaught();
  list_.setCurrent(motion->name);
  work_.editPoints(tr("points reordered"), [frame, to](const trajectory::Trajectory& given) {
    return alone(trajectory::withFrameMoved(given, frame, to));
  });
  if (!in_place) return;
  emit frameChosen(to);
  tree_.chooseFrame(name, to);
}

void MotionTree::showRows() {
  WorkcellTreeModel::MotionFrames rows;
  for (const Motion& motion : list_.motions())
    rows[motion.name] = {motion.trajectory ? motion.trajectory->entity : std::string(),
                         motionFrames(motion, kFrameRows)};
  tree_.model().setMotionFrames(std::move(rows));
}

}  // namespace hapticell::app
