// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

#include "geometry/system/text_case.h"
#include "mannequin/motion/clip_map.h"
#include "mannequin/motion/motion_clip.h"
#include "mannequin/motion/word_reader.h"

namespace hapticell::mannequin {

namespace {

// Guard memory and time: 2 million frames are 4.6 h at 120 Hz. Half, twice: other files are refused with a message.
constexpr std::size_t kMostJoints = 1000, kMostFrames = 2'000'000;
/// m, hip to ankle; a factor 1.5 either way still tells cm from inch. Half: figures of 1.8 m in inch are read as cm;
/// twice: those in cm as inch.
constexpr double kLegOfAPerson = 0.82;

struct Channel {
  std::size_t joint = 0;
  int axis = 0;
  bool turns = false;
};

class BvhReader {
 public:
  BvhReader(std::string_view text, const std::string& name) : words_(text), text_(text), name_(name) {}

  Expected<MotionClip> read(double metres_per_unit) {
    if (const Text why = whyNoText(text_); !why.empty())
      return makeError(
          {.file = name_, .found = why, .expected = "a BVH file in UTF-8", .fix = "Save it as plain text (UTF-8)."});
    if (!sameButForCase(words_.next(), "HIERARCHY")) return fail(Text("HIERARCHY is missing"), Text("a BVH file"));
    if (!sameButForCase(words_.next(), "ROOT")) return fail(Text("ROOT is missing"), Text("ROOT and a name"));
    HAPTICELL_TRY(readTree());
    clip_.metres_per_unit = metres_per_unit > 0.0 ? metres_per_unit : guessedUnit();
    HAPTICELL_TRY(readMotion());
    settlePlaces();
    if (metres_per_unit <= 0.0) guessAgain();
    scale();
    return std::move(clip_);
  }

 private:
  tl::unexpected<Error> fail(Text found, Text expected, Text fix = {}) const {
    return makeError({.file = name_,
                      .place = words_.place(),
                      .found = std::move(found),
                      .expected = std::move(expected),
                      .fix = std::move(fix)});
  }
  /// A number with a comma is one of a program that writes by the rules of its country.
  static Text fixOf(std::string_view word) {
    std::string point(word);
    std::replace(point.begin(), point.end(), ',', '.');
    const bool comma = point != word && WordReader::numberOf(point);
    return comma ? Text("Export the file with decimal points; it has decimal commas.") : Text();
  }

  /// The root's name up to its closing brace; without recursion, so that a deep file does no harm.
  Expected<void> readTree() {
    std::vector<int> open;
    if (auto done = openJoint(false, open); !done) return done;
    while (!open.empty()) {
      const std::string_view word = words_.next();
      if (sameButForCase(word, "JOINT") || sameButForCase(word, "End")) {
        if (clip_.joints.size() >= kMostJoints) return fail(Text("more than 1000 joints"), Text("a skeleton"));
        if (auto done = openJoint(sameButForCase(word, "End"), open); !done) return done;
      } else if (word == "}") {
        open.pop_back();
      } else if (sameButForCase(word, "OFFSET")) {
        dvec3& offset = clip_.joints[static_cast<std::size_t>(open.back())].p_Parent;
        for (int k = 0; k < 3; ++k) {
          const std::string_view number = words_.next();
          const auto value = WordReader::numberOf(number);
          if (!value)
            return fail(Text("'%1' instead of a number in OFFSET", number.substr(0, 40)), Text("three numbers"),
                        fixOf(number));
          offset[k] = *value;
        }
      } else if (sameButForCase(word, "CHANNELS")) {
        if (auto done = readChannels(static_cast<std::size_t>(open.back())); !done) return done;
      } else {
        return fail(word.empty() ? Text("the end of the file") : Text("'%1'", word.substr(0, 40)),
                    Text("JOINT, End Site, OFFSET, CHANNELS or }"));
      }
    }
    return {};
  }

  /// The name is all that is left of the line, blanks in it too, up to a brace.
  Expected<void> openJoint(bool end, std::vector<int>& open) {
    ClipJoint joint;
    joint.name = std::string(words_.nextBefore('{'));
    joint.is_end = end;
    joint.parent = open.empty() ? -1 : open.back();
    if (end) joint.name = clip_.joints[static_cast<std::size_t>(joint.parent)].name + "_end";
    if (!words_.take('{')) return fail(Text("'{' is missing after '%1'", joint.name.substr(0, 40)), Text::plain("{"));
    open.push_back(static_cast<int>(clip_.joints.size()));
    clip_.joints.push_back(std::move(joint));
    return {};
  }

