// SPDX-License-Identifier: MIT
// What runs every period allocates nothing.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <new>
#include <vector>

#include "hal/backend.hpp"
#include "hal/trace.hpp"

namespace {

std::size_t allocations = 0;

}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

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
  CHECK(allocations > 0);  // the counter counts
  const std::size_t before = allocations;
  for (int i = 0; i < 20'000; ++i) {
    setpoint.period = i;
    setpoint.position[0] = i * 0.01;
    (*mill)->exchange(setpoint);
    (*mill)->values(values);
    (*trace)->row(setpoint, values);
  }
  const std::size_t after = allocations;
  CHECK(after == before);
}

}  // namespace softcnc::hal
