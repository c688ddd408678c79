// SPDX-License-Identifier: MIT
// An orderly end when memory runs out.
#pragma once

#include <exception>
#include <string>

namespace softcnc::app {

/// Returns which resource has run out, memory or threads, in words; empty for other exceptions.
std::string lacking_resource(const std::exception& error);

/// From here on, running out of memory where nothing may be thrown, or in a thread, is exit status
/// 5 as well, with a text; port and files are left as by a signal.
void handle_out_of_memory() noexcept;

}  // namespace softcnc::app