  Expected<void> readChannels(std::size_t joint) {
    const auto count = words_.number();
    if (!count || !(*count >= 0.0 && *count <= 6.0))
      return fail(Text("the number of channels is missing"), Text("0 to 6"));
    for (int i = 0; i < static_cast<int>(*count); ++i) {
      const std::string_view word = words_.next();
      const std::string_view kind = word.empty() ? word : word.substr(1);
      const int axis = word.empty() ? -1 : std::toupper(static_cast<unsigned char>(word[0])) - 'X';
      if (axis < 0 || axis > 2 || (!sameButForCase(kind, "position") && !sameButForCase(kind, "rotation"))) {
        return fail(Text("the channel '%1'", word.substr(0, 40)), Text("Xposition ... Zrotation"));
      }
      channels_.push_back({joint, axis, sameButForCase(kind, "rotation")});
      moves_ = moves_ || (joint > 0 && !channels_.back().turns);
    }
    return {};
  }

  double guessedUnit() const {
    // The extent of the skeleton at rest, along its largest axis.
    std::vector<dvec3> p(clip_.joints.size(), dvec3(0.0));
    dvec3 low(0.0), high(0.0);
    for (std::size_t i = 0; i < p.size(); ++i) {
      const ClipJoint& joint = clip_.joints[i];
      if (joint.parent >= 0) p[i] = p[static_cast<std::size_t>(joint.parent)] + joint.p_Parent;
      low = glm::min(low, p[i]);
      high = glm::max(high, p[i]);
    }
    const double size = high.y - low.y > 0.0 ? high.y - low.y : std::max(high.x - low.x, high.z - low.z);
    if (size <= 3.0) return 1.0;
    if (size < 50.0) return 0.0254 / 0.45;
    if (size < 90.0) return 0.0254;
    return size < 300.0 ? 0.01 : 0.001;
  }
  /// By the legs, where they are known: their length does not depend on how the file lays its rest position.
  void guessAgain() {
    const auto map = mapJoints(clip_);
    if (!map) return;
    double leg = 0.0;
    for (const int joint : {map->knee[0], map->knee[1], map->ankle[0], map->ankle[1]})
      leg += 0.5 * glm::length(clip_.joints[static_cast<std::size_t>(joint)].p_Parent);
    if (!(leg > 0.0)) return;
    const auto off = [leg](double unit) { return std::abs(std::log(leg * unit / kLegOfAPerson)); };
    for (const double unit : {1.0, 0.01, 0.001, 0.0254, 0.0254 / 0.45}) {
      if (unit == 1.0 || off(unit) < off(clip_.metres_per_unit)) clip_.metres_per_unit = unit;
    }
  }

  Expected<void> readMotion() {
    const std::string_view motion = words_.next();
    if (sameButForCase(motion, "ROOT"))
      return fail(Text("a second ROOT '%1'", words_.nextLine().substr(0, 40)), Text("one skeleton per file"),
                  Text("Export one person per file."));
    if (!sameButForCase(motion, "MOTION") || !sameButForCase(words_.next(), "Frames:"))
      return fail(Text("MOTION with Frames: is missing"), Text::plain("MOTION"));
    const auto count = words_.number();
    if (!count || *count < 0.0 || *count > static_cast<double>(kMostFrames))
      return fail(Text("the number of frames is missing"), Text("a number"));
    const bool timed = sameButForCase(words_.next(), "Frame") && sameButForCase(words_.next(), "Time:");
    const std::string_view time = timed ? words_.next() : std::string_view();
    const auto period = WordReader::numberOf(time);
    if (!period || !(*period > 0.0)) return fail(Text("Frame Time: is missing"), Text("seconds, above 0"), fixOf(time));
    clip_.frame_time = *period;
    return readRows(static_cast<std::size_t>(*count));
  }

