// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <atomic>
#include <map>
#include <memory>
#include <string>

#include "access/access_answer.h"
#include "app/host/background_work.h"

namespace hapticell::app {

class Host;

/// What the user asks about a part; lengths in m.
struct AccessWish {
  enum class Persons { kBoundary, kWomen, kMen, kNobody };  ///< kBoundary: as the command line without options.
  std::string part;
  Persons persons = Persons::kBoundary;
  double tolerance = 1e-4, glove = 2e-3;
  double tool_length = 0.0, tool_diameter = 0.0;  ///< Length 0: no tool.
};

/// Asks about access in the background, and keeps the question with its answer until another document follows. The
/// document is only read. GUI thread.
class AccessJob : public QObject {
  Q_OBJECT
 public:
  explicit AccessJob(Host& host, QObject* parent = nullptr);
  /// Cancels and waits for the work.
  ~AccessJob() override;

  /// Asks; the earlier answer is dropped. Does nothing while isBusy().
  void ask(const AccessWish& wish);
  /// Checks a recorded motion as the way of a step; if it is free, it replaces that step's way, with its own clearances
  /// and, for the last step, persons. Does nothing while isBusy(). @pre answer() has that step
  void showByHand(std::size_t step, std::shared_ptr<const trajectory::Trajectory> shown);
  /// Measures the way of a step as a motion (access::keptMotion()), to be kept; kept() or failed() follows. Does nothing
  /// while isBusy(). @pre answer() has that step
  void keep(std::size_t step);
  void cancel();
  bool isBusy() const { return work_.isBusy(); }
  double progress() const { return work_.progress().share; }

  /// Null: nothing was answered.
  const access::AccessAnswer* answer() const { return answer_.get(); }
  const access::AccessQuestion& question() const { return question_; }
  /// Whether anything but the parts that go first stands elsewhere than when it was asked.
  bool isOutdated() const;

 signals:
  void progressed();
  void changed();  ///< The answer came, changed or was dropped.
  void failed(const hapticell::Error& error);
  /// The motion of a step is as promised; not yet in the document.
  void kept(const std::shared_ptr<const hapticell::trajectory::Trajectory>& motion);

 private:
  void start(const QString& name, BackgroundWork::Work work);
  void drop();

  Host& host_;
  access::AccessQuestion question_;
  std::shared_ptr<const access::AccessAnswer> answer_;
  std::map<workcell::EntityId, Pose> X_WE_;  ///< When it was asked.
  std::shared_ptr<std::atomic<bool>> stop_ = std::make_shared<std::atomic<bool>>(false);
  BackgroundWork work_;  ///< Last: it ends first.
};

}  // namespace hapticell::app
