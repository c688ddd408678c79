// SPDX-License-Identifier: MIT
#include "operate/key_decoder.hpp"

#include <utility>

namespace softcnc::app {
namespace {

using Kind = Key::Kind;

constexpr unsigned char kControlC = 3, kBackspace = 8, kEscape = 27, kDelete = 127;
constexpr std::size_t kLongest = 32;  // bytes of a sequence

/// Of ESC [ and ESC O.
Key key_of_letter(char letter) noexcept {
  switch (letter) {
    case 'A':
      return {Kind::up};
    case 'B':
      return {Kind::down};
    case 'C':
      return {Kind::right};
    case 'D':
      return {Kind::left};
    case 'H':
      return {Kind::home};
    case 'F':
      return {Kind::end};
    case 'M':  // of the number pad
      return {Kind::enter};
    default:
      return {};
  }
}

Key key_of_sequence(std::string_view sequence) noexcept {
  if (sequence.size() == 1 && sequence != "M") return key_of_letter(sequence.front());
  if (sequence == "5~") return {Kind::page_up};
  if (sequence == "6~") return {Kind::page_down};
  if (sequence == "3~") return {Kind::delete_};
  if (sequence == "1~" || sequence == "7~") return {Kind::home};
  if (sequence == "4~" || sequence == "8~") return {Kind::end};
  return {};
}

Key key_of_plain(unsigned char byte) noexcept {
  if (byte == kControlC) return {Kind::interrupt};
  if (byte == '\r' || byte == '\n') return {Kind::enter};
  if (byte == kBackspace || byte == kDelete) return {Kind::backspace};
  return byte >= ' ' && byte < kDelete ? key_of(static_cast<char>(byte)) : Key{};
}

}  // namespace

std::vector<Key> KeyDecoder::take(std::string_view bytes, double now) {
  std::vector<Key> keys;
  if (const auto escape = wait(now)) keys.push_back(*escape);
  since_ = now;
  for (const char c : bytes)
    if (const auto key = take_byte(static_cast<unsigned char>(c))) keys.push_back(*key);
  return keys;
}

std::optional<Key> KeyDecoder::take_byte(unsigned char byte) {
  if (byte == kEscape) {
    const bool was_escape = state_ == State::escape;
    state_ = State::escape;
    sequence_.clear();
    return was_escape ? std::optional(Key{Kind::escape}) : std::nullopt;
  }
  if (byte == kControlC) {  // it never belongs to a sequence
    state_ = State::plain;
    return Key{Kind::interrupt};
  }
  switch (state_) {
    case State::plain:
      return key_of_plain(byte);
    case State::escape:
      state_ = byte == '[' ? State::sequence : byte == 'O' ? State::letter : State::plain;
      return state_ == State::plain ? std::optional(Key{}) : std::nullopt;
    case State::letter:
      state_ = State::plain;
      return key_of_letter(static_cast<char>(byte));
    case State::sequence:
      break;
  }
  if (sequence_.size() < kLongest) sequence_ += static_cast<char>(byte);
  const bool ends = byte >= '@' && byte <= '~';
  if (!ends) return std::nullopt;
  state_ = State::plain;
  return key_of_sequence(std::exchange(sequence_, {}));
}

std::optional<Key> KeyDecoder::wait(double now) noexcept {
  if (state_ == State::plain || now - since_ < kPatience) return std::nullopt;
  const bool is_escape = std::exchange(state_, State::plain) == State::escape;
  sequence_.clear();
  return is_escape ? Key{Kind::escape} : Key{};
}

}  // namespace softcnc::app
