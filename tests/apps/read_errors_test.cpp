// SPDX-License-Identifier: MIT
// A file that fails while it is read is an error, and never one that ends there.
#include <catch2/catch.hpp>

#include "apps/shell.hpp"

using namespace softcnc::app::test;

namespace {

/// Reading its first page is an input/output error, as on a disk that is about to go.
constexpr const char* kBroken = "/proc/self/mem";

}  // namespace

TEST_CASE("an error of input is no end of file", "[apps][files]") {
  const Folder folder;
  write(folder / "p.nc", "G21 G90\nG01 X1 F600\nM30\n");
  const auto status_of = [&](const std::string& arguments) {
    const Ended ended =
        shell("cd " + (folder / "") + "; timeout 20 $softcnc " + arguments + " 2>&1");
    CAPTURE(arguments, ended.out);
    CHECK(ended.out.find("Input/output error") != std::string::npos);
    return ended.status;
  };
  const std::string broken = kBroken;
  for (const std::string command : {"check ", "run ", "run --dry-run ", "blocks ",
                                    "record -o x.rec ", "surface -o x.png ", "compare "})
    CHECK(status_of(command + broken) == 5);
  CHECK(status_of("run p.nc --machine " + broken) == 2);
  CHECK(status_of("check p.nc --state " + broken) == 2);
  CHECK(status_of("pulses " + broken) == 5);
  CHECK(call("replay " + broken).status == 5);
  CHECK(folder.files() == std::vector<std::string>{"p.nc"});
}

TEST_CASE("a called file that fails while it is read is an error", "[apps][files]") {
  const Folder folder;
  write(folder / "p.nc", "G21 G90\no<sub> call\nM30\n");
  REQUIRE(shell("ln -s /proc/self/mem " + (folder / "sub.ngc")).status == 0);
  const Ended ended = shell("timeout 20 $softcnc check " + (folder / "p.nc"));
  CHECK(ended.status != 0);
  CHECK(ended.out.find(": error: ") != std::string::npos);
}
