// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <map>
#include <memory>

#include "manipulation/engine/manipulation_command.h"
#include "manipulation/engine/take_recorder.h"

namespace hapticell::app {

class Host;

/// Records what is moved in the window (jogged, dragged by a gizmo, typed) while no module moves anything: everything
/// that differs from its pose at the start, a hundred times a second. GUI thread.
class WindowRecorder : public QObject {
  Q_OBJECT
 public:
  explicit WindowRecorder(Host& host, QObject* parent = nullptr);
  ~WindowRecorder() override;
  double seconds() const;
  std::size_t frames() const { return recorder_ ? recorder_->frames() : 0; }
  std::size_t framesByHand() const { return recorder_ ? recorder_->framesByHand() : 0; }
  bool isRecording() const { return recorder_ != nullptr; }

 private:
  void start(const manipulation::command::StartRecording& wanted);
  void stop();
  void mark();
  void look();
  void add(const workcell::Entity& entity, double t, bool by_hand);
  Host& host_;
  std::unique_ptr<manipulation::TakeRecorder> recorder_;
  std::map<workcell::EntityId, std::pair<Pose, std::vector<double>>> start_;  ///< All poses and joint values at first.
  std::map<workcell::EntityId, bool> moves_;
  QTimer timer_;
  QElapsedTimer clock_;
};

}  // namespace hapticell::app
