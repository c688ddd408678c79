// SPDX-License-Identifier: MIT
// The library softcnc: part programs checked, planned, and run from C++.
//
//   #include <softcnc/softcnc.hpp>
//
//   const auto program = softcnc::Program::open("part.nc");
//   if (!program) return 1;
//   const auto trajectory = softcnc::plan(*program, softcnc::Machine());
//   if (!trajectory) return 1;
//   std::cout << trajectory->duration() << " s, "
//             << trajectory->at(1.5).position.transpose() << '\n';
//
// Versions follow semver.org: what these headers declare changes incompatibly only when the first
// number of the version that is not zero does. Nothing else of softcnc is promised to C++ programs.
// Errors are values; functions throw std::bad_alloc alone.
#pragma once

#include <softcnc/backend.hpp>
#include <softcnc/constraint.hpp>
#include <softcnc/diagnostic.hpp>
#include <softcnc/machine.hpp>
#include <softcnc/operator.hpp>
#include <softcnc/program.hpp>
#include <softcnc/session.hpp>
#include <softcnc/setpoint.hpp>
#include <softcnc/state.hpp>
#include <softcnc/trajectory.hpp>

/// Programs write softcnc::plan. Where the sources of softcnc are compiled, the namespace api keeps
/// these names apart from those of its libraries, which include no more than single headers.
namespace softcnc {
using namespace api;  // NOLINT(google-build-using-namespace)
}
