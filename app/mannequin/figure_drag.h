// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QThreadPool>
#include <memory>
#include <optional>

#include "manipulation/engine/manipulation_command.h"
#include "manipulation/holding/figure_way.h"

namespace hapticell::app {

class MannequinContext;

/// Moves the mannequin by a hand, both hands or the head to the mouse's target, in a separate thread: by the same held
/// entity that the stylus moves, so that nothing is penetrated and limits, feet and balance are respected. Everything
/// between begin() and end() is one undo step. GUI thread.
class FigureDrag : public QObject {
  Q_OBJECT
 public:
  explicit FigureDrag(MannequinContext& context, QObject* parent = nullptr);
  ~FigureDrag() override;

  using Turn = manipulation::FigureWay::Turn;
  /// Starts from the mannequin's present posture. `text` names the undo step.
  void begin(const QString& text, const manipulation::MovedBy& moved_by, Turn turn = Turn::kAsWanted);
  /// Sets the target of the moved frame; only the newest counts, and it is reached even if end() follows at once.
  void moveTo(const Pose& X_WM);
  /// Ends at the present posture; if not `keep`, reverts everything.
  void end(bool keep = true);
  bool isOpen() const { return open_; }
  bool isBusy() const { return busy_; }

  /// How the last motion ended.
  using Reach = manipulation::FigureWay::Reach;
  const std::optional<Reach>& reach() const { return reach_; }
  /// True if the mannequin's own body stopped the motion.
  bool isOwnBody() const;

 signals:
  void moved();
  void ended();

 private:
  struct Work;
  void pump();
  void take(const manipulation::EntityConfiguration& stands, const Reach& reach);
  void refuse(const QString& why);
  void finish();
  void forgetCell();
  /// Forgets how the last motion ended if the mannequin has another posture since (undo, a posture).
  void forgetReach();
  MannequinContext& context_;
  std::shared_ptr<Work> work_;
  workcell::EntityId entity_ = 0;
  manipulation::MovedBy moved_by_;
  std::optional<Pose> wanted_;
  std::optional<Reach> reach_;
  bool open_ = false, busy_ = false, under_way_ = false, ending_ = false, keep_ = true;
  QThreadPool pool_;
};

/// Pose of the frame by which a hand or the head is moved: the grip, the middle of both hands, the middle of the eyes.
Pose movedFrame_W(const workcell::Entity& entity, const manipulation::EntityConfiguration& stands,
                  const manipulation::MovedBy& held);

}  // namespace hapticell::app
