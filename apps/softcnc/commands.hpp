// SPDX-License-Identifier: MIT
// One function per command; each returns the exit status.
#pragma once

#include "options.hpp"

namespace softcnc::app {

int run(const Options& options);
int check(const Options& options);
int blocks(const Options& options);
int record(const Options& options);
int replay(const Options& options);
int machine(const Options& options);
int codes(const Options& options);

}  // namespace softcnc::app
