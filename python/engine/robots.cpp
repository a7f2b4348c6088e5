// SPDX-License-Identifier: Apache-2.0
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "geometry/system/listed.h"
#include "kinematics/model/jacobian.h"
#include "python/engine/bindings.h"
#include "python/engine/conversion.h"
#include "python/engine/robot_binding.h"
#include "workcell/import/entity_source.h"
#include "workcell/robots/robot_library.h"
#include "workcell/robots/robot_reader.h"

namespace hapticell::python {

using kinematics::InverseSolution;
using kinematics::RobotModel;

Robot::Robot(std::shared_ptr<const RobotModel> model, int tip, Pose X_LT)
    : model_(std::move(model)), tip_(tip), X_LT_(X_LT) {}

std::unique_ptr<kinematics::InverseModel> Robot::freshInverse() const {
  return valueOf(kinematics::createInverse(*model_, tip_, X_LT_));
}

const kinematics::InverseModel& Robot::inverse() {
  if (!inverse_) inverse_ = freshInverse();
  return *inverse_;
}

const std::vector<double>& Robot::variables(py::handle q) {
  if (q.is_none()) {
    q_ = kinematics::restPositions(*model_);
    return q_;
  }
  const Doubles array = doublesOf(q, "joints");
  if (array.ndim() != 1 || static_cast<std::size_t>(array.size()) != model_->dof()) {
    raise({.place = "joints",
           .found = Text("%1 numbers", array.size()),
           .expected = Text("%1, one for each joint that moves", model_->dof())});
  }
  q_.assign(array.data(), array.data() + array.size());
  if (!std::all_of(q_.begin(), q_.end(), [](double v) { return std::isfinite(v); })) {
    raise({.place = "joints", .found = "a number that is not finite", .expected = "radians or metres"});
  }
  return q_;
}

const std::vector<Pose>& Robot::linkPoses(const std::vector<double>& q) {
  kinematics::forwardKinematics(*model_, q, X_BL_);
  return X_BL_;
}

namespace {

/// An answer of the inverse model, without the model's own types.
struct Alternative {
  std::vector<double> q;
  bool within_limits;
  std::string configuration;
};

Robot loadRobot(py::object what, const std::optional<std::string>& tip) {
  const std::string source = pathOf(what);
  Diagnostics diagnostics;
  std::shared_ptr<const RobotModel> model;
  if (source.starts_with("library:") || !workcell::looksLikeRobot(source)) {
    const auto entity = valueOf(workcell::EntityLoader(".").load(source, 0.0, diagnostics));
    model = entity.robot();
    if (!model) raise({.file = source, .found = "it is not a robot", .expected = "a robot file, or library:NAME"});
  } else {
    auto read = valueOf(workcell::readRobot(source, diagnostics, nullptr, workcell::RobotContent::kKinematics));
    model = std::make_shared<const RobotModel>(std::move(read.model));
  }
  tellWarnings(diagnostics.warnings);
  const int link = tip ? model->findLink(*tip) : model->defaultTip();
  if (link >= 0) return Robot(model, link, {});
  raise({.file = source,
         .place = "tip",
         .found = Text("no link is named '%1'", tip.value_or("")),
         .expected = Text("one of %1", listed(model->links, &kinematics::Link::name))});
}

std::vector<std::string> libraryNames() {
  Diagnostics diagnostics;
  std::vector<std::string> names;
  for (const auto& robot : workcell::listLibraryRobots(diagnostics)) names.push_back(robot.name);
  tellWarnings(diagnostics.warnings);
  return names;
}

py::array_t<double> perJoint(const Robot& robot, double kinematics::Joint::*member) {
  std::vector<double> values;
  for (const int joint : robot.model().moving)
    values.push_back(robot.model().joints[static_cast<std::size_t>(joint)].*member);
  return arrayOf(values);
}

std::vector<std::string> jointNames(const Robot& robot) {
  std::vector<std::string> names;
  for (const int joint : robot.model().moving)
    names.push_back(robot.model().joints[static_cast<std::size_t>(joint)].name);
  return names;
}

/// (n, dof) numbers.
Doubles rowsOf(const Robot& robot, py::handle joints) {
  const Doubles rows = doublesOf(joints, "joints");
  const auto dof = static_cast<py::ssize_t>(robot.model().dof());
  bool fits = rows.ndim() == 2 && rows.shape(1) == dof;
  for (py::ssize_t i = 0; fits && i < rows.size(); ++i) fits = std::isfinite(rows.data()[i]);
  if (fits) return rows;
  raise({.place = "joints", .found = "another array", .expected = Text("finite numbers of shape (n, %1)", dof)});
}

py::array_t<double> forward(Robot& robot, py::handle joints) {
  if (joints.is_none() || doublesOf(joints, "joints").ndim() == 1)
    return arrayOf(robot.toolPose(robot.variables(joints)));
  const Doubles rows = rowsOf(robot, joints);
  std::vector<Pose> poses;
  poses.reserve(static_cast<std::size_t>(rows.shape(0)));
  Robot own = robot.copy();
  constexpr py::ssize_t kPiece = 1 << 14;  // Rows between two looks at signals: 10 ms or so. Half and twice: the same.
  std::vector<double> q(robot.model().dof());
  for (py::ssize_t begin = 0; begin < rows.shape(0); begin += kPiece) {
    {
      const py::gil_scoped_release unlocked;
      for (py::ssize_t i = begin; i < std::min(rows.shape(0), begin + kPiece); ++i) {
        const double* const row = rows.data() + i * rows.shape(1);
        q.assign(row, row + rows.shape(1));
        poses.push_back(own.toolPose(q));
      }
    }
    checkSignals();
  }
  return arrayOf(poses);
}

py::array_t<double> jacobianOf(Robot& robot, py::handle q) {
  const std::vector<double>& joints = robot.variables(q);
  const Pose X_BT = robot.toolPose(joints);
  kinematics::Jacobian J;
  kinematics::geometricJacobian(robot.model(), robot.linkPoses(joints), robot.tip(), X_BT.p, J);
  return py::array_t<double>({py::ssize_t{6}, static_cast<py::ssize_t>(J.columns)}, J.values.data());
}

std::vector<Alternative> allSolutions(Robot& robot, py::handle pose, py::handle start) {
  std::vector<Alternative> all;
  for (auto& one : robot.inverse().solveAll(poseOf(pose), robot.variables(start)))
    all.push_back({std::move(one.q), one.within_limits, std::move(one.configuration)});
  return all;
}

/// Writes "solved" as numpy's U11 has it.
void putWord(const char* word, char32_t* to) {
  for (int i = 0; i < 11 && word[i] != '\0'; ++i) to[i] = static_cast<char32_t>(word[i]);
}

/// One answer a pose: each starts from the one before. The arrays are filled without the lock.
py::dict inverseOfPoses(Robot& robot, py::handle poses, py::handle start) {
  const std::vector<Pose> X_BT = posesOf(poses);
  std::vector<double> previous = robot.variables(start);
  const auto inverse = robot.freshInverse();
  const auto count = static_cast<py::ssize_t>(X_BT.size()), dof = static_cast<py::ssize_t>(robot.model().dof());
  py::array_t<double> joints({count, dof}), position_error(count), orientation_error(count);
  py::array_t<bool> singular(count);
  py::array status(py::dtype("U11"), std::vector<py::ssize_t>{count});
  auto* const words = static_cast<char32_t*>(status.mutable_data());
  std::memset(words, 0, static_cast<std::size_t>(status.nbytes()));
  double *const q = joints.mutable_data(), *const position = position_error.mutable_data(),
                *const orientation = orientation_error.mutable_data();
  bool* const is_singular = singular.mutable_data();
  constexpr py::ssize_t kPiece = 256;  // Poses between two looks at signals: 10 ms or so. Half and twice: the same.
  for (py::ssize_t begin = 0; begin < count; begin += kPiece) {
    {
      const py::gil_scoped_release unlocked;
      for (py::ssize_t i = begin; i < std::min(count, begin + kPiece); ++i) {
        const InverseSolution one = inverse->solve(X_BT[static_cast<std::size_t>(i)], previous);
        std::copy(one.q.begin(), one.q.end(), q + i * dof);
        putWord(toString(one.status), words + 11 * i);
        position[i] = one.position_error;
        orientation[i] = one.orientation_error;
        is_singular[i] = one.singular;
        previous = one.q;
      }
    }
    checkSignals();
  }
  py::dict made = py::module_::import("hapticell._results").attr("Result")();
  made["status"] = status;
  made["joints"] = joints;
  made["position_error"] = position_error;
  made["orientation_error"] = orientation_error;
  made["singular"] = singular;
  return made;
}

void bindSolutions(py::module_& module) {
  py::class_<InverseSolution>(module, "IkSolution",
                              "Joint positions for a pose of the tool, and how well they meet it.")
      .def_property_readonly(
          "status", [](const InverseSolution& s) { return toString(s.status); },
          "'solved'; 'limit': only joint limits prevent it; 'unreachable'.")
      .def_property_readonly(
          "joints", [](const InverseSolution& s) { return arrayOf(s.q); }, "Shape (dof,), rad or m.")
      .def_readonly("position_error", &InverseSolution::position_error, "Metres.")
      .def_readonly("orientation_error", &InverseSolution::orientation_error, "Radians.")
      .def_readonly("singular", &InverseSolution::singular, "A direction of the tool is (nearly) lost there.")
      .def("__bool__", [](const InverseSolution& s) { return s.status == kinematics::InverseStatus::kSolved; })
      .def("__repr__", [](const InverseSolution& s) { return py::str("<IkSolution {}>").format(toString(s.status)); });
  py::class_<Alternative>(module, "IkAlternative", "One of the ways to bring the tool to a pose.")
      .def_property_readonly(
          "joints", [](const Alternative& a) { return arrayOf(a.q); }, "Shape (dof,), rad or m.")
      .def_readonly("within_limits", &Alternative::within_limits)
      .def_readonly("configuration", &Alternative::configuration, "'front, elbow up, wrist flipped'")
      .def("__repr__", [](const Alternative& a) {
        return py::str("<IkAlternative '{}'{}>").format(a.configuration, a.within_limits ? "" : ", beyond limits");
      });
}

void bindKinematics(py::class_<Robot>& robot) {
  robot
      .def("fk", &forward, py::arg("joints") = py::none(),
           "The pose X_BT of the tool in the root link, shape (7,), for joints of shape (dof,) (rad, m; None: at "
           "rest); for "
           "(n, dof) all of them, shape (n, 7).")
      .def(
          "link_poses", [](Robot& self, py::handle q) { return arrayOf(self.linkPoses(self.variables(q))); },
          py::arg("joints") = py::none(), "X_BL of every link in the root link, shape (links, 7).")
      .def("jacobian", &jacobianOf, py::arg("joints") = py::none(),
           "The tool's velocity by each joint's, in the root link: shape (6, dof), linear rows first.")
      .def(
          "manipulability",
          [](Robot& self, py::handle q) {
            const py::array_t<double> J = jacobianOf(self, q);
            kinematics::Jacobian plain{static_cast<std::size_t>(J.shape(1)), {J.data(), J.data() + J.size()}};
            return kinematics::manipulability(plain, 0.25).measure;
          },
          py::arg("joints") = py::none(), "Product of the Jacobian's singular values, lengths divided by 0.25 m.")
      .def(
          "ik",
          [](Robot& self, py::handle pose, py::handle start) {
            return self.inverse().solve(poseOf(pose), self.variables(start));
          },
          py::arg("pose"), py::arg("start") = py::none(),
          "The solution for the tool at X_BT nearest to `start` (None: at rest). 'solved' whenever one within limits "
          "exists.")
      .def("ik_all", &allSolutions, py::arg("pose"), py::arg("start") = py::none(),
           "All solutions, nearest to `start` first, those beyond limits too; of a robot with more than six joints a "
           "sample.")
      .def("ik_batch", &inverseOfPoses, py::arg("poses"), py::arg("start") = py::none(),
           "One solution for each pose of shape (n, 7), nearest to the one before. Arrays: status, joints (n, dof), "
           "position_error, orientation_error, singular.");
}

}  // namespace

void bindRobots(py::module_& module) {
  bindSolutions(module);
  py::class_<Robot> robot(module, "Robot",
                          "A robot's kinematics: joints in radians or metres, one number for each joint that moves "
                          "(dof); poses in its root link.");
  robot
      .def_static(
          "load", &loadRobot, py::arg("what"), py::arg("tip") = py::none(),
          "From URDF, xacro, SDF, robot.toml or 'library:NAME'. `tip`: the link whose pose is asked for (None: the "
          "likeliest one).")
      .def_static("library", &libraryNames, "Names for 'library:NAME'.")
      .def_property_readonly("name", [](const Robot& self) { return self.model().name; })
      .def_property_readonly("dof", [](const Robot& self) { return self.model().dof(); })
      .def_property_readonly(
          "tip", [](const Robot& self) { return self.model().links[static_cast<std::size_t>(self.tip())].name; })
      .def_property_readonly("joint_names", &jointNames)
      .def_property_readonly("link_names",
                             [](const Robot& self) {
                               std::vector<std::string> names;
                               for (const auto& link : self.model().links) names.push_back(link.name);
                               return names;
                             })
      .def_property_readonly(
          "lower", [](const Robot& self) { return perJoint(self, &kinematics::Joint::lower); },
          "Shape (dof,), rad or m.")
      .def_property_readonly(
          "upper", [](const Robot& self) { return perJoint(self, &kinematics::Joint::upper); },
          "Shape (dof,), rad or m.")
      .def_property_readonly(
          "velocity", [](const Robot& self) { return perJoint(self, &kinematics::Joint::velocity); },
          "Shape (dof,), rad/s or m/s; 0 where the file does not say.")
      .def_property_readonly(
          "rest", [](const Robot& self) { return arrayOf(kinematics::restPositions(self.model())); },
          "Home, else zero, moved into the limits: shape (dof,).")
      .def_property_readonly(
          "inverse_model", [](Robot& self) { return self.inverse().name(); }, "The class that was recognised.")
      .def("__repr__", [](const Robot& self) {
        return py::str("<Robot '{}': {} joints, tip '{}'>")
            .format(self.model().name, self.model().dof(),
                    self.model().links[static_cast<std::size_t>(self.tip())].name);
      });
  bindKinematics(robot);
}

}  // namespace hapticell::python
