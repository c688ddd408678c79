// SPDX-License-Identifier: MIT
#include "job/endless_rounds.hpp"

#include <algorithm>

namespace softcnc::app {
namespace {

constexpr int kBlocks = 20'000;  // of the longer reading
constexpr int kFirstRounds = 2;  // what is compensated may be told a round late

/// 0: nothing has been counted there.
template <typename Key>
int at(const std::map<Key, int>& counts, const Key& key) {
  const auto found = counts.find(key);
  return found == counts.end() ? 0 : found->second;
}

}  // namespace

bool leads_too_far(const Diagnostic& diagnostic) {
  return diagnostic.code == Code::SC4001 || diagnostic.code == Code::SC3008;
}

/// The lines of the loop are those that run more often the longer one reads.
std::vector<bool> follow_from_endless_loop(std::span<const Diagnostic> errors,
                                           const ReadRounds& read) {
  std::vector<bool> follows(errors.size(), false);
  const auto is_endless = [](const Diagnostic& error) { return error.code == Code::SC2310; };
  if (std::none_of(errors.begin(), errors.end(), is_endless)) return follows;
  const Rounds all = read(kBlocks), half = read(kBlocks / 2);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const auto& [line, column, length, file, call] = errors[i].pos;
    const bool of_loop = file == 0 && at(all.run, line) > at(half.run, line);
    const int round = at(all.first_told, {line, errors[i].code});
    follows[i] = of_loop && leads_too_far(errors[i]) && (round == 0 || round > kFirstRounds);
  }
  return follows;
}

}  // namespace softcnc::app
