// SPDX-License-Identifier: Apache-2.0
#include <pybind11/stl.h>

#include <atomic>
#include <cmath>
#include <optional>

#include "config/configuration.h"
#include "manipulation/checks/inverse_batch.h"
#include "manipulation/checks/joint_check.h"
#include "python/engine/bindings.h"
#include "python/engine/conversion.h"
#include "python/engine/long_work.h"
#include "python/engine/workcell_binding.h"

namespace hapticell::python {

namespace {

using manipulation::JointCheck;

/// What Python sees as hapticell.JointCheck.
struct Check {
  JointCheck check;

  std::size_t dof() const { return check.entity().robot()->dof(); }
  std::vector<double> joints(py::handle q) const { return numbersOf(q, static_cast<long>(dof()), "joints"); }
};

manipulation::RestContacts atRest(bool leave_out) {
  return leave_out ? manipulation::RestContacts::kLeaveOut : manipulation::RestContacts::kCount;
}

Check checkOf(const Workcell& cell, const std::string& robot, bool leave_out) {
  const auto id = cell.entity(robot).id;
  const auto scene = cell.prepared();
  return {valueOf(JointCheck::create(scene, id, {}, atRest(leave_out)))};
}

/// Whether each row of joints is free.
py::array_t<bool> areFree(Check& self, py::handle joints, double clearance) {
  const Doubles rows = doublesOf(joints, "joints");
  const auto dof = static_cast<py::ssize_t>(self.dof());
  if (rows.ndim() != 2 || rows.shape(1) != dof)
    raise({.place = "joints", .found = "another array", .expected = Text("an array of shape (n, %1)", dof)});
  py::array_t<bool> free(rows.shape(0));
  bool* const to = free.mutable_data();
  constexpr py::ssize_t kPiece = 256;  // Checks between two looks at signals: 10 ms or so. Half and twice: the same.
  for (py::ssize_t begin = 0; begin < rows.shape(0); begin += kPiece) {
    {
      const py::gil_scoped_release unlocked;
      std::vector<double> q(static_cast<std::size_t>(dof));
      for (py::ssize_t i = begin; i < std::min(rows.shape(0), begin + kPiece); ++i) {
        q.assign(rows.data() + i * dof, rows.data() + (i + 1) * dof);
        to[i] = std::all_of(q.begin(), q.end(), [](double v) { return std::isfinite(v); }) &&
                self.check.isFree(q, clearance);
      }
    }
    checkSignals();
  }
  return free;
}

py::list freeInverse(const Workcell& cell, const std::string& robot, py::handle poses, double clearance,
                     py::handle start, bool leave_out, int threads) {
  const auto id = cell.entity(robot).id;
  const std::vector<Pose> X_BT = posesOf(poses);
  manipulation::InverseBatchOptions options;
  options.clearance = clearance;
  options.at_rest = atRest(leave_out);
  options.threads = threads;
  if (!start.is_none()) options.start = numbersOf(start, -1, "start");
  const auto scene = cell.prepared();
  std::optional<Expected<manipulation::InverseBatch>> batch;
  std::atomic<bool> stop{false};
  options.stop = &stop;
  runLong([&] { batch = manipulation::freeInverse(scene, id, X_BT, options, {}); }, [&] { stop = true; });
  py::list answers;
  for (const auto& answer : valueOf(std::move(*batch)).answers) {
    py::array_t<double> solutions({answer.free.size(), scene->find(id)->robot()->dof()});
    double* to = solutions.mutable_data();
    for (const auto& one : answer.free) to = std::copy(one.joints.begin(), one.joints.end(), to);
    answers.append(solutions);
  }
  return answers;
}

}  // namespace

void bindJointChecks(py::module_& module) {
  py::class_<Check>(
      module, "JointCheck",
      "Exact contact checks of one robot of a cell at many joint positions, each by itself (Workcell.joint_check). The "
      "cell counts as it was when this was made.")
      .def(
          "is_free",
          [](Check& self, py::handle joints, double clearance) {
            return self.check.isFree(self.joints(joints), clearance);
          },
          py::arg("joints"), py::arg("clearance") = 0.0,
          "True if nothing touches at these joints, or is nearer than `clearance` (m).")
      .def("are_free", &areFree, py::arg("joints"), py::arg("clearance") = 0.0,
           "The same for joints of shape (n, dof): n booleans.")
      .def(
          "clearance",
          [](Check& self, py::handle joints, double limit) { return self.check.clearance(self.joints(joints), limit); },
          py::arg("joints"), py::arg("limit") = 1.0, "The least distance (m) to the cell, up to `limit`; 0 in contact.")
      .def(
          "contact", [](Check& self, py::handle joints) { return english(self.check.contactAt(self.joints(joints))); },
          py::arg("joints"), "The first contact in words; empty if it is free.")
      .def("__repr__",
           [](const Check& self) { return py::str("<JointCheck of '{}'>").format(self.check.entity().name); });

  auto cell = py::type::of<Workcell>();
  cell.attr("joint_check") = py::cpp_function(
      &checkOf, py::name("joint_check"), py::is_method(cell), py::arg("robot"), py::arg("leave_out_touching") = false,
      "A JointCheck of a robot. `leave_out_touching`: pairs that touch as the cell stands do not count.");
  cell.attr("free_ik") = py::cpp_function(&freeInverse, py::name("free_ik"), py::is_method(cell), py::arg("robot"),
                                          py::arg("poses"), py::arg("clearance") = 0.0, py::arg("start") = py::none(),
                                          py::arg("leave_out_touching") = true, py::arg("threads") = 0,
                                          "All joint positions that bring the robot's tool to each pose X_BT (n, 7) "
                                          "and touch nothing, on all cores: a list of "
                                          "arrays of shape (solutions, dof), nearest to `start` first.");
}

}  // namespace hapticell::python
