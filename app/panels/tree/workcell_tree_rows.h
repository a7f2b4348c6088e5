// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <map>
#include <string>
#include <vector>

#include "app/host/document_model.h"
#include "app/viewport/scene/strip_text.h"

namespace hapticell::app {

/// A frame of a trajectory as a row below it; it also stands for the path to the next row.
struct TreeMotionFrame {
  QString name;             ///< "Frame 12 · 0.11 s", preceded by the waypoint's own name, if any.
  QString own_name;         ///< The user's name for the waypoint; empty: none.
  std::size_t frame = 0;    ///< Its index in the trajectory.
  QString finding;          ///< What a check found there; empty: nothing.
  Mark mark = Mark::kNone;  ///< The strongest mark of these findings.
  bool checked = false;
  bool operator==(const TreeMotionFrame&) const = default;
};
struct TreeMotionRows {
  std::string entity;  ///< The entity that moves; the motion's row is below the row of this entity.
  std::vector<TreeMotionFrame> frames;
  bool operator==(const TreeMotionRows&) const = default;
};
using TreeMotionFrames = std::map<std::string, TreeMotionRows>;  ///< By the trajectory's name.

/// One row of the tree of the workcell.
struct TreeRow {
  enum class Kind {
    kCell,
    kFolder,
    kEntity,
    kTcp,
    kLink,
    kFrame,
    kPairSets,
    kPairSet,
    kTrajectories,
    kTrajectory,
    kMotionFrame
  };
  Kind kind = Kind::kEntity;
  QString name, part;
  workcell::EntityId entity = 0;
  int parent = -1, row = 0;  ///< Index of the parent row; position among its children.
  std::vector<int> children;
  Mark mark = Mark::kNone;
  const TreeMotionFrame* frame = nullptr;  ///< In the motions that the rows were built from.
  /// Whether it is the same row, whatever its marks and children.
  bool operator==(const TreeRow& other) const {
    return kind == other.kind && name == other.name && part == other.part && entity == other.entity &&
           parent == other.parent;
  }
};

/// Determines the rows of the tree from the document, without the marks of a snapshot. GUI thread.
class WorkcellTreeRows {
 public:
  /// Both must outlive it; the rows point into `motions`.
  WorkcellTreeRows(const DocumentModel& document, const TreeMotionFrames& motions)
      : document_(document), motion_frames_(motions) {}
  /// The rows, the cell first, parents before their children.
  std::vector<TreeRow> build();

 private:
  using Motions = std::multimap<std::string, const workcell::TrajectoryReference*>;  // By the name of the moved entity.
  using Children = std::multimap<std::string, const workcell::Entity*>;              // By the name of the parent.
  int append(int parent, TreeRow row);
  void appendEntity(int parent, const workcell::Entity& entity);
  void appendMotion(int parent, const workcell::TrajectoryReference& motion);
  void appendRobot(int row, const workcell::Entity& entity);
  Motions motionsByEntity() const;

  const DocumentModel& document_;
  const TreeMotionFrames& motion_frames_;
  Motions motions_;
  Children children_;
  std::vector<TreeRow> rows_;
};

}  // namespace hapticell::app
