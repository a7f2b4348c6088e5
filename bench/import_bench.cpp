// SPDX-License-Identifier: Apache-2.0
// Time and memory of reading CAD, mesh and robot files as the programs do, beside plain_cad_read on the same file (for
// robots and SDF cells: on the mesh files that they name). usage: import_bench FILE...
// Each file in a process of its own, least of three runs each, in turns; plain_cad_read is looked for beside this one.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "workcell/import/entity_source.h"
#include "workcell/scenes/import_scene.h"
#include "workcell/meshes/mesh_reader.h"

namespace {

namespace fs = std::filesystem;
using namespace hapticell;
using namespace hapticell::workcell;

constexpr int kRuns = 3;

bool endsWithAny(const std::string& text, std::initializer_list<const char*> ends) {
  return std::any_of(ends.begin(), ends.end(), [&](const char* end) { return text.ends_with(end); });
}

std::size_t trianglesOf(const ImportResult& result) {
  std::size_t sum = 0;
  std::set<const void*> seen;
  for (const Entity& entity : result.entities) {
    if (entity.mesh() && seen.insert(entity.mesh().get()).second) sum += entity.mesh()->triangles.size();
    if (!entity.robot()) continue;
    for (const auto& link : entity.robot()->links)
      for (const auto& shape : link.visuals)
        if (seen.insert(shape.mesh.get()).second) sum += shape.mesh->triangles.size();
  }
  return sum;
}

/// Triangles (each mesh once), or nothing where the file cannot be read.
std::optional<std::size_t> read(const fs::path& file) {
  Diagnostics notes;
  if (endsWithAny(file.string(), {".stl", ".STL", ".obj", ".ply", ".off"})) {
    const auto mesh = readMeshParts(file, {.weld = false}, true, notes);
    return mesh ? std::optional(mesh->triangles_in_file) : std::nullopt;
  }
  if (endsWithAny(file.string(), {".urdf", ".sdf", ".world"})) {
    const auto result = EntityLoader(fs::current_path()).loadTree(file.string(), {}, notes);
    return result ? std::optional(trianglesOf(*result)) : std::nullopt;
  }
  const auto scene = readScene(file, {}, nullptr);
  if (!scene) return std::nullopt;
  std::size_t triangles = 0;
  for (const auto& mesh : scene->meshes) triangles += mesh.triangles.size();
  return triangles;
}

/// The files that plain_cad_read is given: the file itself, or all mesh files below the folder of a robot or cell.
std::string peerFiles(const fs::path& file) {
  if (!endsWithAny(file.string(), {".urdf", ".sdf", ".world"})) return "'" + file.string() + "'";
  std::ifstream stream(file);
  std::stringstream content;
  content << stream.rdbuf();
  const std::string text = content.str();
  std::set<std::string> files;
  for (std::size_t at = text.find("package://"); at != std::string::npos; at = text.find("package://", at + 1)) {
    const std::size_t end = text.find_first_of("\"'<", at);
    files.insert((file.parent_path() / text.substr(at + 10, end - at - 10)).string());
  }
  std::string words;
  for (const std::string& name : files) words += "'" + name + "' ";
  return words;
}

/// Of this process and of its children that have ended.
double processorSeconds() {
  double sum = 0.0;
  for (const int whose : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage used{};
    ::getrusage(whose, &used);
    for (const timeval& t : {used.ru_utime, used.ru_stime})
      sum += static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  }
  return sum;
}

struct Peer {
  double seconds = -1.0, processor = 0.0;
  long triangles = 0, megabytes = 0;
};

Peer runPeer(const fs::path& program, const std::string& files) {
  Peer peer;
  if (files.empty()) return peer;
  FILE* pipe = ::popen(("'" + program.string() + "' " + files + " 2>/dev/null").c_str(), "r");
  if (!pipe || std::fscanf(pipe, "%lf s, %lf s of processor, %ld triangles, %ld MB", &peer.seconds, &peer.processor,
                           &peer.triangles, &peer.megabytes) != 4)
    peer.seconds = -1.0;
  if (pipe) ::pclose(pipe);
  return peer;
}

void row(const fs::path& plain, const fs::path& file) {
  double ours = 1e9, processor = 1e9;
  Peer peer{1e9, 0, 0, 0};
  std::size_t triangles = 0;
  long memory = 0, importer = 0;
  for (int run = 0; run < kRuns; ++run) {  // Taken in turns, so that what loads the machine loads both.
    const double used = processorSeconds();
    const auto begin = std::chrono::steady_clock::now();
    const auto count = read(file);
    if (!count) {
      std::printf("| %s | not read |\n", file.c_str());
      return;
    }
    ours = std::min(ours, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    processor = std::min(processor, processorSeconds() - used);
    triangles = *count;
    if (run == 0) {  // Before the peer is a child too.
      rusage self{}, children{};
      ::getrusage(RUSAGE_SELF, &self);
      ::getrusage(RUSAGE_CHILDREN, &children);
      memory = self.ru_maxrss / 1024;
      importer = children.ru_maxrss / 1024;
    }
    const Peer other = runPeer(plain, peerFiles(file));
    if (other.seconds < 0.0)
      peer.seconds = -1.0;
    else if (other.seconds < peer.seconds)
      peer = other;
  }
  const std::string name = file.parent_path().filename() / file.filename();
  std::printf("| %s | %zu | %.3f (%.3f) | %ld + %ld |", name.c_str(), triangles, ours, processor, memory, importer);
  if (peer.seconds < 0.0)
    std::printf(" | | | |\n");
  else
    std::printf(" %ld | %.3f (%.3f) | %ld | %.2f (%.2f) |\n", peer.triangles, peer.seconds, peer.processor,
                peer.megabytes, ours / peer.seconds, processor / std::max(1e-3, peer.processor));
}

}  // namespace

int main(int argc, char** argv) {
  const fs::path plain = fs::read_symlink("/proc/self/exe").parent_path() / "plain_cad_read";
  std::printf(
      "| file | triangles (each mesh once) | s | MB: caller + importer | plain library: triangles | s | MB | ratio of "
      "s |\n");
  std::printf("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (int k = 1; k < argc; ++k) {
    std::fflush(stdout);
    const pid_t child = ::fork();
    if (child == 0) {
      row(plain, argv[k]);
      std::fflush(stdout);
      ::_exit(0);
    }
    ::waitpid(child, nullptr, 0);
  }
}
