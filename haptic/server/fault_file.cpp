// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/fault_file.h"

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "config/user_folders.h"
#include "geometry/system/atomic_file.h"
#include "haptic/server/clock.h"

namespace hapticell::haptic {

namespace fs = std::filesystem;

FaultFiles::FaultFiles(Expected<fs::path> folder, FaultBudget budget) : folder_(std::move(folder)), budget_(budget) {}

Expected<std::optional<fs::path>> FaultFiles::write(const FaultRecord& record, std::int64_t now_ns) {
  const bool at_once = written_ < budget_.at_once;
  if (!at_once && now_ns - written_ns_ < toNanoseconds(budget_.pause)) {
    ++left_out_;
    return std::nullopt;
  }
  HAPTICELL_TRY(folder_);
  ++written_;
  written_ns_ = now_ns;
  auto file = writeFault(record, *folder_);
  HAPTICELL_TRY(file);
  removeOldest(*file);
  return *file;
}

void FaultFiles::removeOldest(const fs::path& newest) const {
  struct Kept {
    fs::path file;
    fs::file_time_type time;
    std::uintmax_t bytes;
  };
  std::vector<Kept> kept;
  std::error_code fault;
  for (fs::directory_iterator at(*folder_, fault), end; !fault && at != end; at.increment(fault)) {
    const std::string name = at->path().filename().string();
    std::error_code gone;
    if (!name.starts_with("fault-") || !name.ends_with(".csv") || at->is_symlink(gone) || !at->is_regular_file(gone))
      continue;
    const Kept one{at->path(), at->last_write_time(gone), at->file_size(gone)};
    if (!gone) kept.push_back(one);
  }
  std::sort(kept.begin(), kept.end(), [](const Kept& a, const Kept& b) { return a.time > b.time; });
  std::uintmax_t bytes = 0;
  std::size_t files = 0;
  for (const Kept& one : kept) {
    const bool fits = files < budget_.files && bytes + one.bytes <= budget_.bytes;
    if (!fits && one.file != newest) {
      fs::remove(one.file, fault);
      continue;
    }
    ++files;
    bytes += one.bytes;
  }
}

Expected<fs::path> writeFault(const FaultRecord& record, const fs::path& folder) {
  std::error_code problem;
  HAPTICELL_TRY(config::makeOwnFolder(fs::absolute(folder, problem)));
  const fs::path path = folder / ("fault-" + std::to_string(record.tick) + ".csv");
  std::ostringstream file;
  file << "# fault: " << toString(record.kind) << " at tick " << record.tick << "\n"
       << "tick,stamp_ns,x,y,z,qw,qx,qy,qz,proxy_x,proxy_y,proxy_z,wanted_x,wanted_y,wanted_z,fx,fy,fz,"
          "rows,set,skipped,buttons,forces_on\n";
  for (const FaultSample& s : record.samples) {
    char line[512];
    std::snprintf(line, sizeof line,
                  "%llu,%lld,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%u,%llu,"
                  "%u,%u,%d\n",
                  static_cast<unsigned long long>(s.tick), static_cast<long long>(s.stamp_ns), s.X_DS.p.x, s.X_DS.p.y,
                  s.X_DS.p.z, s.X_DS.q.w, s.X_DS.q.x, s.X_DS.q.y, s.X_DS.q.z, s.X_DP.p.x, s.X_DP.p.y, s.X_DP.p.z,
                  s.wanted_D.x, s.wanted_D.y, s.wanted_D.z, s.commanded_D.x, s.commanded_D.y, s.commanded_D.z, s.rows,
                  static_cast<unsigned long long>(s.adopted_set), s.skipped, s.buttons, s.forces_on ? 1 : 0);
    file << line;
  }
  HAPTICELL_TRY(writeFileAtomically(path, file.str()));
  return path;
}

}  // namespace hapticell::haptic
