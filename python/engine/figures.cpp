// SPDX-License-Identifier: Apache-2.0
#include <pybind11/stl.h>

#include <optional>

#include "geometry/system/listed.h"
#include "mannequin/body/figure.h"
#include "mannequin/ergonomics/scores/posture_scores.h"
#include "mannequin/ergonomics/scores/work_task.h"
#include "mannequin/posture/forward_kinematics.h"
#include "mannequin/posture/posture.h"
#include "mannequin/posture/reach_envelope.h"
#include "python/engine/bindings.h"
#include "python/engine/conversion.h"
#include "python/engine/mesh_binding.h"

namespace hapticell::python {

namespace {

using mannequin::Figure;
using mannequin::Posture;

mannequin::Sex sexOf(const std::string& word) {
  if (word == "male") return mannequin::Sex::kMale;
  if (word == "female") return mannequin::Sex::kFemale;
  raise({.place = "sex", .found = Text::plain("'" + word + "'"), .expected = "male or female"});
}

Figure makeFigure(const std::string& sex, std::optional<double> percentile, std::optional<double> stature,
                  std::optional<double> mass) {
  if (percentile && stature)
    raise({.place = "size", .found = "both percentile and stature", .expected = "one of them"});
  mannequin::BodyRequest request;
  request.sex = sexOf(sex);
  request.mass = mass;
  request.stature =
      stature ? *stature : valueOf(mannequin::statureOfPercentile(request.sex, percentile.value_or(50.0)));
  return valueOf(mannequin::makeFigure(request));
}

Posture postureOf(const Figure& figure, const std::string& name) {
  if (const auto posture = mannequin::libraryPosture(figure, name)) return *posture;
  raise({.place = "posture",
         .found = Text("no posture is named '%1'", name),
         .expected = Text("one of %1", listed(mannequin::postureLibrary(), &mannequin::LibraryPosture::name))});
}

mannequin::Dof dofOf(const std::string& name) {
  if (const auto dof = mannequin::findDof(name)) return *dof;
  raise({.place = "joint", .found = Text::plain("'" + name + "'"), .expected = "a name of Posture.joint_names()"});
}

std::vector<std::string> dofNames() {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < mannequin::kDofCount; ++i)
    names.push_back(mannequin::dofInfo(static_cast<mannequin::Dof>(i)).name);
  return names;
}

/// The task of a call: what is None stays unknown, and a score that needs it is then partial.
ergonomics::WorkTask taskOf(std::optional<std::pair<double, double>> load_kg, std::optional<double> repetitions,
                            std::optional<bool> is_static, std::optional<bool> has_shock, const std::string& grip) {
  ergonomics::WorkTask task;
  if (load_kg) task.load_kg = {load_kg->first, load_kg->second};
  task.repetitions_per_min = repetitions;
  task.is_static = is_static;
  task.has_shock = has_shock;
  const std::vector<std::string> grips{"good", "fair", "poor", "unacceptable"};
  const auto at = std::find(grips.begin(), grips.end(), grip);
  if (!grip.empty() && at == grips.end())
    raise({.place = "grip", .found = Text::plain("'" + grip + "'"), .expected = "good, fair, poor or unacceptable"});
  if (!grip.empty()) task.grip = static_cast<ergonomics::Grip>(at - grips.begin());
  valueOf(ergonomics::checkWorkTask(task));
  return task;
}

py::object scoresOf(const Figure& figure, const Posture& posture, const ergonomics::WorkTask& task) {
  const auto scores = ergonomics::scorePosture(figure, posture, mannequin::forwardKinematics(figure, posture), task);
  py::object made = py::module_::import("hapticell._results").attr("Result")();
  py::list missing;
  for (const std::string_view one : scores.missing) missing.append(py::str(std::string(one)));
  made["rula"] = scores.rula();
  made["reba"] = scores.reba();
  made["owas_code"] = scores.owasCode();
  made["owas"] = scores.owas_category;
  made["eaws_points"] = scores.eaws_points;
  made["comfort"] = scores.comfort;
  made["worse_side"] = scores.worseSide() == mannequin::Side::kLeft ? "left" : "right";
  made["missing"] = missing;
  return made;
}

void bindPosture(py::module_& module) {
  py::class_<Posture>(module, "Posture",
                      "56 joint angles (rad) and the place of the pelvis. posture['l_elbow_flexion'] is one of them.")
      .def_static("joint_names", &dofNames, "Names of the 56 angles, in their order.")
      .def_property_readonly(
          "angles",
          [](const Posture& self) {
            return py::array_t<double>(static_cast<py::ssize_t>(self.angles.size()), self.angles.data());
          },
          "A copy, shape (56,), rad.")
      .def_property(
          "root", [](const Posture& self) { return arrayOf(self.X_WR); },
          [](Posture& self, py::handle pose) { self.X_WR = poseOf(pose); }, "X_WR of the pelvis, shape (7,).")
      .def("__getitem__", [](const Posture& self, const std::string& name) { return self[dofOf(name)]; })
      .def("__setitem__",
           [](Posture& self, const std::string& name, double angle) {
             if (!std::isfinite(angle))
               raise({.place = Text::plain(name), .found = "a number that is not finite", .expected = "radians"});
             self[dofOf(name)] = angle;
           })
      .def(
          "violations",
          [](const Posture& self) {
            std::vector<std::string> texts;
            for (const auto& one : mannequin::limitViolations(self)) texts.push_back(english(mannequin::textOf(one)));
            return texts;
          },
          "Angles outside their limits, in words.")
      .def(
          "mirrored", [](const Posture& self) { return mannequin::mirror(self); }, "Left and right exchanged.")
      .def("copy", [](const Posture& self) { return self; })
      .def("__repr__", [](const Posture& self) {
        return py::str("<Posture at {:.3f}, {:.3f}, {:.3f} m>").format(self.X_WR.p.x, self.X_WR.p.y, self.X_WR.p.z);
      });
}

}  // namespace

