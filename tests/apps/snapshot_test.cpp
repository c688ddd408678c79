// SPDX-License-Identifier: MIT
// What moves is what has been checked, whatever is written into the files in between.
#include <catch2/catch.hpp>

#include "apps/shell.hpp"
#include "runtime/program/program.hpp"

using namespace softcnc;
using namespace softcnc::app;
using namespace softcnc::app::test;

namespace {

/// A main program whose motion takes longer than a pipe holds rows, and the subprogram that it
/// calls again and again; along one axis each.
void write_program(const Folder& folder, const std::string& axis) {
  std::string main = "G21 G90 G61 F600\n";
  for (int i = 0; i < 60; ++i) main += "G01 " + axis + (i % 2 == 0 ? "2\n" : "0\n") + "o<a> call\n";
  write(folder / "new.nc", main + "M2\n");
  write(folder / "new.ngc", "o<a> sub\nG04 P0.01\nG01 " + axis + "1\no<a> endsub\n");
}

/// Runs p.nc with a FIFO for its rows. The pre-flight is over when the FIFO is opened for writing:
/// then the files are changed in place, and the rest is read.
Ended run_changed(const Folder& folder, const std::string& command) {
  return shell("cd " + (folder / "") +
               "; rm -f rows; mkfifo rows; { exec 3<rows; cat new.nc >p.nc; cat new.ngc >a.ngc; "
               "cat <&3 >read; } & $softcnc " +
               command +
               " p.nc -q --backend hal-stream --set backend.hal-stream.file=rows; s=$?; wait; "
               "exit $s");
}

}  // namespace

TEST_CASE("a program that is rewritten while it runs moves as it was checked", "[apps][snapshot]") {
  const Folder folder;
  const auto begin_with = [&](const std::string& axis) {
    write_program(folder, axis);
    REQUIRE(shell("cd " + (folder / "") + "; cp new.nc p.nc; cp new.ngc a.ngc").status == 0);
  };
  begin_with("X");
  REQUIRE(run_changed(folder, "run").status == 0);
  const std::string unchanged = read(folder / "read");
  write_program(folder, "Y");
  REQUIRE(run_changed(folder, "run").status == 0);
  CHECK(read(folder / "read") == unchanged);
  CHECK(read(folder / "p.nc") == read(folder / "new.nc"));  // it was rewritten
  REQUIRE(run_changed(folder, "run").status == 0);
  CHECK(read(folder / "read") != unchanged);  // and that counts from the next run on

  begin_with("X");
  write_program(folder, "Y");
  REQUIRE(run_changed(folder, "record -o " + (folder / "p.rec")).status == 0);
  CHECK(read(folder / "read") == unchanged);
  const Ended replayed = call("replay " + (folder / "p.rec"));
  CHECK(replayed.status == 0);  // it holds what has run
  begin_with("X");
  CHECK(shell("cd " + (folder / "") +
              "; $softcnc record -q p.nc -o q.rec; unzip -p q.rec program "
              "called/a.ngc >q; unzip -p p.rec program called/a.ngc >p; cmp p q")
            .status == 0);
}

TEST_CASE("a program that is read more than once is what it was when it was opened",
          "[apps][snapshot]") {
  const Folder folder;
  const std::string name = folder / "p.nc";
  write(name, "G00 X1\nX2\n");
  auto program = runtime::Program::open(name);
  REQUIRE(program);
  write(name, "G00 Y1000\nY2000\n");
  ipr::Reader reader = program->reader();
  CHECK(reader.next() == "G00 X1");
  CHECK(program->line(2) == "X2");
  CHECK(program->line(1) == "G00 X1");
  CHECK(reader.next() == "X2");
  CHECK_FALSE(reader.next());
  std::string all;
  program->for_each_piece([&](std::string_view piece) { all += piece; });
  CHECK(all == "G00 X1\nX2\n");
}

TEST_CASE("where a long program cannot be kept, nothing moves", "[apps][snapshot]") {
  const Folder folder;
  std::string part = "G21 G90 F600\nG01 X1\n";
  write(folder / "short.nc", part + "M2\n");
  while (part.size() <= std::size_t{1} << 20) part += "(a comment that makes it longer)\n";
  write(folder / "long.nc", part + "M2\n");
  const std::string run = "cd " + (folder / "") + "; TMPDIR=/no/folder $softcnc run -q ";
  CHECK(shell(run + "short.nc --trace t.csv").status == 0);
  const Ended ended = shell(run + "long.nc --trace u.csv");
  CHECK(ended.status == 5);
  CHECK(shows(ended.err, "long.nc: error: cannot be kept in a temporary file: ... [SC6003]"));
  CHECK(folder.files() == std::vector<std::string>{"long.nc", "short.nc", "t.csv"});
  CHECK(shell("cd " + (folder / "") + "; TMPDIR=/no/folder $softcnc check long.nc").status == 0);
}
