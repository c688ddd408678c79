// SPDX-License-Identifier: MIT
// Probing moves against bodies that the machine file states: closed forms of a ball and a box.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "ipr/interpret.hpp"
#include "motion/model/contact.hpp"

using namespace softcnc;
using namespace softcnc::ipr;

namespace {

constexpr double kRadius = 2;

/// A block of 40 x 30 x 10 mm below Z-20, and a probe with a ball of 4 mm.
Machine machine_with_block() {
  Machine machine;
  machine.probe.radius = kRadius;
  machine.contacts["block"] = {AxisVector(10, 20, -30), AxisVector(50, 50, -20)};
  return machine;
}

std::vector<AxisVector> ends_of(const std::string& text, const Machine& machine,
                                const InterpreterOptions& options = {}) {
  std::vector<AxisVector> ends;
  for (const Move& move : moves_of(text, machine, options)) ends.push_back(end(move.path));
  return ends;
}

bool is_near_to(const AxisVector& a, const AxisVector& b) { return (a - b).norm() < 1e-7; }

}  // namespace

TEST_CASE("a probing move ends at the contact, and the program knows where", "[ipr][probing]") {
  const Machine machine = machine_with_block();
  // down onto the top: the lowest point of the ball touches
  auto ends = ends_of("G0 X20 Y30\nG38.2 Z-50 F100\nG0 Z[#5063+5] X#5061\nM2\n", machine);
  REQUIRE(ends.size() == 3);
  CHECK(is_near_to(ends[1], {20, 30, -20}));
  CHECK(is_near_to(ends[2], {20, 30, -15}));
  // beside it, towards its left face
  ends = ends_of("G0 Y30\nZ-28\nG38.3 X100 F100\nG0 X[#5061-10] Y#5070\nM2\n", machine);
  CHECK(is_near_to(ends[2], {10 - kRadius, 30, -28}));
  CHECK(is_near_to(ends[3], {-2, 1, -28}));
  // off it again
  ends = ends_of("G0 Y30\nZ-28\nG38.2 X30 F100\nG1 X9.5\nG38.4 X-30\nM2\n", machine);
  CHECK(is_near_to(ends.back(), {10 - kRadius, 30, -28}));
}

TEST_CASE("the contact is reported in the work system and the units of the program",
          "[ipr][probing]") {
  const Machine machine = machine_with_block();
  const auto fanuc = ends_of(
      "G10 L2 P1 X5. Y6. Z7.\nG0 X15. Y24.\nG31 Z-50. F100\nG53 G0 X#5061 "
      "Y#5062\nZ[#5063+1.]\nM30\n",
      machine, kFanuc);
  REQUIRE(fanuc.size() == 4);
  CHECK(is_near_to(fanuc[1], {20, 30, -20}));
  CHECK(is_near_to(fanuc[2], {15, 24, -20}));
  CHECK(is_near_to(fanuc[3], {15, 24, -19}));
  const auto ends = ends_of(
      "G10 L2 P1 X5 Y6 Z7 R90\nG54 G20\nG0 X1 Y-1\nG38.2 Z-2 F10\nG53 G0 X#5061 Y#5062\nG53 G0 "
      "X#5063\nM2\n",
      machine);
  REQUIRE(ends.size() == 4);
  CHECK(is_near_to(ends[0], {5 + 25.4, 6 + 25.4, 0}));  // turned by 90 degrees
  CHECK(ends[1][2] == Approx(-20));
  CHECK(is_near_to(ends[2], {25.4, -25.4, -20}));
  CHECK(ends[3][0] == Approx(-27));
}

TEST_CASE("what comes of a probing move that finds nothing, or begins in contact",
          "[ipr][probing][code]") {
  const std::string into =
      "softcnc:2:1: warning: G01 leads the probe into [contact.block], 20 mm from where it begins "
      "[SC2395]\n";
  const Machine machine = machine_with_block();
  const auto told = [&](const std::string& text, Dialect dialect = Dialect::linuxcnc) {
    std::string all;
    for (const Diagnostic& d : interpret(text, machine, in(dialect)).diagnostics)
      all += render(d).substr(0, render(d).find('\n') + 1);
    return all;
  };
  CHECK(told("G38.2 Z-50 F100\nM2\n") ==
        "softcnc:1:1: error: G38.2 comes to its end without a contact [SC2394]\n");
  CHECK(told("G38.3 Z-50 F100\nM2\n").empty());
  CHECK(told("G31 Z-50. F100\nM30\n", Dialect::fanuc).empty());
  CHECK(told("G0 X20 Y30\nG1 Z-21 F100\nG38.2 Z-50\nM2\n") ==
        into + "softcnc:3:1: error: G38.2 begins where the tool touches already [SC2393]\n");
  CHECK(told("G38.4 Z-50 F100\nM2\n") ==
        "softcnc:1:1: error: G38.4 begins without a contact already [SC2393]\n");
  CHECK(told("G0 X20 Y30\nG1 Z-21 F100\nG38.4 X25\nM2\n") ==
        into + "softcnc:3:1: error: G38.4 comes to its end and still touches [SC2394]\n");
  CHECK(told("G0 X20 Y30\nG1 Z-21 F100\nG38.5 X25\nX26\nM2\n") == into);
}

