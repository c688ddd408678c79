// SPDX-License-Identifier: MIT
// Which recordings are replayed: files, folders of them, and shards.
#pragma once

#include <string>
#include <vector>

#include "motion/core/result.hpp"

namespace softcnc::app {

struct ListedRecording {
  std::string file;
  bool found = false;  // in a folder that was named
};

/// Returns the recordings of a command line in its order, with all files *.rec below a folder in
/// its place, in the order of the bytes of their names. Links to folders are not followed. Errors:
/// SC6025, where a folder cannot be read or has no recordings.
Result<std::vector<ListedRecording>> list_recordings(const std::vector<std::string>& names);

/// Returns the part `shard`, from 1, of so many parts of a list: every `shards`-th recording. The
/// parts have no recording in common, and together are the list.
std::vector<ListedRecording> shard_of(const std::vector<ListedRecording>& list, int shard,
                                      int shards);

}  // namespace softcnc::app
