// SPDX-License-Identifier: MIT
// A list whose most part stands in a file is read like any other.
#include "motion/core/disk_backed_vector.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <string>

using namespace softcnc;
using namespace softcnc;

namespace {

/// Sets TMPDIR for a while.
class TemporaryPlace {
 public:
  explicit TemporaryPlace(const char* place) {
    if (const char* before = std::getenv("TMPDIR")) before_ = before;
    ::setenv("TMPDIR", place, 1);
  }
  ~TemporaryPlace() {
    if (before_.empty())
      ::unsetenv("TMPDIR");
    else
      ::setenv("TMPDIR", before_.c_str(), 1);
  }

 private:
  std::string before_;
};

}  // namespace

TEST_CASE("a long list holds what was added, in memory or not", "[hal][long_list]") {
  const auto most = GENERATE(std::size_t{1}, std::size_t{7}, std::size_t{1000}, std::size_t{5000});
  DiskBackedVector<std::size_t> list(most);
  for (std::size_t i = 0; i < 2345; ++i) list.push_back(i * i);
  CHECK(list.size() == 2345);
  REQUIRE(list.finish());
  const DiskBackedVector<std::size_t> moved = std::move(list);
  const auto values = moved.values();
  REQUIRE(values.size() == 2345);
  for (int times = 0; times < 2; ++times) {
    for (std::size_t i = 0; i < values.size(); ++i) REQUIRE(values[i] == i * i);
    moved.release();
  }
  if (most == 1) CHECK(moved.memory() < 100);
}

TEST_CASE("an empty list is finished too", "[hal][long_list]") {
  DiskBackedVector<int> list;
  REQUIRE(list.finish());
  CHECK(list.values().empty());
}

TEST_CASE("a list without room says so: SC6003", "[hal][long_list]") {
  const TemporaryPlace nowhere("/nowhere");
  DiskBackedVector<int> list(4);
  for (int i = 0; i < 4; ++i) list.push_back(i);
  CHECK(list.kept());
  for (int i = 0; i < 20; ++i) list.push_back(i);
  CHECK(!list.kept());
  const Status finished = list.finish();
  REQUIRE(!finished);
  CHECK(finished.error().code == Code::SC6003);
  CHECK(finished.error().message.starts_with("no temporary file: "));
}
