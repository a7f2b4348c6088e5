// SPDX-License-Identifier: Apache-2.0
// Time and memory of reading CAD and mesh files through readScene() or readMesh(), beside plain_cad_read on the same
// file. usage: import_bench FILE...   (least of three runs each; plain_cad_read is looked for beside this program)
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <string>

#include "workcell/import_scene.h"
#include "workcell/mesh_reader.h"

namespace {

namespace fs = std::filesystem;
using namespace hapticell;
using namespace hapticell::workcell;

constexpr int kRuns = 3;

/// Seconds and triangles of one reading; negative where it failed.
std::pair<double, std::size_t> readOnce(const fs::path& file) {
  const auto begin = std::chrono::steady_clock::now();
  std::size_t triangles = 0;
  if (holdsScene(file)) {
    const auto scene = readScene(file, {}, nullptr);
    if (!scene) return {-1.0, 0};
    for (const auto& mesh : scene->meshes) triangles += mesh.triangles.size();
  } else {
    Diagnostics notes;
    const auto mesh = readMesh(file, {.weld = false}, notes);
    if (!mesh) return {-1.0, 0};
    triangles = mesh->triangles.size();
  }
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), triangles};
}

/// Runs the peer; its own seconds.
double plainOnce(const fs::path& program, const fs::path& file) {
  const std::string command = "'" + program.string() + "' '" + file.string() + "' 2>/dev/null";
  FILE* pipe = ::popen(command.c_str(), "r");
  double seconds = -1.0;
  if (!pipe || std::fscanf(pipe, "%lf", &seconds) != 1) seconds = -1.0;
  if (pipe) ::pclose(pipe);
  return seconds;
}

}  // namespace

int main(int argc, char** argv) {
  const fs::path plain = fs::read_symlink("/proc/self/exe").parent_path() / "plain_cad_read";
  std::printf("| file | triangles (each mesh once) | ours s | plain library s | ratio | our processes' memory MB |\n");
  std::printf("| --- | --- | --- | --- | --- | --- |\n");
  for (int k = 1; k < argc; ++k) {
    double ours = 1e9, peer = 1e9;
    std::size_t triangles = 0;
    for (int run = 0; run < kRuns; ++run) {  // Taken in turns, so that what loads the machine loads both.
      const auto [seconds, count] = readOnce(argv[k]);
      ours = std::min(ours, seconds);
      triangles = count;
      peer = std::min(peer, plainOnce(plain, argv[k]));
    }
    rusage self{}, children{};
    ::getrusage(RUSAGE_SELF, &self);
    ::getrusage(RUSAGE_CHILDREN, &children);
    std::printf("| %s | %zu | %.3f | %.3f | %.2f | %ld + %ld (largest so far) |\n",
                fs::path(argv[k]).filename().c_str(), triangles, ours, peer, ours / peer, self.ru_maxrss / 1024,
                children.ru_maxrss / 1024);
    std::fflush(stdout);
  }
}
