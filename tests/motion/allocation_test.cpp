// SPDX-License-Identifier: MIT
// Evaluating a curve allocates nothing: counted at operator new itself.
#include <atomic>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <new>

#include "motion/path.hpp"
#include "support/curves.hpp"

namespace {

std::atomic<long> allocations{0};

}  // namespace

[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t align) {
  ++allocations;
  const auto alignment = static_cast<std::size_t>(align);
  if (void* memory = std::aligned_alloc(alignment, (size / alignment + 1) * alignment))
    return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size > 0 ? size : 1);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace softcnc {
namespace {

template <typename Work>
long allocations_during(Work&& work) {
  const long before = allocations;
  work();
  return allocations - before;
}

}  // namespace

TEST_CASE("the counter counts", "[motion][allocation]") {
  CHECK(allocations_during([] { ::operator delete(::operator new(10)); }) == 1);
}

TEST_CASE("no curve allocates when it is evaluated", "[motion][allocation]") {
  std::vector<Path> paths;
  paths.emplace_back(Line({0, 0, 0}, {1, 2, 3}));
  paths.emplace_back(Arc::make({{1, 0, 0}, {0, 1, 3}, {0, 0, 0}}).value());
  paths.emplace_back(Nurbs::make(test::curve_spec("butterfly")).value());
  // Stands still at its start: the longest way through at().
  paths.emplace_back(
      Nurbs::make(
          {3, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 2, 3}}, {1, 1, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}})
          .value());
  AxisVector sum = AxisVector::Zero();
  const long counted = allocations_during([&] {
    for (const Path& path : paths)
      for (int i = 0; i <= 1000; ++i) {
        const double s = length(path) * i / 1000;
        sum += position(path, s) + at(path, s).ddq + at(path, s, Side::before).dq;
      }
  });
  CHECK(counted == 0);
  CHECK(sum.allFinite());
}

TEST_CASE("no NURBS allocates when it is evaluated by its parameter", "[motion][allocation]") {
  const Nurbs nurbs = Nurbs::make(test::curve_spec("butterfly")).value();
  AxisVector sum = AxisVector::Zero();
  const long counted = allocations_during([&] {
    for (int i = 0; i <= 1000; ++i) {
      const double u = i / 1000.0;
      sum += nurbs.point(u) + nurbs.derivatives(u)[3] + nurbs.derivatives(u, Side::before)[2];
      sum[0] += nurbs.speed(u) + nurbs.parameter(nurbs.arc_length(u));
    }
  });
  CHECK(counted == 0);
  CHECK(sum.allFinite());
}

}  // namespace softcnc
