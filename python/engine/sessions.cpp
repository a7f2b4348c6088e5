// SPDX-License-Identifier: Apache-2.0
#include <pybind11/stl.h>

#include <cmath>
#include <optional>

#include "cli/session/session_plan.h"
#include "cli/session/session_report.h"
#include "cli/session/session_settings.h"
#include "config/configuration.h"
#include "manipulation/session/session.h"
#include "python/engine/bindings.h"
#include "python/engine/conversion.h"
#include "python/engine/felt_object.h"
#include "python/engine/structured_array.h"
#include "python/engine/workcell_binding.h"
#include "workcell/document/assembly_solid.h"

namespace hapticell::python {

namespace {

using manipulation::SessionOptions;

/// A row of the trace; the columns of `session --trace`.
struct TraceRow {
  double t, position[3], quaternion[4], proxy[3], force[3], torque[3], moved[3], moved_quaternion[4];
  std::uint32_t buttons;
  bool contact;
};

TraceRow rowOf(const manipulation::TraceRow& row) {
  TraceRow made{};
  made.t = row.t;
  put(row.X_DS.p, made.position);
  put(row.X_DS.q, made.quaternion);
  put(row.X_DP.p, made.proxy);
  put(row.force_D, made.force);
  put(row.torque_D, made.torque);
  put(row.X_WM.p, made.moved);
  put(row.X_WM.q, made.moved_quaternion);
  made.buttons = row.buttons;
  made.contact = row.contact;
  return made;
}

py::array traceArray(std::vector<TraceRow> rows) {
  return structuredArray(std::move(rows), {{"t", "f8", offsetof(TraceRow, t)},
                                           {"position", "(3,)f8", offsetof(TraceRow, position)},
                                           {"quaternion", "(4,)f8", offsetof(TraceRow, quaternion)},
                                           {"proxy", "(3,)f8", offsetof(TraceRow, proxy)},
                                           {"force", "(3,)f8", offsetof(TraceRow, force)},
                                           {"torque", "(3,)f8", offsetof(TraceRow, torque)},
                                           {"moved", "(3,)f8", offsetof(TraceRow, moved)},
                                           {"moved_quaternion", "(4,)f8", offsetof(TraceRow, moved_quaternion)},
                                           {"buttons", "u4", offsetof(TraceRow, buttons)},
                                           {"contact", "?", offsetof(TraceRow, contact)}});
}

/// Rows t, x, y, z, qw, qx, qy, qz, button of a hand path.
haptic::HandPath pathOfArray(py::handle hand) {
  const Doubles rows = doublesOf(hand, "hand");
  if (rows.ndim() != 2 || rows.shape(1) != 9 || rows.shape(0) == 0)
    raise({.place = "hand", .found = "another array", .expected = "shape (n, 9): t, x, y, z, qw, qx, qy, qz, button"});
  std::vector<haptic::HandSample> samples;
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
    const double* const row = rows.data() + 9 * i;
    const py::array_t<double> pose(7, row + 1);
    const bool later = samples.empty() || row[0] >= samples.back().t;
    if (!std::isfinite(row[0]) || !later || !(row[8] >= 0.0 && row[8] < 256.0))
      raise({.place = Text("hand, row %1", i),
             .found = "a time that decreases, or a button out of range",
             .expected = "times that do not decrease, buttons from 0 to 255"});
    samples.push_back({row[0], poseOf(pose), static_cast<std::uint32_t>(row[8])});
  }
  return haptic::HandPath(std::move(samples));
}

/// What a hand is told: what the force loop gave in the tick before.
struct Felt {
  haptic::HapticState state;
};

haptic::HandSample sampleOf(double t, const py::object& answer) {
  const bool pair = py::isinstance<py::tuple>(answer) && py::len(answer) == 2;
  if (!pair) return {t, poseOf(answer), 0};
  const py::tuple both = answer;
  return {t, poseOf(both[0]), both[1].cast<std::uint32_t>()};
}

SessionOptions optionsOf(const Workcell& cell, const std::string& entity, const std::vector<std::string>& settings,
                         const std::string& device) {
  SessionOptions options;
  options.configuration = valueOf(config::loadConfiguration(""));
  const workcell::Document held(workcell::withAssemblyAsSolid(cell.document.state(), entity));
  options.entities = held.snapshotEntities();
  options.pairs = held.state().pairPolicy();
  options.guides = held.state().guides;
  options.entity = entity;
  cli::SessionPlanWords plan;
  for (const std::string& setting : settings) valueOf(cli::applySessionSetting(setting, options, plan));
  options.device = valueOf(cli::simulatedDevice(device.empty() ? options.configuration.haptic.device : device));
  valueOf(cli::addPlanner(plan, false, options));
  return options;
}

double within(double value, double low, double high, const char* what) {
  if (std::isfinite(value) && value >= low && value <= high) return value;
  raise({.place = Text::plain(what),
         .found = Text::plain(std::to_string(value)),
         .expected = Text("%1 to %2", std::to_string(low), std::to_string(high))});
}

py::object runSession(const Workcell& cell, const std::string& entity, const py::object& hand,
                      std::optional<double> duration, double rate, double latency,
                      const std::vector<std::string>& settings, const std::string& device, const py::object& progress) {
  SessionOptions options = optionsOf(cell, entity, settings, device);
  options.configuration.manipulation.rate_hz = within(rate, 10.0, 1000.0, "rate_manipulation");
  options.latency_s = within(latency, 0.0, 1.0, "latency");
  options.rate_gui_hz = options.configuration.gui.rate_hz;
  const bool live = py::isinstance<py::function>(hand) || py::hasattr(hand, "__call__");
  if (live) {
    if (!duration) raise({.place = "duration", .found = "none", .expected = "seconds, for a hand that is a function"});
    options.live_hand = manipulation::LiveHand{*duration, [&](double t, const haptic::HapticState& felt) {
                                                 const py::gil_scoped_acquire locked;
                                                 return sampleOf(t, hand(t, Felt{felt}));
                                               }};
  } else {
    options.hand = pathOfArray(hand);
  }
  const double whole = live ? *duration : options.hand.duration();
  std::vector<TraceRow> rows;
  std::uint64_t ticks = 0;
  const manipulation::TraceSink trace = [&](const manipulation::TraceRow& row) {
    rows.push_back(rowOf(row));
    constexpr std::uint64_t kLook = 256;  // Ticks between two looks at signals: some ms. Half and twice: the same.
    if (++ticks % kLook != 0) return;
    const py::gil_scoped_acquire locked;
    checkSignals();
    if (!progress.is_none()) progress(whole > 0.0 ? row.t / whole : 1.0, "session");
  };
  auto report = [&] {
    const py::gil_scoped_release unlocked;
    return manipulation::runSession(options, trace);
  }();
  const auto session = valueOf(std::move(report));
  py::object made = objectOf(cli::sessionJson(session, options));
  made.attr("trace") = traceArray(std::move(rows));
  return made;
}

void bindFelt(py::module_& module) {
  py::class_<Felt>(
      module, "Felt",
      "What a hand feels: the force loop's state of one tick. Device frame: x right, y away from the user, z up.")
      .def_property_readonly(
          "pose", [](const Felt& f) { return arrayOf(f.state.X_DS); }, "X_DS of the stylus, shape (7,).")
      .def_property_readonly(
          "proxy", [](const Felt& f) { return arrayOf(f.state.X_DP); },
          "X_DP: where the stylus would be if it obeyed every contact.")
      .def_property_readonly(
          "velocity", [](const Felt& f) { return arrayOf(f.state.v_DS); }, "m/s, shape (3,).")
      .def_property_readonly(
          "force", [](const Felt& f) { return arrayOf(f.state.force_D); },
          "Commanded force on the hand, N, shape (3,).")
      .def_property_readonly(
          "torque", [](const Felt& f) { return arrayOf(f.state.torque_D); }, "N m, shape (3,).")
      .def_property_readonly(
          "buttons", [](const Felt& f) { return f.state.buttons; }, "Bit i is set while button i is pressed.")
      .def_property_readonly("tick", [](const Felt& f) { return f.state.tick; })
      .def_property_readonly("forces_on", [](const Felt& f) { return f.state.forces_on; })
      .def("__repr__", [](const Felt& f) {
        return py::str("<Felt {:.2f} N at {:.4f}, {:.4f}, {:.4f} m>")
            .format(glm::length(f.state.force_D), f.state.X_DS.p.x, f.state.X_DS.p.y, f.state.X_DS.p.z);
      });
}

}  // namespace

