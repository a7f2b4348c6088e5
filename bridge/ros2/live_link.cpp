// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/live_link.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "bridge/ros2/cell_sources.h"
#include "bridge/ros2/published_cell.h"
#include "bridge/ros2/taken_samples.h"
#include "bridge/ros2/topic_list.h"
#include "geometry/system/nesting_limit.h"
#include "geometry/system/scratch_folder.h"
#include "workcell/format/document_io.h"

namespace hapticell::bridge {

namespace {

using LinkClock = std::chrono::steady_clock;
using manipulation::EntityConfiguration;
using nlohmann::ordered_json;

/// Lines of standard input as they come.
class InputLines {
 public:
  bool isOver() const { return over_; }

  /// Waits for `milliseconds` at most; true once a new line is there.
  bool wait(int milliseconds) {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (::poll(&input, 1, milliseconds) <= 0) return false;
    char piece[4096];
    const ssize_t count = ::read(STDIN_FILENO, piece, sizeof piece);
    if (count <= 0) over_ = true;
    if (count > 0) text_.append(piece, static_cast<std::size_t>(count));
    // A line has some hundred bytes; half and twice of this only hold more or less of what no window writes.
    constexpr std::size_t kLongest = 1 << 20;
    if (text_.size() > kLongest) text_.clear();
    return text_.find('\n') != std::string::npos;
  }

  /// The newest whole line; older ones are left out.
  std::string newest() {
    const std::size_t end = text_.rfind('\n');
    if (end == std::string::npos) return {};
    const std::size_t before = end == 0 ? std::string::npos : text_.rfind('\n', end - 1);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    std::string line = text_.substr(begin, end - begin);
    text_.erase(0, end + 1);
    return line;
  }

 private:
  std::string text_;
  bool over_ = false;
};

void putLine(const ordered_json& json) {
  std::printf("%s\n", json.dump().c_str());
  std::fflush(stdout);
}

/// Numbers of a field; empty where it has others or not as many.
std::vector<double> numbersIn(const nlohmann::json& json, const char* field, std::size_t count) {
  const auto found = json.find(field);
  if (found == json.end() || !found->is_array() || found->size() != count) return {};
  std::vector<double> numbers;
  for (const auto& number : *found)
    if (number.is_number() && std::isfinite(number.get<double>())) numbers.push_back(number.get<double>());
  return numbers.size() == count ? numbers : std::vector<double>();
}

void takeLine(const std::string& line, EntityConfiguration& at) {
  if (!geometry::checkNesting(line, geometry::NestedText::kJson, "link")) return;
  const nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
  if (!json.is_object()) return;
  if (auto joints = numbersIn(json, "joints", at.joints.size()); !joints.empty()) at.joints = std::move(joints);
  const auto place = numbersIn(json, "place", 7);
  if (place.empty()) return;
  const dquat q(place[3], place[4], place[5], place[6]);
  if (std::abs(glm::length(q) - 1.0) < 1e-3) at.X_WE = {{place[0], place[1], place[2]}, glm::normalize(q)};
}

/// The robot of another program, by the variables of the cell's.
class HeardRobot {
 public:
  HeardRobot(const workcell::Entity& robot, dds_entity_t reader) : reader_(reader), joints_(robot.joints()) {
    const kinematics::RobotModel& model = *robot.robot();
    for (std::size_t v = 0; v < model.moving.size(); ++v)
      variables_[model.joints[static_cast<std::size_t>(model.moving[v])].name] = v;
  }

  /// True if a joint of the robot came.
  bool take() {
    bool is_new = false;
    takeAll<sensor_msgs_msg_dds__JointState_>(reader_, [&](const auto& state) {
      ++count_;
      for (std::uint32_t i = 0; i < std::min(state.name._length, state.position._length); ++i) {
        const auto variable = variables_.find(state.name._buffer[i] ? state.name._buffer[i] : "");
        if (variable == variables_.end() || !std::isfinite(state.position._buffer[i])) continue;
        joints_[variable->second] = state.position._buffer[i];
        is_new = true;
      }
    });
    return is_new;
  }

