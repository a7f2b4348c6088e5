// SPDX-License-Identifier: Apache-2.0
#include "app/host/document_model.h"

#include <memory>
#include <utility>

#include "workcell/document_io.h"
#include "workcell/mesh_reader.h"
#include "workcell/robot_reader.h"

namespace hapticell::app {

QString DocumentModel::title() const {
  const auto& path = document_.path();
  return path.empty() ? tr("New workcell") : QString::fromStdString(path.stem().string());
}

bool DocumentModel::execute(const workcell::Command& command) {
  const auto done = document_.execute(command);
  if (!done) {
    emit refused(QString::fromStdString(done.error().message()));
    return false;
  }
  emit changed();
  return true;
}

void DocumentModel::undo() {
  if (document_.undo()) emit changed();
}

void DocumentModel::redo() {
  if (document_.redo()) emit changed();
}

void DocumentModel::goTo(int steps) {
  bool moved = false;
  const auto done = [this] { return static_cast<int>(document_.undoTexts().size()); };
  while (done() > steps && document_.undo()) moved = true;
  while (done() < steps && document_.redo()) moved = true;
  if (moved) emit changed();
}

void DocumentModel::beginStep(const QString& text) {
  document_.beginCompound(text.toStdString());
}

void DocumentModel::endStep() {
  if (!document_.inCompound()) return;
  document_.endCompound();
  emit changed();
}

void DocumentModel::cancelStep() {
  if (!document_.inCompound()) return;
  document_.cancelCompound();
  emit changed();
}

void DocumentModel::clear() {
  document_ = workcell::Document();
  emit opened();
  emit changed();
}

Expected<void> DocumentModel::open(const QString& path, Diagnostics& diagnostics) {
  auto loaded = workcell::loadDocument(path.toStdString(), diagnostics);
  if (!loaded) return makeError(loaded.error());
  document_ = std::move(*loaded);
  emit opened();
  emit changed();
  return {};
}

Expected<void> DocumentModel::save(const QString& path) {
  auto saved = workcell::saveDocument(document_, path.toStdString());
  if (saved) emit changed();
  return saved;
}

Expected<workcell::EntityId> DocumentModel::importMesh(const QString& path, double scale, Diagnostics& diagnostics) {
  const std::filesystem::path file = path.toStdString();
  workcell::MeshReadOptions options;
  options.scale = scale;
  auto mesh = workcell::readMesh(file, options, diagnostics);
  if (!mesh) return makeError(mesh.error());
  workcell::Entity entity;
  entity.name = document_.uniqueName(file.stem().string());
  entity.kind = workcell::EntityKind::kSolid;
  entity.source = {std::filesystem::absolute(file).string(), scale};
  entity.mesh = std::make_shared<const geometry::TriangleMesh>(std::move(*mesh));
  auto id = document_.execute(workcell::AddEntity{entity});
  if (id) emit changed();
  return id;
}

Expected<workcell::EntityId> DocumentModel::addRobot(const QString& path, Diagnostics& diagnostics) {
  const std::filesystem::path file = path.toStdString();
  auto robot = workcell::readRobot(file, diagnostics);
  if (!robot) return makeError(robot.error());
  const kinematics::RobotModel& model = robot->model;
  workcell::Entity entity;
  entity.kind = workcell::EntityKind::kRobot;
  entity.source = {std::filesystem::absolute(file).string(), 1.0};
  entity.name = document_.uniqueName(model.name.empty() ? file.stem().string() : model.name);
  entity.joints = kinematics::restPositions(model);
  if (const int tip = model.defaultTip(); tip >= 0) entity.tip_link = model.links[static_cast<std::size_t>(tip)].name;
  entity.tools = std::move(robot->tools);
  entity.robot = std::make_shared<const kinematics::RobotModel>(std::move(robot->model));
  auto id = document_.execute(workcell::AddEntity{entity});
  if (id) emit changed();
  return id;
}

}  // namespace hapticell::app
