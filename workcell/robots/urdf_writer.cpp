// SPDX-License-Identifier: Apache-2.0
#include "workcell/robots/urdf_writer.h"

#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <vector>

#include "geometry/system/markup.h"
#include "workcell/meshes/mesh_writer.h"
#include "workcell/text/file_content.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

std::string number(double value) {
  char text[40];
  return {text, std::to_chars(text, text + sizeof text, value == 0.0 ? 0.0 : value).ptr};
}

std::string numbers(const dvec3& v) {
  return number(v.x) + " " + number(v.y) + " " + number(v.z);
}

/// Roll, pitch, yaw about the fixed axes x, y, z, as URDF turns.
dvec3 rollPitchYaw(const dquat& q) {
  const dmat3 r = glm::mat3_cast(q);  // r[column][row].
  const double across = std::hypot(r[0][0], r[0][1]);
  const double pitch = std::atan2(-r[0][2], across);
  if (across > 1e-9) return {std::atan2(r[1][2], r[2][2]), pitch, std::atan2(r[0][1], r[0][0])};
  return {std::atan2(-r[2][1], r[1][1]), pitch, 0.0};  // Looking along z: roll and yaw are one turn.
}

std::string origin(const Pose& X) {
  return "<origin xyz=\"" + numbers(X.p) + "\" rpy=\"" + numbers(rollPitchYaw(X.q)) + "\"/>";
}

class UrdfText {
 public:
  UrdfText(const Entity& robot, const fs::path& file) : robot_(robot), model_(*robot.robot()) {
    meshes_ = file.stem().string() + "_meshes";
  }

  std::string write() {
    text_ = "<?xml version=\"1.0\"?>\n<robot name=\"" + escapedMarkup(robot_.name) + "\">\n";
    writeBase();
    for (const kinematics::Link& link : model_.links) writeLink(link);
    for (const kinematics::Joint& joint : model_.joints) writeJoint(joint);
    return text_ + "</robot>\n";
  }

  /// File names in the meshes' folder, by mesh.
  const std::map<std::string, const geometry::TriangleMesh*>& files() const { return files_; }
  const std::string& folder() const { return meshes_; }

 private:
  void writeBase() {
    std::string base = "world";
    if (model_.findLink(base) >= 0) base = "cell";
    while (model_.findLink(base) >= 0) base += '_';
    const std::string root = model_.links[0].name;
    text_ += "  <link name=\"" + base + "\"/>\n  <joint name=\"" + base + "_to_" + escapedMarkup(root) +
             "\" type=\"fixed\">\n    " + origin(robot_.X_WE) + "\n    <parent link=\"" + base +
             "\"/>\n    <child link=\"" + escapedMarkup(root) + "\"/>\n  </joint>\n";
  }

  std::string fileOf(const geometry::TriangleMesh& mesh, const std::string& wanted) {
    const auto known = names_.find(&mesh);
    if (known != names_.end()) return known->second;
    std::string stem;
    for (char c : wanted) stem += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    std::string name = stem + ".stl";
    for (int k = 2; files_.contains(name); ++k) name = stem + "_" + std::to_string(k) + ".stl";
    files_[name] = &mesh;
    return names_[&mesh] = name;
  }

  void writeShape(const char* kind, const kinematics::LinkShape& shape, const std::string& link) {
    if (!shape.mesh || shape.mesh->triangles.empty()) return;
    text_ += std::string("    <") + kind + ">\n      " + origin(shape.X_LS) + "\n      <geometry><mesh filename=\"" +
             meshes_ + "/" + fileOf(*shape.mesh, link) + "\"/></geometry>\n";
    if (std::string(kind) == "visual") {
      std::string rgba;
      for (float part : shape.color)
        rgba += (rgba.empty() ? "" : " ") + number(std::round(1e4 * static_cast<double>(part)) / 1e4);
      text_ += "      <material name=\"" + escapedMarkup(link) + "_" + std::to_string(++materials_) +
               "\"><color rgba=\"" + rgba + "\"/></material>\n";
    }
    text_ += std::string("    </") + kind + ">\n";
  }

  void writeLink(const kinematics::Link& link) {
    text_ += "  <link name=\"" + escapedMarkup(link.name) + "\">\n";
    for (const auto& shape : link.visuals) writeShape("visual", shape, link.name);
    for (const auto& shape : link.collisions) writeShape("collision", shape, link.name);
    text_ += "  </link>\n";
  }

  void writeJoint(const kinematics::Joint& joint) {
    const char* const types[] = {"fixed", "revolute", "continuous", "prismatic"};
    const auto link = [&](int index) { return escapedMarkup(model_.links[static_cast<std::size_t>(index)].name); };
    text_ += "  <joint name=\"" + escapedMarkup(joint.name) + "\" type=\"" + types[static_cast<int>(joint.type)] +
             "\">\n    " + origin(joint.X_PJ) + "\n    <parent link=\"" + link(joint.parent_link) +
             "\"/>\n    <child link=\"" + link(joint.child_link) + "\"/>\n";
    if (joint.type != kinematics::JointType::kFixed) writeMotion(joint);
    text_ += "  </joint>\n";
  }

  void writeMotion(const kinematics::Joint& joint) {
    text_ += "    <axis xyz=\"" + numbers(joint.axis_J) + "\"/>\n    <limit";
    if (joint.type != kinematics::JointType::kContinuous)
      text_ += " lower=\"" + number(joint.lower) + "\" upper=\"" + number(joint.upper) + "\"";
    text_ += " effort=\"0\" velocity=\"" + number(joint.velocity) + "\"/>\n";
    if (!joint.mimic || joint.mimic->joint < 0) return;
    const std::string& followed = model_.joints[static_cast<std::size_t>(joint.mimic->joint)].name;
    text_ += "    <mimic joint=\"" + escapedMarkup(followed) + "\" multiplier=\"" + number(joint.mimic->multiplier) +
             "\" offset=\"" + number(joint.mimic->offset) + "\"/>\n";
  }

  const Entity& robot_;
  const kinematics::RobotModel& model_;
  std::string meshes_, text_;
  std::map<std::string, const geometry::TriangleMesh*> files_;
  std::map<const geometry::TriangleMesh*, std::string> names_;
  int materials_ = 0;
};

}  // namespace

Expected<void> writeUrdf(const Entity& robot, const fs::path& file, Diagnostics& diagnostics) {
  if (!robot.robot() || robot.robot()->links.empty()) {
    return makeError({.file = file.string(),
                      .found = Text("'%1', which is not a robot", robot.name),
                      .expected = "a robot",
                      .fix = "Choose a robot."});
  }
  if (robot.robot()->closure) {
    diagnostics.warn(Text("'%1' has closed loops, which URDF cannot describe: only its tree was written", robot.name));
  }
  UrdfText urdf(robot, file);
  const std::string text = urdf.write();
  const fs::path folder = file.parent_path() / urdf.folder();
  std::error_code fault;
  const bool made = !urdf.files().empty() && fs::create_directories(folder, fault);
  if (fault)
    return makeError({.file = folder.string(), .found = fault.message(), .expected = "a folder that can be created"});
  std::vector<FileToWrite> files;
  for (const auto& [name, mesh] : urdf.files()) {
    const NamedMesh part{name, *mesh};
    files.push_back({folder / name, stlBytes({&part, 1}, 1.0)});
  }
  files.push_back({file, text});
  auto written = writeFilesAtomically(files);
  if (!written && made) fs::remove(folder, fault);  // Where it is empty.
  return written;
}

}  // namespace hapticell::workcell
