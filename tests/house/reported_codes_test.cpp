// SPDX-License-Identifier: MIT
// Every code of the table of diagnostics has a test that asserts it as a user reads it: place, code
// and text together, as they stand in a string of a test or in tests/bad/expected.txt.
#include <catch2/catch.hpp>
#include <iterator>
#include <regex>
#include <set>

#include "house/sources.hpp"
#include "motion/core/diagnostic.hpp"

using namespace softcnc;
using namespace softcnc::house;

namespace {

/// Codes of files, ports, runs and surfaces as a whole, which have no line; and 3003, which no
/// program gets.
const std::set<Code> kWithoutPlace{
    Code::SC2318, Code::SC2382, Code::SC3003, Code::SC4002, Code::SC4003, Code::SC4030,
    Code::SC4031, Code::SC4040, Code::SC5030, Code::SC5031, Code::SC5032, Code::SC5033,
    Code::SC5040, Code::SC5041, Code::SC5050, Code::SC5060, Code::SC5070, Code::SC5071,
    Code::SC5072, Code::SC5080, Code::SC5090, Code::SC6001, Code::SC6002, Code::SC6003,
    Code::SC6004, Code::SC6011, Code::SC6012, Code::SC6013, Code::SC6014, Code::SC6015,
    Code::SC6016, Code::SC6017, Code::SC6018, Code::SC6019, Code::SC6021, Code::SC6022,
    Code::SC6023, Code::SC6024, Code::SC6025, Code::SC6026, Code::SC6032, Code::SC6041,
    Code::SC6050, Code::SC6060, Code::SC6062, Code::SC6070, Code::SC6071, Code::SC6072,
    Code::SC6073, Code::SC6074, Code::SC6075, Code::SC6076, Code::SC6081, Code::SC6084,
    Code::SC6085, Code::SC6090, Code::SC6100, Code::SC7003, Code::SC7014, Code::SC7017,
    Code::SC7031, Code::SC7032, Code::SC7033, Code::SC7038, Code::SC7050, Code::SC7072,
    Code::SC9001};

struct Asserted {
  std::set<std::string> with_place, without_place;
};

/// Returns a source in which literals that follow one another are one.
std::string joined(const std::string& source) {
  static const std::regex between_literals("\"\\s+\"");
  return std::regex_replace(source, between_literals, "");
}

/// Returns the code at the end of the diagnostic that begins at a byte of `text`; empty if another
/// diagnostic, or another statement, begins before it.
std::string code_after(const std::string& text, std::size_t begin) {
  static const std::regex end_or_code(R"(: (error|warning|note): |\);|\n\S|\[(SC\d{4})\])");
  std::smatch found;
  const auto from = text.begin() + static_cast<std::ptrdiff_t>(begin);
  return std::regex_search(from, text.end(), found, end_or_code) ? found[2].str() : "";
}

/// Adds the codes of the diagnostics in `text` that have the form in which render() shows them.
void collect(const std::string& text, Asserted& asserted) {
  static const std::regex shown(R"((:\d+(:\d+)?)?: (error|warning|note): (?!\.\.\.)[^"\\\n]{8})");
  for (std::sregex_iterator found(text.begin(), text.end(), shown), end; found != end; ++found) {
    const bool has_place = (*found)[1].matched;
    const auto after = static_cast<std::size_t>(found->position() + found->length());
    const std::string code = code_after(text, after);
    if (!code.empty()) (has_place ? asserted.with_place : asserted.without_place).insert(code);
  }
}

std::string all_of(const Source& source) {
  std::string text;
  for (const std::string& line : source.lines) text += line + '\n';
  return text;
}

Asserted asserted_by_tests() {
  Asserted asserted;
  for (const Source& source : sources_below("tests")) collect(joined(all_of(source)), asserted);
  std::ifstream expected(kRoot / "tests/bad/expected.txt");
  collect({std::istreambuf_iterator<char>(expected), {}}, asserted);
  return asserted;
}

}  // namespace

TEST_CASE("every diagnostic has a test of its place, its code and its text", "[house][code]") {
  const Asserted asserted = asserted_by_tests();
  for (const CodeInfo& row : code_table()) {
    CAPTURE(code_name(row.code));
    const bool is_placeless = kWithoutPlace.count(row.code) == 1;
    CHECK(
        (is_placeless ? asserted.without_place : asserted.with_place).count(code_name(row.code)) ==
        1);
  }
}

TEST_CASE("only what is shown in full counts as a test of a diagnostic", "[house][code]") {
  Asserted found;
  collect(joined("\"a.nc:2:3: error: some\"\n   \" words [SC1111]\""), found);
  collect("\"a.nc: note: some words [SC2222]\"", found);
  collect("\"a.nc:2:3: error: ... [SC3333]\"", found);              // no text
  collect("\"warning: some words [SC4444]\"", found);               // of what file?
  collect("\"a.nc: note: some words\"); f(\"[SC6666]\");", found);  // another statement
  collect("Code::SC5555, {3, 4}, \"some words\"", found);           // not asserted together
  CHECK(found.with_place == std::set<std::string>{"SC1111"});
  CHECK(found.without_place == std::set<std::string>{"SC2222"});
}
