// SPDX-License-Identifier: Apache-2.0
#include <pybind11/stl.h>

#include <chrono>
#include <optional>
#include <thread>

#include "config/configuration.h"
#include "haptic/client/tcp_link.h"
#include "manipulation/session/local_server.h"
#include "python/engine/bindings.h"
#include "python/engine/conversion.h"
#include "python/engine/felt_object.h"

namespace hapticell::python {

namespace {

using Clock = std::chrono::steady_clock;

/// What Python sees as hapticell.HapticClient: a connection and the newest state.
class Client {
 public:
  Client(const std::string& host, int port, double timeout);

  haptic::TcpLink& link() {
    if (link_) return *link_;
    raise({.place = "client", .found = "it is closed", .expected = "an open connection"});
  }
  void close() {
    const py::gil_scoped_release unlocked;
    link_.reset();
  }
  /// Waits for a state that was not returned yet.
  py::object state(double timeout);
  void send(py::handle gaps, py::handle gradients, py::handle reference, double zone_radius, double stiffness);

 private:
  /// Waits until `is_there()`, without the lock; false at the end of the time.
  template <typename IsThere>
  bool await(double timeout, const IsThere& is_there);

  std::unique_ptr<haptic::TcpLink> link_;
  std::uint64_t sequence_ = 0;
};

template <typename IsThere>
bool Client::await(double timeout, const IsThere& is_there) {
  const auto end = Clock::now() + std::chrono::duration<double>(timeout);
  while (!is_there()) {
    if (Clock::now() > end) return false;
    {
      const py::gil_scoped_release unlocked;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    checkSignals();
  }
  return true;
}

Client::Client(const std::string& host, int port, double timeout) {
  if (port < 1 || port > 65535) raise({.place = "port", .found = Text("%1", port), .expected = "1 to 65535"});
  haptic::TcpLinkOptions options = valueOf(haptic::linkOptionsFor(host, static_cast<std::uint16_t>(port)));
  options.program = "Python";
  link_ = std::make_unique<haptic::TcpLink>(options);
  const bool connected = await(timeout, [&] {
    return (link_->linkState() == haptic::LinkState::kConnected && link_->device()) ||
           link_->linkState() == haptic::LinkState::kRefused;
  });
  if (connected && link_->device()) return;
  raise({.file = host + ":" + std::to_string(port),
         .found = link_->problem().empty() ? Text("no answer") : haptic::wholeText(link_->problem()),
         .expected = "a haptic server",
         .fix = "Start hapticell-haptic-server."});
}

py::object Client::state(double timeout) {
  std::optional<haptic::HapticState> newest;
  haptic::TcpLink& from = link();
  if (!await(timeout, [&] { return (newest = from.latestState()).has_value(); })) {
    raise({.place = "client",
           .found = from.problem().empty() ? Text("no new state in %1 s", std::to_string(timeout))
                                           : haptic::wholeText(from.problem()),
           .expected = "a state of the server"});
  }
  return feltObject(*newest);
}

void Client::send(py::handle gaps, py::handle gradients, py::handle reference, double zone_radius, double stiffness) {
  const std::vector<double> gap = numbersOf(gaps, -1, "gaps");
  const Doubles slope = doublesOf(gradients, "gradients");
  const bool fits = slope.ndim() == 2 && static_cast<std::size_t>(slope.shape(0)) == gap.size() && slope.shape(1) == 6;
  if (!fits || gap.size() > haptic::kMaxConstraints) {
    raise({.place = "constraints",
           .found = Text("%1 gaps", gap.size()),
           .expected = Text("at most %1, and gradients of shape (n, 6)", haptic::kMaxConstraints)});
  }
  haptic::ConstraintSet set;
  set.sequence = ++sequence_;
  set.X_DR = poseOf(reference);
  set.zone_radius = zone_radius;
  set.count = gap.size();
  for (std::size_t i = 0; i < gap.size(); ++i) {
    set.constraints[i].group = static_cast<std::uint32_t>(i);
    set.constraints[i].gap = gap[i];
    set.constraints[i].stiffness = stiffness;
    set.constraints[i].id = i + 1;
    std::copy_n(slope.data() + 6 * i, 6, set.constraints[i].gradient.begin());
  }
  link().sendSet(set);
}

py::object deviceOf(Client& self) {
  const auto device = self.link().device();
  if (!device) return py::none();
  py::object made = py::module_::import("hapticell._results").attr("Result")();
  made["name"] = device->name;
  made["simulated"] = device->simulated;
  made["workspace_min"] = arrayOf(device->workspace_min);
  made["workspace_max"] = arrayOf(device->workspace_max);
  made["peak_force"] = device->peak_force;
  made["continuous_force"] = device->continuous_force;
  made["driven_axes"] = device->driven_axes;
  made["buttons"] = device->buttons;
  return made;
}

/// A private server with a simulated stylus.
struct Server {
  std::unique_ptr<manipulation::LocalServer> server;
};

}  // namespace

void bindClients(py::module_& module) {
  py::class_<Client>(
      module, "HapticClient",
      "Drives a running haptic server: sends what can be felt, reads the stylus. The force loop runs in the server, a "
      "thousand "
      "times a second, and goes on whatever Python does. A server on another machine needs its key (hapticell.pair).")
      .def(py::init<const std::string&, int, double>(), py::arg("host") = "127.0.0.1", py::arg("port") = 4747,
           py::arg("timeout") = 5.0)
      .def_property_readonly("device", &deviceOf, "Name, workspace (m) and forces (N) of the device.")
      .def_property_readonly("connected",
                             [](Client& self) { return self.link().linkState() == haptic::LinkState::kConnected; })
      .def("state", &Client::state, py::arg("timeout") = 1.0,
           "The newest state (Felt); waits for one that was not returned yet.")
      .def("send", &Client::send, py::arg("gaps"), py::arg("gradients"), py::arg("reference") = py::none(),
           py::arg("zone_radius") = 0.06, py::arg("stiffness") = 0.0,
           "What can be felt within `zone_radius` (m) of the pose X_DR: the stylus is free while gap + gradient . xi "
           ">= 0 for "
           "each row, xi = dx, dy, dz (m), rx, ry, rz (rad) from there, in the device frame. Shapes (n,) and (n, 6). "
           "`stiffness` in N/m; 0: the device's own. Send it at least every two seconds, or the force fades.")
      .def(
          "enable_forces", [](Client& self, bool on) { self.link().sendControl({.forces_enabled = on}); },
          py::arg("on") = true)
      .def(
          "hold",
          [](Client& self, py::handle pose, std::uint32_t buttons) {
            self.link().sendHandTarget({.holding = true, .X_DH = poseOf(pose), .buttons = buttons});
          },
          py::arg("pose"), py::arg("buttons") = 0,
          "Where the hand of a simulated stylus wants it to be; real devices ignore it.")
      .def(
          "release", [](Client& self) { self.link().sendHandTarget({}); }, "Nobody holds the simulated stylus.")
      .def("close", &Client::close)
      .def("__enter__", [](py::object self) { return self; })
      .def("__exit__", [](Client& self, const py::args&) { self.close(); })
      .def("__repr__", [](Client& self) { return py::str("<HapticClient of {}>").format(deviceOf(self)["name"]); });

  py::class_<Server>(module, "HapticServer",
                     "A haptic server with a simulated stylus in this process, on a free port of this machine.")
      .def(py::init([] { return Server{valueOf(manipulation::LocalServer::start({}, {}))}; }))
      .def_property_readonly(
          "port", [](const Server& self) { return self.server ? self.server->port() : 0; }, "0 once it is closed.")
      .def(
          "close",
          [](Server& self) {
            const py::gil_scoped_release unlocked;
            self.server.reset();
          },
          "Sets the force to zero and ends.")
      .def("__enter__", [](py::object self) { return self; })
      .def("__exit__",
           [](Server& self, const py::args&) {
             const py::gil_scoped_release unlocked;
             self.server.reset();
           })
      .def("__repr__", [](const Server& self) {
        return py::str("<HapticServer on port {}>").format(self.server ? self.server->port() : 0);
      });
}

}  // namespace hapticell::python
