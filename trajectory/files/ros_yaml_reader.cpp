// SPDX-License-Identifier: Apache-2.0
#include "trajectory/files/ros_yaml_reader.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <sstream>

#include "geometry/system/regular_file.h"
#include "trajectory/motion/csv_table.h"
#include "trajectory/motion/number_text.h"

namespace hapticell::trajectory {

namespace {

constexpr std::int64_t kSecond = 1'000'000'000;  ///< ns
constexpr double kMostSeconds = 9e9;             ///< That a 64-bit count of nanoseconds holds.
/// Looked at for it, as anchors may stand for ever more; chosen so that files of kLargestYaml without anchors read.
/// Half: long lists of lists are refused; twice: twice the time until a trap is reported.
constexpr std::size_t kMostNodes = 1'000'000;
// Bytes: guards memory, as the 256 MB of other readers. Half, twice: other files are refused with a message.
constexpr std::uintmax_t kLargestYaml = 256'000'000;
/// Of a JointTrajectory inside other messages, which nest a few levels. Half: still enough; twice: time in files of
/// other lists.
constexpr int kDeepestNesting = 8;

/// What is looked for.
Text wantedMessage() {
  return Text("a JointTrajectory (joint_names and points), or JointState messages (name and position)");
}

/// Goes through a text and keeps nothing: where each document begins.
class Walk final : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark& mark) override { begin = mark; }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t, const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}
  YAML::Mark begin = YAML::Mark::null_mark();
};

/// Where the library would stand still for ever and fill the memory with empty documents (0.7: a "," that opens no
/// list); nothing: it gets to the end.
std::optional<YAML::Mark> standstillOf(const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  Walk walk;
  int last = -1;
  while (parser.HandleNextDocument(walk)) {
    if (walk.begin.pos <= last) return walk.begin;
    last = walk.begin.pos;
  }
  return std::nullopt;
}

class RosYamlReader {
 public:
  explicit RosYamlReader(const std::filesystem::path& file) : name_(file.string()) {}

  Expected<Trajectory> read() {
    const auto content = geometry::readRegularFile(name_, kLargestYaml);
    HAPTICELL_TRY(content);
    const std::string& text = *content;
    std::vector<YAML::Node> documents;
    try {
      if (const auto still = standstillOf(text))
        return makeError({.file = name_,
                          .place = Text("line %1", still->line + 1),
                          .found = "invalid YAML",
                          .expected = wantedMessage()});
      documents = YAML::LoadAll(text);
      return readDocuments(documents);
    } catch (const YAML::Exception& problem) {
      const Text place = problem.mark.is_null() ? Text() : Text("line %1", problem.mark.line + 1);
      return makeError({.file = name_, .place = place, .found = problem.msg, .expected = wantedMessage()});
    }
  }

 private:
  tl::unexpected<Error> fault(const YAML::Node& at, const Text& found, const Text& expected,
                              const Text& fix = {}) const {
    const YAML::Mark mark = at.IsDefined() ? at.Mark() : YAML::Mark::null_mark();
    return makeError({.file = name_,
                      .place = mark.is_null() ? Text() : Text("line %1", mark.line + 1),
                      .found = found,
                      .expected = expected,
                      .fix = fix});
  }

  Expected<Trajectory> readDocuments(const std::vector<YAML::Node>& documents) {
    std::vector<YAML::Node> messages, states;
    for (const YAML::Node& document : documents) {
      HAPTICELL_TRY(search(document, messages, 0));
      if (document.IsMap() && document["name"] && document["position"]) states.push_back(document);
    }
    if (messages.size() > 1) {
      return fault(messages[1], Text("%1 trajectories", messages.size()), Text("one"),
                   Text("Keep only one trajectory in the file."));
    }
    auto taken = messages.size() == 1 ? takeMessage(messages.front()) : takeStates(states);
    HAPTICELL_TRY(taken);
    trajectory_.has_poses = false;
    return std::move(trajectory_);
  }