  const std::vector<double>& joints() const { return joints_; }
  std::uint64_t count() const { return count_; }

 private:
  dds_entity_t reader_;
  std::vector<double> joints_;
  std::map<std::string, std::size_t> variables_;
  std::uint64_t count_ = 0;
};

/// One link, with what it publishes or hears.
class LiveLink {
 public:
  LiveLink(RosNode& node, std::shared_ptr<const workcell::Entity> robot)
      : node_(node), robot_(std::move(robot)), at_{robot_->X_WE, robot_->joints()} {}

  Expected<void> hear(const std::string& topic) {
    const auto reader = node_.subscribe(topic, sensor_msgs_msg_dds__JointState__desc, RosQuality::kSensor);
    HAPTICELL_TRY(reader);
    heard_.emplace(*robot_, *reader);
    return {};
  }

  Expected<void> publish(const workcell::Document& document, std::string description) {
    cell_.emplace(node_, document, robot_, std::nullopt, false);
    cell_->letBaseMove();
    HAPTICELL_TRY(cell_->open());
    return cell_->publishLatched(std::move(description));
  }

  Expected<ordered_json> run(double rate_hz, const std::atomic<bool>& stop) {
    InputLines input;
    const auto begin = LinkClock::now();
    for (std::uint64_t tick = 0; !stop && !input.isOver(); ++tick) {
      const double t = static_cast<double>(tick) / rate_hz;
      const auto due = begin + std::chrono::duration_cast<LinkClock::duration>(std::chrono::duration<double>(t));
      do {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(due - LinkClock::now()).count();
        if (input.wait(static_cast<int>(std::max<std::int64_t>(0, left)))) takeLine(input.newest(), at_);
      } while (!stop && !input.isOver() && LinkClock::now() < due);
      if (cell_) HAPTICELL_TRY(cell_->publishAt(t, at_));
      sayHeard();
      if (LinkClock::now() - reported_ >= std::chrono::seconds(1)) putLine(report());
    }
    return report();
  }

 private:
  void sayHeard() {
    if (!heard_) return;
    is_new_ = heard_->take() || is_new_;
    // As windows draw. Half: twice the work of the window; twice: the robot jerks.
    if (!is_new_ || LinkClock::now() - said_ < std::chrono::milliseconds(33)) return;
    said_ = LinkClock::now();
    is_new_ = false;
    putLine({{"heard", heard_->joints()}});
  }

  ordered_json report() {
    const double passed = std::chrono::duration<double>(LinkClock::now() - reported_).count();
    reported_ = LinkClock::now();
    ordered_json json{{"topics", topicsOf(node_)}};
    if (heard_) json["heard_hz"] = static_cast<double>(heard_->count() - std::exchange(counted_, heard_->count())) / passed;
    if (cell_) json.update(cell_->result());
    return json;
  }

  RosNode& node_;
  std::shared_ptr<const workcell::Entity> robot_;
  EntityConfiguration at_;
  std::optional<HeardRobot> heard_;
  std::optional<PublishedCell> cell_;
  LinkClock::time_point said_{}, reported_ = LinkClock::now();
  std::uint64_t counted_ = 0;
  bool is_new_ = false;
};

}  // namespace

Expected<ordered_json> runLiveLink(const LiveLinkOptions& options, const std::atomic<bool>& stop) {
  Diagnostics notes;
  const auto document = workcell::loadDocument(options.workcell, notes);
  HAPTICELL_TRY(document);
  const auto robot = robotToPublish(*document, options.entity, options.workcell);
  HAPTICELL_TRY(robot);
  const auto scratch = ScratchFolder::make();
  HAPTICELL_TRY(scratch);
  auto node = RosNode::create(options.node);
  HAPTICELL_TRY(node);
  LiveLink link(**node, *robot);
  if (options.mirror) {
    HAPTICELL_TRY(link.hear(options.joint_topic));
  } else {
    auto description = robotDescription(**robot, scratch->path(), notes);
    HAPTICELL_TRY(description);
    HAPTICELL_TRY(link.publish(*document, std::move(*description)));
  }
  return link.run(options.rate_hz, stop);
}

}  // namespace hapticell::bridge
