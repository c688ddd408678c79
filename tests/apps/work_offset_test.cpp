// SPDX-License-Identifier: MIT
// Programs that lie beside the travel of a machine: one error for each end, the offset that fits.
#include <algorithm>
#include <catch2/catch.hpp>

#include "apps/shell.hpp"
#include "settings/machine_memory.hpp"

using namespace softcnc::app::test;

namespace {

/// A router with soft limits, as grbl answers to $$: its travel is -300 to 0 mm, and -80 to 0.
const std::string kGrbl =
    "$20=1\n$22=1\n$100=250\n$101=250\n$102=250\n$110=3000\n$111=3000\n$112=600\n$120=200\n"
    "$121=200\n$122=50\n$130=300\n$131=300\n$132=80\n";

const std::string kPart =
    "G21 G90\nG0 Z5\nX0 Y0\nG1 Z-2 F200\nG1 X100 F400\nY60\nX0\nY0\nG0 Z5\nM2\n";

/// A folder with that router as mill.toml.
Folder& with_mill(Folder& folder) {
  write(folder / "grbl.txt", kGrbl);
  REQUIRE(
      call("machine import " + (folder / "grbl.txt") + " -o " + (folder / "mill.toml")).status ==
      0);
  return folder;
}

Ended check(const Folder& folder, const std::string& part, const std::string& options = {}) {
  write(folder / "p.nc", part);
  return shell("cd " + (folder / "") + "; $softcnc check --machine mill.toml p.nc " + options);
}

std::ptrdiff_t errors_in(const std::string& text) {
  std::ptrdiff_t count = 0;
  for (std::size_t at = 0; (at = text.find(": error: ", at)) != text.npos; ++at) ++count;
  return count;
}

/// The option that the advice names.
std::string advised(const std::string& text) {
  const std::size_t at = text.find("--work ");
  return at == text.npos ? std::string() : text.substr(at, text.find('\n', at) - at);
}

}  // namespace

TEST_CASE("a program beside the travel is one error an axis and side, with the offset that fits",
          "[apps][check][work]") {
  Folder folder;
  const Ended ended = check(with_mill(folder), kPart);
  CHECK(ended.status == 3);
  CHECK(errors_in(ended.out) == 3);
  CHECK(shows(ended.out,
              "p.nc:5:1: error: X reaches 100 mm, 100 mm beyond its travel from -300 to 0 mm... "
              "[SC4001]"));
  CHECK(shows(ended.out,
              "help: in G54 the program spans X 0 to 100 mm; it fits with the origin of G54 "
              "at X -300 to -100 mm (now 0), for example --work G54=-200,-180,-42"));
  const std::string option = advised(ended.out);
  const Ended fits = check(folder, kPart, option);
  CHECK(fits.status == 0);
  CHECK(fits.out.empty());
}

TEST_CASE("the ends of the origins that are named fit, and beyond them nothing does",
          "[apps][check][work]") {
  Folder folder;
  with_mill(folder);
  CHECK(check(folder, kPart, "--work G54=-300,-300,-78").status == 0);
  CHECK(check(folder, kPart, "--work G54=-100,-60,-5").status == 0);
  for (const char* origin : {"-300.01,-300,-78", "-300,-300.01,-78", "-300,-300,-78.01",
                             "-99.99,-60,-5", "-100,-59.99,-5", "-100,-60,-4.99"})
    CHECK(errors_in(check(folder, kPart, std::string("--work G54=") + origin).out) == 1);
}

TEST_CASE("a raster wider than the travel is one error an end, and no offset is advised",
          "[apps][check][work]") {
  Folder folder;
  with_mill(folder);
  std::string raster = "G21 G90 G0 Z-5\nX-200 Y-200\nG1 F500\n";
  for (int i = 0; i < 99; ++i)
    raster +=
        "X" + std::string(i % 2 == 0 ? "150" : "-200") + "\nY" + std::to_string(i - 200) + "\n";
  const Ended ended = check(folder, raster + "M2\n");
  CHECK(errors_in(ended.out) == 1);
  CHECK(shows(ended.out, "; 50 lines leave it there, this one first [SC4001]"));
  CHECK(shows(ended.out, "which is 350 mm: more than the travel of 300 mm, wherever G54 lies"));
  CHECK(advised(ended.out).empty());
}

