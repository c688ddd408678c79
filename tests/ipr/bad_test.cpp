// SPDX-License-Identifier: MIT
// tests/bad: every way to be wrong has a file, whose first line says what is to be reported and
// where; expected.txt there says it with the texts.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "ipr/interpret.hpp"
#include "support/files.hpp"

namespace softcnc::ipr {
namespace {

std::vector<std::filesystem::path> files() {
  std::vector<std::filesystem::path> all;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(SOFTCNC_SOURCE_DIR) + "/tests/bad"))
    if (entry.path().extension() == ".nc") all.push_back(entry.path());
  std::sort(all.begin(), all.end());
  return all;
}

/// What is between "(expect" and ")" on the first line; in UTF-16 too.
std::string expectation(const std::string& bytes) {
  std::string line;
  for (const char c : bytes.substr(0, bytes.find(')')))
    if (c > 0) line += c;
  const std::string key = "(expect ";
  REQUIRE(line.find(key) != std::string::npos);
  return line.substr(line.find(key) + key.size());
}

Places expected_places(const std::string& expectation) {
  std::istringstream list(expectation.substr(0, expectation.find(';')));
  Places all;
  for (std::string place; std::getline(list, place, ',');)
    all.push_back(place.substr(place.find_first_not_of(' ')));
  return all;
}

/// "; axes XZ": the machine has these only. "; limit 1000": its loops run so many lines. ";
/// inputs": it has a digital and an analog input, which are 0.
Machine machine_for(const std::string& expectation) {
  Machine machine;
  const std::string limit = "; limit ";
  if (const std::size_t at = expectation.find(limit); at != std::string::npos)
    machine.program.block_limit = std::stoi(expectation.substr(at + limit.size()));
  if (expectation.find("; inputs") != std::string::npos) {
    machine.inputs["door"].kind = SignalKind::digital;
    machine.inputs["adaptive-feed"].kind = SignalKind::analog;
  }
  const std::string key = "; axes ";
  const std::size_t found = expectation.find(key);
  if (found == std::string::npos) return machine;
  for (std::size_t i = 0; i < kAxes; ++i)
    machine.axes[i].present =
        expectation.find(kAxisLetters[i], found + key.size()) != std::string::npos;
  return machine;
}

/// "; fanuc": read in this dialect, "; auto" in the one that the text shows. "; check": compared
/// with the other one.
InterpreterOptions options_for(const std::string& expectation) {
  InterpreterOptions options;
  for (const Dialect dialect : kAllDialects)
    if (expectation.find("; " + std::string(name(dialect))) != std::string::npos)
      options.dialect = dialect;
  options.guess_dialect = expectation.find("; auto") != std::string::npos;
  options.compare_dialects = expectation.find("; check") != std::string::npos;
  return options;
}

Interpreted read_bad(const std::filesystem::path& file) {
  const std::string bytes = test::bytes_of(file);
  return interpret(bytes, machine_for(expectation(bytes)), options_for(expectation(bytes)));
}

/// As softcnc shows it, without the source line: file, line, column, severity, code and text.
std::string first_line(Diagnostic diagnostic, const std::filesystem::path& file) {
  diagnostic.file = file.filename().string();
  const std::string shown = render(diagnostic);
  return shown.substr(0, shown.find('\n'));
}

/// tests/bad/expected.txt, by the file that each line begins with.
std::map<std::string, Told> expected_lines() {
  std::ifstream stream(std::string(SOFTCNC_SOURCE_DIR) + "/tests/bad/expected.txt");
  std::map<std::string, Told> expected;
  for (std::string line; std::getline(stream, line);)
    expected[line.substr(0, line.find(':'))].push_back(line);
  return expected;
}

/// Codes of the interpreter's own: characters and words, modes and motion, blocks of a NURBS. Those
/// from 2380 to 2383 are reported where a surface is cut: apps/surface_test.cpp; 1059 where errors
/// are shown: apps/repeated_errors_test.cpp.
bool is_own(Code code) {
  if (code == Code::SC2317 || code == Code::SC2318) return false;  // of folders and definitions
  const int number = static_cast<int>(code);
  if (code == Code::SC1059 || code == Code::SC1060) return false;  // of files as a whole
  return number < 2380 || number == 2384 || (number >= 3100 && number < 3200);
}

}  // namespace

TEST_CASE("a bad program is reported what is wrong with it, where, and nothing else",
          "[ipr][bad]") {
  for (const auto& file : files()) {
    INFO(file.filename().string());
    CHECK(places(read_bad(file)) == expected_places(expectation(test::bytes_of(file))));
  }
}

TEST_CASE("every diagnostic of a bad program has its place, its code and its text together",
          "[ipr][bad]") {
  std::map<std::string, Told> reported;
  for (const auto& file : files())
    for (const Diagnostic& diagnostic : read_bad(file).diagnostics)
      reported[file.filename().string()].push_back(first_line(diagnostic, file));
  std::map<std::string, Told> expected = expected_lines();
  for (const auto& [file, lines] : reported) CHECK(lines == expected[file]);
  for (const auto& [file, lines] : expected) CHECK(reported[file] == lines);
}

TEST_CASE("every code of the interpreter has a bad program", "[ipr][bad]") {
  std::set<Code> reported;
  for (const auto& file : files())
    for (const Diagnostic& diagnostic : read_bad(file).diagnostics)
      reported.insert(diagnostic.code);
  for (const CodeInfo& row : code_table()) {
    INFO("SC" << static_cast<int>(row.code));
    CHECK((!is_own(row.code) || reported.count(row.code) == 1));
  }
}

}  // namespace softcnc::ipr
