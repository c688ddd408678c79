// SPDX-License-Identifier: MIT
// Files are the old ones or the new ones, whole, however a command ends; and one run at a time has
// a state file.
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

#include "apps/shell.hpp"
#include "hal/files/file_lock.hpp"
#include "hal/machine/state_file.hpp"
#include "process/out_of_memory.hpp"

using namespace softcnc;
using namespace softcnc::app;
using namespace softcnc::app::test;

namespace {

using Names = std::vector<std::string>;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kAddressSanitized = true;  // the sanitizer's own memory is beyond any limit
#elif defined(__has_feature)
constexpr bool kAddressSanitized = __has_feature(address_sanitizer);
#else
constexpr bool kAddressSanitized = false;
#endif

void write_long(const Folder& folder) {
  std::string part = "G10 L2 P1 X1\nG90 G00 X0 Y100\nG02 F6000\n";
  for (int i = 0; i < 8; ++i) part += "I50\n";
  write(folder / "long.nc", part + "M30\n");
}

Ended in(const Folder& folder, const std::string& command) {
  return shell("cd " + (folder / "") + "; " + command);
}

}  // namespace

TEST_CASE("files of a user under the names of old are left alone", "[apps][files]") {
  const Folder folder;
  write(folder / "p.nc", "G21 G90\nG1 X1 F600\nM2\n");
  write(folder / "out.csv.part", "mine");
  write(folder / "victim.txt", "mine");
  std::filesystem::create_symlink("victim.txt", folder / "y.csv.part");
  CHECK(in(folder, "$softcnc run -q p.nc --trace out.csv && $softcnc run -q p.nc --trace y.csv")
            .status == 0);
  CHECK(read(folder / "out.csv.part") == "mine");
  CHECK(read(folder / "victim.txt") == "mine");
  CHECK_FALSE(std::filesystem::is_symlink(folder / "y.csv"));
}

TEST_CASE("a state file keeps its mode", "[apps][files][state]") {
  const Folder folder;
  write(folder / "p.nc", "G10 L2 P1 X1\nM2\n");
  write(folder / "s.toml", "schema = 1\n");
  CHECK(in(folder, "chmod 600 s.toml; $softcnc run -q p.nc --state s.toml").status == 0);
  CHECK(hal::load_state(folder / "s.toml"));
  CHECK(std::filesystem::status(folder / "s.toml").permissions() == std::filesystem::perms(0600));
}

TEST_CASE("a file beyond the limit of sizes is status 5, and the old ones stay", "[apps][files]") {
  const Folder folder;
  write_long(folder);
  const Names old{"a.rec", "e.vcd", "r.json", "s.toml", "t.csv", "t.npz"};
  for (const std::string& name : old) write(folder / name, "schema = 1\n");
  const std::string edges = "--backend stepdir --set backend.stepdir.file=e.vcd ";
  const Names commands{
      "run -q long.nc --state s.toml --trace t.csv", "run -q long.nc --state s.toml " + edges,
      "run -q long.nc --trace t.csv " + edges,       "run -q long.nc --trace t.npz",
      "run --dry-run -q long.nc --trace t.csv",      "record -q long.nc -o a.rec"};
  for (const std::string& command : commands) {
    CAPTURE(command);
    const Ended ended = in(folder, "ulimit -f 64; $softcnc " + command);
    CHECK(ended.status == 5);
    CHECK(ended.err.find(": File too large [SC60") != std::string::npos);
    for (const std::string& name : old)
      if (name != "s.toml") CHECK(read(folder / name) == "schema = 1\n");
    CHECK(folder.files() ==
          Names{"a.rec", "e.vcd", "long.nc", "r.json", "s.toml", "t.csv", "t.npz"});
  }
}

TEST_CASE("a run that fails leaves the old trace", "[apps][files]") {
  const Folder folder;
  write(folder / "bad.nc", "G1 X1 F600\nX1e\nM2\n");
  write(folder / "t.csv", "old\n");
  CHECK(in(folder, "$softcnc run --dry-run -q bad.nc --trace t.csv").status == 1);
  CHECK(read(folder / "t.csv") == "old\n");
  CHECK(in(folder, "$softcnc run -q bad.nc --trace t.csv").status == 1);
  CHECK(read(folder / "t.csv") == "old\n");
  CHECK(folder.files() == Names{"bad.nc", "t.csv"});
  // What has gone down a pipe has gone.
  CHECK(in(folder, "$softcnc run --dry-run -q bad.nc | wc -l").out.size() > 2);
}

