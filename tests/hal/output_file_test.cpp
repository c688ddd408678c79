// SPDX-License-Identifier: MIT
// Files seen whole or not at all, and how writing fails.
#include "hal/files/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <climits>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <stop_token>

#include "hal/files/leftovers.hpp"
#include "hal/files/unfinished_file.hpp"
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
  const auto names = test::names_in(folder.path());
  REQUIRE(names.size() == 1);
  CHECK(names[0].starts_with(".out.txt.softcnc-"));
  CHECK(is_name_beside_target(folder / names[0]));
  REQUIRE((*output)->finish());
  CHECK(test::names_in(folder.path()) == test::Names{"out.txt"});
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
  CHECK(test::names_in(folder.path()) == test::Names{"out.txt"});
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

TEST_CASE("a symbolic link to nowhere is reported and stays", "[hal][output]") {
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

TEST_CASE("a full disk is reported", "[hal][output]") {
  const auto written = write_file("/dev/full", "x");
  REQUIRE_FALSE(written);
  CHECK(render(written.error()) ==
        "/dev/full: error: writing failed: No space left on device [SC6012]\n");
  CHECK(exit_status(written.error()) == 5);
}

TEST_CASE("what is no regular file is written directly", "[hal][output]") {
  CHECK(write_file("/dev/null", "x"));
  CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("a closed pipe can be distinguished from other failures", "[hal][output]") {
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
  CHECK(test::names_in(folder.path()) == test::Names{"pipe"});
}

TEST_CASE("two that write one file at a time do not meet", "[hal][output]") {
  const test::Folder folder;
  const std::string file = folder / "out.txt";
  auto first = OutputFile::open(file), second = OutputFile::open(file);
  REQUIRE(first);
  REQUIRE(second);
  REQUIRE((*first)->write("first"));
  REQUIRE((*second)->write("second"));
  REQUIRE((*second)->finish());
  CHECK(test::read(file) == "second");
  REQUIRE((*first)->finish());
  CHECK(test::read(file) == "first");
  CHECK(test::names_in(folder.path()) == test::Names{"out.txt"});
}

TEST_CASE("files of others beside the target stay as they are", "[hal][output]") {
  const test::Folder folder;
  test::write(folder / "out.csv.part", "mine");
  test::write(folder / "victim.txt", "mine");
  fs::create_symlink("victim.txt", folder / "y.csv.part");
  REQUIRE(write_file(folder / "out.csv", "rows"));
  REQUIRE(write_file(folder / "y.csv", "rows"));
  CHECK(test::read(folder / "out.csv.part") == "mine");
  CHECK(test::read(folder / "victim.txt") == "mine");
  CHECK(fs::is_symlink(folder / "y.csv.part"));
  CHECK(fs::is_regular_file(fs::symlink_status(folder / "y.csv")));
}

TEST_CASE("a file that replaces another has its mode, a new one that of the umask",
          "[hal][output]") {
  const test::Folder folder;
  const auto mode = [&](const std::string& name) {
    struct stat info {};
    REQUIRE(::stat((folder / name).c_str(), &info) == 0);
    return static_cast<int>(info.st_mode & 07777U);
  };
  const ::mode_t before = ::umask(027);
  REQUIRE(write_file(folder / "new", "x"));
  CHECK(mode("new") == 0640);
  for (const int kept : {0600, 0664, 0444, 0755}) {
    REQUIRE(::chmod((folder / "new").c_str(), static_cast<::mode_t>(kept)) == 0);
    REQUIRE(write_file(folder / "new", "y"));
    CHECK(mode("new") == kept);
  }
  fs::create_symlink("new", folder / "link");
  REQUIRE(::chmod((folder / "new").c_str(), 0600) == 0);
  REQUIRE(write_file(folder / "link", "z"));
  CHECK(mode("new") == 0600);
  ::umask(before);
}

TEST_CASE("while it is written, a file is open to nobody who may not read the old one",
          "[hal][output]") {
  const test::Folder folder;
  REQUIRE(write_file(folder / "new", "x"));
  REQUIRE(::chmod((folder / "new").c_str(), 0600) == 0);
  const auto output = OutputFile::open(folder / "new");
  REQUIRE(output);
  for (const std::string& name : test::names_in(folder.path()))
    CHECK((fs::status(folder / name).permissions() & fs::perms(0077)) == fs::perms::none);
}

TEST_CASE("a file that replaces another has its owner and group", "[hal][output]") {
  if (::geteuid() != 0) return;  // only root may give files away
  const test::Folder folder;
  REQUIRE(write_file(folder / "new", "x"));
  REQUIRE(::chown((folder / "new").c_str(), 1234, 4321) == 0);
  REQUIRE(write_file(folder / "new", "y"));
  struct stat info {};
  REQUIRE(::stat((folder / "new").c_str(), &info) == 0);
  CHECK(info.st_uid == 1234);
  CHECK(info.st_gid == 4321);
}

TEST_CASE("a name as long as names may be can be written", "[hal][output]") {
  const test::Folder folder;
  const std::string name(NAME_MAX, 'n');
  REQUIRE(write_file(folder / name, "x"));
  CHECK(test::names_in(folder.path()) == test::Names{name});
}

TEST_CASE("a name that no file can have is refused before anything is written", "[hal][output]") {
  const test::Folder folder;
  const auto open = OutputFile::open(folder / std::string(NAME_MAX + 1, 'n'));
  REQUIRE_FALSE(open);
  CHECK(open.error().code == Code::SC6011);
  CHECK(test::names_in(folder.path()).empty());
}

TEST_CASE("a pipe that nobody reads is given up once a stop is asked for", "[hal][output]") {
  const test::Folder folder;
  const std::string pipe = folder / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  std::stop_source stop;
  stop.request_stop();
  const auto nobody = OutputFile::open(pipe, {stop.get_token()});
  REQUIRE_FALSE(nobody);
  CHECK(nobody.error().code == Code::SC6011);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  REQUIRE(reader >= 0);
  const std::string much(1U << 20U, 'x');
  const auto after_stop = OutputFile::open(pipe, {stop.get_token()});
  REQUIRE(after_stop);
  CHECK((*after_stop)->write("taken"));
  CHECK((*after_stop)->write(much).error().message ==
        "writing failed: nobody reads what is written");
  std::stop_source none;
  const auto by_the_clock = OutputFile::open(pipe, {none.get_token(), 100});
  REQUIRE(by_the_clock);
  CHECK_FALSE((*by_the_clock)->write(much));
  ::close(reader);
}

TEST_CASE("leftovers of killed runs are named and removed", "[hal][output]") {
  const test::Folder folder;
  const std::string file = folder / "out.txt";
  const std::string left = folder / ".out.txt.softcnc-0a1b2c3d4e5f";
  test::write(left, "half");
  const test::Names others{".out.txt.softcnc-backup",
                           ".out.txt.softcnc-0a1b2c3d4e5",
                           ".out.txt.softcnc-0a1b2c3d4e5f7",
                           ".out.txt.softcnc-0a1b2c3d4e.f",
                           ".out.txt.softcnc-lock",
                           ".other.txt.softcnc-0a1b2c3d4e5f",
                           "out.txt.part"};
  for (const std::string& name : others) test::write(folder / name, "of others");
  fs::create_symlink("out.txt.part", folder / ".out.txt.softcnc-00112233aabb");
  fs::create_directory(folder / ".out.txt.softcnc-ccddeeff4455");
  fs::create_symlink("out.txt", folder / "link");
  const auto open = OutputFile::open(file);
  REQUIRE(open);
  const std::size_t before = test::names_in(folder.path()).size();
  const auto notes = remove_leftovers(folder / "link");
  REQUIRE(notes.size() == 1);
  CHECK(render(notes[0]) == left +
                                ": note: left unfinished by a run that was killed; it is removed "
                                "[SC6016]\n");
  CHECK(test::names_in(folder.path()).size() == before - 1);
  for (const std::string& name : others) CHECK(test::read(folder / name) == "of others");
  CHECK(remove_leftovers(file).empty());
  REQUIRE((*open)->finish());
  CHECK(remove_leftovers("-").empty());
  CHECK(remove_leftovers("").empty());
  CHECK(remove_leftovers("/dev/null").empty());
  CHECK(remove_leftovers("no/such/folder/x").empty());
}

}  // namespace softcnc::hal
