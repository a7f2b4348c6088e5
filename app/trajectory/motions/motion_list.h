// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/host/background_work.h"
#include "manipulation/checks/motion_replay.h"
#include "manipulation/checks/path_check.h"
#include "workcell/document/document_state.h"

namespace hapticell::app {

class Host;

/// A motion of the cell as the panels know it.
struct Motion {
  std::string name;
  std::string path;
  std::shared_ptr<const trajectory::Trajectory> trajectory;  ///< Null while its file is being read, or if it cannot be.
  std::shared_ptr<const manipulation::MotionReplay> replay;  ///< Null if it cannot be played; `problem` says why.
  QString problem;
  bool played = false;                                 ///< Is played with the others.
  std::optional<manipulation::PathCheckResult> check;  ///< For the cell at the time of the check.
  std::shared_ptr<const workcell::Entity> entity;      ///< The entity that the replay was made with.
};

/// The trajectories of the document with their content: reads their files in the background, writes files of new ones,
/// and makes their replays. Files of recordings are never changed: an edit makes a new motion with its own file. GUI
/// thread.
class MotionList : public QObject {
  Q_OBJECT
 public:
  explicit MotionList(Host& host, QObject* parent = nullptr);

  const std::vector<Motion>& motions() const { return motions_; }
  const Motion* find(const std::string& name) const;
  /// The motion that is being edited; null: none.
  const Motion* current() const { return find(current_); }
  void setCurrent(const std::string& name);
  void setPlayed(const std::string& name, bool played);
  void setCheck(const std::string& name, std::optional<manipulation::PathCheckResult> check);

  /// Adds motions as one undo step. The last one becomes the current one, and they are all played in place of the
  /// earlier ones. Writes their files in the background. False if the document refused.
  bool add(const QString& step, std::vector<std::pair<std::string, trajectory::Trajectory>> motions);
  /// Replaces a motion by an edited one, as one undo step; whether it is played does not change. `same_way`: the path
  /// is the same (only names were edited), so the findings of its check are kept. False if the document refused.
  bool replace(const QString& step, std::string name, trajectory::Trajectory motion, bool same_way);
  bool rename(const std::string& name, const QString& new_name);
  bool remove(const std::string& name);
  /// `wanted`, with a number added if necessary.
  std::string uniqueName(const std::string& wanted) const;

  /// Background work on motions, one job after the other.
  BackgroundWork& work() { return work_; }
  /// The folder for files of new motions: next to the document, or in the user's data while the document has no file.
  QString folder() const;

 signals:
  void changed();         ///< Motions, their content, or the choice of those to play changed.
  void currentChanged();  ///< Another motion is the current one, or its check changed.

 private:
  void takeDocument();
  workcell::TrajectoryReference fileFor(trajectory::Trajectory motion);
  void read(const std::string& path);
  void makeReplay(Motion& motion);
  std::shared_ptr<const workcell::Entity> entityOf(const trajectory::Trajectory& trajectory) const;
  void write(const std::string& path, std::shared_ptr<const trajectory::Trajectory> trajectory);

  Host& host_;
  BackgroundWork work_;
  std::vector<Motion> motions_;
  std::map<std::string, std::shared_ptr<const trajectory::Trajectory>> read_;  ///< By path; null while being read.
  std::map<std::string, QString> unreadable_;
  std::string current_;
};

}  // namespace hapticell::app
