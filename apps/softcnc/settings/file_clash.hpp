// SPDX-License-Identifier: MIT
// A file named twice, where the second use would destroy the first.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "motion/model/machine.hpp"
#include "settings/options.hpp"

namespace softcnc::app {

/// Returns what is wrong where a file to be written is also read, or written twice; empty: nothing.
/// Files that exist are compared by device and inode, others by path; anything that is not a
/// regular file may be named any number of times.
std::string file_clash(const Options& options);
/// The same with the file that the machine's backend writes; also where two write standard output.
std::string file_clash(const Options& options, const Machine& machine);

/// Returns whether two names lead to one file, as far as can be known; an empty name leads to none.
bool same_file(const std::string& a, const std::string& b);

/// Returns the key and the name of the file that the machine's backend writes; empty: none.
std::pair<std::string, std::string> backend_file(const Machine& machine);

/// Returns the names of the files that a command writes; empty ones stand for no file.
std::vector<std::string> written_files(const Options& options, const Machine& machine);

}  // namespace softcnc::app
