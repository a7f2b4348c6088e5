// SPDX-License-Identifier: Apache-2.0
// Any text as the SRDF of a small robot: refused in words, or a model whose pairs name its links.
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "workcell/robots/srdf.h"
#include "workcell/robots/urdf_reader.h"

namespace {
constexpr const char* kRobot =
    "<robot name='r'><link name='base'/><link name='arm'/><link name='hand'/>"
    "<joint name='j1' type='revolute'><parent link='base'/><child link='arm'/><axis xyz='0 0 1'/>"
    "<limit lower='-1' upper='1' effort='1' velocity='1'/></joint>"
    "<joint name='j2' type='prismatic'><parent link='arm'/><child link='hand'/><axis xyz='1 0 0'/>"
    "<limit lower='0' upper='1' effort='1' velocity='1'/></joint></robot>";
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hapticell;
  static const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("hapticell-fuzz-" + std::to_string(::getpid()) + ".srdf");
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  Diagnostics notes;
  auto model = workcell::readUrdfText(kRobot, "/nowhere/fuzzed.urdf", notes);
  if (!model) std::abort();
  const auto read = workcell::readSrdf(file, *model, notes);
  if (!read && read.error().message().empty()) std::abort();
  return 0;
}
