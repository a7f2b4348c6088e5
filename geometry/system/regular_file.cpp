// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/regular_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <streambuf>

#include "geometry/system/open_file.h"

namespace hapticell::geometry {

namespace fs = std::filesystem;

namespace {

/// What is there instead of a file; empty if it is a file.
Text otherThanFile(mode_t mode) {
  if (S_ISREG(mode)) return {};
  if (S_ISDIR(mode)) return Text("a folder");
  if (S_ISFIFO(mode)) return Text("a pipe, not a regular file");
  if (S_ISSOCK(mode)) return Text("a socket, not a regular file");
  return Text("a device, not a regular file");
}

std::optional<Error> faultOf(const fs::path& path, const struct stat& state, std::uintmax_t most_bytes) {
  if (const Text other = otherThanFile(state.st_mode); !other.empty())
    return Error{.file = path.string(), .found = other, .expected = "a file"};
  const auto size = static_cast<std::uintmax_t>(state.st_size);
  if (size <= most_bytes) return std::nullopt;
  constexpr std::uintmax_t kMega = 1'000'000;
  const Text most =
      most_bytes < kMega ? Text("at most %1 bytes", most_bytes) : Text("at most %1 MB", most_bytes / kMega);
  return Error{.file = path.string(), .found = Text("%1 bytes", size), .expected = most};
}

Error unreadable(const fs::path& path, int fault) {
  if (fault == ENOENT || fault == ENOTDIR) return {.file = path.string(), .found = "the file does not exist"};
  return {.file = path.string(),
          .found = Text("it cannot be read (%1)", std::strerror(fault)),
          .fix = fault == EACCES ? Text("Check its permissions.") : Text()};
}

/// Up to `count` bytes; fewer at the file's end or after a fault.
std::size_t readUpTo(int file, char* into, std::size_t count) {
  std::size_t have = 0;
  while (have < count) {
    const ssize_t got = ::read(file, into + have, count - have);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    have += static_cast<std::size_t>(got);
  }
  return have;
}

}  // namespace

Expected<OpenFile> openRegularFile(const fs::path& path, std::uintmax_t most_bytes) {
  HAPTICELL_TRY(checkRegularFile(path, most_bytes));
  const int file = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (file < 0) return makeError(unreadable(path, errno));
  struct stat state {};
  auto fault = ::fstat(file, &state) != 0 ? std::optional(unreadable(path, errno)) : faultOf(path, state, most_bytes);
  if (!fault) return OpenFile{file, static_cast<std::uintmax_t>(state.st_size)};
  ::close(file);
  return makeError(std::move(*fault));
}

Error endedEarly(const fs::path& path) {
  return {.file = path.string(),
          .found = "the file could not be read to its end",
          .fix = "Read it again when no program writes to it."};
}

Expected<void> checkRegularFile(const fs::path& path, std::uintmax_t most_bytes) {
  struct stat state {};
  if (::stat(path.c_str(), &state) != 0) return makeError(unreadable(path, errno));
  if (auto fault = faultOf(path, state, most_bytes)) return makeError(std::move(*fault));
  return {};
}

Expected<std::string> readRegularFile(const fs::path& path, std::uintmax_t most_bytes) {
  const auto file = openRegularFile(path, most_bytes);
  HAPTICELL_TRY(file);
  std::string content(file->size, '\0');
  const std::size_t have = readUpTo(file->descriptor, content.data(), content.size());
  ::close(file->descriptor);
  if (have == content.size()) return content;
  return makeError(endedEarly(path));
}

std::string headOfFile(const fs::path& path, std::size_t most) {
  const auto file = openRegularFile(path, ~std::uintmax_t{0});
  if (!file) return {};
  std::string head(static_cast<std::size_t>(std::min<std::uintmax_t>(most, file->size)), '\0');
  head.resize(readUpTo(file->descriptor, head.data(), head.size()));
  ::close(file->descriptor);
  return head;
}

class RegularFileStream::Buffer final : public std::streambuf {
 public:
  explicit Buffer(const OpenFile& file) : file_(file) {}
  ~Buffer() override { ::close(file_.descriptor); }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

 protected:
  int_type underflow() override {
    const std::size_t wanted = static_cast<std::size_t>(std::min<std::uintmax_t>(block_.size(), file_.size));
    const std::size_t got = readUpTo(file_.descriptor, block_.data(), wanted);
    file_.size = got == wanted ? file_.size - got : 0;
    setg(block_.data(), block_.data(), block_.data() + got);
    return got == 0 ? traits_type::eof() : traits_type::to_int_type(block_.front());
  }

 private:
  OpenFile file_;  ///< `size`: what is left to be read.
  std::array<char, 65536> block_;
};

RegularFileStream::RegularFileStream(const fs::path& path, std::uintmax_t most_bytes) : std::istream(nullptr) {
  const auto file = openRegularFile(path, most_bytes);
  if (!file) {
    error_ = file.error();
    return;  // A stream without a buffer is bad.
  }
  buffer_ = std::make_unique<Buffer>(*file);
  rdbuf(buffer_.get());  // Clears what was bad.
}

RegularFileStream::~RegularFileStream() = default;

}  // namespace hapticell::geometry
