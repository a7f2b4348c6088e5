// SPDX-License-Identifier: Apache-2.0
#include "mannequin/motion/motion_clip.h"

#include "geometry/system/regular_file.h"
#include "geometry/system/text_case.h"

namespace hapticell::mannequin {

namespace {

// Guards memory. Half, twice: other files are refused with a message.
constexpr std::uintmax_t kMostBytes = 256u << 20;

Expected<std::string> contentOf(const std::filesystem::path& file) {
  return geometry::readRegularFile(file, kMostBytes);
}

}  // namespace

int MotionClip::find(std::string_view name) const {
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (sameButForCase(joints[i].name, name)) return static_cast<int>(i);
  }
  return -1;
}

void placeJoints(const MotionClip& clip, const ClipFrame& frame, ClipPose& pose) {
  pose.p.resize(clip.joints.size());
  pose.q.resize(clip.joints.size());
  for (std::size_t i = 0; i < clip.joints.size(); ++i) {
    const ClipJoint& joint = clip.joints[i];
    const dvec3& p_Parent = frame.p_Parent.empty() ? joint.p_Parent : frame.p_Parent[i];
    if (joint.parent < 0) {
      pose.p[i] = frame.p_root + joint.p_Parent;
      pose.q[i] = frame.turns[i];
      continue;
    }
    const std::size_t parent = static_cast<std::size_t>(joint.parent);
    pose.p[i] = pose.p[parent] + pose.q[parent] * p_Parent;
    pose.q[i] = glm::normalize(pose.q[parent] * frame.turns[i]);
  }
}

Expected<MotionClip> readMotionFile(const std::filesystem::path& file) {
  const std::string ending = lowerExtension(file);
  const Expected<std::string> text = contentOf(file);
  HAPTICELL_TRY(text);
  if (ending == ".bvh") return readBvh(*text, file.string());
  if (ending != ".amc")
    return makeError({.file = file.string(),
                      .found = Text("'%1'", ending),
                      .expected = ".bvh, .c3d, or .amc with its .asf in the same folder"});
  std::filesystem::path skeleton = file;
  skeleton.replace_extension(".asf");
  std::error_code ignored;
  if (!std::filesystem::exists(skeleton, ignored)) {
    const std::string stem = file.stem().string();
    skeleton.replace_filename(stem.substr(0, stem.find('_')) + ".asf");
  }
  const Expected<std::string> asf = contentOf(skeleton);
  HAPTICELL_TRY(asf);
  return readAsfAmc(*asf, skeleton.string(), *text, file.string());
}

}  // namespace hapticell::mannequin
