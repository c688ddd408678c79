// SPDX-License-Identifier: MIT
// check --watch: checks again when a file changes, however it is saved.
#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/shell.hpp"
#include "apps/talk.hpp"
#include "support/shown.hpp"

using namespace softcnc::app::test;

namespace {

const std::string kGood = "G00 X1\nM30\n", kBad = "G00 X1.2.3\nM30\n";
const std::string kNothing = "--- 0 errors, 0 warnings, 0 notes; watching";
const std::string kOne = "--- 1 error, 0 warnings, 0 notes; watching";

}  // namespace

TEST_CASE("a program is checked again when it changes, until Ctrl-C", "[apps][watch]") {
  const Folder folder;
  const std::string part = folder / "p.nc";
  write(part, kGood);
  Talk talk({"check", "--watch", part});
  CHECK(talk.hear("---") == std::vector<std::string>{kNothing});

  write(part, kBad);
  const auto told = talk.hear("---");
  CHECK(begins_showing(told.front(), part + ":1:6: error: ... [SC1004]"));
  CHECK(told.back() == kOne);

  write(folder / "p.nc~", kGood);  // as editors save
  std::filesystem::rename(folder / "p.nc~", part);
  CHECK(talk.hear("---") == std::vector<std::string>{kNothing});

  std::filesystem::remove(part);
  CHECK(begins_showing(talk.hear("---").front(), part + ": error: ... [SC6001]"));
  write(part, kGood);
  CHECK(talk.hear("---").back() == kNothing);

  talk.send(SIGINT);
  CHECK(talk.status() == 130);
}

TEST_CASE("a program is found again where its folder is made again", "[apps][watch]") {
  const Folder folder;
  const std::filesystem::path parts = folder / "parts";
  std::filesystem::create_directory(parts);
  const std::string part = parts / "p.nc";
  write(part, kGood);
  Talk talk({"check", "--watch", part});
  CHECK(talk.hear("---").back() == kNothing);
  std::filesystem::remove_all(parts);
  CHECK(begins_showing(talk.hear("---").front(), part + ": error: ... [SC6001]"));
  std::filesystem::create_directory(parts);
  write(part, kBad);
  CHECK(talk.hear("---").back() == kOne);
  write(part, kGood);
  CHECK(talk.hear("---").back() == kNothing);
  std::filesystem::rename(parts, folder / "away");
  CHECK(begins_showing(talk.hear("---").front(), part + ": error: ... [SC6001]"));
  std::filesystem::rename(folder / "away", parts);
  CHECK(talk.hear("---").back() == kNothing);
  talk.send(SIGINT);
  CHECK(talk.status() == 130);
}

TEST_CASE("a program is checked where a link leads to now", "[apps][watch]") {
  const Folder folder;
  const std::filesystem::path there = folder / "there";
  std::filesystem::create_directory(there);
  write(there / "a.nc", kGood);
  write(there / "b.nc", kBad);
  const std::string part = folder / "p.nc";
  write(part, kGood);
  Talk talk({"check", "--watch", part});
  CHECK(talk.hear("---").back() == kNothing);
  std::filesystem::create_symlink(there / "b.nc", folder / "link");
  std::filesystem::rename(folder / "link", part);
  CHECK(talk.hear("---").back() == kOne);
  write(there / "b.nc", kGood);
  CHECK(talk.hear("---").back() == kNothing);
  std::filesystem::create_symlink(there / "a.nc", folder / "link");
  std::filesystem::rename(folder / "link", part);
  CHECK(talk.hear("---").back() == kNothing);
  write(there / "a.nc", kBad);
  CHECK(talk.hear("---").back() == kOne);
  talk.send(SIGINT);
  CHECK(talk.status() == 130);
}

TEST_CASE("programs are checked again when their machine or state changes", "[apps][watch]") {
  const Folder folder;
  write(folder / "p.nc", "G00 X10\nM30\n");
  write(folder / "m.toml", "");
  write(folder / "s.toml", "schema = 1\n");
  Talk talk({"check", "--watch", folder / "p.nc", "--machine", folder / "m.toml", "--state",
             folder / "s.toml"});
  talk.hear(kNothing);
  write(folder / "m.toml", "[axis.x]\nmax_mm = 5\n");
  CHECK(talk.hear("---").back() == kOne);
  write(folder / "m.toml", "[axis.x]\nmax_mm = 15\n");
  CHECK(talk.hear("---").back() == kNothing);
  write(folder / "s.toml", "schema = 1\n[work.G54]\nx_mm = 10\n");
  CHECK(talk.hear("---").back() == kOne);
  talk.send(SIGTERM);
  CHECK(talk.status() == 143);
}

TEST_CASE("a program is checked again when a file changes that it calls", "[apps][watch]") {
  const Folder folder;
  write(folder / "p.nc", "M98 P5\nM30\n");
  write(folder / "5.nc", "O5\nG00 X10\nM99\n");
  Talk talk({"check", "--watch", folder / "p.nc"});
  CHECK(talk.hear("---").back() == kNothing);
  write(folder / "5.nc", "O5\nG00 X1.0.0\nM99\n");
  CHECK(talk.hear("---").back() == kOne);
  talk.send(SIGINT);
  CHECK(talk.status() == 130);
}

TEST_CASE("a program is checked again when a file appears that it calls", "[apps][watch]") {
  const Folder folder;
  write(folder / "p.nc", "M98 P123\nM30\n");
  Talk talk({"check", "--watch", folder / "p.nc"});
  CHECK(shows(talk.hear("---").front(), "error: no subprogram O123 in ... [SC2301]"));
  write(folder / "124.ngc", "G00 X10\nM99\n");  // of another number: nothing is reported of it
  write(folder / "123.ngc", "G00 X10\nM99\n");
  CHECK(talk.hear("---") == std::vector<std::string>{kNothing});
  write(folder / "O0123.nc", "G00 X1.0.0\nM99\n");  // which is looked for before the other
  CHECK(shows(talk.hear("---").front(), "O0123.nc:1:6: error: ... [SC1004]"));
  std::filesystem::remove(folder / "O0123.nc");
  CHECK(talk.hear("---") == std::vector<std::string>{kNothing});
  talk.send(SIGINT);
  CHECK(talk.status() == 130);
}

TEST_CASE("each round is a document of its own where that is asked for", "[apps][watch]") {
  const Folder folder;
  write(folder / "p.nc", kGood);
  Talk talk({"check", "--watch", "--diagnostics", "json", folder / "p.nc"});
  CHECK(talk.hear("[]").size() == 1);
  write(folder / "p.nc", kBad);
  std::string document;
  for (const std::string& line : talk.hear("]")) document += line;
  CHECK(nlohmann::json::parse(document)[0]["code"] == "SC1004");
}

TEST_CASE("what cannot be watched is reported", "[apps][watch]") {
  const Ended folder = call("check --watch no/p.nc");
  CHECK(folder.status == 5);
  CHECK(folder.err == "no/p.nc: error: cannot be watched: No such file or directory [SC6041]\n");
  const Ended input = call("check --watch -");
  CHECK(input.status == 2);
  CHECK(input.err.starts_with("--watch cannot watch standard input\n"));
}