TEST_CASE("what a killed run leaves is named and removed by the next one", "[apps][files]") {
  const Folder folder;
  write_long(folder);
  const std::string all =
      " long.nc --trace t.csv --state s.toml --backend stepdir --set backend.stepdir.file=e.vcd";
  const Ended killed =
      in(folder, "$softcnc run -q --realtime" + all +
                     " & pid=$!; until ls .t.csv.softcnc-* .e.vcd.softcnc-* "
                     ">/dev/null 2>&1; do sleep 0.02; done; kill -9 $pid; wait $pid");
  CHECK(killed.status == 137);
  CHECK(folder.files().size() == 6);  // three of the run, its lock, the mark, and the program
  CHECK(in(folder, "$softcnc run -q" + all).status == 4);
  CHECK(in(folder, "$softcnc state set position X0 Y0 Z0 --state s.toml").status == 0);
  const Ended next = in(folder, "$softcnc run -q" + all);
  CHECK(next.status == 0);
  std::size_t notes = 0;
  for (std::size_t at = 0; (at = next.err.find("[SC6016]", at)) != std::string::npos; ++at) ++notes;
  CHECK(notes == 0);  // the run before, which was refused, has said so
  CHECK(folder.files() == Names{"e.vcd", "long.nc", "s.toml", "t.csv"});
  CHECK(in(folder, "$softcnc run -q" + all).err.find("SC6016") == std::string::npos);
}

TEST_CASE("a second signal leaves neither a half-written file nor a lock", "[apps][files]") {
  const Folder folder;
  write_long(folder);
  write(folder / "s.toml", "schema = 1\n");
  const Ended ended = in(folder,
                         "$softcnc run -q --realtime long.nc --trace t.csv --state s.toml & "
                         "pid=$!; until ls .t.csv.softcnc-* >/dev/null 2>&1; do sleep 0.02; done; "
                         "sleep 0.2; for i in 1 2 3 4 5 6; do kill -TERM $pid; sleep 0.04; done; "
                         "wait $pid");
  CHECK(ended.status == 143);
  CHECK(folder.files() == Names{"long.nc", "s.toml"});
  CHECK(read(folder / "s.toml").find("in_motion = \"yes\"\n") != std::string::npos);
}

TEST_CASE("a run that goes on keeps what it writes from the next one", "[apps][files]") {
  const Folder folder;
  write_long(folder);
  write(folder / "short.nc", "G1 X1 F600\nM2\n");
  const Ended both = in(folder,
                        "$softcnc run -q --realtime long.nc --trace t.csv & pid=$!; until ls "
                        ".t.csv.softcnc-* >/dev/null 2>&1; do sleep 0.02; done; "
                        "$softcnc run -q short.nc --trace t.csv || exit 9; cp t.csv short.csv; "
                        "kill -TERM $pid; wait $pid");
  CHECK(both.status == 143);
  CHECK(both.err.find("SC6016") == std::string::npos);
  CHECK(folder.files() == Names{"long.nc", "short.csv", "short.nc", "t.csv"});
  CHECK(read(folder / "t.csv") != read(folder / "short.csv"));
}

TEST_CASE("nothing is left in the folder for temporary files", "[apps][files]") {
  const Folder folder, temporary;
  write_long(folder);
  const std::string there = "export TMPDIR=" + (temporary / "") + "; ";
  CHECK(in(folder, there + "$softcnc record -q long.nc -o a.rec").status == 0);
  CHECK(in(folder, there + "$softcnc run -q long.nc --trace a.npz").status == 0);
  CHECK(in(folder, there + "$softcnc replay -q a.rec").status == 0);
  CHECK(temporary.files().empty());
  for (const std::string command :
       {"record -q --realtime long.nc -o b.rec", "run -q --realtime long.nc --trace b.npz"}) {
    CAPTURE(command);
    const Ended killed =
        in(folder, there + "$softcnc " + command + " & sleep 0.6; kill -9 $!; wait $!");
    CHECK(killed.status == 137);
    CHECK(temporary.files().empty());
  }
  for (int most = 4; most < 12; ++most) {
    in(folder, there + "ulimit -n " + std::to_string(most) + "; $softcnc replay -q a.rec");
    CHECK(temporary.files().empty());
  }
}

