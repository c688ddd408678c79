// SPDX-License-Identifier: MIT
#include "replay/recording_list.hpp"

#include <algorithm>
#include <cassert>
#include <filesystem>
#include <system_error>
#include <utility>

namespace softcnc::app {
namespace {

namespace fs = std::filesystem;

Result<std::vector<ListedRecording>> failure(const std::string& folder, std::string why) {
  return tl::make_unexpected(
      Diagnostic{.code = Code::SC6025, .message = std::move(why), .file = folder});
}

Result<std::vector<ListedRecording>> recordings_below(const std::string& folder) {
  std::vector<ListedRecording> found;
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, error), end;
  while (!error && entry != end) {
    std::error_code unknown;
    if (entry->path().extension() == ".rec" && entry->is_regular_file(unknown))
      found.push_back({entry->path().string(), true});
    entry.increment(error);
  }
  if (error) return failure(folder, "cannot be read: " + error.message());
  if (found.empty()) return failure(folder, "has no recordings: no file ends in .rec");
  std::sort(found.begin(), found.end(),
            [](const ListedRecording& a, const ListedRecording& b) { return a.file < b.file; });
  return found;
}

}  // namespace

Result<std::vector<ListedRecording>> list_recordings(const std::vector<std::string>& names) {
  std::vector<ListedRecording> list;
  for (const std::string& name : names) {
    std::error_code unknown;
    if (!fs::is_directory(name, unknown)) {
      list.push_back({name, false});
      continue;
    }
    auto found = recordings_below(name);
    if (!found) return found;
    list.insert(list.end(), found->begin(), found->end());
  }
  return list;
}

std::vector<ListedRecording> shard_of(const std::vector<ListedRecording>& list, int shard,
                                      int shards) {
  assert(shard >= 1 && shard <= shards);
  std::vector<ListedRecording> part;
  for (std::size_t i = static_cast<std::size_t>(shard) - 1; i < list.size();
       i += static_cast<std::size_t>(shards))
    part.push_back(list[i]);
  return part;
}

}  // namespace softcnc::app
