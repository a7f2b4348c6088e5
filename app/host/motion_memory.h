// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QElapsedTimer>
#include <deque>
#include <functional>
#include <map>
#include <vector>

#include "geometry/shapes/pose.h"
#include "workcell/entity/entity.h"

namespace hapticell::app {

class DocumentModel;

/// Remembers the placements of all entities during the last minute of motion, so that "go back ten seconds" works
/// without a recording. Time without motion does not count. GUI thread.
class MotionMemory {
  Q_DECLARE_TR_FUNCTIONS(MotionMemory)
 public:
  struct Place {
    Pose X_WE;
    std::vector<double> joints;
    bool operator==(const Place& other) const;
  };
  using Places = std::map<workcell::EntityId, Place>;
  /// Seconds of motion: six steps of going back (go_back.cpp). Memory is proportional: half gives three steps, double
  /// gives twelve.
  static constexpr double kKept = 60.0;

  /// `places` gives the present placements of all entities, as drawn.
  MotionMemory(DocumentModel& document, std::function<Places()> places);
  /// Keeps what moved since the last call; `seconds` is the time between the calls (longer pauses count as 0.2).
  void look(double seconds);
  /// The same with the clock's time, at most ten times a second.
  void look();
  /// Moves everything back to where it was `seconds` of motion ago (or at the earliest known time), as one undo step;
  /// entities that are locked or removed stay. Another call continues from there. False: nothing moved.
  bool goBack(double seconds);
  /// Forgets everything, for another document.
  void forget();

 private:
  struct Step {
    double seconds = 0.0;
    Places before;  ///< Of the entities that moved.
  };
  DocumentModel& document_;
  std::function<Places()> places_;
  Places last_;
  std::deque<Step> steps_;
  double kept_ = 0.0;
  QElapsedTimer since_look_;
  bool going_back_ = false;
};

}  // namespace hapticell::app
