// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/devices/force_reason.h"

#include "app/style/library_text.h"
#include "app/style/units.h"

#include <QObject>
#include <cmath>

namespace hapticell::app {
namespace {

// Of the 1000 a second that are wanted. Half the rest: warns of a passing load; twice: 100 missing ticks a second are
// not said.
constexpr double kFewHertz = 0.95;
// ms by which one of a hundred ticks is late: half a tick, when the next is near. Half: warns on usual machines; twice:
// whole ticks are missed unsaid.
constexpr double kLateWarning = 0.5;

QString tr(const char* text) {
  return QObject::tr(text);
}

QString timeText(double milliseconds) {
  return milliseconds < 1000.0 ? tr("%1 ms").arg(milliseconds, 0, 'f', 2)
                               : tr("%1 s").arg(1e-3 * milliseconds, 0, 'f', 3);
}

DeviceCheck serverCheck(const QString& server, const haptic::ServerStatistics& figures) {
  const QString where = tr("%1, round trip %2 ms").arg(server).arg(figures.round_trip_ms, 0, 'f', 2);
  const QString clocks =
      figures.clock_offset_ms ? tr(", clock offset %1").arg(timeText(std::abs(*figures.clock_offset_ms))) : QString();
  return {DeviceCheck::Result::kGood, tr("The haptic server is responding"), where + clocks};
}

/// How old contacts are when they are felt. Nothing is late before the first.
DeviceCheck contactsCheck(const haptic::ServerStatistics& figures) {
  const QString counts =
      tr("%1 late and %2 rejected since the server started").arg(figures.late_sets).arg(figures.refused_sets);
  if (!(figures.set_age_p99_ms > 0.0)) return {DeviceCheck::Result::kOpen, tr("No recent contacts"), counts};
  const bool late = figures.set_age_p99_ms > 1e3 * haptic::kLateSetAge;
  return {late ? DeviceCheck::Result::kWarning : DeviceCheck::Result::kGood,
          late ? tr("Contacts are sometimes late") : tr("Contacts arrive on time"),
          tr("age: median %1 ms, 99th percentile %2 ms; %3")
              .arg(figures.set_age_p50_ms, 0, 'f', 1)
              .arg(figures.set_age_p99_ms, 0, 'f', 1)
              .arg(counts)};
}

/// How soon contacts are on the screen.
DeviceCheck sightCheck(const TouchSight& sight) {
  const TouchMeter::Figures& figures = sight.figures;
  if (figures.contacts == 0)
    return {DeviceCheck::Result::kOpen, tr("No contact on the screen yet"),
            tr("Touch something with forces on to measure the delay from felt to displayed")};
  const double limit = longestUnnoticed(sight);
  const bool late = figures.median_s > limit;
  return {late ? DeviceCheck::Result::kWarning : DeviceCheck::Result::kGood,
          late ? tr("Contacts are displayed late") : tr("Contacts are displayed on time"),
          tr("delay: median %1 ms, maximum %2 ms, contacts: %3; up to %4 ms is not noticeable")
                  .arg(1e3 * figures.median_s, 0, 'f', 0)
                  .arg(1e3 * figures.worst_s, 0, 'f', 0)
                  .arg(figures.contacts)
                  .arg(1e3 * limit, 0, 'f', 0) +
              (late ? tr(". Make the window smaller") : QString())};
}

}  // namespace

double longestUnnoticed(const TouchSight& sight) {
  // s from a contact to its picture that go unnoticed: drawn by the processor; with a card a frame and as much as one
  // at 60 Hz. Half: warns always; twice: the picture follows the hand visibly.
  constexpr double kSoftware = 0.050, kBeyondFrame = 0.015;
  return sight.software ? kSoftware : kBeyondFrame + sight.frame_s;
}

ForceReason forceReason(const ForceFacts& facts) {
  using Fix = ForceReason::Fix;
  if (!facts.started) return {tr("Forces off"), tr("No stylus is connected"), Fix::kConnect, tr("Connect")};
  if (facts.watching)
    return {tr("Forces off"), tr("Another window controls the stylus; this one observes"), Fix::kTakeStylus,
            tr("Take control")};
  if (!facts.connected) {
    // What to do about it stands beside the device's state.
    const QString problem = shownText(facts.problem.what);
    const QString why = problem.isEmpty() ? tr("Waiting for the haptic server") : problem;
    return {tr("Forces off"), why, Fix::kStartServer, tr("Start the server")};
  }
  if (facts.device_fault)
    return {tr("Forces off"), tr("The device is not responding. Check its cable and power"), Fix::kNone, {}};
  if (facts.stalled)
    return {
        tr("Forces off"), tr("The simulation is not responding. Forces return when it responds again"), Fix::kNone, {}};
  if (facts.forceless) return {tr("No forces"), tr("This device has no force feedback"), Fix::kNone, {}};
  if (!facts.on && !facts.wanted && facts.lost)
    return {tr("Forces off"),
            tr("The haptic server stopped, so forces are off. Press Ctrl+Space to turn them on again"),
            Fix::kNone,
            {}};
  if (!facts.on && !facts.wanted) return {tr("Forces off"), tr("Press Ctrl+Space to turn them on"), Fix::kNone, {}};
  if (!facts.on && facts.cut)
    return {tr("Forces off"),
            tr("The server switched them off. Move the stylus to free space, or press Esc, then Ctrl+Space"),
            Fix::kNone,
            {}};
  if (!facts.on) return {tr("Forces pending"), tr("Move the stylus into free space"), Fix::kNone, {}};
  const QString ramp = facts.ramp < 0.999 ? tr("Ramp %1 %, 1 N/ms limit").arg(std::lround(100.0 * facts.ramp))
                                          : tr("Ramp done, 1 N/ms limit");
  if (facts.ramp < 0.999) return {tr("Forces on"), ramp, Fix::kNone, {}};
  if (!facts.held) return {tr("Forces on"), tr("Nothing is held. Press the stylus button to hold it"), Fix::kNone, {}};
  if (!facts.checked)
    return {tr("Forces on"), tr("The held entity is not checked for collision"), Fix::kCheck, tr("Check it")};
  if (facts.at_edge)
    return {tr("Forces on"),
            tr("The device is at the edge of its workspace. Hold Space and move the hand back"),
            Fix::kNone,
            {}};
  if (facts.passes)
    return {tr("Forces on"), tr("Contact mode is Pass: contacts are shown, not felt"), Fix::kSlide, tr("Slide")};
  return {tr("Forces on"), ramp, Fix::kNone, {}};
}

QString scaleNote(double motion_scale) {
  if (!(motion_scale > 0.0)) return {};
  const double hand = motion_scale < 1.0 ? 1.0 / motion_scale : 1.0;
  const double cell = motion_scale < 1.0 ? 1.0 : motion_scale;
  const auto count = [](double of_them) { return QString::number(of_them, 'g', 3) + ' ' + unitsNow().lengthUnit(); };
  return tr("%1 of hand → %2 in the cell").arg(count(hand), count(cell));
}

std::vector<DeviceCheck> deviceChecks(const QString& server, const ForceFacts& facts,
                                      const haptic::DeviceDescription* device, const manipulation::SceneSnapshot& now,
                                      const TouchSight& sight) {
  using Result = DeviceCheck::Result;
  std::vector<DeviceCheck> checks;
  if (!facts.connected) {
    checks.push_back(
        {Result::kProblem, tr("No haptic server is responding at %1").arg(server), forceReason(facts).why});
    for (const QString& title : {tr("Device"), tr("Force loop"), tr("Range of motion and button")})
      checks.push_back({Result::kOpen, title, tr("Not tested yet. The server must respond first")});
    return checks;
  }
  checks.push_back(serverCheck(server, now.server));
  if (device) {
    const dvec3 size = device->workspace_max - device->workspace_min;
    checks.push_back({Result::kGood, QString::fromStdString(device->name),
                      tr("%1 × %2 × %3, %4 N peak, %5 N continuous, %6 measured and %7 driven axes")
                          .arg(lengthText(size.x, 0), lengthText(size.y, 0), lengthText(size.z, 0))
                          .arg(device->peak_force, 0, 'f', 1)
                          .arg(device->continuous_force, 0, 'f', 1)
                          .arg(device->measured_axes)
                          .arg(device->driven_axes)});
  }
  const bool slow = now.server.rate_hz < 1000.0 * kFewHertz || now.server.late_p99_ms > kLateWarning;
  checks.push_back(
      {slow ? Result::kWarning : Result::kGood,
       slow ? tr("The force loop is sometimes late") : tr("The force loop is on time"),
       tr("%1 Hz, lateness (99th percentile) %2 ms%3")
           .arg(std::lround(now.server.rate_hz))
           .arg(now.server.late_p99_ms, 0, 'f', 2)
           .arg(slow ? tr(". To fix it, give it real-time priority: add your account to the group realtime")
                     : QString())});
  checks.push_back(contactsCheck(now.server));
  checks.push_back(sightCheck(sight));
  const bool edge = now.stylus.device_edge_m < 0.005;
  checks.push_back({edge ? Result::kWarning : Result::kGood, tr("Range of motion"),
                    tr("%1 to the edge of the workspace").arg(lengthText(now.stylus.device_edge_m, 0))});
  return checks;
}

}  // namespace hapticell::app
