// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/scene/strip_text.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/style/units.h"

namespace hapticell::app {
namespace {

std::string fixed(double value, int decimals) {
  if (std::abs(value) < 0.5 * std::pow(10.0, -decimals)) value = 0.0;
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  for (char* c = text; *c; ++c)
    if (*c == ',') *c = '.';  // Whatever the process's locale says.
  return text;
}

std::string shortNumber(double value) {
  return fixed(value, std::abs(value - std::round(value)) < 0.05 ? 0 : 1);
}

/// What stands over the scene, in the window's language.
struct StripText {
  Q_DECLARE_TR_FUNCTIONS(StripText)
};

QString onContactText(workcell::OnContact on_contact) {
  if (on_contact == workcell::OnContact::kStop) return StripText::tr("Stop");
  return on_contact == workcell::OnContact::kSlide ? StripText::tr("Slide") : StripText::tr("Pass");
}

}  // namespace

std::string millimetres(double metres) {
  if (!std::isfinite(metres)) return StripText::tr("none").toStdString();
  const bool usual = unitsNow().length == Units::Length::kMillimetre;
  if (usual && std::abs(metres) >= 10.0) return fixed(metres, 2) + " m";
  return lengthText(metres).toStdString();
}

std::string newtons(double value) {
  return forceText(value).toStdString();
}

std::string scaleText(double motion_scale) {
  if (!(motion_scale > 0.0)) return StripText::tr("none").toStdString();
  if (motion_scale >= 1.0) return shortNumber(motion_scale) + " : 1";
  return "1 : " + shortNumber(1.0 / motion_scale);
}

namespace {

/// The nearest pair that does not touch, for the force shows what touches; without one, why there is no distance.
StripCell clearanceCell(const manipulation::SceneSnapshot& snapshot, double near_miss_distance) {
  StripCell cell{Mark::kNone, {}, StripText::tr("clearance").toStdString()};
  const auto free =
      std::find_if(snapshot.pairs.begin(), snapshot.pairs.end(), [](const auto& pair) { return !pair.contact; });
  if (free != snapshot.pairs.end()) {
    cell.value = millimetres(free->distance);
    if (free->near_miss || free->distance <= near_miss_distance) cell.mark = Mark::kNearMiss;
  } else if (!snapshot.pairs.empty()) {
    cell.value = StripText::tr("contact").toStdString();
    cell.mark = Mark::kContact;
  } else {
    cell.value = (snapshot.stylus.held ? StripText::tr("none nearby") : StripText::tr("nothing held")).toStdString();
  }
  return cell;
}

}  // namespace

std::vector<StripCell> stripCells(const manipulation::SceneSnapshot& snapshot, const StripContext& context) {
  const bool contact = !snapshot.pairs.empty() && snapshot.pairs.front().contact;
  std::vector<StripCell> cells;
  const auto say = [](const QString& text) { return text.toStdString(); };
  cells.push_back(clearanceCell(snapshot, context.near_miss_distance));
  const std::string force = snapshot.stylus.forces_on ? newtons(snapshot.stylus.force_n) : say(StripText::tr("off"));
  cells.push_back({contact ? Mark::kContact : Mark::kNone, force, say(StripText::tr("force"))});
  const std::string name = context.scale_name.empty() ? "" : context.scale_name + " ";
  cells.push_back({Mark::kNone, name + scaleText(snapshot.stylus.motion_scale), say(StripText::tr("scale"))});
  const QString on_contact = snapshot.stopped ? StripText::tr("Stopped") : onContactText(context.on_contact);
  cells.push_back({Mark::kNone, say(on_contact), say(StripText::tr("on contact"))});
  cells.push_back({Mark::kNone, snapshot.clutched ? say(StripText::tr("Clutch")) : context.free_axes,
                   say(StripText::tr("free to move"))});
  StripCell edge{Mark::kNone, say(lengthText(snapshot.stylus.device_edge_m, 0)), say(StripText::tr("to device edge"))};
  if (snapshot.stylus.device_edge_m < 0.005) edge.mark = Mark::kLimit;
  cells.push_back(edge);
  return cells;
}

}  // namespace hapticell::app
