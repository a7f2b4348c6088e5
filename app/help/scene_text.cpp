// SPDX-License-Identifier: Apache-2.0
#include "app/help/scene_text.h"

#include <QCoreApplication>
#include <QStringList>
#include <array>

#include "app/style/units.h"

namespace hapticell::app {
namespace {

// Pairs that are read aloud: more are not kept in mind. Half, twice: shorter or longer texts.
constexpr std::size_t kMostPairs = 6;

struct SceneText {
  Q_DECLARE_TR_FUNCTIONS(SceneText)
};

QString countLine(const workcell::DocumentState& state) {
  std::array<int, 6> counts{};
  int hidden = 0, locked = 0;
  for (const auto& entity : state.entities) {
    ++counts[static_cast<std::size_t>(entity->kind())];
    hidden += !entity->visible;
    locked += entity->locked;
  }
  if (state.entities.empty()) return SceneText::tr("The cell is empty.");
  QStringList parts;
  const std::array<const char*, 6> kinds{
      QT_TRANSLATE_N_NOOP("SceneText", "%n solids"),     QT_TRANSLATE_N_NOOP("SceneText", "%n robots"),
      QT_TRANSLATE_N_NOOP("SceneText", "%n mechanisms"), QT_TRANSLATE_N_NOOP("SceneText", "%n assemblies"),
      QT_TRANSLATE_N_NOOP("SceneText", "%n mannequins"), QT_TRANSLATE_N_NOOP("SceneText", "%n frames")};
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] > 0) parts << SceneText::tr(kinds[i], nullptr, counts[i]);
  QString line = SceneText::tr("In the cell: %1.").arg(parts.join(QStringLiteral(", ")));
  if (hidden > 0) line += QLatin1Char(' ') + SceneText::tr("%n are hidden.", nullptr, hidden);
  if (locked > 0) line += QLatin1Char(' ') + SceneText::tr("%n are locked.", nullptr, locked);
  return line;
}

void appendSelected(const workcell::DocumentState& state, const std::vector<workcell::EntityId>& selected,
                    const SceneModel& scene, QStringList& lines) {
  for (const auto id : selected) {
    const workcell::Entity* entity = state.find(id);
    if (!entity) continue;
    const dvec3 p_W = scene.placement_W(*entity).p;
    lines << SceneText::tr("Selected: %1, at X %2, Y %3, Z %4.")
                 .arg(QString::fromStdString(entity->name), lengthText(p_W.x), lengthText(p_W.y), lengthText(p_W.z));
  }
}

void appendLive(const SceneModel& scene, QStringList& lines) {
  const auto& now = scene.snapshot();
  if (!now) return;
  std::size_t told = 0;
  for (const auto& pair : now->pairs) {
    if (!pair.contact && !pair.near_miss) continue;
    if (++told > kMostPairs) break;
    const QString a = QString::fromStdString(scene.nameOf(pair.moved, pair.moved_part));
    const QString b = QString::fromStdString(scene.nameOf(pair.other, pair.other_part));
    lines << (pair.contact ? SceneText::tr("%1 touches %2.").arg(a, b)
                           : SceneText::tr("%1 is %2 from %3: a near miss.").arg(a, lengthText(pair.distance), b));
  }
  if (!now->limits.empty()) lines << SceneText::tr("%n limits reached.", nullptr, static_cast<int>(now->limits.size()));
  const workcell::Entity* held = scene.find(now->stylus.held);
  lines << (held ? SceneText::tr("Held by the stylus: %1.").arg(QString::fromStdString(held->name))
                 : SceneText::tr("Nothing is held."));
  lines << (now->stylus.forces_on ? SceneText::tr("Forces are on: %1.").arg(forceText(now->stylus.force_n))
                                  : SceneText::tr("Forces are off."));
}

}  // namespace

QString sceneText(const workcell::DocumentState& state, const std::vector<workcell::EntityId>& selected,
                  const SceneModel& scene) {
  QStringList lines;
  appendLive(scene, lines);
  appendSelected(state, selected, scene, lines);
  lines << countLine(state);
  return lines.join(QLatin1Char('\n'));
}

}  // namespace hapticell::app
