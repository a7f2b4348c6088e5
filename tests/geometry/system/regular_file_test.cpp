// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/regular_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>

#include "geometry/system/file_bytes.h"
#include "geometry/system/open_file.h"
#include "tests/support/test_data.h"

namespace hapticell::geometry {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

class RegularFile : public ::testing::Test {
 protected:
  std::string refusal(const fs::path& path) {
    RegularFileStream stream(path);
    EXPECT_FALSE(stream) << path;
    EXPECT_EQ(headOfFile(path, 10), "") << path;
    const auto checked = checkRegularFile(path);
    EXPECT_FALSE(checked) << path;
    const auto content = readRegularFile(path);
    const auto bytes = FileBytes::read(path);
    if (content || bytes) return "read";
    EXPECT_EQ(bytes.error().message(), content.error().message());
    EXPECT_EQ(content.error().message(), stream.error().message());
    return content.error().message();
  }

  test::TemporaryFolder folder_;
};

TEST_F(RegularFile, IsTheSameReadByAllCores) {
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{20'000'003}}) {
    std::string written(size, '\0');
    std::uint32_t number = 1;
    for (char& byte : written) byte = static_cast<char>((number = number * 1664525 + 1013904223) >> 24);
    const fs::path file = folder_.path() / std::to_string(size);
    std::ofstream(file, std::ios::binary).write(written.data(), static_cast<std::streamsize>(size));
    const auto bytes = FileBytes::read(file);
    ASSERT_TRUE(bytes.has_value());
    EXPECT_TRUE(bytes->view() == written) << size;
    EXPECT_TRUE(*readRegularFile(file) == written) << size;
    EXPECT_EQ(FileBytes::read(file, 20'000'000).has_value(), size < 20'000'000);
    const auto opened = openRegularFile(file, size);
    ASSERT_TRUE(opened.has_value());
    EXPECT_EQ(opened->size, size);
    EXPECT_EQ(::close(opened->descriptor), 0);
  }
}

// Each would wait for ever, or have no end, if it were only opened.
TEST_F(RegularFile, NothingElseIsOpened) {
  const fs::path pipe = folder_.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(refusal(pipe), HasSubstr("pipe: a pipe, not a regular file"));
  fs::create_symlink(pipe, folder_.path() / "link");
  EXPECT_THAT(refusal(folder_.path() / "link"), HasSubstr("a pipe"));
  EXPECT_THAT(refusal("/dev/zero"), HasSubstr("a device"));
  fs::create_symlink("/dev/zero", folder_.path() / "zero.csv");
  EXPECT_THAT(refusal(folder_.path() / "zero.csv"), HasSubstr("a device"));
  EXPECT_THAT(refusal(folder_.path()), HasSubstr("a folder"));
  EXPECT_THAT(refusal(folder_.path() / "none"), HasSubstr("the file does not exist"));
  fs::create_symlink("circle", folder_.path() / "circle");
  EXPECT_THAT(refusal(folder_.path() / "circle"), HasSubstr("cannot be read"));

  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string name = (folder_.path() / "socket").string();
  ASSERT_LT(name.size(), sizeof address.sun_path);
  std::memcpy(address.sun_path, name.c_str(), name.size() + 1);
  ASSERT_EQ(::bind(socket, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  EXPECT_THAT(refusal(name), HasSubstr("a socket"));
  ::close(socket);
}

TEST_F(RegularFile, IsReadWholeByItselfAndByLinks) {
  std::string text;
  for (int k = 0; k < 30'000; ++k) text += std::to_string(k) + '\n';
  const fs::path file = folder_.write("file.txt", text);
  fs::create_symlink(file, folder_.path() / "link");
  for (const fs::path& path : {file, folder_.path() / "link"}) {
    const auto content = readRegularFile(path);
    ASSERT_TRUE(content);
    EXPECT_EQ(*content, text);
    RegularFileStream stream(path);
    std::string lines;
    for (std::string line; std::getline(stream, line);) lines += line + '\n';
    EXPECT_EQ(lines, text);
    EXPECT_EQ(headOfFile(path, 6), "0\n1\n2\n");
  }
  EXPECT_EQ(readRegularFile(folder_.write("empty", "")), "");
  RegularFileStream empty(folder_.path() / "empty");
  EXPECT_TRUE(empty) << "it is there";
  EXPECT_EQ(empty.get(), std::istream::traits_type::eof());
}

TEST_F(RegularFile, OneThatIsTooLargeIsNotRead) {
  const fs::path file = folder_.write("file", std::string(2'000'001, 'a'));
  EXPECT_TRUE(readRegularFile(file, 2'000'001));
  EXPECT_THAT(readRegularFile(file, 2'000'000).error().message(), HasSubstr("2000001 bytes; expected at most 2 MB"));
  EXPECT_FALSE(RegularFileStream(file, 1000));
}

}  // namespace
}  // namespace hapticell::geometry
