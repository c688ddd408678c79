// SPDX-License-Identifier: MIT
// Whether a file lies in a folder, whatever links lead there.
#pragma once

#include <filesystem>

namespace softcnc::hal {

/// Returns the whole path with links followed, as far as it is there.
std::filesystem::path real_path(const std::filesystem::path& path);

/// Returns whether a real path is that of a folder, or lies in it.
bool is_in_folder(const std::filesystem::path& path, const std::filesystem::path& folder);

}  // namespace softcnc::hal
