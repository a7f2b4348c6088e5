// SPDX-License-Identifier: Apache-2.0
#include "config/user_folders.h"

#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <iterator>

#include "geometry/system/plain_text.h"

namespace hapticell::config {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kEntryBytes = 16 * 1024;  // Of an entry of the password or group file.

/// The variable's value where it is an absolute path.
fs::path absolutePath(const char* variable) {
  const char* const value = std::getenv(variable);
  return value != nullptr && value[0] == '/' ? fs::path(value).lexically_normal() : fs::path();
}

Expected<fs::path> userFolder(const char* variable, const char* below_home, const Text& what) {
  const fs::path own = variable != nullptr ? absolutePath(variable) : fs::path();
  if (!own.empty()) return own / "hapticell";
  const fs::path home = absolutePath("HOME");
  if (!home.empty()) return home / below_home / "hapticell";
  const char* const home_given = std::getenv("HOME");
  Text found = "HOME is not set";
  if (home_given != nullptr) {
    found = *home_given == '\0' ? Text("HOME is empty") : Text("HOME is '%1', not an absolute path", home_given);
  }
  return makeError({.place = what,
                    .found = found,
                    .expected = "the home folder of this user",
                    .fix = variable != nullptr ? Text("Set HOME or %1. The current folder is not searched.", variable)
                                               : Text("Set HOME. The current folder is not searched.")});
}

/// Empty: it has no name.
std::string nameOf(uid_t user) {
  std::array<char, kEntryBytes> room{};
  passwd entry{}, *found = nullptr;
  if (getpwuid_r(user, &entry, room.data(), room.size(), &found) == 0 && found != nullptr) return found->pw_name;
  return {};
}

/// A group that only its owner is in, as many systems give one to each user.
bool isGroupOfItsOwn(gid_t id, uid_t owner) {
  std::array<char, kEntryBytes> room{};
  group entry{}, *found = nullptr;
  if (getgrgid_r(id, &entry, room.data(), room.size(), &found) != 0 || found == nullptr) return false;
  const std::string user = nameOf(owner);
  if (user.empty() || user != found->gr_name) return false;
  for (char** member = found->gr_mem; *member != nullptr; ++member) {
    if (user != *member) return false;
  }
  return true;
}

Text belongsTo(uid_t user) {
  const std::string name = nameOf(user);
  return name.empty() ? Text("it belongs to user %1", user) : Text("it belongs to %1", name);
}

tl::unexpected<Error> refuse(const fs::path& path, Text found, Text fix) {
  return makeError({.file = path.string(),
                    .found = std::move(found),
                    .expected = "a file or folder that only you and root can change",
                    .fix = std::move(fix)});
}

/// `also` is believed besides root and this user.
Expected<void> checkOne(const fs::path& path, uid_t also) {
  struct stat facts {};
  if (::stat(path.c_str(), &facts) != 0) return {};
  if (facts.st_uid != 0 && facts.st_uid != ::geteuid() && facts.st_uid != also)
    return refuse(path, belongsTo(facts.st_uid), Text("Remove it, or make it yours with chown."));
  const bool folder_of_all = S_ISDIR(facts.st_mode) && (facts.st_mode & S_ISVTX) != 0;  // As /tmp.
  const bool group = (facts.st_mode & S_IWGRP) != 0 && !isGroupOfItsOwn(facts.st_gid, facts.st_uid);
  if (((facts.st_mode & S_IWOTH) != 0 || group) && !folder_of_all)
    return refuse(path, Text("other users can write to it"),
                  Text("Check its content, then run: chmod go-w '%1'.", path.string()));
  return {};
}

Expected<void> checkAll(const fs::path& file, int levels, uid_t also) {
  fs::path at = file.lexically_normal();
  for (int level = 0; level <= levels; ++level) {
    if (auto own = checkOne(at, also); !own) return own;
    if (at == at.parent_path()) break;
    at = at.parent_path();
  }
  return {};
}

uid_t ownerOfProgram() {
  struct stat facts {};
  return ::stat("/proc/self/exe", &facts) == 0 ? facts.st_uid : ::geteuid();
}

}  // namespace

