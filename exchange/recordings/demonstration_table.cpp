// SPDX-License-Identifier: Apache-2.0
#include "exchange/recordings/demonstration_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "trajectory/motion/number_text.h"

namespace hapticell::exchange {

namespace {

using nlohmann::ordered_json;
using trajectory::Trajectory;

/// Columns of one feature: "observation.state" of "A1", "A2".
struct DemonstrationFeature {
  std::string name;
  std::vector<std::string> parts;
};

/// Rows of one episode, feature by feature.
using EpisodeRows = std::vector<std::vector<double>>;

const std::vector<std::string> kPoseParts{"x", "y", "z", "qw", "qx", "qy", "qz"};
const std::vector<std::string> kForceParts{"force_x", "force_y", "force_z"};

std::vector<DemonstrationFeature> featuresOf(const Trajectory& motion) {
  std::vector<DemonstrationFeature> features;
  const std::vector<std::string>& state = motion.hasJoints() ? motion.joint_names : kPoseParts;
  features.push_back({"observation.state", state});
  if (motion.hasJoints() && motion.has_poses) features.push_back({"observation.pose", kPoseParts});
  const bool has_force = std::ranges::all_of(
      kForceParts, [&](const std::string& part) { return motion.findChannel(part).has_value(); });
  if (has_force) features.push_back({"observation.force", kForceParts});
  if (motion.findChannel("contact")) features.push_back({"observation.contact", {"contact"}});
  features.push_back({"action", state});
  return features;
}

std::vector<double> poseNumbers(const Trajectory& motion, double t) {
  const Pose X = motion.poseAt(t);
  return {X.p.x, X.p.y, X.p.z, X.q.w, X.q.x, X.q.y, X.q.z};
}

std::vector<double> stateAt(const Trajectory& motion, double t) {
  return motion.hasJoints() ? motion.jointsAt(t) : poseNumbers(motion, t);
}

/// Channels of the last frame that is not after `t`.
double channelAt(const Trajectory& motion, const std::string& name, double t) {
  const auto frames = motion.frames();
  const auto after = std::upper_bound(frames.begin(), frames.end(), t,
                                      [](double time, const Trajectory::Frame& frame) { return time < frame.t; });
  const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - frames.begin() - 1));
  return motion.channels(i)[*motion.findChannel(name)];
}

std::vector<double> rowAt(const Trajectory& motion, const std::vector<DemonstrationFeature>& features, double t,
                          double step) {
  std::vector<double> row;
  for (const DemonstrationFeature& feature : features) {
    std::vector<double> numbers;
    if (feature.name == "action") numbers = stateAt(motion, t + step);
    if (feature.name == "observation.state") numbers = stateAt(motion, t);
    if (feature.name == "observation.pose") numbers = poseNumbers(motion, t);
    if (numbers.empty())
      for (const std::string& part : feature.parts) numbers.push_back(channelAt(motion, part, t));
    row.insert(row.end(), numbers.begin(), numbers.end());
  }
  return row;
}

ordered_json statisticsJson(const EpisodeRows& rows, std::size_t first, std::size_t count) {
  ordered_json low = ordered_json::array(), high = low, mean = low, deviation = low;
  for (std::size_t k = first; k < first + count; ++k) {
    double least = rows.front()[k], most = least, sum = 0.0, squares = 0.0;
    for (const auto& row : rows) {
      least = std::min(least, row[k]);
      most = std::max(most, row[k]);
      sum += row[k];
    }
    const double middle = sum / static_cast<double>(rows.size());
    for (const auto& row : rows) squares += (row[k] - middle) * (row[k] - middle);
    low.push_back(least);
    high.push_back(most);
    mean.push_back(middle);
    deviation.push_back(std::sqrt(squares / static_cast<double>(rows.size())));
  }
  return {{"min", low}, {"max", high}, {"mean", mean}, {"std", deviation}, {"count", {rows.size()}}};
}

std::string episodeTable(const EpisodeRows& rows, const std::vector<DemonstrationFeature>& features, double step,
                         std::size_t episode, std::size_t first_index) {
  std::string text;
  for (const DemonstrationFeature& feature : features)
    for (const std::string& part : feature.parts) text += feature.name + "." + part + ",";
  text += "timestamp,frame_index,episode_index,index,task_index\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const double value : rows[i]) text += trajectory::shortestText(value) + ",";
    text += trajectory::shortestText(static_cast<double>(i) * step) + "," + std::to_string(i) + "," +
            std::to_string(episode) + "," + std::to_string(first_index + i) + ",0\n";
  }
  return text;
}

