// SPDX-License-Identifier: Apache-2.0
// A main() for the fuzz targets where there is no libFuzzer: runs every seed as it is, then bent ones, the same ones
// each time. A short run for ./check with any compiler and any sanitizer; run.sh is the long one.
// usage: NAME_replay RUNS FILE_OR_FOLDER...
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

constexpr std::size_t kLongest = 8192;

using Random = std::mt19937_64;

std::vector<std::string> seedsOf(int count, char** words) {
  std::vector<std::filesystem::path> files;
  for (int i = 2; i < count; ++i) {
    if (!std::filesystem::is_directory(words[i])) {
      files.emplace_back(words[i]);
      continue;
    }
    for (const auto& entry : std::filesystem::recursive_directory_iterator(words[i])) {
      if (entry.is_regular_file()) files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());  // Folders tell in any order.
  std::vector<std::string> seeds;
  for (const auto& file : files) {
    std::ifstream in(file, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(in), {}};
    if (in && bytes.size() <= kLongest) seeds.push_back(std::move(bytes));
  }
  return seeds;
}

/// One change of a kind that readers stumble over.
void bend(std::string& bytes, const std::vector<std::string>& seeds, Random& random) {
  const auto place = [&] { return bytes.empty() ? 0 : random() % bytes.size(); };
  static const char* const kNumbers[] = {"-1", "0", "1e308", "nan", "inf", "4294967296", "99999999999999999999", "1e-320"};
  switch (random() % 7) {
    case 0:
      if (!bytes.empty()) bytes[place()] ^= static_cast<char>(1u << (random() % 8));
      break;
    case 1:
      if (!bytes.empty()) bytes[place()] = static_cast<char>(random());
      break;
    case 2:  // A piece is gone, or all behind it.
      if (!bytes.empty()) bytes.erase(place(), random() % 4 == 0 ? std::string::npos : 1 + random() % 32);
      break;
    case 3: {  // A piece twice.
      const std::size_t from = place();
      bytes.insert(place(), bytes.substr(from, 1 + random() % 64));
      break;
    }
    case 4: {  // A piece of another file.
      const std::string& other = seeds[random() % seeds.size()];
      if (!other.empty()) bytes.insert(place(), other.substr(random() % other.size(), 1 + random() % 256));
      break;
    }
    case 5: {  // Another number in the place of one.
      const std::size_t at = bytes.find_first_of("0123456789", place());
      if (at == std::string::npos) break;
      const std::size_t end = std::min(bytes.find_first_not_of("0123456789.eE+-", at), bytes.size());
      bytes.replace(at, end - at, kNumbers[random() % std::size(kNumbers)]);
      break;
    }
    default:  // A count of many bytes.
      for (std::size_t i = place(), last = std::min(i + 4, bytes.size()); i < last; ++i) bytes[i] = static_cast<char>(0xff);
      break;
  }
  if (bytes.size() > kLongest) bytes.resize(kLongest);
}

void runOnce(const std::string& bytes) {
  // Its own copy of just that length, so that a sanitizer sees what reads beyond.
  const std::vector<std::uint8_t> data(bytes.begin(), bytes.end());
  static_cast<void>(LLVMFuzzerTestOneInput(data.data(), data.size()));
}

}  // namespace

int main(int count, char** words) {
  const long runs = count > 2 ? std::atol(words[1]) : 0;
  const std::vector<std::string> seeds = count > 2 ? seedsOf(count, words) : std::vector<std::string>();
  if (runs <= 0 || seeds.empty()) {
    std::fprintf(stderr, "usage: %s RUNS FILE_OR_FOLDER...\n", words[0]);
    return 2;
  }
  for (const std::string& seed : seeds) runOnce(seed);
  Random random(20261122);
  for (long i = 0; i < runs; ++i) {
    std::string bytes = seeds[random() % seeds.size()];
    for (std::uint64_t changes = 1 + random() % 4; changes > 0; --changes) bend(bytes, seeds, random);
    runOnce(bytes);
  }
  std::printf("%zu seeds and %ld bent ones, nothing found\n", seeds.size(), runs);
  return 0;
}