py::object feltObject(const haptic::HapticState& state) {
  return py::cast(Felt{state});
}

void bindSessions(py::module_& module) {
  bindFelt(module);
  auto cell = py::type::of<Workcell>();
  cell.attr("session") = py::cpp_function(
      &runSession, py::name("session"), py::is_method(cell), py::arg("entity"), py::arg("hand"),
      py::arg("duration") = py::none(), py::arg("rate_manipulation") = 250.0, py::arg("latency") = 0.0,
      py::arg("set") = std::vector<std::string>(), py::arg("device") = "", py::arg("progress") = py::none(),
      "A session in virtual time: a hand on a simulated stylus moves `entity`. The same input gives the same "
      "result.\n\n"
      "`hand`: an array of shape (n, 9) with t (s), x, y, z, qw, qx, qy, qz, button (device frame, metres), or a "
      "function "
      "hand(t, felt) that is called each millisecond for `duration` seconds and returns the wanted pose of the hand, "
      "or "
      "(pose, buttons). `rate_manipulation` in Hz, `latency` in s; `set` as of the command session. Returns what the "
      "command "
      "session does, and `.trace`: a structured array, one row a millisecond, of t, position, quaternion, proxy, force "
      "(N), "
      "torque (N m), moved, moved_quaternion, buttons, contact.");
}

}  // namespace hapticell::python
