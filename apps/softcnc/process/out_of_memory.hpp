// SPDX-License-Identifier: MIT
// An end in order where there is no more memory.
#pragma once

#include <exception>
#include <string>

namespace softcnc::app {

/// What the system had no more of, memory or threads, in words; empty: the exception is another.
std::string lacking_resource(const std::exception& error);

/// From here on, running out of memory where nothing may be thrown, or in a thread, is exit status
/// 5 as well, with a text; port and files are left as by a signal.
void end_well_out_of_memory() noexcept;

}  // namespace softcnc::app