  Expected<void> readRows(std::size_t stated) {
    if (channels_.empty())
      return stated == 0 ? Expected<void>() : fail(Text("CHANNELS is missing"), Text("channels of the joints"));
    for (std::string_view line = words_.nextLine(); !line.empty(); line = words_.nextLine()) {
      if (clip_.frames.size() >= kMostFrames) return fail(Text("more than 2000000 frames"), Text("a motion"));
      if (auto done = readRow(line); !done) return done;
    }
    const std::size_t found = clip_.frames.size();
    if (found < stated) {
      return fail(Text("the file ends before frame %1", found + 1), Text("%1 frames, as the file states", stated),
                  Text("The file is incomplete: export it again, or correct the number after Frames:."));
    }
    if (found > stated) {
      clip_.warnings.push_back(Text("the file states %1 frames but has %2; all %2 are read", stated, found));
    }
    return {};
  }

  Expected<void> readRow(std::string_view line) {
    ClipFrame frame;
    frame.turns.assign(clip_.joints.size(), dquat(1.0, 0.0, 0.0, 0.0));
    for (const ClipJoint& joint : clip_.joints) {
      if (moves_) frame.p_Parent.push_back(joint.p_Parent);
    }
    const std::size_t row = clip_.frames.size() + 1;
    WordReader words(line);
    std::size_t read = 0;
    for (std::string_view word = words.next(); !word.empty(); word = words.next(), ++read) {
      const auto value = WordReader::numberOf(word);
      if (!value)
        return fail(Text("'%2' instead of a number in frame %1", row, word.substr(0, 40)), Text("numbers"),
                    fixOf(word));
      if (read < channels_.size()) apply(channels_[read], *value, frame);
    }
    if (read != channels_.size()) {
      return fail(Text("%1 numbers in frame %2", read, row), Text("%1 numbers, one per channel", channels_.size()),
                  Text("Each frame is one line. The file is incomplete or was edited: export it again."));
    }
    clip_.frames.push_back(std::move(frame));
    return {};
  }

  void apply(const Channel& channel, double value, ClipFrame& frame) const {
    if (!channel.turns) {
      (channel.joint == 0 ? frame.p_root : frame.p_Parent[channel.joint])[channel.axis] = value;
      return;
    }
    dvec3 turn(0.0);
    turn[channel.axis] = value * std::numbers::pi / 180.0;
    frame.turns[channel.joint] = glm::normalize(frame.turns[channel.joint] * quaternionFromRotationVector(turn));
  }

  /// Positions of joints below the root replace their offsets; where they stay near zero though there is no offset,
  /// they are added to it. What does not move is left out of the frames.
  void settlePlaces() {
    if (!moves_ || clip_.frames.empty()) return;
    std::vector<bool> placed(clip_.joints.size(), false);
    for (const Channel& channel : channels_)
      placed[channel.joint] = placed[channel.joint] || (channel.joint > 0 && !channel.turns);
    bool still = true;
    for (std::size_t j = 1; j < clip_.joints.size(); ++j) {
      if (!placed[j]) continue;
      const dvec3 offset = clip_.joints[j].p_Parent;
      dvec3 mean(0.0);
      for (const ClipFrame& frame : clip_.frames) mean += frame.p_Parent[j] / static_cast<double>(clip_.frames.size());
      const double length = glm::length(offset);
      if (length > 0.0 && glm::length(mean) < 0.3 * length) {
        for (ClipFrame& frame : clip_.frames) frame.p_Parent[j] += offset;
        mean += offset;
        added_ = true;
      }
      for (const ClipFrame& frame : clip_.frames)
        still = still && glm::length(frame.p_Parent[j] - mean) <= 1e-4 * std::max(1.0, glm::length(mean));
      clip_.joints[j].p_Parent = mean;
    }
    if (added_) {
      clip_.warnings.push_back(Text("joint positions in the channels are near zero; they are added to the offsets"));
    }
    if (still) {
      for (ClipFrame& frame : clip_.frames) frame.p_Parent.clear();
    }
  }

  void scale() {
    for (ClipJoint& joint : clip_.joints) joint.p_Parent *= clip_.metres_per_unit;
    for (ClipFrame& frame : clip_.frames) {
      frame.p_root *= clip_.metres_per_unit;
      for (dvec3& p : frame.p_Parent) p *= clip_.metres_per_unit;
    }
  }

  WordReader words_;
  std::string_view text_;
  const std::string& name_;
  MotionClip clip_;
  std::vector<Channel> channels_;
  bool moves_ = false;  ///< Some joint below the root has positions in the channels.
  bool added_ = false;
};

}  // namespace

Expected<MotionClip> readBvh(std::string_view text, const std::string& name, double metres_per_unit) {
  return BvhReader(text, name).read(metres_per_unit);
}

}  // namespace hapticell::mannequin
