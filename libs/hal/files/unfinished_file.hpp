// SPDX-License-Identifier: MIT
// A file beside its target while it is written: `.NAME.softcnc-XXXXXXXXXXXX`, locked by its
// writer.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace softcnc::hal {

struct UnfinishedFile {
  std::string name;
  int descriptor = -1;  // below 0: none could be made, and errno says why
};

inline constexpr mode_t kNewFileMode = 0666;  // less the umask

/// A new file in the folder of `target`, under a name that nothing had. It is locked (flock) as
/// long as the descriptor is open, where the file system knows locks. `mode` is less the umask.
UnfinishedFile make_unfinished(const std::string& target, mode_t mode);

/// The number of hexadecimal digits at the end of its name: so many that nobody else gives a file
/// such a name.
inline constexpr std::size_t kUnfinishedEnding = 12;

/// Returns `.NAME.softcnc-ENDING` in the folder of `target`; a long NAME is cut, so that the file
/// system takes it.
std::string name_beside_target(const std::string& target, std::string_view ending);

/// Returns whether an open file still has a name: somebody may have removed it there.
bool bears(int descriptor, const std::string& name);

/// Returns whether a path ends in such a name, of an unfinished file or of a lock. Calls nothing
/// that a signal handler must not call.
bool is_name_beside_target(std::string_view path) noexcept;

}  // namespace softcnc::hal
