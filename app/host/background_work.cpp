// SPDX-License-Identifier: Apache-2.0
#include "app/host/background_work.h"

#include <exception>
#include <utility>

namespace hapticell::app {

struct BackgroundWork::Run {
  QString name;
  workcell::ImportMonitor monitor;
};

namespace {

Expected<BackgroundWork::Then> guarded(const BackgroundWork::Work& work, workcell::ImportMonitor& monitor) {
  try {
    return work(monitor);
  } catch (const std::exception& exception) {
    return makeError({.found = Text("an unexpected error: %1", exception.what())});
  }
}

}  // namespace

BackgroundWork::BackgroundWork(QObject* parent) : QObject(parent) {
  worker_.setMaxThreadCount(1);
  poll_.setInterval(50);
  connect(&poll_, &QTimer::timeout, this, &BackgroundWork::progressed);
}

BackgroundWork::~BackgroundWork() {
  for (const auto& run : runs_) run->monitor.cancel();
  worker_.waitForDone();
}

QString BackgroundWork::name() const {
  return runs_.empty() ? QString() : runs_.front()->name;
}

workcell::ImportProgress BackgroundWork::progress() const {
  return runs_.empty() ? workcell::ImportProgress{} : runs_.front()->monitor.progress();
}

void BackgroundWork::cancel() {
  if (!runs_.empty()) runs_.front()->monitor.cancel();
}

void BackgroundWork::start(const QString& name, Work work, Failed failed) {
  auto run = std::make_shared<Run>();
  run->name = name;
  runs_.push_back(run);
  poll_.start();
  worker_.start([this, run, work = std::move(work), failed = std::move(failed)] {
    auto done = std::make_shared<Expected<Then>>(guarded(work, run->monitor));
    const auto end = [this, done, failed] {
      runs_.pop_front();
      if (runs_.empty()) poll_.stop();
      emit progressed();
      if (!*done) return failed(done->error());
      if (**done) (**done)();
    };
    QMetaObject::invokeMethod(this, end, Qt::QueuedConnection);
  });
  emit progressed();
}

}  // namespace hapticell::app
