// SPDX-License-Identifier: MIT
// One file named twice, where the second use would destroy the first.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "motion/model/machine.hpp"
#include "settings/options.hpp"

namespace softcnc::app {

/// What is wrong where a file to be written is also read, or written twice; empty: nothing. Files
/// that exist are compared by device and inode, others by path; what is no regular file may serve
/// any number of times.
std::string file_clash(const Options& options);
/// The same with the file that the machine's backend writes; also where two write standard output.
std::string file_clash(const Options& options, const Machine& machine);

/// Whether two names lead to one file, as far as can be known; an empty name leads to none.
bool same_file(const std::string& a, const std::string& b);

/// The key and the name of the file that the machine's backend writes; empty ones: it writes none.
std::pair<std::string, std::string> backend_file(const Machine& machine);

/// The files that this makes, by their names; empty ones are none.
std::vector<std::string> written_files(const Options& options, const Machine& machine);

}  // namespace softcnc::app
