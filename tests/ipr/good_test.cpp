// SPDX-License-Identifier: MIT
// tests/good: programs as people and CAM systems write them, with which nothing is wrong. A comment
// in each says what it makes, "expect 12 blocks, 345.678 mm, to 0 0 10": how many blocks, the
// length of all moves, and where the last one ends in machine coordinates.
#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "ipr/interpret.hpp"

namespace softcnc::ipr {
namespace {

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

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

}  // namespace

TEST_CASE("a good program is read without a word, and all of it", "[ipr][good]") {
  int files = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(SOFTCNC_SOURCE_DIR) + "/tests/good")) {
    if (entry.path().extension() != ".nc") continue;
    INFO(entry.path().filename().string());
    auto reader = Reader::open(entry.path().string());
    REQUIRE(reader);
    const Interpreted result = interpret(std::move(*reader));
    for (const Diagnostic& diagnostic : result.diagnostics) FAIL_CHECK(render(diagnostic));
    REQUIRE_FALSE(result.blocks.empty());
    const auto* end = std::get_if<Action>(&result.blocks.back().what);
    CHECK((end != nullptr && end->kind == Action::Kind::end));
    CHECK(made(result.blocks) == expected(bytes_of(entry.path())));
    ++files;
  }
  CHECK(files >= 200);
}

}  // namespace softcnc::ipr
