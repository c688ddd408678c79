// SPDX-License-Identifier: MIT
#include "process/file_watch.hpp"

#include <poll.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

namespace softcnc::app {
namespace {

constexpr std::uint32_t kChanges =
    IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_CREATE | IN_DELETE;
constexpr int kQuiet = 50;  // ms: what is saved in several steps is one change

tl::unexpected<Diagnostic> unwatched(const std::string& file) {
  return tl::make_unexpected(
      Diagnostic{.code = Code::SC6041,
                 .message = std::string("cannot be watched: ") + std::strerror(errno),
                 .file = file});
}

constexpr int kWatchInterval = 1000;  // ms

FileStamp stamp_of(const std::string& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return {};
  return {status.st_dev, status.st_ino, status.st_size, status.st_mtim.tv_sec,
          status.st_mtim.tv_nsec};
}

bool is_readable(int descriptor, int timeout) {
  pollfd source{descriptor, POLLIN, 0};
  return ::poll(&source, 1, timeout) > 0;
}

}  // namespace

Result<FileWatch> FileWatch::open(std::span<const std::string> files) {
  FileWatch watch(runtime::Descriptor(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)));
  if (*watch.queue_ < 0) return unwatched(files.front());
  for (const std::string& file : files)
    if (Status added = watch.add(file); !added)
      return tl::make_unexpected(std::move(added.error()));
  return watch;
}

/// A symbolic link is watched where it lies, and where it leads.
Status FileWatch::add(const std::string& file) {
  std::error_code error;
  const std::filesystem::path named(file), target = std::filesystem::canonical(named, error);
  for (const auto& path : {named, error ? named : target}) {
    const std::string folder = path.has_parent_path() ? path.parent_path().string() : ".";
    const int watched = ::inotify_add_watch(*queue_, folder.c_str(), kChanges);
    if (watched < 0) return unwatched(file);
    names_[watched].insert(path.filename());
  }
  const FileStamp stamp = stamp_of(file);
  seen_.try_emplace(file, Seen{stamp, stamp});
  return {};
}

void FileWatch::also(std::span<const std::string> files) {
  for (const std::string& file : files) static_cast<void>(add(file));
}

/// Empties the queue.
bool FileWatch::has_changed() {
  alignas(inotify_event) std::array<char, 16384> events{};
  bool changed = false;
  for (ssize_t n = 0; (n = ::read(*queue_, events.data(), events.size())) > 0;)
    for (const char* at = events.data(); at < events.data() + n;) {
      inotify_event event{};
      std::memcpy(&event, at, sizeof event);
      const std::string name = event.len > 0 ? at + sizeof event : "";
      changed = changed || (event.mask & IN_Q_OVERFLOW) != 0 || names_[event.wd].contains(name);
      at += sizeof event + event.len;
    }
  return changed;
}

/// Everything there is now counts as reported.
void FileWatch::look() {
  for (auto& [file, seen] : seen_) seen.reported = seen.last = stamp_of(file);
}

/// Returns whether something unreported is there and has been left alone since the last look.
bool FileWatch::looks_changed() {
  bool changed = false;
  for (auto& [file, seen] : seen_) {
    const FileStamp before = std::exchange(seen.last, stamp_of(file));
    changed = changed || (seen.last == before && !(seen.last == seen.reported));
  }
  return changed;
}

/// Where the files lie now, and links lead to.
void FileWatch::watch_again() {
  for (const auto& [file, seen] : seen_) static_cast<void>(add(file));
}

bool FileWatch::wait(StopSignals& signals) {
  bool changed = false;
  while (signals.poll() == 0) {
    changed = has_changed() || changed;
    if (!changed && !signals.wait_for_input(*queue_, kWatchInterval)) changed = looks_changed();
    if (!changed || is_readable(*queue_, kQuiet)) continue;
    watch_again();
    look();
    return true;
  }
  return false;
}

}  // namespace softcnc::app
