// SPDX-License-Identifier: MIT
#include "operate/line_editor.hpp"

#include <utility>

namespace softcnc::app {

void LineEditor::recall(std::size_t index) {
  if (recalled_ == before_.size()) typed_ = text_;
  recalled_ = index;
  text_ = index < before_.size() ? before_[index] : typed_;
  cursor_ = text_.size();
}

void LineEditor::key(const Key& key) {
  switch (key.kind) {
    case Key::Kind::character:
      if (text_.size() < kLongest) text_.insert(cursor_++, 1, key.character);
      break;
    case Key::Kind::backspace:
      if (cursor_ > 0) text_.erase(--cursor_, 1);
      break;
    case Key::Kind::delete_:
      if (cursor_ < text_.size()) text_.erase(cursor_, 1);
      break;
    case Key::Kind::left:
      if (cursor_ > 0) --cursor_;
      break;
    case Key::Kind::right:
      if (cursor_ < text_.size()) ++cursor_;
      break;
    case Key::Kind::home:
      cursor_ = 0;
      break;
    case Key::Kind::end:
      cursor_ = text_.size();
      break;
    case Key::Kind::up:
      if (recalled_ > 0) recall(recalled_ - 1);
      break;
    case Key::Kind::down:
      if (recalled_ < before_.size()) recall(recalled_ + 1);
      break;
    default:
      break;
  }
}

std::string LineEditor::take() {
  const bool is_new = !text_.empty() && (before_.empty() || before_.back() != text_);
  if (is_new) before_.push_back(text_);
  if (before_.size() > kKept) before_.erase(before_.begin());
  std::string taken = std::exchange(text_, {});
  clear();
  return taken;
}

void LineEditor::clear() {
  text_.clear();
  typed_.clear();
  cursor_ = 0;
  recalled_ = before_.size();
}

}  // namespace softcnc::app
