// SPDX-License-Identifier: Apache-2.0
#include <pybind11/stl.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "geometry/system/atomic_file.h"
#include "geometry/system/listed.h"
#include "manipulation/scene/rest_pairs.h"
#include "python/engine/bindings.h"
#include "python/engine/conversion.h"
#include "python/engine/entity_binding.h"
#include "python/engine/long_work.h"
#include "python/engine/robot_binding.h"
#include "python/engine/workcell_binding.h"
#include "workcell/files/document_lock.h"
#include "workcell/files/scene_export.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"
#include "workcell/import/imported_entities.h"
#include "workcell/meshes/length_unit.h"

namespace hapticell::python {

using workcell::Entity;
using workcell::EntityId;

const Entity& Workcell::entity(const std::string& name) const {
  if (const Entity* const found = document.findByName(name)) return *found;
  raise({.file = document.path().string(),
         .place = "entity",
         .found = Text("no entity is named '%1'", name),
         .expected = Text("one of %1", listed(document.state().entities, [](const auto& one) { return one->name; }))});
}

void Workcell::execute(const workcell::Command& command) {
  valueOf(document.execute(command));
}

std::shared_ptr<const manipulation::PreparedScene> Workcell::prepared() const {
  std::shared_ptr<const manipulation::PreparedScene> scene;
  manipulation::PreparationProgress progress;
  manipulation::SceneSource source = manipulation::sourceOf(document, {});
  runLong([&] { scene = scenes->prepare(std::move(source), &progress); }, [&] { progress.build.cancelled = true; });
  return scene;
}

namespace {

std::unique_ptr<Workcell> open(py::object file) {
  Diagnostics diagnostics;
  workcell::ImportMonitor monitor;
  workcell::LoadOptions options;
  options.monitor = &monitor;
  const std::string path = pathOf(file);
  std::optional<Expected<workcell::Document>> read;
  runLong([&] { read = workcell::loadDocument(path, diagnostics, options); }, [&] { monitor.cancel(); });
  tellWarnings(diagnostics.warnings);
  auto cell = std::make_unique<Workcell>();
  cell->document = valueOf(std::move(*read));
  return cell;
}

/// For the console: the cell is that of the window from now on, without a history; shapes that are known are not read
/// again.
void takeDocument(Workcell& self, const std::string& text, const std::string& folder, const std::string& path) {
  Diagnostics diagnostics;
  workcell::ImportMonitor monitor;
  workcell::LoadOptions options;
  options.monitor = &monitor;
  options.keep_unloaded = true;
  options.known = &self.document.state();
  std::optional<Expected<workcell::Document>> read;
  runLong([&] { read = workcell::parseDocument(text, folder, path, diagnostics, options); }, [&] { monitor.cancel(); });
  workcell::Document document = valueOf(std::move(*read));
  document.continueAfter(self.document);
  document.setPath(path);
  self.document = std::move(document);
}

void saveWorkcell(Workcell& self, const py::object& file) {
  const std::filesystem::path path = file.is_none() ? self.document.path() : std::filesystem::path(pathOf(file));
  if (path.extension() != ".hcell")
    raise({.file = path.string(), .found = "the name of the document", .expected = "one that ends in .hcell"});
  const auto lock = valueOf(workcell::DocumentLock::takeForWriting(path));
  valueOf(workcell::saveDocument(self.document, path));
}

void convert(const Workcell& self, py::object file) {
  const std::string path = pathOf(file);
  Diagnostics diagnostics;
  workcell::ImportMonitor monitor;
  workcell::ExportOptions options;
  options.monitor = &monitor;
  Expected<void> written;
  runLong([&] { written = workcell::exportState(self.document.state(), path, options, diagnostics); },
          [&] { monitor.cancel(); });
  tellWarnings(diagnostics.warnings);
  valueOf(std::move(written));
}

workcell::ImportOptions importOptions(const std::optional<std::string>& unit, bool merge) {
  workcell::ImportOptions options;
  options.merge = merge;
  if (unit) options.metres_per_unit = workcell::metresPer(valueOf(workcell::parseLengthUnit(*unit)));
  return options;
}

/// Adds what a file or a word stands for as one undo step; returns the names.
std::vector<std::string> add(Workcell& self, py::object what, const std::string& name, py::handle pose,
                             const std::optional<std::string>& unit, bool merge, const py::object& progress) {
  const std::string source = pathOf(what);
  const Pose X_WF = poseOf(pose);
  const workcell::ImportOptions options = importOptions(unit, merge);
  Diagnostics diagnostics;
  workcell::ImportMonitor monitor;
  std::optional<Expected<workcell::ImportResult>> imported;
  runLong(
      [&] {
        imported =
            workcell::EntityLoader(std::filesystem::current_path()).loadTree(source, options, diagnostics, &monitor);
      },
      [&] { monitor.cancel(); },
      [&] {
        if (!progress.is_none()) progress(monitor.progress().share, english(monitor.progress().stage));
      });
  tellWarnings(diagnostics.warnings);
  auto entities = valueOf(std::move(*imported)).entities;
  if (!name.empty()) {
    const auto roots =
        std::count_if(entities.begin(), entities.end(), [](const Entity& e) { return e.parent.empty(); });
    if (roots != 1)
      raise({.file = source,
             .place = "name",
             .found = Text("%1 things at the top of the file", roots),
             .expected = "one, or no name; merge=True makes one"});
    for (Entity& entity : entities) {
      if (entity.parent == entities.front().name) entity.parent = name;
    }
    if (self.document.findByName(name) != nullptr)
      raise({.file = source,
             .place = "name",
             .found = Text("the name '%1' is already in use", name),
             .expected = "a unique name"});
    entities.front().name = name;
  }
  std::vector<std::string> names;
  for (const EntityId id : valueOf(workcell::addImported(self.document, std::move(entities), X_WF)))
    names.push_back(self.document.find(id)->name);
  return names;
}

/// Distances of one entity to everything that it is checked against, as they stand.
py::list distancesTo(const Workcell& self, const std::string& name, double limit) {
  const EntityId id = self.entity(name).id;
  const auto scene = self.prepared();
  std::vector<manipulation::PairState> pairs;
  runLong([&] { pairs = manipulation::pairsAtRest(*scene, id, limit); }, [] {});
  py::list found;
  const py::object result = py::module_::import("hapticell._results").attr("Result");
  for (const auto& pair : pairs) {
    py::object one = result();
    one["entity"] = scene->find(pair.moved)->name;
    one["part"] = pair.moved_part;
    one["other"] = scene->find(pair.other)->name;
    one["other_part"] = pair.other_part;
    one["distance"] = pair.distance;
    one["point"] = arrayOf(pair.p_WA);
    one["point_other"] = arrayOf(pair.p_WB);
    found.append(one);
  }
  return py::module_::import("hapticell._results").attr("Records")(found);
}

workcell::PairSet pairSet(const std::string& name, std::vector<std::string> first, std::vector<std::string> second,
                          double safety, double near_miss) {
  workcell::PairSet set;
  set.name = name;
  set.first = std::move(first);
  set.second = std::move(second);
  set.safety_distance = safety;
  set.near_miss = near_miss;
  return set;
}

void bindChecks(py::class_<Workcell>& cell) {
  cell.def(
          "add_check",
          [](Workcell& self, const std::string& name, std::vector<std::string> first, std::vector<std::string> second,
             double safety, double near_miss) {
            for (const auto* side : {&first, &second})
              for (const std::string& one : *side) self.entity(one);
            self.execute(workcell::AddPairSet{pairSet(name, std::move(first), std::move(second), safety, near_miss)});
          },
          py::arg("name"), py::arg("first"), py::arg("second"), py::arg("safety_distance") = 0.001,
          py::arg("near_miss") = 0.010,
          "Checks the entities of one list against those of the other (empty: everything); distances in metres.")
      .def(
          "remove_check", [](Workcell& self, const std::string& name) { self.execute(workcell::RemovePairSet{name}); },
          py::arg("name"))
      .def(
          "leave_out",
          [](Workcell& self, const std::string& first, const std::string& second) {
            workcell::PairRule rule;
            rule.first = self.entity(first).name;
            rule.second = self.entity(second).name;
            rule.checked = false;
            self.execute(workcell::SetPairRules{{rule}});
          },
          py::arg("first"), py::arg("second"), "Never checks this pair.")
      .def("distances", &distancesTo, py::arg("name"), py::arg("limit") = std::numeric_limits<double>::infinity(),
           "Distances (m) of an entity to everything that it is checked against, as the cell stands: Records with "
           "entity, part, "
           "other, other_part, distance, point, point_other; nearest first.");
}

void bindHistory(py::class_<Workcell>& cell) {
  cell.def(
          "undo", [](Workcell& self) { return self.document.undo(); }, "False if there is nothing to undo.")
      .def("redo", [](Workcell& self) { return self.document.redo(); })
      .def_property_readonly(
          "history", [](const Workcell& self) { return self.document.undoTexts(); },
          "Steps that can be undone, oldest first.")
      .def_property_readonly(
          "dirty", [](const Workcell& self) { return self.document.isDirty(); }, "Differs from what was saved or read.")
      .def("_begin_step", [](Workcell& self, const std::string& text) { self.document.beginCompound(text); })
      .def("_end_step", [](Workcell& self) { self.document.endCompound(); })
      .def("_cancel_step", [](Workcell& self) { self.document.cancelCompound(); });
}

}  // namespace

void bindWorkcells(py::module_& module) {
  bindEntity(module);
  py::class_<Workcell> cell(module, "Workcell",
                            "A workcell document: entities placed in the world W (metres, z up). Every change is a "
                            "command that can be undone.");
  cell.def(py::init<>())
      .def_static("open", &open, py::arg("file"), "Reads a .hcell with all that it names.")
      .def("save", &saveWorkcell, py::arg("file") = py::none(), "Writes the .hcell; a failure leaves the old file.")
      .def(
          "_write_copy",
          [](const Workcell& self, py::object file) {
            const std::filesystem::path path = std::filesystem::absolute(pathOf(file));
            valueOf(writeFileAtomically(path, workcell::documentText(self.document.state(), path.parent_path())));
          },
          py::arg("file"))
      .def(
          "_document_text",
          [](const Workcell& self, const std::string& folder) {
            return workcell::documentText(self.document.state(), folder);
          },
          py::arg("folder"))
      .def("_take_document", &takeDocument, py::arg("text"), py::arg("folder"), py::arg("path"))
      .def_property_readonly("_revision", [](const Workcell& self) { return self.document.revision(); })
      .def_property_readonly("_in_step", [](const Workcell& self) { return self.document.inCompound(); })
      .def("convert", &convert, py::arg("file"), "Writes STEP, glTF, STL, OBJ, PLY, OFF, or the one robot as URDF.")
      .def("add", &add, py::arg("what"), py::arg("name") = "", py::arg("pose") = py::none(),
           py::arg("unit") = py::none(), py::arg("merge") = false, py::arg("progress") = py::none(),
           "Adds a CAD, mesh or robot file, library:NAME, mannequin:SEX:PERCENTILE, or a built-in part (box:X,Y,Z, "
           "cylinder:R,H, sphere:R, table:, ...) at X_WE, as one undo step. `progress(share, stage)` is called while "
           "it is "
           "read. Returns the names of the new entities.")
      .def_property_readonly("path", [](const Workcell& self) { return self.document.path().string(); })
      .def_property_readonly("names",
                             [](const Workcell& self) {
                               std::vector<std::string> names;
                               for (const auto& entity : self.document.state().entities) names.push_back(entity->name);
                               return names;
                             })
      .def("__len__", [](const Workcell& self) { return self.document.state().entities.size(); })
      .def("__contains__",
           [](const Workcell& self, const std::string& name) { return self.document.findByName(name) != nullptr; })
      .def("__getitem__", [](const Workcell& self, const std::string& name) { return EntityView{self.entity(name)}; })
      .def(
          "robot",
          [](const Workcell& self, const std::string& name) {
            const Entity& entity = self.entity(name);
            const workcell::Jointed& jointed = entity.jointed();
            if (!workcell::isMachine(entity))
              raise({.place = Text("entity '%1'", name), .found = "it is not a robot", .expected = "a robot"});
            const int link = jointed.model->findLink(jointed.tip_link);
            return Robot(jointed.model, link >= 0 ? link : jointed.model->defaultTip(), jointed.X_LT);
          },
          py::arg("name"), "The kinematics of a robot of the cell with its tool; poses are in its root link.")
      .def("__repr__", [](const Workcell& self) {
        return py::str("<Workcell of {} entities{}>")
            .format(self.document.state().entities.size(),
                    self.document.path().empty() ? "" : " '" + self.document.path().filename().string() + "'");
      });
  bindPlacing(cell);
  bindChecks(cell);
  bindHistory(cell);
}

}  // namespace hapticell::python
