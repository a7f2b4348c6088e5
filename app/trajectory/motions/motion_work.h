// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/trajectory/motions/kept_motion.h"
#include "app/trajectory/motions/motion_list.h"
#include "manipulation/checks/kept_free.h"
#include "manipulation/scene/scene_service.h"
#include "trajectory/editing/editing.h"
#include "trajectory/timing/retiming.h"

namespace hapticell::app {

/// Work on motions in the background: each edit gives a new motion (one step of undo) and a line that says what it did
/// and how far the result is from what it was made of. One piece after the other, with progress and cancel
/// (MotionList::work()). GUI thread, but for the work itself.
class MotionWork : public QObject {
  Q_OBJECT
 public:
  MotionWork(Host& host, MotionList& list, QObject* parent = nullptr);

  /// Frames that are enough within the tolerance.
  void simplify(const trajectory::PathTolerance& tolerance);
  /// Smoothed within the tolerance; `keep_free`: nearer to the recording where it would collide.
  void smooth(const trajectory::PathTolerance& tolerance, bool keep_free);
  /// New times; limits of joints are the robot's where `options` has none; `keep_free` as for smooth().
  void retime(trajectory::RetimingOptions options, bool keep_free);
  /// Limits, singular places, configurations and collisions along the current motion.
  void check();

  /// Any edit of the current motion. `word` names it ("reversed") in the new motion's name and in the undo step.
  using Edit = std::function<Expected<std::vector<trajectory::Trajectory>>(const trajectory::Trajectory&)>;
  void edit(const QString& word, Edit edit);
  /// An edit of points: of a program, all of whose points were set by somebody, in its place; of a recording as a copy.
  void editPoints(const QString& word, Edit edit);
  /// All motions of the current one's entity that are played or named, one after the other.
  void join(const std::vector<std::string>& names);

  const QString& line() const { return line_; }

 signals:
  void told(const QString& line, bool careful);  ///< What an edit did; `careful`: a warning or a refusal.
  void missed();                                 ///< The last line reports a missed request: show it red.

 private:
  /// The document as the worker needs it.
  struct Cell {
    std::vector<std::shared_ptr<const workcell::Entity>> entities;
    manipulation::SceneSource source;
    std::shared_ptr<manipulation::SceneService> scenes;
    config::Configuration configuration;
    /// Recorded together with the motion that is worked on: what its robot stands on moves meanwhile.
    std::vector<std::shared_ptr<const trajectory::Trajectory>> take;
  };
  struct Result {
    std::vector<trajectory::Trajectory> motions;
    QString line;
    bool careful = false;
    bool missed = false;  ///< Something that was asked; the line says what.
    std::optional<manipulation::PathCheckResult> check;
  };
  using Work = std::function<Expected<Result>(const std::shared_ptr<const trajectory::Trajectory>&, const Cell&,
                                              workcell::ImportMonitor&)>;
  void run(const QString& word, Work work, bool in_place = false);
  static Work workOf(const QString& line, Edit edit);
  /// Measures the newest motion as its file would be read back, and says what it misses.
  static void measure(Result& result, const MeasureMotion& measure);
  static void takeKept(manipulation::KeptFree kept, Result& result);
  std::shared_ptr<const Cell> cell() const;
  void tell(const QString& line, bool careful);

  Host& host_;
  MotionList& list_;
  QString line_;
};

/// Bounds of a motion for re-timing and curves: a robot's joint speeds (reached in a quarter of a second where nothing
/// else is known), 0.5 m/s and 2 rad/s for a solid.
trajectory::MotionLimits limitsOf(const workcell::Entity& entity, const trajectory::Trajectory& trajectory);

}  // namespace hapticell::app