Expected<fs::path> userSettingsFolder() {
  return userFolder("XDG_CONFIG_HOME", ".config", Text("the folder of settings"));
}

Expected<fs::path> userStateFolder() {
  return userFolder("XDG_STATE_HOME", ".local/state", Text("the folder of saved states"));
}

Expected<fs::path> userLibraryFolder() {
  return userFolder(nullptr, ".local/lib", Text("the folder of your plug-ins"));
}

Expected<void> checkOwn(const fs::path& file, int levels) {
  return checkAll(file, levels, ::geteuid());
}

Expected<void> checkUserFile(const fs::path& file) {
  const fs::path whole = file.lexically_normal();
  int levels = 1;
  for (const char* variable : {"HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_DATA_HOME"}) {
    const fs::path base = absolutePath(variable);
    const fs::path below = base.empty() ? fs::path() : whole.lexically_relative(base);
    if (below.empty() || *below.begin() == "..") continue;
    levels = std::max(levels, static_cast<int>(std::distance(below.begin(), below.end())));
  }
  return checkOwn(whole, levels);
}

Expected<void> checkPlugIn(const fs::path& file) {
  constexpr int kItsFolder = 1;
  return checkAll(file, kItsFolder, ownerOfProgram());
}

Expected<void> makeOwnFolder(const fs::path& folder) {
  std::error_code ignored;
  fs::path made;
  for (const fs::path& step : folder) {
    made /= step;
    if (fs::exists(made, ignored)) continue;
    if (::mkdir(made.c_str(), 0700) != 0 && errno != EEXIST)
      return makeError({.file = made.string(), .found = systemText(errno), .expected = "a folder that can be created"});
  }
  return checkUserFile(folder);
}

std::vector<fs::path> absoluteEntries(const char* list, std::vector<std::string>* refused) {
  std::vector<fs::path> entries;
  const std::string text = list != nullptr ? list : "";
  for (std::size_t begin = 0; begin <= text.size() && !text.empty();) {
    const std::size_t end = std::min(text.find(':', begin), text.size());
    const std::string entry = text.substr(begin, end - begin);
    if (entry.starts_with('/'))
      entries.emplace_back(entry);
    else if (refused != nullptr)
      refused->push_back(entry);
    begin = end + 1;
  }
  return entries;
}

fs::path systemProgram(const std::string& name) {
  if (name.empty() || name.find('/') != std::string::npos) return {};
  for (const fs::path& folder : absoluteEntries(std::getenv("PATH"))) {
    const fs::path program = folder / name;
    std::error_code ignored;
    if (fs::is_regular_file(program, ignored) && ::access(program.c_str(), X_OK) == 0 && checkOwn(program, 1))
      return program;
  }
  return {};
}

std::vector<Text> cleanEnvironment() {
  std::vector<Text> sentences;
  // LD_LIBRARY_PATH is the loader's: it was read before main().
  for (const std::string variable : {"PATH", "QT_PLUGIN_PATH", "QT_QPA_PLATFORM_PLUGIN_PATH", "QML_IMPORT_PATH",
                                     "QML2_IMPORT_PATH", "OPENSSL_CONF", "OPENSSL_MODULES", "OPENSSL_ENGINES"}) {
    const char* const list = std::getenv(variable.c_str());
    if (list == nullptr) continue;
    std::vector<std::string> refused;
    std::string kept;
    for (const fs::path& entry : absoluteEntries(list, &refused)) {
      const auto own = variable == "PATH" ? Expected<void>() : checkOwn(entry, 0);
      if (own)
        kept += (kept.empty() ? "" : ":") + entry.string();
      else
        refused.push_back(entry.string());
    }
    if (refused.empty()) continue;
    kept.empty() ? ::unsetenv(variable.c_str()) : ::setenv(variable.c_str(), kept.c_str(), 1);
    for (const std::string& entry : refused) {
      if (variable != "PATH")
        sentences.push_back(
            Text("%1 names '%2', which is left out. Plug-ins are loaded only from absolute paths of folders that no "
                 "other user can write to.",
                 variable, plainText(entry)));
    }
  }
  return sentences;
}

}  // namespace hapticell::config
