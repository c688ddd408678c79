// SPDX-License-Identifier: MIT
// Files seen whole or not at all, and how writing fails.
#include "hal/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "support_hal.hpp"

namespace softcnc::hal {

namespace fs = std::filesystem;

TEST_CASE("a file appears under its name only when it is finished", "[hal][output]") {
  const test::Folder folder;
  const std::string file = folder / "out.txt";
  auto output = OutputFile::open(file);
  REQUIRE(output);
  REQUIRE((*output)->write("hello "));
  REQUIRE((*output)->write("world\n"));
  CHECK_FALSE(fs::exists(file));
  CHECK(fs::exists(file + ".part"));
  REQUIRE((*output)->finish());
  CHECK_FALSE(fs::exists(file + ".part"));
  CHECK(test::read(file) == "hello world\n");
}

TEST_CASE("an unfinished file leaves nothing, and the old one stays", "[hal][output]") {
  const test::Folder folder;
  const std::string file = folder / "out.txt";
  REQUIRE(write_file(file, "old"));
  {
    auto output = OutputFile::open(file);
    REQUIRE(output);
    REQUIRE((*output)->write("new"));
  }
  CHECK_FALSE(fs::exists(file + ".part"));
  CHECK(test::read(file) == "old");
}

TEST_CASE("a symbolic link is written through", "[hal][output]") {
  const test::Folder folder;
  REQUIRE(write_file(folder / "target", "old"));
  fs::create_symlink(folder / "target", folder / "link");
  REQUIRE(write_file(folder / "link", "new"));
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(test::read(folder / "target") == "new");
}

TEST_CASE("a symbolic link to a file that is not there yet is written through", "[hal][output]") {
  const test::Folder folder;
  fs::create_symlink("second", folder / "first");
  fs::create_symlink(folder / "target", folder / "second");
  REQUIRE(write_file(folder / "first", "new"));
  CHECK(fs::is_symlink(folder / "first"));
  CHECK(fs::is_symlink(folder / "second"));
  CHECK(test::read(folder / "target") == "new");
}

TEST_CASE("a symbolic link to nowhere is told and stays", "[hal][output]") {
  const test::Folder folder;
  fs::create_symlink("no/such/folder", folder / "lost");
  fs::create_symlink("circle", folder / "circle");
  const auto lost = write_file(folder / "lost", "x"), circle = write_file(folder / "circle", "x");
  REQUIRE_FALSE(lost);
  REQUIRE_FALSE(circle);
  CHECK(render(lost.error()) ==
        (folder / "lost") + ": error: cannot be created: No such file or directory [SC6011]\n");
  CHECK(render(circle.error()) == (folder / "circle") +
                                      ": error: cannot be created: Too many levels of "
                                      "symbolic links [SC6011]\n");
  CHECK(fs::is_symlink(folder / "lost"));
  CHECK(fs::is_symlink(folder / "circle"));
}

TEST_CASE("a file that cannot be created says why", "[hal][output]") {
  const auto missing = OutputFile::open("no/such/folder/out.csv");
  REQUIRE_FALSE(missing);
  CHECK(render(missing.error()) ==
        "no/such/folder/out.csv: error: cannot be created: No such file or directory [SC6011]\n");
  CHECK(exit_status(missing.error()) == 5);
  const test::Folder folder;
  const auto directory = OutputFile::open(folder.path());
  REQUIRE_FALSE(directory);
  CHECK(render(directory.error()) ==
        folder.path() + ": error: cannot be created: Is a directory [SC6011]\n");
}

TEST_CASE("a full disk is told", "[hal][output]") {
  const auto written = write_file("/dev/full", "x");
  REQUIRE_FALSE(written);
  CHECK(render(written.error()) ==
        "/dev/full: error: writing failed: No space left on device [SC6012]\n");
  CHECK(exit_status(written.error()) == 5);
  CHECK_FALSE(fs::exists("/dev/full.part"));
}

TEST_CASE("what is no regular file is written directly", "[hal][output]") {
  CHECK(write_file("/dev/null", "x"));
  CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("a closed pipe can be told from other failures", "[hal][output]") {
  std::signal(SIGPIPE, SIG_IGN);
  const test::Folder folder;
  const std::string pipe = folder / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  REQUIRE(reader >= 0);
  auto output = OutputFile::open(pipe);
  REQUIRE(output);
  REQUIRE((*output)->write("read by someone"));
  ::close(reader);
  const auto written = (*output)->write("read by nobody");
  REQUIRE_FALSE(written);
  CHECK(render(written.error()) ==
        pipe + ": error: the reader closed the pipe: Broken pipe [SC6013]\n");
  CHECK_FALSE(fs::exists(pipe + ".part"));
}

}  // namespace softcnc::hal
