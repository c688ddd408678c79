// SPDX-License-Identifier: MIT
// The form of the pages: their lines wrap, the files that they name exist, and every page is
// listed.
#include <catch2/catch.hpp>
#include <regex>
#include <string_view>

#include "house/sources.hpp"

using namespace softcnc::house;

namespace {

constexpr std::ptrdiff_t kMostColumns = 100;

/// Returns every page of the project, named from the root: "docs/feed.md".
std::vector<Source> pages() {
  std::vector<std::filesystem::path> files{"README.md", "CHANGELOG.md", "CONTRIBUTING.md"};
  for (const auto& entry : std::filesystem::directory_iterator(kRoot / "docs"))
    if (entry.path().extension() == ".md")
      files.push_back(std::filesystem::relative(entry.path(), kRoot));
  std::vector<Source> all;
  for (const std::filesystem::path& file : files) {
    std::ifstream in(kRoot / file);
    all.push_back(source_from(file.generic_string(), in));
  }
  return all;
}

/// Returns the number of characters of a line in UTF-8.
std::ptrdiff_t columns(std::string_view line) {
  return std::count_if(line.begin(), line.end(),
                       [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
}

/// What may be longer: a row of a table, code, a picture, and a comment.
bool is_free_line(std::string_view line) {
  for (const std::string_view beginning : {"|", "    ", "![", "<!--"})
    if (line.starts_with(beginning)) return true;
  return false;
}

/// Lines of text that are too long, outside of code and of what is generated.
Faults lines_too_long(const Source& page) {
  Faults faults;
  bool in_code = false, in_generated = false;
  for (std::size_t i = 0; i < page.lines.size(); ++i) {
    const std::string& line = page.lines[i];
    if (line.starts_with("```")) in_code = !in_code;
    if (line.starts_with("<!-- begin") || line == "<!-- surface_table -->") in_generated = true;
    if (line.starts_with("<!-- end")) in_generated = false;
    if (!in_code && !in_generated && !is_free_line(line) && columns(line) > kMostColumns)
      faults.push_back(page.place(i));
  }
  return faults;
}

/// Returns whether a name is that of a file or a folder, as pages give it: from the root, or
/// without its suffix.
bool exists(const std::string& name) {
  for (const char* suffix : {"", ".hpp", ".cpp"})
    if (std::filesystem::exists(kRoot / (name + suffix))) return true;
  return false;
}

/// Names in a page of files that do not exist: below libs, apps and tests from the root, and those
/// of the planner from libs/ipo.
Faults files_missing(const Source& page) {
  static const std::regex name("`(([a-z]+)/[a-z_0-9./]+)`");
  Faults faults;
  for (const std::string& line : page.lines)
    for (std::sregex_iterator found(line.begin(), line.end(), name), end; found != end; ++found) {
      const std::string file = (*found)[1], top = (*found)[2];
      const bool is_planner = std::filesystem::exists(kRoot / "libs/ipo" / top);
      const bool is_from_root = top == "libs" || top == "apps" || top == "tests";
      if ((is_from_root && !exists(file)) || (is_planner && !exists("libs/ipo/" + file)))
        faults.push_back(page.name + ": " + file);
    }
  return faults;
}

}  // namespace

TEST_CASE("lines of pages have at most 100 columns, except tables and code", "[house][docs]") {
  CHECK(listed(over(pages(), lines_too_long)) == "");
  const std::string long_line(101, 'x');
  CHECK(lines_too_long(planted("a.md", "short\n" + long_line)) == Faults{"a.md:2: " + long_line});
  CHECK(lines_too_long(planted("a.md", "```\n" + long_line + "\n```\n| " + long_line)).empty());
  CHECK(lines_too_long(planted("a.md", std::string(99, 'x') + "µ")).empty());
}

TEST_CASE("files and folders that pages name exist", "[house][docs]") {
  CHECK(listed(over(pages(), files_missing)) == "");
  CHECK(files_missing(planted("a.md", "`libs/ipo/path` `libs/attic` `path/grid` `path/attic`")) ==
        Faults{"a.md: libs/attic", "a.md: path/attic"});
}

TEST_CASE("every page of docs is listed in docs/README.md", "[house][docs]") {
  const std::string list = text_of(kRoot / "docs/README.md");
  for (const Source& page : pages()) {
    const std::string file = std::filesystem::path(page.name).filename().string();
    CAPTURE(page.name);
    if (page.name.starts_with("docs/") && page.name != "docs/README.md")
      CHECK(list.find("](" + file + ")") != std::string::npos);
  }
}
