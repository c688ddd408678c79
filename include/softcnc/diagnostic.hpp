// SPDX-License-Identifier: MIT
// What is wrong with a program or a machine, and values that may be missing for that reason.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>
namespace softcnc::api {

enum class Severity : std::uint8_t { note, warning, error };

struct Diagnostic {
  std::string code;  // "SC2103"; docs/codes.md lists all
  Severity severity = Severity::error;
  std::string file;  // as it was named; empty where there is none
  int line = 0;      // from 1; 0: no place
  int column = 0;    // of characters, from 1; 0: the line as a whole
  int length = 1;    // characters
  std::string message;
  std::string source_line;  // empty if unknown
  std::string text;         // all of it, as softcnc check shows it: with a caret, and a newline
  std::string help;         // what to do about it
};

/// A value, or the diagnostics that explain why there is none.
template <typename T>
class Expected {
 public:
  Expected(T value) : content_(std::move(value)) {}
  Expected(std::vector<Diagnostic> errors) : content_(std::move(errors)) {}

  explicit operator bool() const noexcept { return content_.index() == 0; }
  /// Returns the value. Requires that there is one.
  T& operator*() { return *std::get_if<0>(&content_); }
  const T& operator*() const { return *std::get_if<0>(&content_); }
  T* operator->() { return std::get_if<0>(&content_); }
  const T* operator->() const { return std::get_if<0>(&content_); }

  /// Returns the errors, at least one. Requires that there is no value.
  const std::vector<Diagnostic>& errors() const { return *std::get_if<1>(&content_); }

 private:
  std::variant<T, std::vector<Diagnostic>> content_;
};

}  // namespace softcnc::api