TEST_CASE("no offset is advised that would change nothing", "[apps][check][work]") {
  Folder folder;
  with_mill(folder);
  const std::string in_machine = check(folder, "G21 G90 G53 G0 X10\nM2\n").out;
  CHECK(errors_in(in_machine) == 1);
  CHECK(advised(in_machine).empty());
  const std::string sets_its_own = check(folder, "G21 G90 G10 L2 P1 X-5\nG0 X10\nM2\n").out;
  CHECK(errors_in(sets_its_own) == 1);
  CHECK(advised(sets_its_own).empty());
}

TEST_CASE("what is advised fits, wherever the program begins", "[apps][check][work]") {
  Folder folder;
  with_mill(folder);
  // Where the machine stands already, X0 moves nothing.
  const std::string part = "G21 G90\nG0 X0\nG1 X290 F500\nM2\n";
  const std::string out = check(folder, part).out;
  CHECK(shows(out,
              "in G54 the program spans X 0 to 290 mm; it fits with the origin of G54 at X -300 "
              "to -290 mm"));
  CHECK(check(folder, part, advised(out)).status == 0);
  for (const char* never :
       {"G21 G91\nG1 X90 F500\nM2\n", "G21 G90\nG92 X0 Y0 Z0\nG1 X90 F500\nM2\n",
        "G21 G90\nG10 L2 P1 X0 Y0 Z0\nG1 X90 F500\nM2\n", "G21 G90 G17\nG2 X0 Y0 I50 J0 F500\nM2\n",
        "G21 G90\nG0 X0.0005\nX300.0005\nM2\n"}) {
    const Ended ended = check(folder, never);
    CHECK(ended.status == 3);
    CHECK(advised(ended.out).empty());
  }
}

TEST_CASE("the advice is on the work system that leaves the travel", "[apps][check][work]") {
  Folder folder;
  with_mill(folder);
  const std::string part = "G21 G90 G54 G0 X-10 Y-10 Z-10\nG56 X20\nG54 X-20\nM2\n";
  const std::string option = advised(check(folder, part).out);
  CHECK(option.starts_with("--work G56="));
  CHECK(check(folder, part, option).status == 0);
  const std::string further = "G21 G90 G54.1 P7\nG0 X20 Y-1 Z-1\nM2\n";
  const std::string other = advised(check(folder, further).out);
  CHECK(other.starts_with("--work G54.1P7="));
  CHECK(check(folder, further, other).status == 0);
}

TEST_CASE("an origin by --work is on top of the state, and is kept with it", "[apps][work]") {
  const Folder folder;
  write(folder / "p.nc", "G21 G90\nG0 X1 Y2 Z3\nX0\nM2\n");
  const auto run = [&](const std::string& options) {
    return shell("cd " + (folder / "") + "; $softcnc run -q p.nc --state s.toml " + options);
  };
  CHECK(run("--work G54=10,20,-30").status == 0);
  const std::string blocks =
      shell("cd " + (folder / "") + "; $softcnc blocks p.nc --state s.toml").out;
  CHECK(shows(blocks, "\"to\":[11,22,-27]"));
  CHECK(run("--work G54=,,7").status == 0);
  CHECK(shows(read(folder / "s.toml"), "x_mm = 10\ny_mm = 20\nz_mm = 7\n"));
}

TEST_CASE("texts of --work", "[apps][work]") {
  using softcnc::app::parse_work_origin;
  const auto all = parse_work_origin("G55=1.5,-2,+3");
  REQUIRE(all);
  CHECK(all->system == 1);
  CHECK(all->origin == decltype(all->origin){1.5, -2, 3});
  CHECK(parse_work_origin("g59.3=1")->system == 8);
  CHECK(parse_work_origin("G54.1P300=,,1")->system == 308);
  CHECK(parse_work_origin("G54.1 P2=1")->system == 10);
  for (const char* wrong : {"", "G54", "G54=", "=1", "G53=1", "G60=1", "G54=1,2,3,4", "G54=1;2",
                            "G54=a", "G54=nan", "G54=1e9", "G54.1P0=1", "G54.1P301=1", "G54=1 ,2"})
    CHECK_FALSE(parse_work_origin(wrong).has_value());
  CHECK(shows(call("check p.nc --work G53=1").err, "--work: takes SYSTEM=X,Y,Z... not 'G53=1'"));
}
