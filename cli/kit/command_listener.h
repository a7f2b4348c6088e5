// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <exception>
#include <nlohmann/json.hpp>
#include <string>

#include "geometry/system/error.h"

namespace hapticell::cli {

/// Hears what a command says where another program than hapticell-cli runs it (python/): nothing then goes to standard
/// output or standard error. Called by the thread that runs the command, progress also by another one.
class CommandListener {
 public:
  virtual ~CommandListener() = default;
  /// The result; a command that reports more than once calls it again.
  virtual void hearResult(const nlohmann::ordered_json& result) = 0;
  /// What hapticell-cli would print instead of a result: a table, a help text.
  virtual void hearText(const std::string& text) = 0;
  virtual void hearError(const Error& error) = 0;
  virtual void hearWarning(const Text& sentence) = 0;
  /// `share` of the work is done, 0 to 1; negative if it is not known.
  virtual void hearProgress(double share, const std::string& stage) = 0;
  /// True once the command is asked to end. Any thread.
  const std::atomic<bool>& stopAsked() const { return stop_asked_; }
  /// Any thread.
  void askToStop() { stop_asked_ = true; }

 private:
  std::atomic<bool> stop_asked_{false};
};

/// The listener of this thread; null: the command is run by hapticell-cli itself.
CommandListener* commandListener();

/// While it lives, `listener` hears the commands of this thread.
class ListenerOfThread {
 public:
  explicit ListenerOfThread(CommandListener& listener);
  ~ListenerOfThread();
  ListenerOfThread(const ListenerOfThread&) = delete;
  ListenerOfThread& operator=(const ListenerOfThread&) = delete;

 private:
  CommandListener* before_;
};

/// A listener asked the command to end; runCommand() catches it.
struct Stopped : std::exception {
  const char* what() const noexcept override { return "stopped"; }
};

/// What the listener of this thread sets when it asks to stop, for work that looks for it by itself; null without one.
const std::atomic<bool>* stopFlag();

/// Ends the command by Stopped if the listener of this thread asked for it. Long loops call it; without a listener it
/// does nothing, since a signal ends hapticell-cli.
void stopWhereAsked();

}  // namespace hapticell::cli
