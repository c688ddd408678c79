// SPDX-License-Identifier: MIT
// One process at a time has a file.
#include "hal/files/file_lock.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <optional>

#include "support_hal.hpp"

namespace softcnc::hal {

namespace fs = std::filesystem;

TEST_CASE("a file that is in use is refused and says by whom", "[hal][lock]") {
  const test::Folder folder;
  const std::string file = folder / "s.toml";
  fs::create_symlink("s.toml", folder / "link");
  {
    const auto first = FileLock::take(file);
    REQUIRE(first);
    for (const std::string& name : {file, folder / "link"}) {
      const auto second = FileLock::take(name);
      REQUIRE_FALSE(second);
      CHECK(render(second.error()) ==
            name + ": error: is in use by process " + std::to_string(::getpid()) + " [SC6017]\n");
      CHECK(exit_status(second.error()) == 5);
    }
    CHECK(FileLock::take(folder / "other.toml"));
    CHECK(test::names_in(folder.path()) == test::Names{".s.toml.softcnc-lock", "link"});
  }
  CHECK(test::names_in(folder.path()) == test::Names{"link"});
  CHECK(FileLock::take(file));
}

TEST_CASE("a lock that a killed process has left is taken over", "[hal][lock]") {
  const test::Folder folder;
  test::write(folder / ".s.toml.softcnc-lock", "999999999\n");
  {
    const auto taken = FileLock::take(folder / "s.toml");
    REQUIRE(taken);
    CHECK(test::read(folder / ".s.toml.softcnc-lock") == std::to_string(::getpid()) + '\n');
  }
  CHECK(test::names_in(folder.path()).empty());
}

TEST_CASE("a lock moves, and ends once", "[hal][lock]") {
  const test::Folder folder;
  std::optional<FileLock> kept;
  {
    auto taken = FileLock::take(folder / "s.toml");
    REQUIRE(taken);
    kept.emplace(std::move(*taken));
  }
  CHECK_FALSE(FileLock::take(folder / "s.toml"));
  kept.reset();
  CHECK(FileLock::take(folder / "s.toml"));
}

TEST_CASE("what is no regular file has no lock, and a lock that cannot be made is reported",
          "[hal][lock]") {
  for (const std::string file : {"", "-", "/dev/null"}) {
    const auto first = FileLock::take(file), second = FileLock::take(file);
    CHECK(first);
    CHECK(second);
  }
  const auto nowhere = FileLock::take("no/such/folder/s.toml");
  REQUIRE_FALSE(nowhere);
  CHECK(render(nowhere.error()) ==
        "no/such/folder/s.toml: error: cannot be created: No such file or directory [SC6011]\n");
}

}  // namespace softcnc::hal
