// SPDX-License-Identifier: MIT
#include "runtime/run/foreign_language.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace softcnc::runtime {
namespace {

constexpr int kEnough = 3;  // weights of marks

constexpr std::string_view kControlNames[] = {
    "a Heidenhain control, in Klartext",
    "a Sinumerik control",
    "an Okuma control",
    "a 3-D printer",
};

/// A pattern as of file names (POSIX, fnmatch), of a line in capitals without its number.
struct LanguageMark {
  std::size_t control;
  int weight;
  const char* pattern;
};

constexpr LanguageMark kMarks[] = {
    {0, 3, "BEGIN PGM *"},
    {0, 2, "BLK FORM *"},
    {0, 2, "TOOL CALL *"},
    {0, 2, "CYCL DEF *"},
    {0, 1, "L [XYZIABC]*[-+][0-9]* [RF]*"},
    {0, 1, "CC [XYZI]*[-+][0-9]*"},
    {0, 1, "FN *[0-9]:*"},
    {0, 1, "LBL *"},
    {1, 3, "%_N_*_[MS]PF*"},
    {1, 2, "*CYCLE[0-9]*(*"},
    {1, 2, "DEF REAL *"},
    {1, 2, "DEF INT *"},
    {1, 2, "MSG*(\"*"},
    {1, 2, "*WORKPIECE(*"},
    {1, 2, "*[XYZIJKABC]=[AI]C(*"},
    {1, 1, "T=\"*"},
    {1, 1, "*TRANS [XYZ]*"},
    {1, 1, "*ROT [XYZ]*"},
    {1, 1, "* CR=*"},
    {1, 1, "* [XYZ]=*"},
    {1, 1, "R[0-9]*=*"},
    {1, 1, "MCALL*"},
    {1, 2, "*GOTO[FB] *"},
    {1, 1, "*RND=*"},
    {1, 1, "*CH[FR]=*"},
    {1, 1, "*SUPA*"},
    {1, 1, "G500*"},
    {1, 1, "*G64[1-5]*"},
    {1, 2, "TRAORI*"},
    {1, 1, "*SETMS(*"},
    {1, 1, "ENDPROC*"},
    {2, 3, "$*.MIN%*"},
    {2, 2, "CALL O*"},
    {2, 1, "NAT[0-9]*"},
    {2, 1, "V[0-9]*=*"},
    {2, 1, "VC[0-9]*=*"},
    {2, 1, "G15 H[0-9]*"},
    {2, 1, "V[A-Z][A-Z]*=*"},
    {2, 1, "*=V[0-9]*"},
    {3, 2, "G1 * E[-.0-9]*"},
    {3, 2, "G92 E*"},
    {3, 1, "M104*"},
    {3, 1, "M8[234]*"},
};
static_assert(std::size(kMarks) <= 64);

/// In capitals, without blanks and a block number before it.
std::string bare(std::string_view line) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  const auto skip = [&](auto is) {
    while (!line.empty() && is(line.front())) line.remove_prefix(1);
  };
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  skip(is_blank);
  std::string_view whole = line;
  if (!line.empty() && (line.front() == 'N' || line.front() == 'n')) line.remove_prefix(1);
  if (!line.empty() && is_digit(line.front())) {
    skip(is_digit);
    skip(is_blank);
  } else {
    line = whole;
  }
  std::string text(line);
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

}  // namespace

std::string_view kind_of_binary(std::string_view first_line) {
  constexpr std::pair<std::string_view, std::string_view> kKinds[] = {
      {"\x89PNG", "a PNG picture"},
      {"\xFF\xD8\xFF", "a JPEG picture"},
      {"%PDF", "a PDF document"},
      {"PK\x03\x04", "a zip archive"},
      {"\x1F\x8B", "a gzip archive"},
      {"\x28\xB5\x2F\xFD", "a zstd archive"},
      {"\x7F"
       "ELF",
       "a program"},
      {"GIF8", "a GIF picture"},
      {"<?xml", "an XML document"},
      {"<svg", "an SVG picture"},
      {"<!DOCTYPE", "an HTML document"},
      {"solid ", "an STL model"},
      {"ISO-10303-21", "a STEP model"}};
  for (const auto& [mark, kind] : kKinds)
    if (first_line.starts_with(mark)) return kind;
  const auto is_control = [](char c) { return c > 0 && c < ' ' && c != '\t' && c != '\r'; };
  const auto controls = std::count_if(first_line.begin(), first_line.end(), is_control);
  constexpr std::ptrdiff_t kMost = 4;  // a paper tape begins and ends with one or two
  return controls > kMost ? "no text" : std::string_view();
}

void ForeignLanguage::see(std::string_view line, int number) {
  const std::string text = bare(line);
  if (text.empty() || text.front() == '(' || text.front() == ';') return;
  for (std::size_t i = 0; i < std::size(kMarks); ++i) {
    const LanguageMark& mark = kMarks[i];
    if (seen_[i] || ::fnmatch(mark.pattern, text.c_str(), FNM_NOESCAPE) != 0) continue;
    seen_[i] = true;
    Evidence& evidence = evidence_[mark.control];
    evidence.weight += mark.weight;
    if (evidence.line == 0) {
      evidence.line = number;
      evidence.text = line;
    }
  }
}

std::size_t ForeignLanguage::best() const noexcept {
  const auto lighter = [](const Evidence& a, const Evidence& b) { return a.weight < b.weight; };
  return static_cast<std::size_t>(std::max_element(evidence_.begin(), evidence_.end(), lighter) -
                                  evidence_.begin());
}

bool ForeignLanguage::found() const noexcept { return evidence_[best()].weight >= kEnough; }
std::string_view ForeignLanguage::control() const noexcept { return kControlNames[best()]; }
int ForeignLanguage::line() const noexcept { return evidence_[best()].line; }
const std::string& ForeignLanguage::text() const noexcept { return evidence_[best()].text; }

}  // namespace softcnc::runtime
