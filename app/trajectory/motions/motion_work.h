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

/// Work on motions in the background: each edit makes a new motion (one undo step) and a line that says what it did and
/// how far the result deviates from the original. One job after the other, with progress and cancel
/// (MotionList::work()). GUI thread, except for the work itself.
class MotionWork : public QObject {
  Q_OBJECT
 public:
  MotionWork(Host& host, MotionList& list, QObject* parent = nullptr);

  /// Keeps only the frames needed within the tolerance.
  void simplify(const trajectory::PathTolerance& tolerance);
  /// Smooths within the tolerance; `keep_free`: stays closer to the recording where it would collide.
  void smooth(const trajectory::PathTolerance& tolerance, bool keep_free);
  /// Computes new times. Joint limits are the robot's where `options` has none; `keep_free` as for smooth().
  void retime(trajectory::RetimingOptions options, bool keep_free);
  /// Checks limits, singularities, configurations and collisions along the current motion.
  void check();

  /// An edit of the current motion. `word` names it ("reversed") in the new motion's name and in the undo step.
  using Edit = std::function<Expected<std::vector<trajectory::Trajectory>>(const trajectory::Trajectory&)>;
  void edit(const QString& word, Edit edit);
  /// Edits frames: in a program (all frames set by hand) in place, in a recording as a copy.
  void editPoints(const QString& word, Edit edit);
  /// Joins all motions of the current one's entity that are played or in `names`, one after the other.
  void join(const std::vector<std::string>& names);

  const QString& line() const { return line_; }

 signals:
  void told(const QString& line, bool careful);  ///< Result of an edit; `careful`: a warning or a refusal.
  void missed();                                 ///< The last result is a missed request: show it red.

 private:
  /// The document data that the worker needs.
  struct Cell {
    std::vector<std::shared_ptr<const workcell::Entity>> entities;
    manipulation::SceneSource source;
    std::shared_ptr<manipulation::SceneService> scenes;
    config::Configuration configuration;
    /// Recorded together with the edited motion: what carries its robot moves at the same time.
    std::vector<std::shared_ptr<const trajectory::Trajectory>> take;
  };
  struct Result {
    std::vector<trajectory::Trajectory> motions;
    QString line;
    bool careful = false;
    bool missed = false;  ///< A request was missed; the line says which one.
    std::optional<manipulation::PathCheckResult> check;
  };
  using Work = std::function<Expected<Result>(const std::shared_ptr<const trajectory::Trajectory>&, const Cell&,
                                              workcell::ImportMonitor&)>;
  void run(const QString& word, Work work, bool in_place = false);
  static Work workOf(const QString& line, Edit edit);
  /// Measures the newest motion as if its file were read back, and says what it misses.
  static void measure(Result& result, const MeasureMotion& measure);
  static void takeKept(manipulation::KeptFree kept, Result& result);
  std::shared_ptr<const Cell> cell() const;
  void tell(const QString& line, bool careful);

  Host& host_;
  MotionList& list_;
  QString line_;
};

/// Limits of a motion for retiming and curves: a robot's joint speeds (reached in a quarter of a second if nothing else
/// is known), 0.5 m/s and 2 rad/s for a solid.
trajectory::MotionLimits limitsOf(const workcell::Entity& entity, const trajectory::Trajectory& trajectory);

}  // namespace hapticell::app
