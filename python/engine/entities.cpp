// SPDX-License-Identifier: Apache-2.0
#include "python/engine/entity_binding.h"

#include <pybind11/stl.h>

#include <array>

#include "python/engine/conversion.h"
#include "workcell/format/document_io.h"

namespace hapticell::python {

namespace {

void setProperties(Workcell& self, const std::string& name, const py::kwargs& values) {
  workcell::SetProperties change;
  change.id = self.entity(name).id;
  const auto onContact = [](const std::string& word) {
    for (const auto one : {workcell::OnContact::kStop, workcell::OnContact::kSlide, workcell::OnContact::kPass})
      if (word == workcell::wordOf(one)) return one;
    raise({.place = "on_contact", .found = Text::plain("'" + word + "'"), .expected = "stop, slide or pass"});
  };
  const auto forceClass = [](const std::string& word) {
    for (const auto one :
         {workcell::ForceClass::kConstant, workcell::ForceClass::kContact, workcell::ForceClass::kDynamics})
      if (word == workcell::wordOf(one)) return one;
    raise(
        {.place = "force_class", .found = Text::plain("'" + word + "'"), .expected = "constant, contact or dynamics"});
  };
  for (const auto& [key, value] : values) {
    const auto word = key.cast<std::string>();
    if (word == "color")
      change.color = value.cast<std::array<float, 3>>();
    else if (word == "visible")
      change.visible = value.cast<bool>();
    else if (word == "locked")
      change.locked = value.cast<bool>();
    else if (word == "checked")
      change.checked = value.cast<bool>();
    else if (word == "on_contact")
      change.on_contact = onContact(value.cast<std::string>());
    else if (word == "force_class")
      change.force_class = forceClass(value.cast<std::string>());
    else if (word == "material")
      change.material = value.cast<std::string>();
    else if (word == "mass")
      change.mass = value.cast<double>();
    else if (word == "parent")
      change.parent = value.cast<std::string>();
    else
      raise({.place = Text::plain(word),
             .found = "an unknown property",
             .expected = "color, visible, locked, checked, on_contact, force_class, material, mass or parent"});
  }
  self.execute(change);
}

}  // namespace

void bindEntity(py::module_& module) {
  py::class_<EntityView>(module, "Entity",
                         "An entity of a cell as it was when it was asked for; change it by the cell's methods.")
      .def_property_readonly("name", [](const EntityView& e) { return e.entity.name; })
      .def_property_readonly(
          "kind", [](const EntityView& e) { return workcell::wordOf(e.entity.kind()); },
          "solid, robot, mechanism, assembly, mannequin or frame")
      .def_property_readonly(
          "pose", [](const EntityView& e) { return arrayOf(e.entity.X_WE); }, "X_WE, shape (7,).")
      .def_property_readonly(
          "joints", [](const EntityView& e) { return arrayOf(e.entity.joints()); }, "rad or m; empty for a solid.")
      .def_property_readonly("parent", [](const EntityView& e) { return e.entity.parent; })
      .def_property_readonly(
          "color", [](const EntityView& e) { return e.entity.color; }, "sRGB, 0 to 1.")
      .def_property_readonly("visible", [](const EntityView& e) { return e.entity.visible; })
      .def_property_readonly("locked", [](const EntityView& e) { return e.entity.locked; })
      .def_property_readonly("checked", [](const EntityView& e) { return e.entity.checked; })
      .def_property_readonly(
          "attached_to", [](const EntityView& e) { return e.entity.attachment.to; }, "Name of the carrier, or empty.")
      .def_property_readonly("material", [](const EntityView& e) { return e.entity.contact.material; })
      .def_property_readonly(
          "mass", [](const EntityView& e) { return e.entity.contact.mass; }, "kg")
      .def_property_readonly("on_contact",
                             [](const EntityView& e) { return workcell::wordOf(e.entity.contact.on_contact); })
      .def_property_readonly("source", [](const EntityView& e) { return e.entity.source.path; })
      .def("__repr__", [](const EntityView& e) {
        return py::str("<Entity '{}': {}>").format(e.entity.name, workcell::wordOf(e.entity.kind()));
      });
}

void bindPlacing(py::class_<Workcell>& cell) {
  cell.def(
          "move",
          [](Workcell& self, const std::string& name, py::handle pose) {
            self.execute(workcell::SetPlacement{self.entity(name).id, poseOf(pose)});
          },
          py::arg("name"), py::arg("pose"), "Places an entity at X_WE; what is attached to it goes along.")
      .def(
          "set_joints",
          [](Workcell& self, const std::string& name, py::handle joints) {
            self.execute(workcell::SetJoints{self.entity(name).id, numbersOf(joints, -1, "joints")});
          },
          py::arg("name"), py::arg("joints"), "Joints of a robot, mechanism or mannequin, rad or m.")
      .def(
          "rename",
          [](Workcell& self, const std::string& name, const std::string& to) {
            self.execute(workcell::RenameEntity{self.entity(name).id, to});
          },
          py::arg("name"), py::arg("new_name"))
      .def(
          "remove",
          [](Workcell& self, const std::string& name) { self.execute(workcell::RemoveEntity{self.entity(name).id}); },
          py::arg("name"))
      .def("set", &setProperties, py::arg("name"),
           "Changes color, visible, locked, checked, on_contact, force_class, material, mass (kg) or parent.")
      .def(
          "attach",
          [](Workcell& self, const std::string& name, const std::string& to, const std::string& link) {
            self.execute(workcell::Attach{self.entity(name).id, self.entity(to).id, link});
          },
          py::arg("name"), py::arg("to"), py::arg("link") = "",
          "At its present place; from then on it moves with the link.")
      .def(
          "detach",
          [](Workcell& self, const std::string& name) { self.execute(workcell::Detach{self.entity(name).id}); },
          py::arg("name"))
      .def(
          "set_tool",
          [](Workcell& self, const std::string& name, const std::string& link, py::handle pose) {
            self.execute(workcell::SetTool{self.entity(name).id, link, poseOf(pose)});
          },
          py::arg("name"), py::arg("link"), py::arg("pose") = py::none(), "The tool centre point X_LT of a robot.");
}

}  // namespace hapticell::python
