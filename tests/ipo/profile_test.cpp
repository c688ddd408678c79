// SPDX-License-Identifier: MIT
#include "ipo/path/profile.hpp"

#include <catch2/catch.hpp>

using namespace softcnc;
using namespace softcnc::ipo;

namespace {

/// Up to 10 mm/s at 100 mm/s^2, a cruise of 1 s, down at 50 mm/s^2, a rest of 0.5 s.
Profile trapezoid() {
  Profile profile;
  profile.add_piece(0, 0.5, 0, 10, Limit::acceleration);
  profile.add_piece(0.5, 10.5, 10, 10, Limit::feed);
  profile.add_piece(10.5, 11.5, 10, 0, Limit::acceleration);
  profile.add_rest(0.5);
  return profile;
}

}  // namespace

TEST_CASE("a profile lasts as long as its pieces", "[profile]") {
  CHECK(trapezoid().duration() == Approx(0.1 + 1.0 + 0.2 + 0.5));
}

TEST_CASE("a profile gives place, speed and acceleration in closed form", "[profile]") {
  const Profile profile = trapezoid();
  std::size_t hint = 0;
  const auto check = [&](double t, double s, double v, double a, Limit limit) {
    const State state = profile.at(t, hint);
    CHECK(state.s == Approx(s).margin(1e-12));
    CHECK(state.v == Approx(v).margin(1e-12));
    CHECK(state.a == Approx(a).margin(1e-9));
    CHECK(state.limit == limit);
  };
  check(0.05, 0.125, 5, 100, Limit::acceleration);
  check(0.6, 5.5, 10, 0, Limit::feed);
  check(1.2, 11.25, 5, -50, Limit::acceleration);
  check(1.5, 11.5, 0, 0, Limit::stop);
  check(9.0, 11.5, 0, 0, Limit::stop);
}

TEST_CASE("the time of a place is the inverse of the place at a time", "[profile]") {
  const Profile profile = trapezoid();
  std::size_t hint = 0;
  for (double t = 0.001; t < 1.29; t += 0.003)
    CHECK(profile.time_at(profile.at(t, hint).s) == Approx(t).epsilon(1e-9));
  CHECK(profile.time_at(11.5) == Approx(1.3));  // the first instant there
}

TEST_CASE("speed changes inside a piece so that v squared is linear in s", "[profile]") {
  Profile profile;
  profile.add_piece(0, 3, 2, 7, Limit::acceleration);
  std::size_t hint = 0;
  const State middle = profile.at(profile.time_at(1.5), hint);
  CHECK(middle.v * middle.v == Approx((4.0 + 49.0) / 2));
}

TEST_CASE("what is left of a profile goes on where it is", "[profile]") {
  const Profile whole = trapezoid();
  for (const double t : {0.0, 0.05, 0.6, 1.2, 1.5, 1.8}) {
    const Profile rest = whole.from(t);
    CHECK(rest.duration() == Approx(whole.duration() - t).margin(1e-12));
    std::size_t a = 0, b = 0;
    for (double later = 0; later < rest.duration(); later += 0.07) {
      CHECK(rest.at(later, a).s == Approx(whole.at(t + later, b).s).margin(1e-12));
      CHECK(rest.at(later, a).v == Approx(whole.at(t + later, b).v).margin(1e-12));
    }
  }
  CHECK(whole.end_speed() == 0);
  Profile running;
  running.add_piece(0, 1, 2, 3, Limit::acceleration);
  CHECK(running.end_speed() == Approx(3));
}
