// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointF>
#include <optional>

#include "geometry/shapes/pose.h"

namespace hapticell::app {

class Host;

/// A person's hand that leads agents: the mouse pulls the moved frame in the plane of the screen, or the stylus leads by
/// its own motion. GUI thread.
class AgentHand final : public QObject {
  Q_OBJECT
 public:
  explicit AgentHand(Host& host, QObject* parent = nullptr);

  /// Takes the pointer near the moved frame while on.
  void setOn(bool on);
  void setStylusLeads(bool leads);
  /// Where the moved frame is now. Ten times a second or more.
  void setFrame(const Pose& X_WM) { X_WM_ = X_WM; }
  /// What the hand wants of it now (m/s, rad/s); empty: the hand is away.
  std::optional<Twist> velocity();
  bool isDragging() const { return target_.has_value(); }
  /// Where the mouse pulls it to.
  const std::optional<dvec3>& target_W() const { return target_; }

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool take(const QPointF& place);
  void pull(const QPointF& place);
  std::optional<dvec3> underPointer(const QPointF& place, const dvec3& p_W) const;

  struct StylusAt {
    double t = 0.0;
    Pose X_WS;
  };
  Host& host_;
  bool on_ = false, stylus_leads_ = false;
  Pose X_WM_;
  std::optional<dvec3> target_;
  dvec3 grip_{0.0};  ///< From the point under the pointer to the frame, at the press.
  std::optional<StylusAt> stylus_;
  std::optional<Twist> stylus_velocity_;
};

}  // namespace hapticell::app