TEST_CASE(
    "in the linuxcnc dialect G38.3 and G38.5 may find at once what they look for, or move nowhere",
    "[ipr][probing]") {
  const Machine machine = machine_with_block();
  const std::string before = "G0 X20 Y30\nG38.2 Z-50 F100\n";
  for (const auto& [lines, contact] : {std::pair{"G38.3 Z-60\n", 1.0},
                                       {"G38.4 Z0\nG38.5 Z9\n", 1.0},
                                       {"G38.4 Z0\nG0 Z2\nG38.3 Z2\n", 0.0}}) {
    CAPTURE(lines);
    const auto ends = ends_of(before + lines + "G0 X[100 + #5070]\nM2\n", machine);
    CHECK(ends.back()[0] == Approx(100 + contact));
    InterpreterOptions options;
    options.dialect = Dialect::grbl;
    CHECK(interpret(before + lines + "M2\n", machine, options).diagnostics.size() == 1);
  }
}

TEST_CASE("after a release nothing touches, and after a contact a release has a way to go",
          "[ipr][probing][property]") {
  const Machine machine = machine_with_block();
  std::mt19937 chance(7);
  std::uniform_real_distribution<double> part(-1, 1);
  for (int i = 0; i < 500; ++i) {
    const auto number = [&](double size) { return std::to_string(size * part(chance)); };
    const std::string program = "G0 X30 Y35 Z" + std::to_string(-15 - 4 * part(chance)) +
                                "\nG38.2 X[30 + " + number(9) + "] Y[35 + " + number(9) +
                                "] Z-29 F100\nG38.4 X[30 + " + number(9) +
                                "] Z-5\nG38.2 X30 Z-29\nG38.5 Z-5\nG38.2 Z-29\nM2\n";
    CAPTURE(program);
    CHECK(ends_of(program, machine).size() == 6);
  }
}

TEST_CASE("without bodies a probing move ends where it is programmed to, with a note",
          "[ipr][probing][code]") {
  const Interpreted read = interpret("G38.2 Z-5 F100\nG0 Z0\nG38.2 Z-6\nM2\n");
  REQUIRE(read.diagnostics.size() == 1);
  CHECK(render(read.diagnostics[0])
            .starts_with(
                "softcnc:1:1: note: G38.2 is taken to end where it is programmed to: no [contact] "
                "of the machine file "
                "says what it touches [SC2392]"));
  REQUIRE(read.blocks.size() == 6);  // each after a rest
  CHECK(std::get<Move>(read.blocks[1].what).path_mode == PathMode::stop);
}

TEST_CASE("a machine that moves by a port without a probe refuses to probe",
          "[ipr][probing][code]") {
  Machine machine;
  machine.control.backend = BackendKind::hal_stream;
  const Interpreted read = interpret("G38.2 Z-5 F100\nM2\n", machine);
  REQUIRE(read.diagnostics.size() == 1);
  CHECK(render(read.diagnostics[0])
            .starts_with(
                "softcnc:1:1: error: G38.2 is refused: the backend hal-stream has no input for a "
                "probe [SC2114]"));
  machine.control.backend = BackendKind::parport;
  machine.parallel_port.probe_pin = 15;
  const Interpreted by_run = interpret("G38.2 Z-5 F100\nM2\n", machine);
  REQUIRE(by_run.diagnostics.size() == 1);
  CHECK(render(by_run.diagnostics[0])
            .starts_with("softcnc:1:1: error: G38.2 is refused: only softcnc operate and softcnc "
                         "serve read backend.parport.probe_pin [SC2114]"));
  InterpreterOptions options;
  options.contacts = Contacts::expected;
  CHECK(interpret("G38.2 Z-5 F100\nM2\n", machine, options).blocks.size() == 3);
}

