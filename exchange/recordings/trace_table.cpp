// SPDX-License-Identifier: Apache-2.0
#include "exchange/recordings/trace_table.h"

#include "exchange/recordings/message_decoding.h"
#include "geometry/system/regular_file.h"
#include "trajectory/motion/csv_table.h"

namespace hapticell::exchange {

namespace {

/// Seven numbers, metres and a quaternion with w first.
std::optional<Pose> tracePose(const std::vector<double>& row, std::size_t at) {
  return usablePose({{row[at], row[at + 1], row[at + 2]}, dquat(row[at + 3], row[at + 4], row[at + 5], row[at + 6])});
}

}  // namespace

bool isTraceTable(const std::filesystem::path& file) {
  const std::string head = geometry::headOfFile(file, 400);
  return head.substr(0, head.find('\n')).find("proxy_x") != std::string::npos;
}

Expected<std::vector<StylusSample>> readTraceTable(const std::filesystem::path& file) {
  const auto table = trajectory::readCsvTable(
      file, {"t",       "x",       "y",       "z",        "qw",       "qx",       "qy", "qz", "proxy_x", "proxy_y",
             "proxy_z", "fx",      "fy",      "fz",       "button",   "contact",  "moved_x", "moved_y", "moved_z",
             "moved_qw", "moved_qx", "moved_qy", "moved_qz", "tx", "ty", "tz"});
  HAPTICELL_TRY(table);
  std::vector<StylusSample> samples;
  samples.reserve(table->rows.size());
  for (std::size_t i = 0; i < table->rows.size(); ++i) {
    const std::vector<double>& row = table->rows[i];
    const auto stylus = tracePose(row, 1), moved = tracePose(row, 16);
    const bool rises = samples.empty() || row[0] > samples.back().t;
    if (!stylus || !moved || !rises || !(row[14] >= 0.0 && row[14] < 4294967296.0)) {
      return makeError({file.string(), Text("line %1", table->lines[i]), "a row that is no tick of a session",
                        "rising times, unit quaternions and buttons", {}});
    }
    StylusSample sample;
    sample.t = row[0];
    sample.X_DS = *stylus;
    sample.X_DP = {{row[8], row[9], row[10]}, stylus->q};  // The table has the proxy's position alone.
    sample.force_D = {row[11], row[12], row[13]};
    sample.torque_D = {row[23], row[24], row[25]};
    sample.buttons = static_cast<std::uint32_t>(row[14]);
    sample.contact = row[15] != 0.0;
    sample.X_WM = *moved;
    samples.push_back(sample);
  }
  return samples;
}

}  // namespace hapticell::exchange
