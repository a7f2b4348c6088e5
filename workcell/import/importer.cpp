// SPDX-License-Identifier: Apache-2.0
#include "workcell/import/importer.h"

#include <exception>
#include <utility>

#include "workcell/import/background_thread.h"

namespace hapticell::workcell {

using State = ImportStatus::State;

struct Importer::Job {
  ImportId id = 0;
  ImportRequest request;
  ImportMonitor monitor;
  State state = State::kQueued;
  std::optional<Expected<ImportResult>> result;
};

namespace {

Error cancelled(const std::string& what) {
  return {.file = what, .found = "the import was cancelled"};
}

/// Nothing may leave the thread: what a library throws becomes a sentence.
Expected<ImportResult> importNow(const ImportRequest& request, ImportMonitor& monitor) {
  try {
    Diagnostics diagnostics;
    EntityLoader loader(request.folder);
    auto result = loader.loadTree(request.what, request.options, diagnostics, &monitor);
    if (result) result->report.warnings = std::move(diagnostics.warnings);
    return result;
  } catch (const std::bad_alloc&) {
    return makeError(
        {.file = request.what, .found = "there is not enough memory for it", .fix = "Use a smaller or coarser model."});
  } catch (const std::exception& exception) {
    return makeError({.file = request.what, .found = Text("an unforeseen fault: %1", exception.what())});
  }
}

}  // namespace

Importer::Importer(std::function<void(ImportId)> listener)
    : listener_(std::move(listener)), thread_([this] {
        lowerThreadPriority();
        run();
      }) {}

Importer::~Importer() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    queue_.clear();
    for (auto& [id, job] : jobs_) job->monitor.cancel();
  }
  wake_.notify_all();
  thread_.join();
}

ImportId Importer::start(ImportRequest request) {
  const auto job = std::make_shared<Job>();
  job->request = std::move(request);
  ImportId id = 0;
  {
    const std::lock_guard lock(mutex_);
    id = job->id = ++last_id_;
    jobs_[id] = job;
    queue_.push_back(job);
  }
  wake_.notify_all();
  return id;
}

ImportStatus Importer::status(ImportId id) const {
  const std::lock_guard lock(mutex_);
  const auto found = jobs_.find(id);
  if (found == jobs_.end()) return {};
  return {found->second->state, found->second->monitor.progress()};
}

void Importer::cancel(ImportId id) {
  {
    const std::lock_guard lock(mutex_);
    const auto found = jobs_.find(id);
    if (found == jobs_.end() || found->second->result) return;
    const std::shared_ptr<Job>& job = found->second;
    job->monitor.cancel();
    std::erase(queue_, job);
    job->state = State::kCancelled;
    job->result = makeError(cancelled(job->request.what));
  }
  if (listener_) listener_(id);
}

std::optional<Expected<ImportResult>> Importer::take(ImportId id) {
  const std::lock_guard lock(mutex_);
  const auto found = jobs_.find(id);
  if (found == jobs_.end() || !found->second->result) return std::nullopt;
  std::optional<Expected<ImportResult>> result = std::move(found->second->result);
  jobs_.erase(found);
  return result;
}

void Importer::run() {
  while (true) {
    std::shared_ptr<Job> job;
    {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [this] { return stopping_ || !queue_.empty(); });
      if (stopping_) return;
      job = queue_.front();
      queue_.pop_front();
      job->state = State::kRunning;
    }
    finish(job, importNow(job->request, job->monitor));
  }
}

void Importer::finish(const std::shared_ptr<Job>& job, Expected<ImportResult> result) {
  {
    const std::lock_guard lock(mutex_);
    if (job->state == State::kCancelled) return;
    job->state = result ? State::kDone : State::kFailed;
    job->result = std::move(result);
    if (stopping_) return;
  }
  if (listener_) listener_(job->id);
}

}  // namespace hapticell::workcell
