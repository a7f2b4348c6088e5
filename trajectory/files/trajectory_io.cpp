// SPDX-License-Identifier: Apache-2.0
#include "trajectory/files/trajectory_io.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>

#include "geometry/system/nesting_limit.h"
#include "geometry/system/regular_file.h"
#include "geometry/system/text_case.h"
#include "trajectory/files/ros_yaml_reader.h"
#include "trajectory/motion/csv_table.h"
#include "trajectory/motion/number_text.h"
#include "trajectory/programs/reading/program_reader.h"

namespace hapticell::trajectory {

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr int kVersion = 1;
constexpr const char* kFormat = "hapticell-trajectory";
// Of a quaternion's length; as kUnitTolerance of pose_csv.cpp, where half and twice are given.
constexpr double kUnitQuaternionTolerance = 1e-3;
constexpr std::array<double, 7> kNoPose{0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0};  ///< Of a motion of joints alone.

const std::vector<std::string>& poseColumns() {
  static const std::vector<std::string> kColumns{"t", "x", "y", "z", "qw", "qx", "qy", "qz"};
  return kColumns;
}

/// The quaternion as it stands where it is a unit one to rounding, so that writing and reading change nothing.
Expected<Pose> poseOf(const double* v) {
  const dquat q(v[3], v[4], v[5], v[6]);
  const double norm = glm::length(q);
  if (!(std::abs(norm - 1.0) <= kUnitQuaternionTolerance)) {
    return makeError({.place = Text::plain("qw,qx,qy,qz"),
                      .found = Text("a quaternion of length %1", shortestText(norm)),
                      .expected = "a unit quaternion"});
  }
  return Pose{{v[0], v[1], v[2]}, std::abs(norm - 1.0) < 1e-9 ? q : q / norm};
}

/// A frame as both formats give it: t, pose, joints.
Expected<void> append(Trajectory& trajectory, const std::vector<double>& numbers, bool by_hand, double dwell,
                      bool is_pose_apart, std::shared_ptr<const std::string> name = nullptr) {
  const auto pose = poseOf(numbers.data() + 1);
  HAPTICELL_TRY(pose);
  const std::span<const double> joints = std::span(numbers).subspan(8, trajectory.joint_names.size());
  const std::span<const double> channels = std::span(numbers).subspan(8 + joints.size());
  if (!trajectory.addFrame({numbers[0], *pose, by_hand, dwell, std::move(name), is_pose_apart}, joints, channels)) {
    return makeError(
        {.place = "t",
         .found = Text("%1 s", shortestText(numbers[0])),
         .expected = Text("a time after the one before, %1 s", shortestText(trajectory.frames().back().t))});
  }
  return {};
}

Error placed(Error error, const fs::path& file, const Text& place) {
  error.file = file.string();
  error.place = error.place.empty() ? place : Text("%1, %2", place, error.place);
  return error;
}

/// The columns of a CSV file beside the known names, and whether it has any of the pose's.
struct CsvColumns {
  std::vector<std::string> joints;
  bool has_pose = false;
};

CsvColumns csvColumns(const fs::path& file) {
  geometry::RegularFileStream stream(file);
  std::string line;
  do {
    if (!std::getline(stream, line)) return {{}, true};
    if (line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
  } while (line.empty() || line.front() == '#' || line == "\r");
  const char separator = line.find(';') != std::string::npos ? ';' : ',';
  CsvColumns columns;
  std::string name;
  for (const char c : line + separator) {
    if (c != separator) {
      if (c != '"' && c != '\r' && !(c == ' ' && name.empty())) name += c;
      continue;
    }
    while (!name.empty() && name.back() == ' ') name.pop_back();
    static const std::vector<std::string> kOther{"button", "by_hand", "dwell", "pose_apart", ""};
    const auto& known = poseColumns();
    const bool is_known = std::find(known.begin(), known.end(), name) != known.end();
    columns.has_pose = columns.has_pose || (is_known && name != "t");
    if (!is_known && std::find(kOther.begin(), kOther.end(), name) == kOther.end()) columns.joints.push_back(name);
    name.clear();
  }
  return columns;
}

Expected<Trajectory> readCsv(const fs::path& file) {
  CsvColumns columns = csvColumns(file);
  // Channels stand behind the joints in a row, whatever the order in the file.
  std::stable_partition(columns.joints.begin(), columns.joints.end(),
                        [](const std::string& name) { return !isChannel(name); });
  Trajectory trajectory;
  trajectory.name = file.stem().string();
  for (const std::string& name : columns.joints)
    (isChannel(name) ? trajectory.channel_names : trajectory.joint_names).push_back(name);
  // Times and joints alone are a motion too; a file that has neither lacks its pose.
  trajectory.has_poses = columns.has_pose || !trajectory.hasJoints();
  std::vector<std::string> wanted = trajectory.has_poses ? poseColumns() : std::vector<std::string>{"t"};
  wanted.insert(wanted.end(), columns.joints.begin(), columns.joints.end());
  const auto table = readCsvTable(file, wanted, {"by_hand", "dwell", "pose_apart"});
  HAPTICELL_TRY(table);
  trajectory.reserve(table->rows.size());
  for (std::size_t i = 0; i < table->rows.size(); ++i) {
    std::vector<double> row = table->rows[i];
    const double by_hand = row[wanted.size()], dwell = row[wanted.size() + 1], apart = row[wanted.size() + 2];
    row.resize(wanted.size());
    if (!trajectory.has_poses) row.insert(row.begin() + 1, kNoPose.begin(), kNoPose.end());
    if (auto added = append(trajectory, row, by_hand != 0.0, dwell, apart != 0.0); !added) {
      return tl::unexpected(placed(added.error(), file, Text("line %1", table->lines[i])));
    }
  }
  return trajectory;
}

/// Numbers of one frame in the file: [t, x, y, z, qw, qx, qy, qz, joints...].
Expected<std::vector<double>> numbersOf(const json& list, std::size_t count) {
  const bool is_right = list.is_array() && list.size() == count &&
                        std::all_of(list.begin(), list.end(), [](const json& n) { return n.is_number(); });
  if (!is_right) {
    return makeError({.found = list.is_array() ? Text("%1 entries", list.size()) : Text("not a list of numbers"),
                      .expected = Text("%1 numbers: t,x,y,z,qw,qx,qy,qz, the joints and the channels", count)});
  }
  auto numbers = list.get<std::vector<double>>();
  if (!std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::isfinite(n); })) {
    return makeError({.found = "a number that is not finite", .expected = "finite numbers"});
  }
  return numbers;
}

