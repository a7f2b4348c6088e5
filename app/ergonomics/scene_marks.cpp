// SPDX-License-Identifier: Apache-2.0
#include "app/ergonomics/scene_marks.h"

#include <QCoreApplication>
#include <array>
#include <cmath>

#include "app/ergonomics/live_scores.h"
#include "app/host/hold_choice.h"
#include "app/host/host.h"
#include "app/mannequin/mannequin_context.h"
#include "app/style/units.h"
#include "mannequin/posture/support_polygon.h"

namespace hapticell::app {
namespace {

constexpr std::uint64_t kFirstKey = 100;  ///< Of the labels, one a part.
constexpr int kArcPieces = 24;
constexpr double kArcShare = 0.55;     ///< Of the limb's length: the arc's radius.
constexpr double kLongestArc = 0.2;    // m
constexpr double kLeastAngle = 0.035;  // rad: a smaller arc is only a spot.

struct MarkText {
  Q_DECLARE_TR_FUNCTIONS(MarkText)
};

std::string said(const QString& text) {
  return text.toStdString();
}

/// From one unit vector to another, along the great circle.
dvec3 between(const dvec3& from, const dvec3& to, double angle, double share) {
  return (std::sin((1.0 - share) * angle) * from + std::sin(share * angle) * to) / std::sin(angle);
}

void addAngle(const ergonomics::JointAngle& joint, std::vector<SceneCurve>& curves) {
  using Style = SceneCurve::Style;
  const double radius = std::min(kArcShare * joint.length, kLongestArc);
  const auto line = [&](const dvec3& along, double length, Style style) {
    curves.push_back({{joint.p_W, joint.p_W + length * along}, SceneCurve::Role::kMeasure, style, 1.4, {}});
  };
  line(joint.from_W, 1.15 * radius, Style::kDashed);
  line(joint.to_W, std::max(1.15 * radius, joint.length), Style::kSolid);
  const double angle = std::acos(std::clamp(glm::dot(joint.from_W, joint.to_W), -1.0, 1.0));
  if (angle > kLeastAngle && angle < 3.1) {
    SceneCurve arc{{}, SceneCurve::Role::kMeasure, Style::kSolid, 2.2, {}};
    for (int i = 0; i <= kArcPieces; ++i)
      arc.points_W.push_back(joint.p_W +
                             radius * between(joint.from_W, joint.to_W, angle, i / static_cast<double>(kArcPieces)));
    curves.push_back(std::move(arc));
  }
  curves.push_back({{joint.p_W}, SceneCurve::Role::kMeasure, Style::kSolid, 2.0, {}});
}

StripCell sizeCell(const LiveScores& scores, const MannequinContext& context) {
  const std::array<QString, 4> names{MarkText::tr("P5 woman"), MarkText::tr("P50 woman"), MarkText::tr("P50 man"),
                                     MarkText::tr("P95 man")};
  const int own = scores.ownBody();
  const QString name = own >= 0 ? names[static_cast<std::size_t>(own)] : shown(context.entity()->name);
  return {Mark::kNone, said(name), said(lengthText(scores.figure()->body[mannequin::Dimension::kStature], 0))};
}

QString heldText(const manipulation::MovedBy& held) {
  using manipulation::isSameWay;
  if (isSameWay(held, by::Hand{mannequin::Side::kLeft})) return MarkText::tr("Left hand");
  if (isSameWay(held, by::Hand{mannequin::Side::kRight})) return MarkText::tr("Right hand");
  if (std::holds_alternative<by::BothHands>(held)) return MarkText::tr("Both hands");
  return std::holds_alternative<by::Head>(held) ? MarkText::tr("Head") : MarkText::tr("Mannequin");
}

QString activeHandsText(const std::array<bool, 2>& active) {
  if (active[0] && active[1]) return MarkText::tr("Both hands");
  return active[0] ? MarkText::tr("Left hand") : MarkText::tr("Right hand");
}

StripCell handCell(const MannequinContext& context, const std::array<bool, 2>& active) {
  if (!context.isHeld()) return {Mark::kNone, said(activeHandsText(active)), said(MarkText::tr("at work"))};
  return {Mark::kNone, said(heldText(context.host().holdChoice().movedBy())), said(MarkText::tr("held"))};
}

StripCell balanceCell(const LiveScores& scores, const mannequin::FigurePose& pose) {
  if (scores.scores().is_seated)
    return {Mark::kNone, said(MarkText::tr("Seated")), said(MarkText::tr("carried by the seat"))};
  const mannequin::Figure& figure = *scores.figure();
  const auto support =
      mannequin::supportPolygon(figure, {pose[mannequin::Segment::kLeftFoot], pose[mannequin::Segment::kRightFoot]},
                                mannequin::standingFeet(figure, pose));
  const double margin = support.margin(glm::dvec2(mannequin::centerOfMass(figure, pose)));
  if (margin < 0.0) return {Mark::kLimit, said(lengthText(-margin, 0)), said(MarkText::tr("out of balance"))};
  return {Mark::kNone, said(lengthText(margin, 0)), said(MarkText::tr("in balance"))};
}

std::vector<StripCell> stripOf(const LiveScores& scores, const MannequinContext& context,
                               const mannequin::FigurePose& pose) {
  constexpr double kLittle = 0.01;  // m
  const auto active = ergonomics::activeHands(pose, scores.posture());
  const double left = ergonomics::reachLeft(*scores.figure(), pose, active);
  const by::BothHands& chosen = context.host().holdChoice().hands();
  return {sizeCell(scores, context),
          handCell(context, active),
          {left < kLittle ? Mark::kLimit : Mark::kNone, said(lengthText(left, 0)), said(MarkText::tr("of reach left"))},
          balanceCell(scores, pose),
          {Mark::kNone, said(chosen.may_step ? MarkText::tr("Feet can step") : MarkText::tr("Feet locked")),
           said(chosen.locks.trunk ? MarkText::tr("trunk locked") : MarkText::tr("trunk free"))}};
}

}  // namespace

SceneMarks sceneMarks(const LiveScores& scores, const MannequinContext& context, ergonomics::PostureMethod method) {
  SceneMarks marks;
  if (scores.isEmpty() || !context.entity()) return marks;
  const auto pose = mannequin::forwardKinematics(*scores.figure(), scores.posture());
  for (const auto& part : ergonomics::drivingParts(scores.scores(), method)) {
    const ergonomics::JointAngle joint = ergonomics::jointAngle(pose, part);
    OverlayLabel label;
    label.key = kFirstKey + static_cast<std::uint64_t>(part.part);
    label.number = std::to_string(std::lround(part.angle)) + "°";
    label.title = ergonomics::jointWords(part, shownLanguage());
    label.names = ergonomics::drivingWords(scores.scores(), method, part, shownLanguage());
    label.p_WQ = joint.p_W;
    label.band = part.band;
    marks.labels.push_back(std::move(label));
    addAngle(joint, marks.curves);
  }
  marks.strip = stripOf(scores, context, pose);
  return marks;
}

}  // namespace hapticell::app