void bindFigures(py::module_& module) {
  bindPosture(module);
  py::class_<Figure>(
      module, "Figure",
      "A person of one size, from ANSUR II.\n\nFigure(sex, percentile=50, stature=None, mass=None): sex 'male' or "
      "'female'; percentile of stature, or stature (m, 1.2 to 2.3); mass in kg.")
      .def(py::init(&makeFigure), py::arg("sex") = "male", py::arg("percentile") = py::none(),
           py::arg("stature") = py::none(), py::arg("mass") = py::none())
      .def_property_readonly("measures", &mannequin::measuresOf, "Outer measures by name, metres.")
      .def_property_readonly(
          "stature", [](const Figure& self) { return self.body[mannequin::Dimension::kStature]; }, "m")
      .def_property_readonly("mass", &Figure::totalMass, "kg")
      .def("posture", &postureOf, py::arg("name") = "standing", "A posture of the library, with its feet on the floor.")
      .def(
          "on_floor", [](const Figure& self, const Posture& posture) { return mannequin::onFloor(self, posture); },
          py::arg("posture"))
      .def(
          "hand_pose",
          [](const Figure& self, const Posture& posture, const std::string& hand) {
            if (hand != "left" && hand != "right")
              raise({.place = "hand", .found = Text::plain("'" + hand + "'"), .expected = "left or right"});
            return arrayOf(mannequin::handPose(mannequin::forwardKinematics(self, posture),
                                               hand == "left" ? mannequin::Side::kLeft : mannequin::Side::kRight));
          },
          py::arg("posture"), py::arg("hand"), "X_WH of a hand: origin at the wrist, fingers along -z. Shape (7,).")
      .def(
          "center_of_mass",
          [](const Figure& self, const Posture& posture) {
            return arrayOf(mannequin::centerOfMass(self, mannequin::forwardKinematics(self, posture)));
          },
          py::arg("posture"), "In the world, metres.")
      .def(
          "scores",
          [](const Figure& self, const Posture& posture, std::optional<std::pair<double, double>> load_kg,
             std::optional<double> repetitions, std::optional<bool> is_static, std::optional<bool> has_shock,
             const std::string& grip) {
            return scoresOf(self, posture, taskOf(load_kg, repetitions, is_static, has_shock, grip));
          },
          py::arg("posture"), py::arg("load_kg") = py::none(), py::arg("repetitions_per_min") = py::none(),
          py::arg("static") = py::none(), py::arg("shock") = py::none(), py::arg("grip") = "",
          "RULA, REBA, OWAS and EAWS of a posture at a task: load in the left and right hand (kg). What is None is "
          "listed in "
          "`missing` and counts as least. NIOSH and single sub-scores: hapticell.ergonomics.")
      .def(
          "reach",
          [](const Figure& self, const Posture& posture, const std::string& hand, bool with_trunk) {
            mannequin::ReachOptions options;
            options.with_trunk = with_trunk;
            const auto side = hand == "left" ? mannequin::Side::kLeft : mannequin::Side::kRight;
            const py::gil_scoped_release unlocked;
            return Mesh{collision::MeshCollider::build(mannequin::reachEnvelope(self, posture, side, options)),
                        "reach"};
          },
          py::arg("posture"), py::arg("hand") = "right", py::arg("with_trunk") = false,
          "The surface that the hand reaches, as a Mesh in the world.")
      .def("__repr__", [](const Figure& self) {
        return py::str("<Figure: {}, {:.3f} m, {:.1f} kg>")
            .format(self.sex == mannequin::Sex::kMale ? "male" : "female", self.body[mannequin::Dimension::kStature],
                    self.totalMass());
      });
}

}  // namespace hapticell::python