Expected<void> checkHeader(const json& document, const fs::path& file) {
  const std::string name = file.string();
  if (!document.is_object() || document.value("format", json()) != kFormat) {
    return makeError({.file = name,
                      .place = Text("field '%1'", "format"),
                      .found = "not a HaptiCell trajectory",
                      .expected = Text("\"%1\"", kFormat)});
  }
  const json version = document.value("version", json());
  if (!version.is_number_integer() || version.get<std::int64_t>() < 1) {
    return makeError({.file = name,
                      .place = Text("field '%1'", "version"),
                      .found = version.dump(),
                      .expected = "a whole number, 1 or more"});
  }
  if (version.get<std::int64_t>() > kVersion) {
    return makeError({.file = name,
                      .place = Text("field '%1'", "version"),
                      .found = version.dump(),
                      .expected = Text("at most %1", kVersion),
                      .fix = "The file was written by a newer HaptiCell: open it there and export it as CSV."});
  }
  return {};
}

Expected<void> readText(const json& document, const char* field, std::string& text) {
  const auto value = document.find(field);
  if (value == document.end()) return {};
  if (!value->is_string())
    return makeError({.place = Text("field '%1'", field), .found = value->dump(), .expected = "a text"});
  text = value->get<std::string>();
  return {};
}

/// Frames that a list of indices marks ("by_hand"), that carry a number ("dwells": [[index, seconds], ...]) or a name
/// ("names": [[index, name], ...]), or lie in a run ("pose_apart": [[first, last], ...]).
struct Marks {
  std::vector<bool> by_hand, pose_apart;
  std::vector<double> dwell;
  std::map<std::size_t, std::string> names;
};

Expected<Marks> readMarks(const json& document, std::size_t count) {
  Marks marks{std::vector<bool>(count, false), std::vector<bool>(count, false), std::vector<double>(count, 0.0), {}};
  const auto isIndex = [count](const json& i) { return i.is_number_unsigned() && i.get<std::size_t>() < count; };
  for (const json& index : document.value("by_hand", json::array())) {
    if (!isIndex(index))
      return makeError(
          {.place = Text("field '%1'", "by_hand"), .found = index.dump(), .expected = "a frame number, 0 or more"});
    marks.by_hand[index.get<std::size_t>()] = true;
  }
  for (const json& dwell : document.value("dwells", json::array())) {
    if (!dwell.is_array() || dwell.size() != 2 || !isIndex(dwell[0]) || !dwell[1].is_number()) {
      return makeError({.place = Text("field '%1'", "dwells"), .found = dwell.dump(), .expected = "[frame, seconds]"});
    }
    marks.dwell[dwell[0].get<std::size_t>()] = dwell[1].get<double>();
  }
  for (const json& name : document.value("names", json::array())) {
    if (!name.is_array() || name.size() != 2 || !isIndex(name[0]) || !name[1].is_string()) {
      return makeError({.place = Text("field '%1'", "names"), .found = name.dump(), .expected = "[frame, \"name\"]"});
    }
    marks.names[name[0].get<std::size_t>()] = name[1].get<std::string>();
  }
  for (const json& run : document.value("pose_apart", json::array())) {
    if (!run.is_array() || run.size() != 2 || !isIndex(run[0]) || !isIndex(run[1])) {
      return makeError(
          {.place = Text("field '%1'", "pose_apart"), .found = run.dump(), .expected = "[first frame, last frame]"});
    }
    for (auto i = run[0].get<std::size_t>(); i <= run[1].get<std::size_t>(); ++i) marks.pose_apart[i] = true;
  }
  return marks;
}

