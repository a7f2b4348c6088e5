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
/// rate. It never waits for the window or for the socket. While nothing is held, forces are off and the stylus lies
/// still, it rests: 50 steps a second, until the stylus moves or a command comes (SceneSnapshot::idle).
///
/// post() and takeResults() may be called from any thread; latest() from one (the window's). Meshes of a new document
/// are prepared in a thread of their own; until they are ready the old scene goes on.
class ManipulationLoop {
 public:
  /// Starts the thread. The link is used by that thread alone from now on. `on_felt` is called in that thread as soon
  /// as latest() has a picture of a new contact, so that nobody has to wait to see it; it must not wait. May be empty.
  /// `scenes` prepares the documents; null: one of its own.
  ManipulationLoop(std::unique_ptr<haptic::HapticLink> link, const config::Configuration& configuration,
                   std::function<void()> on_felt = {}, std::shared_ptr<SceneService> scenes = {});
  /// Stops it: forces off, set emptied, thread joined.
  ~ManipulationLoop();
  ManipulationLoop(const ManipulationLoop&) = delete;
  ManipulationLoop& operator=(const ManipulationLoop&) = delete;

  /// Queues a command for the next step. Holds a lock only for as long as a pointer is moved.
  void post(Command command);
  /// A second stylus in the same cell (manipulation/engine/second_stylus.h); null takes it away: what it holds is let
  /// go.
  void setSecondStylus(std::unique_ptr<haptic::HapticLink> link);
  /// A command for the second stylus; dropped while there is none.
  void postSecond(Command command);
  /// Copies the newest snapshot if there is one since the last call; false when there is none.
  bool latest(SceneSnapshot& snapshot);
  /// What happened since the last call, in order.
  std::vector<Result> takeResults();
  /// Ends the loop: commands posted before are carried out, what is held is let go, a recording is ended; results as
  /// takeResults() gives them, with those of this. No command is taken after it. The posting thread waits for a step.
  std::vector<Result> finish();
  /// What is being made ready of a new document, 0 to 1 of it; nothing while nothing is. Any thread.
  std::optional<double> preparation() const;
  /// Gives it up: the old scene goes on, and what the document has since is not felt until the next one is posted.
  void cancelPreparation();

  /// The newest document as it was prepared; null before the first is. Any thread.
  std::shared_ptr<const PreparedScene> scene() const;

 private:
  struct Worker;
  std::unique_ptr<Worker> worker_;
};

}  // namespace hapticell::manipulation
