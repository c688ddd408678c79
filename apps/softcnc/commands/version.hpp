// SPDX-License-Identifier: MIT
// The version, and what it was built from.
#pragma once

#include <string>

namespace softcnc::app {

/// "softcnc 0.1.0 (commit 0123abcd, GNU 12.2.0)"; without the commit where the sources are no
/// checkout of Git.
std::string version_text();

}  // namespace softcnc::app
