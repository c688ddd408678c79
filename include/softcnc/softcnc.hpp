// SPDX-License-Identifier: MIT
// The library softcnc: part programs checked, planned, and run from C++.
//
//   #include <softcnc/softcnc.hpp>
//   namespace cnc = softcnc::api;
//
//   const auto program = cnc::Program::open("part.nc");
//   if (!program) return 1;
//   const auto trajectory = cnc::plan(*program, cnc::Machine());
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
#include <softcnc/program.hpp>
#include <softcnc/session.hpp>
#include <softcnc/setpoint.hpp>
#include <softcnc/state.hpp>
#include <softcnc/trajectory.hpp>
