// SPDX-License-Identifier: MIT
// M codes, outputs and inputs of a machine file, from outside.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "shell.hpp"

namespace softcnc::app::test {
namespace {

using nlohmann::json;

const std::string kMachine =
    "[mcode.31]\ndo = \"output\"\noutput = \"pump\"\nvalue = 1\n[mcode.88]\ndo = \"coolant\"\n"
    "coolant = \"mist\"\n[mcode.110]\ndo = \"stop\"\n[output.pump]\nnumber = "
    "2\n[output.lamp]\nkind "
    "= \"analog\"\n[input.door]\nlines = [3]\nvalues = [1]\nafter_s = [0.3]\n";

/// A folder with p.nc and its machine p.toml.
struct Part {
  explicit Part(const std::string& program, const std::string& machine = kMachine) {
    write(folder / "p.nc", program);
    write(folder / "p.toml", machine);
  }
  std::string file() const { return folder / "p.nc"; }
  Folder folder;
};

}  // namespace

TEST_CASE("blocks shows outputs and M codes of the machine", "[apps][outputs]") {
  const Part part("M31\nM68 E0 Q2.5\nM88\nM110\nM62 P2\nG0 X1\nM2\n");
  const Ended ended = call("blocks " + part.file());
  CHECK(ended.status == 0);
  CHECK(ended.out ==
        "{\"line\":1,\"block\":1,\"kind\":\"output\",\"code\":31,\"output\":\"pump\",\"signal\":"
        "\"digital\",\"number\":2,\"value\":1}\n"
        "{\"line\":2,\"block\":2,\"kind\":\"output\",\"code\":68,\"output\":\"lamp\",\"signal\":"
        "\"analog\",\"number\":0,\"value\":2.5}\n"
        "{\"line\":3,\"block\":3,\"kind\":\"coolant\",\"code\":88,\"coolant\":\"mist\"}\n"
        "{\"line\":4,\"block\":4,\"kind\":\"stop\",\"code\":110}\n"
        "{\"line\":5,\"block\":5,\"kind\":\"output\",\"code\":62,\"output\":\"pump\",\"signal\":"
        "\"digital\",\"number\":2,\"value\":1}\n"
        "{\"line\":6,\"block\":6,\"kind\":\"rapid\",\"from\":[0,0,0],\"to\":[1,0,0]}\n"
        "{\"line\":7,\"block\":7,\"kind\":\"end\",\"code\":2}\n");
}

TEST_CASE("the report has each output with its time", "[apps][outputs]") {
  // A rapid of 10 mm at 1000 mm/s^2 from rest to rest takes 0.2 s, and the input comes after 0.3 s.
  const Part part("G0 X10\nM31\nM66 P0 L3 Q5\nM68 E0 Q-1.5\nM62 P2 X[20+#5399]\nM63 P2\nM2\n");
  const Ended ended = call("run --dry-run -q --trace /dev/null --report " +
                           (part.folder / "r.json") + " " + part.file());
  INFO(ended.err);
  REQUIRE(ended.status == 0);
  const json report = json::parse(read(part.folder / "r.json"));
  const json& outputs = report["outputs"];
  REQUIRE(outputs.size() == 3);
  CHECK(outputs[0]["line"] == 2);
  CHECK(outputs[0]["output"] == "pump");
  CHECK(outputs[0]["value"] == 1);
  CHECK(outputs[0]["t_s"].get<double>() == Approx(0.2).epsilon(1e-3));
  CHECK(outputs[1]["line"] == 4);
  CHECK(outputs[1]["output"] == "lamp");
  CHECK(outputs[1]["value"] == -1.5);
  CHECK(outputs[1]["t_s"].get<double>() == Approx(0.5).epsilon(1e-3));
  CHECK(outputs[2]["line"] == 5);
  CHECK(outputs[2]["t_s"] == outputs[1]["t_s"]);
  CHECK(report["length_mm"].get<double>() == Approx(21));
  CHECK_FALSE(report.contains("outputs_left_out"));
}

TEST_CASE("without outputs of the machine the report has none", "[apps][outputs]") {
  const Part part("G0 X10\nM2\n", "");
  const Ended ended = call("run --dry-run -q --trace /dev/null --report " +
                           (part.folder / "r.json") + " " + part.file());
  REQUIRE(ended.status == 0);
  CHECK_FALSE(json::parse(read(part.folder / "r.json")).contains("outputs"));
}

TEST_CASE("check reads the M codes and inputs of the machine", "[apps][outputs]") {
  const Part good("M31\nG0 X1\nM66 P0 L3 Q1\nM110\nM2\n");
  CHECK(call("check " + good.file()).status == 0);
  const Part bad("M32 P1\nM64 P9\nM2\n");
  const Ended ended = call("check " + bad.file());
  CHECK(ended.status == 1);
  CHECK(ended.out.find("p.nc:1:1: error: M32 is not supported; if the machine has it, its machine "
                       "file says so in three lines: [mcode.32] | do = \"ignore\" | words = \"P\" "
                       "[SC2001]") != std::string::npos);
  CHECK(ended.out.find("p.nc:2:5: error: M64 sets digital output 9, which the machine does not "
                       "have [SC2240]") != std::string::npos);
}

TEST_CASE("a recording keeps the M codes and inputs of its machine", "[apps][outputs]") {
  const Part part("M31\nG0 X1\nM66 P0 L3 Q1\nX[3+#5399]\nM110\nM2\n");
  const std::string recording = part.folder / "p.rec";
  REQUIRE(call("record -q " + part.file() + " -o " + recording).status == 0);
  CHECK(call("replay -q " + recording).status == 0);
}

TEST_CASE("a backend that sets no outputs reports that once", "[apps][outputs]") {
  const Part part("M31\nM64 P2\nG0 X1\nM65 P2\nM2\n");
  const std::string run = "run --set backend.stepdir.file=" + (part.folder / "s.vcd") + " ";
  const Ended ended = call(run + "--backend stepdir " + part.file());
  CHECK(ended.status == 0);
  const std::string note =
      "note: the program sets outputs 3 times, which backend stepdir does not pass on [SC5050]";
  const std::size_t at = ended.err.find(note);
  CHECK(at != std::string::npos);
  CHECK(ended.err.find("SC5050", at + note.size()) == std::string::npos);
  CHECK(call(run + "--backend sim " + part.file()).err.find("SC5050") == std::string::npos);
}

}  // namespace softcnc::app::test
