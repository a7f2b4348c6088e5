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

/// Drags the mannequin by a hand, both hands or the head to the mouse's target, in a separate thread: through the same
/// held entity that the stylus moves, so that nothing is entered and limits, feet and balance hold. All between begin()
/// and end() is one step of undo. GUI thread.
class FigureDrag : public QObject {
  Q_OBJECT
 public:
  explicit FigureDrag(MannequinContext& context, QObject* parent = nullptr);
  ~FigureDrag() override;

  using Turn = manipulation::FigureWay::Turn;
  /// Takes the mannequin in its present posture. `text` names the step.
  void begin(const QString& text, const manipulation::MovedBy& moved_by, Turn turn = Turn::kAsWanted);
  /// Where the moved frame shall be; the newest counts, and is reached even when end() follows at once.
  void moveTo(const Pose& X_WM);
  /// Ends it in its present posture; `keep` false takes all back.
  void end(bool keep = true);
  bool isOpen() const { return open_; }
  bool isBusy() const { return busy_; }

  /// How the last motion ended.
  using Reach = manipulation::FigureWay::Reach;
  const std::optional<Reach>& reach() const { return reach_; }
  /// What holds it up is the figure itself.
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
  /// Forgets how the last motion ended once the figure stands otherwise (undo, a posture).
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

/// Pose of what a hand or the head is drawn by: the grip, the middle between both hands, the point between the eyes.
Pose movedFrame_W(const workcell::Entity& entity, const manipulation::EntityConfiguration& stands,
                  const manipulation::MovedBy& held);

}  // namespace hapticell::app
