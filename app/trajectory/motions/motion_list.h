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
  std::shared_ptr<const trajectory::Trajectory> trajectory;  ///< Null while its file is being read, or cannot be.
  std::shared_ptr<const manipulation::MotionReplay> replay;  ///< Null while it cannot be played; `problem` says why.
  QString problem;
  bool played = false;                                 ///< Takes part in the play.
  std::optional<manipulation::PathCheckResult> check;  ///< As the cell stood when it was asked for.
  std::shared_ptr<const workcell::Entity> entity;      ///< The one that the replay was made with.
};

/// The trajectories of the document with their content: reads their files beside the window, writes those of new ones,
/// makes replays of them. Files of recordings are never altered: what is made of one is a new motion in a file of its
/// own. GUI thread.
class MotionList : public QObject {
  Q_OBJECT
 public:
  explicit MotionList(Host& host, QObject* parent = nullptr);

  const std::vector<Motion>& motions() const { return motions_; }
  const Motion* find(const std::string& name) const;
  /// The one that is worked on; null: none.
  const Motion* current() const { return find(current_); }
  void setCurrent(const std::string& name);
  void setPlayed(const std::string& name, bool played);
  void setCheck(const std::string& name, std::optional<manipulation::PathCheckResult> check);

  /// Adds motions as one step of undo, the last one current and all of them played in place of what was. Their files
  /// are written in the background. False where the document refused.
  bool add(const QString& step, std::vector<std::pair<std::string, trajectory::Trajectory>> motions);
  /// Puts an edited motion in the place of one, as one step of undo; it goes on being played as it was. `same_way`: it
  /// moves as before (points were named), so what its check found still holds. False where the document refused.
  bool replace(const QString& step, std::string name, trajectory::Trajectory motion, bool same_way);
  bool rename(const std::string& name, const QString& new_name);
  bool remove(const std::string& name);
  /// `wanted`, or with a number behind it.
  std::string uniqueName(const std::string& wanted) const;

  /// Work on motions beside the window, one piece after the other.
  BackgroundWork& work() { return work_; }
  /// Where files of new motions are put: beside the document, or among the user's data while it has no file.
  QString folder() const;

 signals:
  void changed();         ///< Motions, their content, or what is played.
  void currentChanged();  ///< Another one, or its check.

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
  std::map<std::string, std::shared_ptr<const trajectory::Trajectory>> read_;  ///< By path; null while under way.
  std::map<std::string, QString> unreadable_;
  std::string current_;
};

}  // namespace hapticell::app
