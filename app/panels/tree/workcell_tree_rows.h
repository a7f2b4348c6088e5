// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <map>
#include <string>
#include <vector>

#include "app/host/document_model.h"
#include "app/viewport/scene/strip_text.h"

namespace hapticell::app {

/// A frame of a trajectory as a row below it, standing for the way on to the next row.
struct TreeMotionFrame {
  QString name;             ///< "Frame 12 · 0.11 s", or the point's own name in front.
  QString own_name;         ///< What users call the point; empty: nothing.
  std::size_t frame = 0;    ///< Its index.
  QString finding;          ///< What a check found there; empty: nothing.
  Mark mark = Mark::kNone;  ///< The strongest of it.
  bool checked = false;
  bool operator==(const TreeMotionFrame&) const = default;
};
struct TreeMotionRows {
  std::string entity;  ///< Whose motion it is; its row stands below that one's.
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
  int parent = -1, row = 0;  ///< Index of the row above; place among that one's children.
  std::vector<int> children;
  Mark mark = Mark::kNone;
  const TreeMotionFrame* frame = nullptr;  ///< In the motions that the rows were built of.
  /// Whether it is the same row, whatever its marks and children.
  bool operator==(const TreeRow& other) const {
    return kind == other.kind && name == other.name && part == other.part && entity == other.entity &&
           parent == other.parent;
  }
};

/// Which rows the tree has, from the document; without marks of a snapshot. GUI thread.
class WorkcellTreeRows {
 public:
  /// Both must outlive it; the rows point into `motions`.
  WorkcellTreeRows(const DocumentModel& document, const TreeMotionFrames& motions)
      : document_(document), motion_frames_(motions) {}
  /// The cell first; parents before their children.
  std::vector<TreeRow> build();

 private:
  using Motions = std::multimap<std::string, const workcell::TrajectoryReference*>;  // By the name of whose they are.
  using Children = std::multimap<std::string, const workcell::Entity*>;  // By the name of what they stand below.
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
