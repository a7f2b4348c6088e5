// SPDX-License-Identifier: Apache-2.0
#include "agents/runner/run_recorder.h"

#include "trajectory/motion/number_text.h"

namespace hapticell::agents {

RunRecorder::RunRecorder(const AgentCell& cell) {
  motion_.name = cell.task().name;
  motion_.entity = cell.entity().name;
  const bool figure = cell.entity().figure() != nullptr;
  whole_ = figure;
  motion_.moved = "geometric_center";
  if (figure) motion_.moved = "whole";
  if (cell.entity().robot() == nullptr) return;
  if (!figure) motion_.moved = "tcp";
  for (const int joint : cell.entity().robot()->moving)
    motion_.joint_names.push_back(cell.entity().robot()->joints[static_cast<std::size_t>(joint)].name);
}

void RunRecorder::add(const AgentLoop& loop) {
  const manipulation::EntityConfiguration& at = loop.body().configuration();
  trajectory::Trajectory::Frame frame;
  frame.t = loop.t();
  frame.X_WT = whole_ ? at.X_WE : loop.body().handle();
  motion_.addFrame(frame, at.joints);
}

void RunRecorder::addWishes(const AgentLoop& loop) {
  if (csv_.empty()) {
    csv_ = "t";
    for (const ShownWish& wish : loop.wishes()) {
      for (const char* column : {"_x", "_y", "_z", "_strength"}) csv_ += "," + wish.name + column;
    }
    csv_ += "\n";
  }
  csv_ += trajectory::shortestText(loop.t());
  for (const ShownWish& wish : loop.wishes()) {
    for (const double value : {wish.arrow_W.x, wish.arrow_W.y, wish.arrow_W.z, wish.strength})
      csv_ += "," + trajectory::shortestText(value);
  }
  csv_ += "\n";
}

}  // namespace hapticell::agents