/// Channels and touches.
Expected<void> readRecorded(const json& document, Trajectory& trajectory) {
  for (const json& channel : document.value("channels", json::array())) {
    if (!channel.is_string() || !isChannel(channel.get<std::string>())) {
      return makeError({.place = Text("field '%1'", "channels"),
                        .found = channel.dump(),
                        .expected = "force_x, force_y, force_z, contact or configuration"});
    }
    trajectory.channel_names.push_back(channel.get<std::string>());
  }
  for (const json& touch : document.value("touches", json::array())) {
    const bool is_right = touch.is_array() && touch.size() == 5 && touch[0].is_number() && touch[1].is_number() &&
                          touch[2].is_string() && touch[3].is_string() && touch[4].is_number();
    if (!is_right)
      return makeError({.place = Text("field '%1'", "touches"),
                        .found = touch.dump(),
                        .expected = "[in, out, \"first\", \"second\", force]"});
    trajectory.touches.push_back({touch[0].get<double>(), touch[1].get<double>(), touch[2].get<std::string>(),
                                  touch[3].get<std::string>(), touch[4].get<double>()});
  }
  return {};
}

Expected<Trajectory> fromJson(const json& document) {
  Trajectory trajectory;
  for (auto [field, text] : {std::pair("name", &trajectory.name), std::pair("entity", &trajectory.entity),
                             std::pair("moved", &trajectory.moved), std::pair("take", &trajectory.take)}) {
    HAPTICELL_TRY(readText(document, field, *text));
  }
  for (const json& joint : document.value("joints", json::array())) {
    if (!joint.is_string())
      return makeError({.place = Text("field '%1'", "joints"), .found = joint.dump(), .expected = "joint names"});
    trajectory.joint_names.push_back(joint.get<std::string>());
  }
  HAPTICELL_TRY(readRecorded(document, trajectory));
  const json has_poses = document.value("has_poses", json(true));
  if (!has_poses.is_boolean() || (!has_poses.get<bool>() && !trajectory.hasJoints())) {
    return makeError({.place = Text("field '%1'", "has_poses"),
                      .found = has_poses.dump(),
                      .expected = "true, or false for a motion that has only joints"});
  }
  trajectory.has_poses = has_poses.get<bool>();
  const json frames = document.value("frames", json());
  if (!frames.is_array())
    return makeError({.place = Text("field '%1'", "frames"), .found = "none", .expected = "a list of frames"});
  const auto marks = readMarks(document, frames.size());
  HAPTICELL_TRY(marks);
  trajectory.reserve(frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Text place("frame %1", i);
    auto numbers = numbersOf(frames[i], 8 + trajectory.joint_names.size() + trajectory.channel_names.size());
    if (!numbers) return tl::unexpected(placed(numbers.error(), {}, place));
    const auto named = marks->names.find(i);
    auto name = named == marks->names.end() ? nullptr : std::make_shared<const std::string>(named->second);
    if (!trajectory.has_poses) std::copy(kNoPose.begin(), kNoPose.end(), numbers->begin() + 1);
    if (auto added =
            append(trajectory, *numbers, marks->by_hand[i], marks->dwell[i], marks->pose_apart[i], std::move(name));
        !added) {
      return tl::unexpected(placed(added.error(), {}, place));
    }
  }
  return trajectory;
}

Expected<Trajectory> readJson(const fs::path& file) {
  const auto text = geometry::readRegularFile(file);
  HAPTICELL_TRY(text);
  auto flat = geometry::checkNesting(*text, geometry::NestedText::kJson, file.string());
  HAPTICELL_TRY(flat);
  const json document = json::parse(*text, nullptr, false);
  if (document.is_discarded())
    return makeError({.file = file.string(), .found = "invalid JSON", .expected = "a HaptiCell trajectory"});
  HAPTICELL_TRY(checkHeader(document, file));
  auto trajectory = fromJson(document);
  if (!trajectory) trajectory.error().file = file.string();
  return trajectory;
}

