// SPDX-License-Identifier: MIT
// One function per command; each returns the exit status.
#pragma once

#include "settings/options.hpp"

namespace softcnc::app {

int run(const Options& options);
int check(const Options& options);
int blocks(const Options& options);
int convert(const Options& options);
int operate(const Options& options);
int serve(const Options& options);
int record(const Options& options);
int replay(const Options& options);
int report(const Options& options);
int diff(const Options& options);
int identify(const Options& options);
int surface(const Options& options);
int compare(const Options& options);
int machine(const Options& options);
int state(const Options& options);
int latency(const Options& options);
int pulses(const Options& options);
int codes(const Options& options);
int circle(const Options& options);
/// The codes of programs, one a line: name, words, what it does.
std::string list_of_codes();

}  // namespace softcnc::app
