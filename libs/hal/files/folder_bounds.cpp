// SPDX-License-Identifier: MIT
#include "hal/files/folder_bounds.hpp"

#include <algorithm>
#include <system_error>

namespace softcnc::hal {

namespace fs = std::filesystem;

fs::path real_path(const fs::path& path) {
  std::error_code unreadable;
  auto real = fs::weakly_canonical(fs::absolute(path.empty() ? "." : path, unreadable), unreadable);
  if (unreadable) return path.lexically_normal();
  return real.has_filename() ? real : real.parent_path();
}

bool is_in_folder(const fs::path& path, const fs::path& folder) {
  const auto differ = std::mismatch(path.begin(), path.end(), folder.begin(), folder.end());
  return differ.second == folder.end();
}

}  // namespace softcnc::hal