ordered_json infoJson(const std::vector<DemonstrationFeature>& features, const DemonstrationOptions& options,
                      std::size_t episodes, std::size_t frames) {
  ordered_json described;
  for (const DemonstrationFeature& feature : features)
    described[feature.name] = {{"dtype", "float32"}, {"shape", {feature.parts.size()}}, {"names", feature.parts}};
  described["timestamp"] = {{"dtype", "float32"}, {"shape", {1}}, {"names", nullptr}};
  for (const char* name : {"frame_index", "episode_index", "index", "task_index"})
    described[name] = {{"dtype", "int64"}, {"shape", {1}}, {"names", nullptr}};
  return {{"codebase_version", "v2.1"},
          {"robot_type", options.robot},
          {"total_episodes", episodes},
          {"total_frames", frames},
          {"total_tasks", 1},
          {"total_videos", 0},
          {"total_chunks", 1},
          {"chunks_size", 1000},
          {"fps", options.rate_hz},
          {"splits", {{"train", "0:" + std::to_string(episodes)}}},
          {"data_path", "data/chunk-{episode_chunk:03d}/episode_{episode_index:06d}.parquet"},
          {"video_path", nullptr},
          {"features", described}};
}

}  // namespace

Expected<std::vector<FileToWrite>> demonstrationFiles(const std::vector<Trajectory>& motions,
                                                      const DemonstrationOptions& options) {
  if (!(options.rate_hz >= 1.0 && options.rate_hz <= 1000.0))
    return makeError({.place = "rate", .found = trajectory::shortestText(options.rate_hz), .expected = "1 to 1000 Hz"});
  const bool is_empty = motions.empty() || std::ranges::any_of(motions, [](const auto& motion) { return motion.empty(); });
  if (is_empty || motions.size() > 1000)
    return makeError({.found = Text("%1 motions, or one without frames", motions.size()),
                      .expected = "1 to 1000 motions with frames"});
  const auto features = featuresOf(motions.front());
  DemonstrationOptions named = options;
  if (named.task.empty()) named.task = motions.front().name.empty() ? "demonstration" : motions.front().name;
  if (named.robot.empty()) named.robot = motions.front().entity;
  const double step = 1.0 / options.rate_hz;
  std::vector<FileToWrite> files;
  std::string episodes, statistics;
  std::size_t frames = 0;
  for (std::size_t e = 0; e < motions.size(); ++e) {
    const Trajectory& motion = motions[e];
    if (motion.joint_names != motions.front().joint_names || motion.channel_names != motions.front().channel_names ||
        motion.has_poses != motions.front().has_poses) {
      return makeError({.place = Text("motion '%1'", motion.name),
                        .found = "other joints or channels than the first motion",
                        .expected = "motions of one robot"});
    }
    EpisodeRows rows;
    const auto count = static_cast<std::size_t>(std::floor(motion.duration() * options.rate_hz + 1e-6)) + 1;
    for (std::size_t i = 0; i < count; ++i)
      rows.push_back(rowAt(motion, features, motion[0].t + static_cast<double>(i) * step, step));
    char name[64];
    std::snprintf(name, sizeof name, "data/chunk-000/episode_%06zu.csv", e);
    files.push_back({name, episodeTable(rows, features, step, e, frames)});
    episodes += ordered_json{{"episode_index", e}, {"tasks", {named.task}}, {"length", count}}.dump() + "\n";
    ordered_json all;
    std::size_t first = 0;
    for (const DemonstrationFeature& feature : features) {
      all[feature.name] = statisticsJson(rows, first, feature.parts.size());
      first += feature.parts.size();
    }
    statistics += ordered_json{{"episode_index", e}, {"stats", all}}.dump() + "\n";
    frames += count;
  }
  files.push_back({"meta/tasks.jsonl", ordered_json{{"task_index", 0}, {"task", named.task}}.dump() + "\n"});
  files.push_back({"meta/episodes.jsonl", episodes});
  files.push_back({"meta/episodes_stats.jsonl", statistics});
  files.push_back({"meta/info.json", infoJson(features, named, motions.size(), frames).dump(1) + "\n"});
  return files;
}

}  // namespace hapticell::exchange
