// SPDX-License-Identifier: MIT
// Copies of files, and of what a program calls: later changes of the files are not in them.
#include "ipr/text/snapshot.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "ipr/interpret.hpp"
#include "ipr/text/called_texts.hpp"
#include "support/files.hpp"
#include "support/folder.hpp"
#include "support/shown.hpp"

namespace softcnc::ipr {
namespace {

using test::Folder;

/// A text in which no two pieces are alike.
std::string text_of_size(std::size_t size) {
  std::string text;
  for (int i = 0; text.size() < size; ++i) text += "G01 X" + std::to_string(i) + '\n';
  text.resize(size);
  return text;
}

Result<Snapshot> snapshot_of(const std::string& name, std::int64_t begin = 0) {
  const int file = ::open(name.c_str(), O_RDONLY);
  REQUIRE(file >= 0);
  auto snapshot = Snapshot::of(file, begin);
  ::close(file);
  return snapshot;
}

/// TMPDIR is a folder in which no file can be made, while it lives.
class NoTemporaryFiles {
 public:
  NoTemporaryFiles() { ::setenv("TMPDIR", "/proc/self/task", 1); }
  NoTemporaryFiles(const NoTemporaryFiles&) = delete;
  NoTemporaryFiles& operator=(const NoTemporaryFiles&) = delete;
  ~NoTemporaryFiles() {
    before_.empty() ? ::unsetenv("TMPDIR") : ::setenv("TMPDIR", before_.c_str(), 1);
  }

 private:
  std::string before_ = ::getenv("TMPDIR") != nullptr ? ::getenv("TMPDIR") : "";
};

Interpreted run_in(const Folder& folder, const std::string& text, CalledTexts* called = nullptr) {
  InterpreterOptions options;
  options.folder = folder.path();
  options.called = called;
  return interpret(text, {}, options);
}

std::size_t moves_in(const Interpreted& result) { return result.blocks.size() - 1; }

}  // namespace

TEST_CASE("a snapshot is what the file held, whatever is written into it later",
          "[ipr][snapshot]") {
  const auto size = GENERATE(std::size_t{0}, std::size_t{1000}, std::size_t{1} << 20,
                             (std::size_t{1} << 20) + 1, std::size_t{5'000'001});
  const Folder folder;
  const std::string text = text_of_size(size), name = folder / "a.nc";
  for (const std::size_t begin : {std::size_t{0}, std::size_t{7}}) {
    if (begin > size) continue;
    std::ofstream(name, std::ios::binary) << text;
    const auto snapshot = snapshot_of(name, static_cast<std::int64_t>(begin));
    REQUIRE(snapshot);
    std::ofstream(name, std::ios::binary) << "something else";
    CHECK(test::bytes_of(snapshot->name()) == text.substr(begin));
  }
}

TEST_CASE("a snapshot of a file without a size is what reading it gives", "[ipr][snapshot]") {
  const auto snapshot = snapshot_of("/proc/self/limits");
  REQUIRE(snapshot);
  CHECK(test::bytes_of(snapshot->name()).starts_with("Limit "));
}

TEST_CASE("a long snapshot needs the folder for temporary files, a short one does not",
          "[ipr][snapshot]") {
  Folder folder;
  folder.with("short.nc", text_of_size(Snapshot::kLongestInMemory));
  folder.with("long.nc", text_of_size(Snapshot::kLongestInMemory + 1));
  const NoTemporaryFiles none;
  CHECK(snapshot_of(folder / "short.nc"));
  const auto snapshot = snapshot_of(folder / "long.nc");
  REQUIRE_FALSE(snapshot);
  CHECK(shows(render(snapshot.error()),
              "softcnc: error: cannot be kept in a temporary file: ... [SC6003]"));
  CHECK(exit_status(snapshot.error()) == 5);
}

TEST_CASE("what is called and no regular file is refused at once", "[ipr][snapshot]") {
  const Folder folder;
  const auto [name, kind] = GENERATE(table<std::string, std::string>(
      {{"fifo", "a pipe"}, {"link", "a pipe"}, {"null", "a device"}, {"zero", "a device"}}));
  REQUIRE(::mkfifo((folder / "fifo.ngc").c_str(), 0600) == 0);
  REQUIRE(::symlink("fifo.ngc", (folder / "link.ngc").c_str()) == 0);
  REQUIRE(::symlink("/dev/null", (folder / "null.ngc").c_str()) == 0);
  REQUIRE(::symlink("/dev/zero", (folder / "zero.ngc").c_str()) == 0);
  const Interpreted result = run_in(folder, "G0 X1\no<" + name + "> call\nM2\n");
  REQUIRE(result.diagnostics.size() == 1);
  CHECK(shows(render(result.diagnostics.front()),
              "softcnc:2:1: error: cannot call '" + (folder / name) + ".ngc': it is " + kind +
                  ", and only a regular file can be called [SC6033]"));
  CHECK(exit_status(result.diagnostics.front()) == 5);
}

TEST_CASE("a called file that is too long is refused at once", "[ipr][snapshot]") {
  Folder folder;
  folder.with("long.ngc", "o<long> sub\no<long> endsub\n");
  std::filesystem::resize_file(folder / "long.ngc", CalledTexts::kLongest + 1);
  const Interpreted result = run_in(folder, "o<long> call\nM2\n");
  REQUIRE(result.diagnostics.size() == 1);
  CHECK(shows(render(result.diagnostics.front()), "softcnc:1:1: error: cannot call '" +
                                                      (folder / "long.ngc") +
                                                      "': it is longer than 1024 MiB [SC6034]"));
  CHECK(exit_status(result.diagnostics.front()) == 5);
}

TEST_CASE("a program finds again what it has called, though the file has changed",
          "[ipr][snapshot]") {
  Folder folder;
  folder.with("a.ngc", "o<a> sub\nG0 X1\no<a> endsub\n");
  CalledTexts called;
  CHECK(moves_in(run_in(folder, "o<a> call\nM2\n", &called)) == 1);
  folder.with("a.ngc", "o<a> sub\nG0 X1\nX2\no<a> endsub\n");
  CHECK(moves_in(run_in(folder, "o<a> call\nM2\n", &called)) == 1);
  CHECK(moves_in(run_in(folder, "o<a> call\nM2\n")) == 2);
}

TEST_CASE("what a program has called in vain is not found later", "[ipr][snapshot]") {
  Folder folder;
  CalledTexts called;
  CHECK(places(run_in(folder, "o<a> call\nM2\n", &called)) == Places{"SC2301 1:1"});
  folder.with("a.ngc", "o<a> sub\nG0 X1\no<a> endsub\n");
  CHECK(places(run_in(folder, "o<a> call\nM2\n", &called)) == Places{"SC2301 1:1"});
  CHECK(places(run_in(folder, "o<a> call\nM2\n")).empty());
}

}  // namespace softcnc::ipr
