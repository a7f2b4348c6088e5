// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/overlay/overlay_labels.h"

#include <QCoreApplication>
#include <algorithm>

#include "app/style/library_text.h"

namespace hapticell::app {
namespace {

constexpr std::uint64_t kContactKey = 1, kNearMissKey = 2, kLimitKey = 3;

struct OverlayText {
  Q_DECLARE_TR_FUNCTIONS(OverlayText)
};

std::string pairNames(const SceneModel& scene, const manipulation::PairState& pair) {
  return scene.nameOf(pair.moved, pair.moved_part) + " – " + scene.nameOf(pair.other, pair.other_part);
}

/// "A5 is 1.2° from its upper limit and pushes back".
std::string limitWords(const manipulation::SceneSnapshot& snapshot) {
  const manipulation::LimitState& limit = snapshot.limits.front();
  const std::string words = shownText(limit.text).toStdString();
  return limit.holds && snapshot.stylus.forces_on ? words + OverlayText::tr(" and pushes back").toStdString() : words;
}

}  // namespace

std::vector<OverlayLabel> overlayLabels(const SceneModel& scene) {
  std::vector<OverlayLabel> labels;
  if (!scene.snapshot()) return labels;
  const manipulation::SceneSnapshot& snapshot = *scene.snapshot();
  const auto contact =
      std::find_if(snapshot.pairs.begin(), snapshot.pairs.end(), [](const auto& p) { return p.contact; });
  if (contact != snapshot.pairs.end())
    labels.push_back({kContactKey, Mark::kContact, OverlayText::tr("Contact").toStdString(), pairNames(scene, *contact),
                      contact->p_WB});
  const auto near =
      std::find_if(snapshot.pairs.begin(), snapshot.pairs.end(), [](const auto& p) { return !p.contact; });
  // While something touches, a distance that is no near miss would only distract.
  if (near != snapshot.pairs.end() && (near->near_miss || contact == snapshot.pairs.end()))
    labels.push_back({kNearMissKey, near->near_miss ? Mark::kNearMiss : Mark::kNone, millimetres(near->distance),
                      pairNames(scene, *near), 0.5 * (near->p_WA + near->p_WB)});
  if (!snapshot.limits.empty())
    labels.push_back({kLimitKey, Mark::kLimit, OverlayText::tr("Limit").toStdString(), limitWords(snapshot),
                      snapshot.stylus.X_WStylus.p});
  return labels;
}

double forceArrowLength(double newtons) {
  return std::clamp(40.0 + 80.0 * newtons, 0.0, 200.0);
}

double forceArrowOpacity(double newtons) {
  return std::clamp((newtons - 0.02) / 0.03, 0.0, 1.0);
}

dvec3 forceArrowStart_W(const manipulation::SceneSnapshot& snapshot) {
  const auto contact =
      std::find_if(snapshot.pairs.begin(), snapshot.pairs.end(), [](const auto& p) { return p.contact; });
  return contact != snapshot.pairs.end() ? contact->p_WB : snapshot.stylus.X_WStylus.p;
}

std::optional<ForceArrow> forceArrow(const manipulation::SceneSnapshot& snapshot, const Camera& camera,
                                     const ViewSize& size) {
  const double opacity = forceArrowOpacity(snapshot.stylus.force_n);
  const double force = glm::length(snapshot.stylus.force_W);
  if (opacity <= 0.0 || force <= 0.0) return std::nullopt;
  const auto from = camera.project(forceArrowStart_W(snapshot), size);
  if (!from) return std::nullopt;
  const dvec3 direction = snapshot.stylus.force_W / force;
  const glm::dvec2 seen(glm::dot(direction, camera.right_W()), -glm::dot(direction, camera.up_W()));
  const double share = glm::length(seen);
  const glm::dvec2 along = share > 1e-6 ? seen / share : glm::dvec2(0, -1);
  // Seen from its end an arrow is short, but it never disappears.
  const double length = forceArrowLength(snapshot.stylus.force_n) * std::max(share, 0.25);
  return ForceArrow{*from, *from + length * along, opacity, newtons(snapshot.stylus.force_n)};
}

}  // namespace hapticell::app
