// SPDX-License-Identifier: Apache-2.0
#include "manipulation/checks/hand_targets.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/system/regular_file.h"
#include "trajectory/motion/csv_table.h"

namespace hapticell::manipulation {

namespace {

using Columns = std::vector<std::string>;

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\xEF\xBB\xBF");
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

Columns fieldsOf(const std::string& line) {
  const char separator = line.find(';') != std::string::npos ? ';' : ',';
  Columns fields;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(separator, begin), line.size());
    fields.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return fields;
}

constexpr std::array<const char*, 7> kNumbers = {"x", "y", "z", "qw", "qx", "qy", "qz"};

class TargetReader {
 public:
  explicit TargetReader(const std::filesystem::path& file) : file_(file) {}

  Expected<std::vector<HandTargets>> read() {
    geometry::RegularFileStream stream(file_);
    HAPTICELL_TRY(stream);
    for (std::string line; std::getline(stream, line);) {
      ++line_;
      const std::string text = trimmed(line);
      if (text.empty() || text.front() == '#') continue;
      const auto done = header_.empty() ? readHeader(text) : readRow(fieldsOf(text));
      HAPTICELL_TRY(done);
    }
    if (header_.empty()) return fail("", Text("an empty file"), Text("a header line hand,x,y,z,qw,qx,qy,qz"));
    if (targets_.empty()) return fail("", Text("no line after the header"), Text("at least one target"));
    return std::move(targets_);
  }

 private:
  tl::unexpected<Error> fail(const std::string& column, Text found, Text expected) const {
    Text place = line_ > 0 ? Text("line %1", line_) : Text();
    if (!column.empty()) place = Text("line %1, column '%2'", line_, column);
    return makeError(
        {.file = file_.string(), .place = place, .found = std::move(found), .expected = std::move(expected)});
  }

  std::size_t columnOf(const std::string& name) const {
    return static_cast<std::size_t>(std::find(header_.begin(), header_.end(), name) - header_.begin());
  }

  Expected<void> readHeader(const std::string& text) {
    header_ = fieldsOf(text);
    for (const char* name : {"hand", "x", "y", "z", "qw", "qx", "qy", "qz"}) {
      if (columnOf(name) == header_.size()) return fail(name, Text("no such column"), "hand,x,y,z,qw,qx,qy,qz");
    }
    return {};
  }

  Expected<double> number(const Columns& fields, const std::string& name) const {
    const std::size_t column = columnOf(name);
    const std::string text = column < fields.size() ? fields[column] : "";
    const std::optional<double> value = trajectory::parseNumber(text);
    if (!value) return fail(name, "'" + text.substr(0, 40) + "'", Text("a finite number"));
    return *value;
  }

  Expected<void> readRow(const Columns& fields) {
    const std::size_t hand_column = columnOf("hand");
    const std::string hand = hand_column < fields.size() ? fields[hand_column] : "";
    if (hand != "left" && hand != "right") return fail("hand", "'" + hand.substr(0, 40) + "'", Text("left or right"));
    std::array<double, 7> values{};
    for (std::size_t i = 0; i < 7; ++i) {
      const Expected<double> value = number(fields, kNumbers[i]);
      HAPTICELL_TRY(value);
      values[i] = *value;
    }
    const dquat q(values[3], values[4], values[5], values[6]);
    if (!(std::abs(glm::length(q) - 1.0) <= 1e-3)) {
      return fail("qw,qx,qy,qz", Text("a quaternion of length %1", std::to_string(glm::length(q))),
                  Text("a unit quaternion"));
    }
    double step = static_cast<double>(targets_.size());
    const bool stepped = columnOf("step") < header_.size();
    if (stepped) {
      const Expected<double> value = number(fields, "step");
      HAPTICELL_TRY(value);
      step = *value;
    }
    auto found = std::find_if(targets_.begin(), targets_.end(), [&](const HandTargets& t) { return t.step == step; });
    if (!stepped || found == targets_.end()) found = targets_.insert(targets_.end(), HandTargets{step, {}});
    std::optional<Pose>& target = found->hands[hand == "left" ? 0 : 1];
    if (target)
      return fail(
          "hand",
          hand == "left" ? Text("a second left hand in the same step") : Text("a second right hand in the same step"),
          Text("each hand once per step"));
    target = Pose{{values[0], values[1], values[2]}, glm::normalize(q)};
    return {};
  }

  std::filesystem::path file_;
  std::size_t line_ = 0;
  Columns header_;
  std::vector<HandTargets> targets_;
};

}  // namespace

Expected<std::vector<HandTargets>> readHandTargets(const std::filesystem::path& file) {
  return TargetReader(file).read();
}

}  // namespace hapticell::manipulation