void appendFrame(std::string& text, const Trajectory& trajectory, std::size_t i, bool with_pose) {
  const auto& frame = trajectory[i];
  const Pose& X = frame.X_WT;
  text += shortestText(frame.t) + ',';
  for (const double value : {X.p.x, X.p.y, X.p.z, X.q.w, X.q.x, X.q.y, X.q.z}) {
    if (!with_pose) break;
    text += shortestText(value);
    text += ',';
  }
  for (const std::span<const double> more : {trajectory.joints(i), trajectory.channels(i)}) {
    for (const double value : more) {
      text += shortestText(value);
      text += ',';
    }
  }
  text.pop_back();
}

}  // namespace

Expected<Trajectory> readTrajectory(const fs::path& file, std::vector<Text>* notes) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored))
    return makeError({.file = file.string(), .found = "a folder", .expected = "a trajectory file"});
  if (!fs::exists(file, ignored))
    return makeError({.file = file.string(), .found = "the file does not exist", .expected = "a trajectory"});
  const std::string extension = lowerExtension(file);
  if (extension == ".csv") return readCsv(file);
  if (extension == ".yaml" || extension == ".yml") return readRosYaml(file);
  if (extension == ".htraj" || extension == ".json") return readJson(file);
  if (isProgramFile(file)) {
    auto program = readProgram(file);
    HAPTICELL_TRY(program);
    if (notes) notes->insert(notes->end(), program->notes.begin(), program->notes.end());
    return std::move(program->trajectory);
  }
  return makeError({.file = file.string(),
                    .found = Text("the extension '%1'", extension),
                    .expected = ".htraj, .csv, .json, .yaml, or a robot's program: .src, .mod, .ls, .script, .jbi"});
}

std::string toJsonText(const Trajectory& trajectory) {
  nlohmann::ordered_json head{{"format", kFormat},         {"version", kVersion},
                              {"name", trajectory.name},   {"entity", trajectory.entity},
                              {"moved", trajectory.moved}, {"joints", trajectory.joint_names}};
  std::vector<std::size_t> by_hand;
  nlohmann::ordered_json dwells = nlohmann::ordered_json::array(), names = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    if (trajectory[i].by_hand) by_hand.push_back(i);
    if (trajectory[i].dwell > 0.0) dwells.push_back({i, trajectory[i].dwell});
    if (trajectory[i].name) names.push_back({i, *trajectory[i].name});
  }
  if (!trajectory.take.empty()) head["take"] = trajectory.take;
  if (!trajectory.channel_names.empty()) head["channels"] = trajectory.channel_names;
  for (const auto& touch : trajectory.touches) {
    head["touches"].push_back({touch.t_in, touch.t_out, touch.first, touch.second, touch.max_force});
  }
  head["by_hand"] = by_hand;
  head["dwells"] = std::move(dwells);
  if (!names.empty()) head["names"] = std::move(names);
  if (!trajectory.has_poses) head["has_poses"] = false;
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    if (!trajectory[i].is_pose_apart) continue;
    const std::size_t first = i;
    while (i + 1 < trajectory.size() && trajectory[i + 1].is_pose_apart) ++i;
    head["pose_apart"].push_back({first, i});
  }
  std::string text = head.dump(1);
  text.erase(text.size() - 2);  // the closing brace, so that frames stand one a line
  text += ",\n \"frames\": [";
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    text += i == 0 ? "\n  [" : ",\n  [";
    appendFrame(text, trajectory, i, true);
    text += ']';
  }
  text += "\n ]\n}\n";
  return text;
}

std::string toCsvText(const Trajectory& trajectory) {
  std::string text = trajectory.has_poses ? "t,x,y,z,qw,qx,qy,qz" : "t";
  for (const std::string& joint : trajectory.joint_names) text += "," + joint;
  for (const std::string& channel : trajectory.channel_names) text += "," + channel;
  const auto any = [&](auto what) { return std::any_of(trajectory.frames().begin(), trajectory.frames().end(), what); };
  const bool by_hand = any([](const auto& frame) { return frame.by_hand; });
  const bool dwells = any([](const auto& frame) { return frame.dwell > 0.0; });
  const bool apart = any([](const auto& frame) { return frame.is_pose_apart; });
  if (by_hand) text += ",by_hand";
  if (dwells) text += ",dwell";
  if (apart) text += ",pose_apart";
  text += '\n';
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    appendFrame(text, trajectory, i, trajectory.has_poses);
    if (by_hand) text += trajectory[i].by_hand ? ",1" : ",0";
    if (dwells) text += "," + shortestText(trajectory[i].dwell);
    if (apart) text += trajectory[i].is_pose_apart ? ",1" : ",0";
    text += '\n';
  }
  return text;
}

}  // namespace hapticell::trajectory