TEST_CASE("out of memory is status 5 with a text, and files stay", "[apps][files]") {
  if (kAddressSanitized) return;
  const Folder folder;
  std::string part;
  for (int i = 0; i < 400'000; ++i) part += "#<name_" + std::to_string(i) + ">=1\n";
  write(folder / "p.nc", part + "M2\n");
  write(folder / "t.csv", "old\n");
  for (const std::string command :
       {"check p.nc", "run -q p.nc --trace t.csv", "blocks p.nc",
        "run -q --dry-run p.nc --trace t.csv", "record -q p.nc -o t.csv"}) {
    CAPTURE(command);
    const Ended ended = in(folder, "ulimit -v 48000; $softcnc " + command);
    CHECK(ended.status == 5);
    CHECK((ended.out + ended.err).find("softcnc: error: out of memory [SC6004]\n") !=
          std::string::npos);
    CHECK(read(folder / "t.csv") == "old\n");
  }
  CHECK(folder.files() == Names{"p.nc", "t.csv"});
}

TEST_CASE("what the system has no more of is named, and nothing else", "[apps][files]") {
  const auto again = std::make_error_code(std::errc::resource_unavailable_try_again);
  CHECK(lacking_resource(std::bad_alloc()) == "out of memory");
  CHECK(lacking_resource(std::system_error(again)) ==
        "no more memory or threads: Resource temporarily unavailable");
  CHECK(lacking_resource(std::system_error(std::make_error_code(std::errc::io_error))).empty());
  CHECK(lacking_resource(std::runtime_error("a defect")).empty());
}

TEST_CASE("a state file that a run has is refused to another, before anything moves",
          "[apps][files][state]") {
  const Folder folder;
  write(folder / "p.nc", "G10 L2 P1 X1\nM2\n");
  {
    const auto lock = hal::FileLock::take(folder / "s.toml");
    REQUIRE(lock);
    const Ended ended = in(folder, "$softcnc run p.nc --state s.toml --trace t.csv");
    CHECK(ended.status == 5);
    CHECK(ended.err ==
          "s.toml: error: is in use by process " + std::to_string(::getpid()) + " [SC6017]\n");
    for (const std::string reader : {"check", "blocks", "run -q --dry-run", "record -q -o a.rec"})
      CHECK(in(folder, "$softcnc " + reader + " p.nc --state s.toml").status == 0);
  }
  CHECK(in(folder, "$softcnc run -q p.nc --state s.toml").status == 0);
  CHECK(folder.files() == Names{"a.rec", "p.nc", "s.toml"});
}

TEST_CASE("of 52 changes by four that run at once none is lost", "[apps][files][state]") {
  const Folder folder;
  constexpr int kRuns = 4, kChanges = 13;
  std::string state = "schema = 1\n[parameter]\n";
  for (int run = 0; run < kRuns; ++run)
    for (int i = 0; i < kChanges; ++i) {
      const std::string number = std::to_string(100 * (run + 1) + i);
      write(folder / ("p" + number + ".nc"), "#" + number + "=" + number + "\nG1 X1 F6000\nM2\n");
      state += number + " = -1\n";
    }
  write(folder / "s.toml", state);
  const Ended ended =
      in(folder,
         "for run in 1 2 3 4; do for i in 00 01 02 03 04 05 06 07 08 09 10 11 12; do "
         "until $softcnc run -q p$run$i.nc --state s.toml --trace t.csv 2>err$run$i; do "
         "grep -q SC6017 err$run$i || exit 9; sleep 0.01; done; done & pids=\"$pids $!\"; done; "
         "for pid in $pids; do wait $pid || exit 9; done");
  CHECK(ended.status == 0);
  const auto kept = hal::load_state(folder / "s.toml");
  REQUIRE(kept);
  int changes = 0;
  for (const auto& [number, value] : kept->parameters) changes += value == number ? 1 : 0;
  CHECK(changes == kRuns * kChanges);
}
