// SPDX-License-Identifier: MIT
// What runs every period allocates nothing.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "hal/backends/backend.hpp"
#include "hal/trace/trace.hpp"
#include "support/allocations.hpp"

namespace softcnc::hal {

TEST_CASE("a period on the simulated mill with its trace allocates nothing", "[hal][realtime]") {
  const Machine machine;
  const auto mill = open_backend(machine);
  REQUIRE(mill);
  const char* file = GENERATE("/dev/null", "/dev/full");
  const auto trace = TraceWriter::open(file, {}, machine, (*mill)->columns());
  REQUIRE(trace);
  std::vector<double> values((*mill)->columns().size());
  Setpoint setpoint;
  CHECK(softcnc::test::allocations_during([&] {
          for (int i = 0; i < 20'000; ++i) {
            setpoint.period = i;
            setpoint.position[0] = i * 0.01;
            (*mill)->exchange(setpoint);
            (*mill)->values(values);
            (*trace)->row(setpoint, values);
          }
        }) == 0);
}

TEST_CASE("a period with compensation allocates nothing", "[hal][realtime]") {
  Machine machine;
  machine.screws[0] = {0.1, {{0, 0}, {50, 0.02}}};
  machine.control.backend = GENERATE(BackendKind::sim, BackendKind::hal_stream);
  const auto backend = open_backend(without_port(machine));
  REQUIRE(backend);
  std::vector<FinePoint> fine(4);
  Setpoint setpoint;
  CHECK(softcnc::test::allocations_during([&] {
          for (int i = 0; i < 20'000; ++i) {
            setpoint.position[0] = std::abs(i % 1000 - 500) * 0.01;
            fine.assign(4, {0, setpoint.position});
            setpoint.fine = fine;
            (*backend)->exchange(setpoint);
          }
        }) == 0);
}

TEST_CASE("a period of rows for HAL allocates nothing", "[hal][realtime]") {
  Machine machine;
  machine.control.backend = BackendKind::hal_stream;
  machine.hal_stream.file = "/dev/null";
  const auto rows = open_backend(machine);
  REQUIRE(rows);
  Setpoint setpoint;
  CHECK(softcnc::test::allocations_during([&] {
          for (int i = 0; i < 20'000; ++i) {
            setpoint.position[0] = i / 3.0;
            (*rows)->exchange(setpoint);
          }
        }) == 0);
}

}  // namespace softcnc::hal
