// SPDX-License-Identifier: MIT
#include "ipr/dialects/grbl_reading.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace softcnc::ipr {
namespace {

constexpr int kG[] = {0,   10,  20,  30,  40,  100, 170, 180, 190, 200, 210, 280, 281,
                      300, 301, 382, 383, 384, 385, 400, 431, 490, 530, 540, 550, 560,
                      570, 580, 590, 610, 800, 900, 910, 911, 920, 921, 930, 940};
constexpr int kM[] = {0, 10, 20, 30, 40, 50, 70, 80, 90, 300, 560};

template <std::size_t kCount>
bool holds(const int (&codes)[kCount], int code) noexcept {
  return std::find(std::begin(codes), std::end(codes), code) != std::end(codes);
}

}  // namespace

bool is_grbl_code(char letter, int tenths) noexcept {
  return letter == 'G' ? holds(kG, tenths) : holds(kM, tenths);
}

bool is_grbl_letter(char letter) noexcept {
  return std::string_view("GMFSTNIJKLPRXYZ").find(letter) != std::string_view::npos;
}

bool takes_grbl_radii(double start, double end) noexcept {
  constexpr double kClose = 0.005, kMost = 0.5, kOfRadius = 0.001;
  constexpr double kRounding = 1e-9;  // mm, of the two radii
  const double off = std::abs(end - start) - kRounding;
  return off <= kClose || (off <= kMost && off <= kOfRadius * start);
}

std::size_t computed_at(std::string_view line) noexcept {
  bool comment = false;
  for (std::size_t at = 0; at < line.size() && (comment || line[at] != ';'); ++at) {
    comment = comment ? line[at] != ')' : line[at] == '(';
    if (!comment && std::string_view("#[Oo").find(line[at]) != std::string_view::npos) return at;
  }
  return std::string_view::npos;
}

}  // namespace softcnc::ipr