  /// JointTrajectory messages anywhere in the document.
  Expected<void> search(const YAML::Node& node, std::vector<YAML::Node>& found, int depth) {
    if (depth > kDeepestNesting) return {};
    if (++searched_ > kMostNodes) return fault(node, Text("lists that contain themselves"), wantedMessage());
    if (node.IsMap()) {
      if (node["joint_names"]) {
        found.push_back(node);
        return {};
      }
      for (const auto& entry : node) {
        if (auto searched = search(entry.second, found, depth + 1); !searched) return searched;
      }
    } else if (node.IsSequence()) {
      for (const auto& entry : node) {
        if (!entry.IsMap()) break;  // A list of numbers or texts.
        if (auto searched = search(entry, found, depth + 1); !searched) return searched;
      }
    }
    return {};
  }

  /// A key that stands twice would be read once, whichever.
  Expected<void> checkKeys(const YAML::Node& map) const {
    std::set<std::string> keys;
    for (const auto& entry : map) {
      if (!entry.first.IsScalar()) continue;
      if (!keys.insert(entry.first.Scalar()).second)
        return fault(entry.first, Text("'%1' twice", entry.first.Scalar()), Text("each name once"));
    }
    return {};
  }

  Expected<void> takeNames(const YAML::Node& names) {
    if (!names.IsSequence())
      return fault(names, Text("joint names that are not a list"), Text::plain("[joint_1, joint_2, ...]"));
    std::set<std::string> known;
    for (const YAML::Node& name : names) {
      if (!name.IsScalar() || name.Scalar().empty())
        return fault(name, Text("a name that is not text"), Text("joint names"));
      if (!known.insert(name.Scalar()).second)
        return fault(name, Text("joint '%1' twice", name.Scalar()), Text("each joint once"));
      trajectory_.joint_names.push_back(name.Scalar());
    }
    if (trajectory_.joint_names.empty())
      return fault(names, Text("the joint names are missing"), Text("one name per joint"));
    return {};
  }

  Expected<void> takeMessage(const YAML::Node& message) {
    if (auto checked = checkKeys(message); !checked) return checked;
    if (auto taken = takeNames(message["joint_names"]); !taken) return taken;
    const YAML::Node points = message["points"];
    if (!points) return fault(message, Text("no points"), Text("a list of points"));
    if (points.IsNull()) return {};
    if (!points.IsSequence()) return fault(points, Text("points that are not a list"), Text("a list of points"));
    for (const YAML::Node& point : points) {
      if (!point.IsMap())
        return fault(point, echoedShort(point) ? Text("a shortened list") : Text("a point that is not a map"),
                     Text("positions and time_from_start"), echoedShort(point) ? fullLength() : Text());
      if (auto checked = checkKeys(point); !checked) return checked;
      const auto positions = numbersOf(point["positions"], point);
      HAPTICELL_TRY(positions);
      const auto time = timeOf(point["time_from_start"], point, "time_from_start");
      HAPTICELL_TRY(time);
      if (auto added = addPoint(point, *time, *positions); !added) return added;
    }
    return {};
  }

  /// One frame a message, from the first one's stamp on.
  Expected<void> takeStates(const std::vector<YAML::Node>& states) {
    if (states.empty())
      return makeError({.file = name_, .found = "no message of these types", .expected = wantedMessage()});
    if (auto taken = takeNames(states.front()["name"]); !taken) return taken;
    std::int64_t first = 0;
    for (const YAML::Node& state : states) {
      std::vector<std::string> names;
      for (const YAML::Node& name : state["name"]) names.push_back(name.IsScalar() ? name.Scalar() : "");
      if (names != trajectory_.joint_names)
        return fault(state["name"], Text("other joints"), Text("the joints of the first message"));
      const auto positions = numbersOf(state["position"], state);
      HAPTICELL_TRY(positions);
      const YAML::Node header = state["header"];
      const auto time = timeOf(header ? header["stamp"] : YAML::Node(YAML::NodeType::Undefined), state, "stamp");
      HAPTICELL_TRY(time);
      if (trajectory_.empty()) first = *time;
      if (auto added = addPoint(state, *time - first, *positions); !added) return added;
    }
    return {};
  }

