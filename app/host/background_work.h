// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <deque>
#include <functional>
#include <memory>

#include "geometry/system/error.h"
#include "workcell/scenes/import_monitor.h"

namespace hapticell::app {

/// Work on files in the background that ends with a message or a change of the document: exports, reports, reading
/// shapes again. One job after the other. GUI thread, except for the work itself.
class BackgroundWork : public QObject {
  Q_OBJECT
 public:
  /// Runs in the worker; must not touch anything of the window. Returns what to do afterwards in the window's thread.
  using Then = std::function<void()>;
  using Work = std::function<Expected<Then>(workcell::ImportMonitor& monitor)>;
  using Failed = std::function<void(const Error&)>;

  explicit BackgroundWork(QObject* parent = nullptr);
  /// Ends running work within a second, if that work checks its monitor.
  ~BackgroundWork() override;

  /// `name` is shown while the work runs. An exception of the work becomes an error.
  void start(const QString& name, Work work, Failed failed);
  bool isBusy() const { return !runs_.empty(); }
  QString name() const;
  workcell::ImportProgress progress() const;
  /// Cancels the running job.
  void cancel();

 signals:
  void progressed();  ///< Twenty times a second while busy, and once when all jobs are done.

 private:
  struct Run;
  std::deque<std::shared_ptr<Run>> runs_;
  QTimer poll_;
  QThreadPool worker_;
};

}  // namespace hapticell::app
