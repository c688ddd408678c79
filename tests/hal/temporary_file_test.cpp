// SPDX-License-Identifier: MIT
// Files without a name, and zips that are written into them.
#include "hal/files/temporary_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "hal/files/zip_file.hpp"
#include "support_hal.hpp"

namespace softcnc::hal {
namespace {

/// The folder for temporary files is another one meanwhile.
class Elsewhere {
 public:
  explicit Elsewhere(const std::string& folder) { ::setenv("TMPDIR", folder.c_str(), 1); }
  Elsewhere(const Elsewhere&) = delete;
  Elsewhere& operator=(const Elsewhere&) = delete;
  ~Elsewhere() {
    if (had_)
      ::setenv("TMPDIR", before_.c_str(), 1);
    else
      ::unsetenv("TMPDIR");
  }

 private:
  bool had_ = std::getenv("TMPDIR") != nullptr;
  std::string before_ = had_ ? std::getenv("TMPDIR") : "";
};

std::string whole_text(const TemporaryFile& file) {
  std::string text;
  REQUIRE(file.for_each_piece([&](std::string_view piece) -> Status {
    text += piece;
    return {};
  }));
  return text;
}

void fill(ZipWriter& zip) {
  zip.add_text("short", "text");
  zip.add_text("long", std::string(300'000, 'x'));
  REQUIRE(zip.finish());
}

}  // namespace

TEST_CASE("a temporary file has no name at any time, and holds what is added", "[hal][temporary]") {
  const test::Folder folder;
  const Elsewhere elsewhere(folder.path());
  auto file = TemporaryFile::make();
  REQUIRE(file);
  const std::string text(200'000, 'a');
  REQUIRE(file->add(text));
  REQUIRE(file->add("end"));
  CHECK(test::names_in(folder.path()).empty());
  CHECK(whole_text(*file) == text + "end");
  CHECK(whole_text(*file) == text + "end");
}

TEST_CASE("a zip in a file without a name is that in a file with one", "[hal][temporary][zip]") {
  const test::Folder folder, named;
  const Elsewhere elsewhere(folder.path());
  auto file = TemporaryFile::make();
  REQUIRE(file);
  REQUIRE(file->add(std::string(1'000'000, 'o')));  // is written over
  ZipWriter unnamed(file->descriptor());
  fill(unnamed);
  CHECK(test::names_in(folder.path()).empty());
  ZipWriter with_name(named / "x.zip");
  fill(with_name);
  CHECK(whole_text(*file) == test::read(named / "x.zip"));
  CHECK(test::names_in(named.path()) == test::Names{"x.zip"});
  const auto reader = ZipReader::open(named / "x.zip");
  REQUIRE(reader);
  CHECK(*reader->text("short") == "text");
  CHECK(*reader->text("long") == std::string(300'000, 'x'));
}

TEST_CASE("an entry from an open file is all of it", "[hal][temporary][zip]") {
  const test::Folder folder;
  auto file = TemporaryFile::make();
  REQUIRE(file);
  REQUIRE(file->add("what has just been written"));
  ZipWriter zip(folder / "x.zip");
  zip.add_descriptor("stored", file->descriptor(), Compression::store);
  REQUIRE(zip.finish());
  CHECK(*ZipReader::open(folder / "x.zip")->text("stored") == "what has just been written");
}

TEST_CASE("a zip that cannot be written says why", "[hal][temporary][zip]") {
  const int full = ::open("/dev/full", O_RDWR | O_CLOEXEC);
  REQUIRE(full >= 0);
  const test::Folder folder;
  test::write(folder / "x", "");
  const int read_only = ::open((folder / "x").c_str(), O_RDONLY | O_CLOEXEC);
  REQUIRE(read_only >= 0);
  for (const int descriptor : {full, read_only, -1}) {
    ZipWriter zip(descriptor);
    zip.add_text("short", "text");
    const auto written = zip.finish();
    REQUIRE_FALSE(written);
    CHECK(written.error().code == Code::SC6012);
    CHECK(written.error().message.starts_with("writing failed: "));
    ::close(descriptor);
  }
}

}  // namespace softcnc::hal
