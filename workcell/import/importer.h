// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "workcell/import/entity_source.h"
#include "workcell/scenes/import_monitor.h"

namespace hapticell::workcell {

using ImportId = std::uint64_t;

struct ImportRequest {
  std::string what;              ///< A file, or anything else that EntityLoader accepts.
  std::filesystem::path folder;  ///< File names are relative to it.
  ImportOptions options;
};

struct ImportStatus {
  enum class State { kUnknown, kQueued, kRunning, kDone, kFailed, kCancelled };
  State state = State::kUnknown;
  ImportProgress progress;
};

/// Imports files in the background: queued, one after the other, in a separate thread, so that the caller does not
/// wait.
///
///     const ImportId id = importer.start({"part.step", folder, options});
///     ... later, on a timer or when the listener was called: importer.status(id), importer.cancel(id)
///     if (auto result = importer.take(id)) { ... *result is an Expected<ImportResult> ... }
///
/// The result is a value (entities in tree order and a report); the document changes only when its owner calls
/// addImported(). All functions may be called from any thread; none blocks for longer than a lock.
class Importer {
 public:
  /// Calls `listener`, if given, on the importer's thread whenever a job ends: it should only wake another thread.
  explicit Importer(std::function<void(ImportId)> listener = {});
  /// Cancels everything and waits for the thread: at most 0.2 s if a process does the work, else until the present file
  /// is read.
  ~Importer();
  Importer(const Importer&) = delete;
  Importer& operator=(const Importer&) = delete;

  ImportId start(ImportRequest request);
  ImportStatus status(ImportId id) const;
  /// Removes a queued job, or cancels a running one; its result is an error that says so. Does nothing for others.
  void cancel(ImportId id);
  /// The result, once: empty until the job has ended, and after the result was taken.
  std::optional<Expected<ImportResult>> take(ImportId id);

 private:
  struct Job;
  void run();
  void finish(const std::shared_ptr<Job>& job, Expected<ImportResult> result);

  std::function<void(ImportId)> listener_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::map<ImportId, std::shared_ptr<Job>> jobs_;
  std::deque<std::shared_ptr<Job>> queue_;
  ImportId last_id_ = 0;
  bool stopping_ = false;
  std::thread thread_;  // Last: it uses all other members.
};

}  // namespace hapticell::workcell
