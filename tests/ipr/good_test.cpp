// SPDX-License-Identifier: MIT
// tests/good: programs as people and CAM systems write them, with which nothing is wrong. A comment
// in each says what it makes, "expect 12 blocks, 345.678 mm, to 0 0 10": how many blocks, the
// length of all moves, and where the last one ends in machine coordinates. Those in tests/dialects
// are as good, but the other dialect would do something else.
#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>

#include "ipr/interpret.hpp"
#include "support/files.hpp"

namespace softcnc::ipr {
namespace {

/// As the comment says it: rounded to a thousandth, no trailing zeros.
std::string thousandths(double value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.3f", value);
  std::string number(text.data());
  number.erase(number.find_last_not_of('0') + 1);
  if (number.back() == '.') number.pop_back();
  return number == "-0" ? "0" : number;
}

std::string made(const std::vector<Block>& blocks) {
  double way = 0;
  AxisVector end = AxisVector::Zero();
  for (const Block& block : blocks) {
    const auto* move = std::get_if<Move>(&block.what);
    if (move == nullptr) continue;
    way += length(move->path);
    end = softcnc::end(move->path);
  }
  return std::to_string(blocks.size()) + " blocks, " + thousandths(way) + " mm, to " +
         thousandths(end.x()) + " " + thousandths(end.y()) + " " + thousandths(end.z());
}

/// Behind "expect ", up to what ends the comment.
std::string expected(const std::string& bytes) {
  const std::string key = "expect ";
  const std::size_t found = bytes.find(key);
  if (found == std::string::npos) return "a comment that says what is expected";
  const std::size_t begin = found + key.size();
  return bytes.substr(begin, bytes.find_first_of(")\r\n", begin) - begin);
}

std::vector<std::filesystem::path> files_in(const std::string& folder) {
  std::vector<std::filesystem::path> all;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(SOFTCNC_SOURCE_DIR) + folder))
    if (entry.path().extension() == ".nc") all.push_back(entry.path());
  return all;
}

Interpreted read_good(const std::filesystem::path& file, bool compare_dialects) {
  auto reader = Reader::open(file.string());
  REQUIRE(reader);
  InterpreterOptions options;
  options.compare_dialects = compare_dialects;
  return interpret(std::move(*reader), {}, options);
}

/// Nothing is reported, and the blocks are as the comment says.
void check_file(const std::filesystem::path& file, bool compare_dialects) {
  INFO(file.filename().string());
  const Interpreted result = read_good(file, compare_dialects);
  for (const Diagnostic& diagnostic : result.diagnostics) FAIL_CHECK(render(diagnostic));
  REQUIRE_FALSE(result.blocks.empty());
  const auto* end = std::get_if<Action>(&result.blocks.back().what);
  CHECK((end != nullptr && end->kind == Action::Kind::end));
  CHECK(made(result.blocks) == expected(test::bytes_of(file)));
}

}  // namespace

TEST_CASE("a good program is read without a word, and all of it", "[ipr][good]") {
  const auto files = files_in("/tests/good");
  for (const auto& file : files) check_file(file, true);
  CHECK(files.size() >= 200);
}

TEST_CASE("a program that means something else in the other dialect is as good", "[ipr][good]") {
  const auto files = files_in("/tests/dialects");
  for (const auto& file : files) {
    check_file(file, false);
    INFO(file.filename().string());
    const Interpreted compared = read_good(file, true);
    CHECK_FALSE(compared.diagnostics.empty());
    for (const Diagnostic& diagnostic : compared.diagnostics)
      CHECK(diagnostic.message.find("; in the fanuc dialect: ") != std::string::npos);
  }
  CHECK_FALSE(files.empty());
}

}  // namespace softcnc::ipr