  static bool echoedShort(const YAML::Node& item) { return item.IsScalar() && item.Scalar() == "..."; }

  Expected<std::vector<double>> numbersOf(const YAML::Node& list, const YAML::Node& point) const {
    std::vector<double> numbers;
    if (list && !list.IsNull() && !list.IsSequence())
      return fault(list, Text("positions that are not a list"), Text("numbers"));
    if (list && list.IsSequence()) {
      for (const YAML::Node& item : list) {
        if (echoedShort(item)) return fault(item, Text("a shortened list"), Text("all positions"), fullLength());
        const auto number = item.IsScalar() ? parseNumber(item.Scalar()) : std::nullopt;
        if (!number)
          return fault(item, item.IsScalar() ? Text("'%1'", item.Scalar()) : Text("not a number"), Text("a number"));
        numbers.push_back(*number);
      }
    }
    if (numbers.size() == trajectory_.joint_names.size()) return numbers;
    return fault(list && !list.IsNull() ? list : point, Text("%1 positions", numbers.size()),
                 Text("%1, one per joint", trajectory_.joint_names.size()));
  }

  /// Nanoseconds of `{sec, nanosec}`, `{secs, nsecs}` or a number of seconds.
  Expected<std::int64_t> timeOf(const YAML::Node& time, const YAML::Node& point, const char* what) const {
    const Text expected = "seconds and nanoseconds: {sec, nanosec} or {secs, nsecs}";
    if (!time || time.IsNull()) return fault(point, Text("%1 is missing", what), expected);
    if (time.IsScalar()) {
      const auto seconds = parseNumber(time.Scalar());
      if (!seconds) return fault(time, Text("'%1'", time.Scalar()), expected);
      if (std::abs(*seconds) > kMostSeconds) return tooLong(time, *seconds);
      return std::llround(*seconds * static_cast<double>(kSecond));
    }
    if (!time.IsMap()) return fault(time, Text("%1 is a list", what), expected);
    HAPTICELL_TRY(checkKeys(time));
    std::int64_t sum = 0;
    bool any = false;
    for (const auto& entry : time) {
      const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
      const bool is_seconds = key == "sec" || key == "secs";
      if (!is_seconds && key != "nanosec" && key != "nsec" && key != "nsecs" && key != "nanosecs")
        return fault(entry.first, Text("'%1' in a time", key), expected);
      const auto number = entry.second.IsScalar() ? parseNumber(entry.second.Scalar()) : std::nullopt;
      if (!number || *number != std::floor(*number))
        return fault(entry.second, Text("a time that is not a whole number"), Text("whole seconds and nanoseconds"));
      const double seconds = is_seconds ? *number : *number / static_cast<double>(kSecond);
      if (std::abs(seconds) > 0.5 * kMostSeconds) return tooLong(entry.second, *number);
      sum += static_cast<std::int64_t>(*number) * (is_seconds ? kSecond : 1);
      any = true;
    }
    if (!any) return fault(point, Text("%1 is empty", what), expected);
    return sum;
  }

  tl::unexpected<Error> tooLong(const YAML::Node& at, double seconds) const {
    return fault(at, Text("a time of %1 s", shortestText(seconds)), Text("at most 9e9 s"));
  }

  Expected<void> addPoint(const YAML::Node& point, std::int64_t nanoseconds, const std::vector<double>& positions) {
    const double time = static_cast<double>(nanoseconds) / static_cast<double>(kSecond);
    if (trajectory_.addFrame({time, Pose::identity()}, positions)) return {};
    return fault(point, Text("a time_from_start of %1 s", shortestText(time)), Text("times that increase"));
  }

  static Text fullLength() { return Text("Run ros2 topic echo again with --full-length (-f)."); }

  std::string name_;
  Trajectory trajectory_;
  std::size_t searched_ = 0;
};

}  // namespace

Expected<Trajectory> readRosYaml(const std::filesystem::path& file) {
  auto trajectory = RosYamlReader(file).read();
  if (trajectory) trajectory->name = file.stem().string();
  return trajectory;
}

}  // namespace hapticell::trajectory
