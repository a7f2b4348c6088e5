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

/// Remembers where everything stood during the last minute of motion, so that "go back ten seconds" works without a
/// recording. Time in which nothing moves does not count. GUI thread.
class MotionMemory {
  Q_DECLARE_TR_FUNCTIONS(MotionMemory)
 public:
  struct Place {
    Pose X_WE;
    std::vector<double> joints;
    bool operator==(const Place& other) const;
  };
  using Places = std::map<workcell::EntityId, Place>;
  /// Seconds of motion: six times what one step of going back takes (go_back.cpp). Half, twice: three or twelve steps,
  /// memory in proportion.
  static constexpr double kKept = 60.0;

  /// `places` gives the present placements of all entities, as drawn.
  MotionMemory(DocumentModel& document, std::function<Places()> places);
  /// Keeps what moved since the last look; `seconds` lie between the two (longer pauses count as 0.2).
  void look(double seconds);
  /// The same by the clock, ten times a second at the most.
  void look();
  /// Puts everything where it stood `seconds` of motion ago (or as early as is known), as one step of undo; what is
  /// locked or gone stays. Called again, it goes on from there. False: nothing moved.
  bool goBack(double seconds);
  /// Another document: nothing is known of it.
  void forget();

 private:
  struct Step {
    double seconds = 0.0;
    Places before;  ///< Of those that moved.
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
