// SPDX-License-Identifier: MIT
// The texts of a program, its own and those it calls, and the subprograms in them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "ipr/parser/parser.hpp"
#include "ipr/text/called_texts.hpp"

namespace softcnc::ipr {

/// A place between two lines of one of the texts.
struct Spot {
  int file = 0;  // SourcePos::file
  Reader::Place place;
};

/// The two ways in which a subprogram begins.
enum class SubKind : std::uint8_t {
  o_word,   // `o100 sub`, ended by `o100 endsub`
  program,  // `O100` alone, or the beginning of a file of its own; ended by M99
  lines     // the lines from one number on, `N100`; ended by M99
};

/// A subprogram: its name, and what lies after its first line.
struct Subprogram {
  SubKind kind = SubKind::o_word;
  std::string label;
  Spot begin;
};

/// Returns a statement as it is written: "o100 sub", "o<name> call".
std::string o_word(std::string_view label, std::string_view keyword = {});
/// Returns the name of a program: "O1000", "O<name>".
std::string program_name(std::string_view label);

/// The folders of called files: first that of the program, empty if it has none, then those of the
/// search path, out of which no link may lead.
using Folders = std::vector<std::string>;

/// A called file. In the folder of the program `name` is its name there, in the n-th folder of the
/// search path (from 1) it is "n/NAME": so a recording names it, wherever the folders were.
struct FoundFile {
  std::string name, path;
};

class Library {
 public:
  /// Makes a library that looks for called files in `folders`, in their order; nowhere if there are
  /// none. Their texts are kept in `called`, which must outlive the library, or in the library
  /// itself if `called` is nullptr.
  Library(Parser& parser, Diagnostics& diagnostics, Folders folders, CalledTexts* called = nullptr);

  /// Returns where the parser stands.
  Spot here() const;
  /// Makes the parser read on at a spot. Returns false, and reports it, where that is not possible.
  bool go(const Spot& spot);

  /// Returns the subprogram that a call means, looked for in the file of the call, in the main
  /// program and in the folders. `program` says that the call is M98 or G65. Returns nothing if
  /// there is none, or if its file cannot be read, which is reported at `call`. The parser's place
  /// stays; its line is lost.
  std::optional<Subprogram> find(const std::string& label, bool program, const SourcePos& call,
                                 std::string_view line);
  /// Returns all subprograms of the program's own file, in the order of their lines, including
  /// several of one name. The parser's place is lost.
  std::vector<Subprogram> all_of_program();
  /// Returns whether a line had a label or keyword that cannot be read: it may begin any
  /// subprogram.
  bool has_unread_label() const noexcept { return unread_label_; }
  /// Returns the known label that resembles an unknown one; an empty string if none does.
  std::string nearest(const std::string& label) const;

  /// Returns the files that have been called.
  std::vector<FoundFile> files() const;
  /// Returns the paths under which calls have looked for a file that is not there; 1000 at most.
  const std::set<std::string>& missing_files() const noexcept { return missing_; }
  /// Returns where find() looks, in words: "in this program, beside it or in macros".
  std::string places() const;
  /// Returns whether a go() has failed: the parser then stands nowhere in particular.
  bool is_lost() const noexcept { return lost_; }

 private:
  struct Text {
    std::unique_ptr<Reader> own;  // of a called file
    Reader* reader = nullptr;
    FoundFile found;
    std::map<std::string, Subprogram> subs, programs;
    Spot searched;  // subprograms before here are known
    bool searched_all = false;
  };

  const Subprogram* find_in(int file, const std::string& label, bool program);
  const Subprogram* known(const Text& text, const std::string& label, bool program) const;
  void search_on(int file, const std::string& label, bool program);
  void learn(Text& text, const ProgramLine& line);
  Subprogram begun_by(const Statement& statement) const;
  std::optional<Subprogram> find_file(const std::string& label, bool program, const SourcePos& call,
                                      std::string_view line);
  std::optional<int> open(std::size_t folder, const std::string& name, const SourcePos& call,
                          std::string_view line);
  Text& text(int file) { return texts_.at(file); }

  Parser& parser_;
  Diagnostics& diagnostics_;
  Folders folders_;
  CalledTexts own_;
  CalledTexts* called_;
  bool lost_ = false, unread_label_ = false;
  std::map<int, Text> texts_;                        // by SourcePos::file
  std::map<std::string, int, std::less<>> file_of_;  // by path; -1: unreadable
  std::set<std::string> missing_;
};

}  // namespace softcnc::ipr