TEST_CASE("an interpreter waits for what a machine finds", "[ipr][probing]") {
  Machine machine;
  Diagnostics diagnostics;
  Reader reader = Reader::from_text(
      "G92 Z4\nG38.2 Z-46 F120\nG0 Z[#5063 + #5070]\nG38.3 Z-60\nG0 X[#5070 + 3]\nG38.4 Z9\nG0 "
      "X5\nM2\n");
  Parser parser(reader, diagnostics);
  InterpreterOptions options;
  options.contacts = Contacts::read;
  Interpreter interpreter(parser, machine, diagnostics, options);
  const auto next = [&] {
    const auto block = interpreter.next();
    return block ? std::get_if<Action>(&block->what) != nullptr : false;
  };
  const auto asks = [&](double to) {
    CHECK(next());
    CHECK_FALSE(interpreter.next());
    CHECK(interpreter.waiting());
    REQUIRE(interpreter.probe() != nullptr);
    CHECK(interpreter.probe()->to[2] == Approx(to));
    CHECK(interpreter.probe()->feed == 2);
  };
  const auto moves_to = [&](const AxisVector& place) {
    const auto block = interpreter.next();
    REQUIRE(block);
    CHECK(is_near_to(end(std::get<Move>(block->what).path), place));
  };
  asks(-50);  // machine coordinates
  interpreter.probed({ProbeFound::found, {0, 0, -20}, {0, 0, -21}});
  CHECK(interpreter.probe() == nullptr);
  moves_to({0, 0, -19});
  asks(-64);
  interpreter.probed({ProbeFound::nothing, {}, {0, 0, -64}});
  moves_to({3, 0, -64});
  asks(5);
  interpreter.probed({ProbeFound::already, {}, {0, 0, -64}});
  REQUIRE(diagnostics.errors() == 1);
  CHECK(render(diagnostics.all()[0]) ==
        "softcnc:6:1: error: G38.4 begins without a contact already [SC2393]\n"
        "    6 | G38.4 Z9\n      | ^~~~~\n");
}

TEST_CASE("the length of a tool moves its contacts", "[ipr][probing]") {
  Machine machine = machine_with_block();
  machine.tools[3].length = 40;
  machine.tools[3].radius = 1;
  const auto ends = ends_of("T3 M6\nG0 X20 Y30 Z30\nG38.2 Z0 F100\nM2\n", machine);
  CHECK(is_near_to(ends.back(), {20, 30, 20}));
}

TEST_CASE("contacts of a ball and a box are where their distance is the radius",
          "[motion][probing]") {
  std::mt19937 chance(3);
  const auto from_to = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(chance()) / 4294967296.0;
  };
  const auto point = [&](double size) {
    return AxisVector(from_to(-size, size), from_to(-size, size), from_to(-size, size));
  };
  int contacts = 0, releases = 0;
  for (int i = 0; i < 2000; ++i) {
    const AxisVector corner = point(5);
    const ContactBody body{corner,
                           corner + AxisVector(from_to(0.1, 8), from_to(0.1, 8), from_to(0.1, 8))};
    const ProbeTip tip{from_to(0, 2), from_to(0, 5)};
    const bool from_within = i % 3 == 0;
    const Line line(from_within ? AxisVector(0.5 * (body.min + body.max)) : point(20), point(20));
    const auto off = [&](double s) {
      const AxisVector c = tip.center(line.position(s));
      return (c - c.cwiseMax(body.min).cwiseMin(body.max)).norm() - tip.radius;
    };
    const std::span bodies(&body, 1);
    double nearest = 1e9;  // by samples
    for (int k = 0; k <= 2000; ++k) nearest = std::min(nearest, off(line.length() * k / 2000));
    const auto contact = contact_along(line, bodies, tip, ProbeAim::contact);
    const auto release = contact_along(line, bodies, tip, ProbeAim::release);
    CAPTURE(i, nearest);
    if (off(0) > 1e-6) {
      CHECK_FALSE(release);
      if (nearest < -1e-3) REQUIRE(contact);
      if (nearest > 1e-2) CHECK_FALSE(contact);
    } else if (off(line.length()) > 1e-6) {
      CHECK_FALSE(contact);
      REQUIRE(release);
    }
    if (contact) {
      ++contacts;
      CHECK(off(*contact) == Approx(0).margin(1e-6));
      for (int k = 0; k < 50; ++k) CHECK(off(*contact * k / 50) > -1e-6);
    }
    if (release) {
      ++releases;
      if (off(0) < 0) CHECK(off(*release) == Approx(0).margin(1e-6));
    }
  }
  CHECK(contacts > 100);
  CHECK(releases > 20);
}

TEST_CASE("a probe that touches where it does not probe is reported once", "[ipr][probing]") {
  Machine machine = machine_with_block();
  const auto reported = [&](const std::string& text) {
    std::string all;
    for (const Diagnostic& found : interpret(text, machine).diagnostics) all += render(found);
    return all;
  };
  CHECK(
      reported("G0 X20 Y30\nG0 Z-20.5\nG0 Z0\nG0 Z-21\nM2\n") ==
      "softcnc:2:1: warning: G00 leads the probe into [contact.block], 20 mm from where it begins "
      "[SC2395]\n"
      "    2 | G0 Z-20.5\n"
      "      | ^~\n");
  CHECK(reported("G0 Y30 Z-28\nG1 X100 F600\nM2\n").find("SC2395") != std::string::npos);
  // along the faces, away from a contact, and with a tool that the machine file has: nothing
  CHECK(reported("G0 X20 Y30\nG38.2 Z-50 F100\nG0 Z-10\nX100\nZ-28\nY17.9\nX0\nM2\n").empty());
  machine.tools[3] = {1, 2, 0};
  CHECK(reported("T3 M6\nG0 X20 Y30\nG0 Z-20.5\nM2\n").find("SC2395") == std::string::npos);
}
