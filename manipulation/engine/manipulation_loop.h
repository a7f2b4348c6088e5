// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "config/configuration.h"
#include "haptic/transport/haptic_link.h"
#include "manipulation/engine/manipulation_command.h"
#include "manipulation/engine/scene_snapshot.h"

namespace hapticell::manipulation {

class PreparedScene;
class SceneService;

/// The manipulation loop in its own thread: as fast as its queries allow, from 10 up to Configuration::Manipulation's
/// rate. It never waits for the window or for the socket. If nothing is held, forces are off and the stylus does not
/// move, it makes only 50 steps a second until the stylus moves or a command arrives (SceneSnapshot::idle).
///
/// post() and takeResults() may be called from any thread; latest() from one (the window's). A separate thread prepares
/// the meshes of a new document; until they are ready the old scene stays in use.
class ManipulationLoop {
 public:
  /// Starts the thread. From now on only that thread uses the link. `on_felt` is called in that thread as soon as
  /// latest() has the snapshot of a new contact, so that it can be shown at once; it must not wait. May be empty.
  /// `scenes` prepares the documents; null: the loop uses its own.
  ManipulationLoop(std::unique_ptr<haptic::HapticLink> link, const config::Configuration& configuration,
                   std::function<void()> on_felt = {}, std::shared_ptr<SceneService> scenes = {});
  /// Stops it: forces off, set emptied, thread joined.
  ~ManipulationLoop();
  ManipulationLoop(const ManipulationLoop&) = delete;
  ManipulationLoop& operator=(const ManipulationLoop&) = delete;

  /// Queues a command for the next step. Holds a lock only while a pointer is moved.
  void post(Command command);
  /// A second stylus in the same cell (manipulation/engine/second_stylus.h); null removes it and releases what it
  /// holds.
  void setSecondStylus(std::unique_ptr<haptic::HapticLink> link);
  /// Posts a command for the second stylus; ignored if there is no second stylus.
  void postSecond(Command command);
  /// Copies the newest snapshot if there is one since the last call; else returns false.
  bool latest(SceneSnapshot& snapshot);
  /// Results since the last call, in order.
  std::vector<Result> takeResults();
  /// Ends the loop: executes the commands posted before, releases what is held and ends a recording. Returns the
  /// results as takeResults() does, including these. Later commands are ignored. The calling thread waits for a step.
  std::vector<Result> finish();
  /// Progress of preparing a new document, 0 to 1; empty if idle. Any thread.
  std::optional<double> preparation() const;
  /// Cancels the preparation. The old scene stays in use, and changes of the document are not felt until the next one
  /// is posted.
  void cancelPreparation();

  /// The newest prepared document; null before the first. Any thread.
  std::shared_ptr<const PreparedScene> scene() const;

 private:
  struct Worker;
  std::unique_ptr<Worker> worker_;
};

}  // namespace hapticell::manipulation
