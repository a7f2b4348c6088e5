// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "mannequin/motion_clip.h"
#include "mannequin/word_reader.h"

namespace hapticell::mannequin {

namespace {

constexpr std::size_t kMostJoints = 1000, kMostFrames = 2'000'000;

struct Channel {
  std::size_t joint = 0;
  int axis = 0;
  bool turns = false;
};

class BvhReader {
 public:
  BvhReader(std::string_view text, const std::string& name) : words_(text), name_(name) {}

  Expected<MotionClip> read(double metres_per_unit) {
    if (words_.next() != "HIERARCHY") return fail("no HIERARCHY", "a BVH file");
    if (words_.next() != "ROOT") return fail("no ROOT", "ROOT and a name");
    if (auto done = readTree(); !done) return makeError(done.error());
    clip_.metres_per_unit = metres_per_unit > 0.0 ? metres_per_unit : guessedUnit();
    for (ClipJoint& joint : clip_.joints) joint.p_Parent *= clip_.metres_per_unit;
    if (auto done = readMotion(); !done) return makeError(done.error());
    return std::move(clip_);
  }

 private:
  tl::unexpected<Error> fail(std::string found, std::string expected) const {
    return makeError({name_, words_.place(), std::move(found), std::move(expected), ""});
  }
  static std::string quoted(std::string_view word) { return "'" + std::string(word.substr(0, 40)) + "'"; }

  /// The root's name up to its closing brace; without recursion, so that a deep file does no harm.
  Expected<void> readTree() {
    std::vector<int> open;
    if (auto done = openJoint(false, open); !done) return done;
    while (!open.empty()) {
      const std::string_view word = words_.next();
      if (word == "JOINT" || word == "End") {
        if (clip_.joints.size() >= kMostJoints) return fail("more than 1000 joints", "a skeleton");
        if (auto done = openJoint(word == "End", open); !done) return done;
      } else if (word == "}") {
        open.pop_back();
      } else if (word == "OFFSET") {
        dvec3& offset = clip_.joints[static_cast<std::size_t>(open.back())].p_Parent;
        for (int k = 0; k < 3; ++k) {
          const auto value = words_.number();
          if (!value) return fail("no number in OFFSET", "three numbers");
          offset[k] = *value;
        }
      } else if (word == "CHANNELS") {
        if (auto done = readChannels(static_cast<std::size_t>(open.back())); !done) return done;
      } else {
        return fail(word.empty() ? "the end of the file" : quoted(word), "JOINT, End Site, OFFSET, CHANNELS or }");
      }
    }
    return {};
  }

  Expected<void> openJoint(bool end, std::vector<int>& open) {
    ClipJoint joint;
    joint.name = std::string(words_.next());
    joint.is_end = end;
    joint.parent = open.empty() ? -1 : open.back();
    if (end) joint.name = clip_.joints[static_cast<std::size_t>(joint.parent)].name + "_end";
    if (words_.next() != "{") return fail("no { after " + quoted(joint.name), "{");
    open.push_back(static_cast<int>(clip_.joints.size()));
    clip_.joints.push_back(std::move(joint));
    return {};
  }

  Expected<void> readChannels(std::size_t joint) {
    const auto count = words_.number();
    if (!count || !(*count >= 0.0 && *count <= 6.0)) return fail("no count of channels", "0 to 6");
    for (int i = 0; i < static_cast<int>(*count); ++i) {
      const std::string_view word = words_.next();
      const std::string_view kind = word.empty() ? word : word.substr(1);
      const int axis = word.empty() ? -1 : word[0] - 'X';
      if (axis < 0 || axis > 2 || (kind != "position" && kind != "rotation")) {
        return fail("the channel " + quoted(word), "Xposition ... Zrotation");
      }
      channels_.push_back({joint, axis, kind == "rotation"});
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
    return size < 50.0 ? 0.0254 / 0.45 : size < 90.0 ? 0.0254 : size < 300.0 ? 0.01 : 0.001;
  }

  Expected<void> readMotion() {
    if (words_.next() != "MOTION" || words_.next() != "Frames:") return fail("no MOTION with Frames:", "MOTION");
    const auto count = words_.number();
    if (!count || *count < 0.0 || *count > static_cast<double>(kMostFrames))
      return fail("no count of frames", "a number");
    const bool timed = words_.next() == "Frame" && words_.next() == "Time:";
    const auto period = timed ? words_.number() : std::nullopt;
    if (!period || !(*period > 0.0)) return fail("no Frame Time:", "seconds, above 0");
    clip_.frame_time = *period;
    for (std::size_t f = 0; f < static_cast<std::size_t>(*count); ++f) {
      ClipFrame frame;
      frame.turns.assign(clip_.joints.size(), dquat(1.0, 0.0, 0.0, 0.0));
      for (const Channel& channel : channels_) {
        const auto value = words_.number();
        if (!value)
          return fail("no number in frame " + std::to_string(f + 1),
                      std::to_string(channels_.size()) + " numbers a frame");
        apply(channel, *value, frame);
      }
      clip_.frames.push_back(std::move(frame));
    }
    return {};
  }

  void apply(const Channel& channel, double value, ClipFrame& frame) const {
    if (!channel.turns) {
      // Positions of joints below the root repeat their offsets in the files that have them.
      if (channel.joint == 0) frame.p_root[channel.axis] = value * clip_.metres_per_unit;
      return;
    }
    dvec3 turn(0.0);
    turn[channel.axis] = value * M_PI / 180.0;
    frame.turns[channel.joint] = glm::normalize(frame.turns[channel.joint] * quaternionFromRotationVector(turn));
  }

  WordReader words_;
  const std::string& name_;
  MotionClip clip_;
  std::vector<Channel> channels_;
};

}  // namespace

Expected<MotionClip> readBvh(std::string_view text, const std::string& name, double metres_per_unit) {
  return BvhReader(text, name).read(metres_per_unit);
}

}  // namespace hapticell::mannequin
