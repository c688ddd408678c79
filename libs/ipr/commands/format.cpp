// SPDX-License-Identifier: MIT
#include "ipr/commands/format.hpp"

#include <string>

#include "ipr/commands/command_line.hpp"
#include "ipr/text/reader.hpp"

namespace softcnc::ipr {
namespace {

/// What a line may be, by the name it begins with and how many numbers follow.
struct Shape {
  std::string name;
  int numbers = 0;
  double number = 0;           // the first one
  bool other = false;          // something else is on it
  std::string other_name;      // what it begins with
  bool command_after = false;  // and that can only be a command
  bool error = false;          // what no language has
  bool of_gcode = false;       // but G-code: a variable, a '%', a '/'
  bool skipped = false;        // begins with '/'
};

bool is_arc_command(std::string_view name) {
  return name == "pcw" || name == "pccw" || name == "dcw" || name == "dcaw" || name == "dccw";
}

/// A variable, its assignment, a '%', a '/', a '$' as of grbl: no line of the other language begins
/// so.
bool begins_gcode(std::string_view text) {
  if (text.starts_with('%') || text.starts_with('/') || text.starts_with('$')) return true;
  constexpr std::string_view kAfterSign{"0123456789<[#"};
  return text.size() > 1 && text.front() == '#' &&
         kAfterSign.find(text[1]) != std::string_view::npos;
}

/// A second name on a line, with what follows it: no word has that many numbers.
bool is_command(const std::string& name, CommandLine fields) {
  if (is_arc_command(name)) return true;
  std::size_t numbers = 0;
  while (fields.next().kind == CommandField::Kind::number) ++numbers;
  return (name == "l" && numbers > 1) || (name == "s" && numbers > 2);
}

Shape shape_of(std::string_view line) {
  Shape shape;
  shape.skipped = line.starts_with('/');
  CommandLine fields(line);
  for (auto field = fields.next(); field.kind != CommandField::Kind::end; field = fields.next()) {
    if (field.kind == CommandField::Kind::number) {
      if (shape.numbers++ == 0) shape.number = field.value;
    } else if (field.kind == CommandField::Kind::name && shape.name.empty() && shape.numbers == 0) {
      shape.name = field.name;
    } else if (field.kind == CommandField::Kind::error) {
      shape.error = true;
      shape.of_gcode = begins_gcode(line.substr(static_cast<std::size_t>(field.column) - 1));
    } else {
      shape.other = true;
      shape.other_name = field.name;
      shape.command_after = is_command(field.name, fields);
    }
    if (shape.other || shape.error) break;
  }
  return shape;
}

/// No letter at the beginning, or several, or one alone with its numbers that is neither a command
/// nor begins G-code: wrong in either, or nothing that moves. The other letters are those of codes,
/// numbers of lines and programs.
bool is_stray(const Shape& line) {
  if (line.name.empty()) return !line.of_gcode;
  if (line.name.size() > 1) return true;
  constexpr std::string_view kBeginners = "gmnotlsf";
  constexpr std::string_view kBesideNoFeed = "ijkpqrhdlbcuvwe";  // alone: `f 3J0`, for f 300
  if (line.name == "f" && line.other && line.other_name.size() == 1 &&
      kBesideNoFeed.find(line.other_name) != std::string_view::npos)
    return true;
  const bool alone = !line.other && !line.error && line.numbers > 0;
  constexpr double kLargeCode = 200;  // no control has codes from here on: `M300` may be F300
  const bool no_code = (line.name == "m" || line.name == "g") && line.number >= kLargeCode;
  const bool several = line.numbers > 1 && (line.name == "f" || line.name == "g");  // `f3 00`
  const bool any = line.name == "o" || no_code || several;
  return alone && (any || kBeginners.find(line.name.front()) == std::string_view::npos);
}

/// `f 1M00`, `S6000 03`, `s N`, `/F 600`, `903` after S1000: a feed or a speed, or what is left of
/// a command or a code. The lines after it decide, if one does.
bool is_weak(const Shape& line, Format decided) {
  if (decided == Format::gcode) {
    const bool of_both = line.name == "f" || line.name == "l";
    const bool lone_spline = line.name == "s" && line.numbers == 0;
    return line.skipped || (line.other && (of_both || lone_spline));
  }
  return line.name.empty() ? line.numbers == 1 : line.name == "s" && line.numbers == 2;
}

/// Looks at lines until one decides.
class Detector {
 public:
  /// `text` begins with what has been looked at before; its last line may go on after it.
  void look(std::string_view text) {
    for (std::size_t end = text.find_first_of("\r\n", at_);
         end != std::string_view::npos && format_ == Format::automatic;
         end = text.find_first_of("\r\n", at_)) {
      decide(line(text, end));
      at_ = end + 1;
    }
  }
  void look_at_last(std::string_view text) {
    if (format_ == Format::automatic) decide(line(text, text.size()));
  }
  /// As far as the lines show, which may be weak.
  Format format() const noexcept { return format_ == Format::automatic ? weak_ : format_; }

 private:
  std::string_view line(std::string_view text, std::size_t end) const {
    if (at_ == 0 && text.starts_with(kByteOrderMark))
      return text.substr(kByteOrderMark.size(), end - kByteOrderMark.size());
    return text.substr(at_, end - at_);
  }

  void decide(std::string_view text) {
    const Shape line = shape_of(text.substr(0, text.find('\0')));  // after it the file is damaged
    const Format decided = known_by(line);
    const bool weak = decided != Format::automatic && is_weak(line, decided);
    if (!weak || weak_lines_++ == kMostWeakLines)
      format_ = decided;
    else if (weak_ == Format::automatic)
      weak_ = decided;
  }

  Format known_by(const Shape& line) {
    const std::string& name = line.name;
    const bool alone = line.numbers == 1 && !line.other;
    const bool of_both = name == "s" || name == "f" || name == "l";
    if (is_arc_command(name) || (of_both && line.command_after)) return Format::commands;
    if (name.empty() && line.numbers == 0 && !line.other && !line.error) return Format::automatic;
    if (name.empty() && spline_ && !line.error && !line.other) return Format::commands;
    const bool empty = of_both && line.numbers == 0 && !line.other;
    if (empty || is_stray(line) || (of_both && line.error)) return Format::automatic;
    const bool moves = name == "l" || name == "s" || name == "t";
    if (moves && line.numbers > 1 && !line.other) return Format::commands;
    if (!alone || !of_both) return Format::gcode;
    spline_ = name == "s";
    return Format::automatic;
  }

  static constexpr int kMostWeakLines = 20;

  Format format_ = Format::automatic, weak_ = Format::automatic;
  int weak_lines_ = 0;
  std::size_t at_ = 0;   // of the line to be looked at next
  bool spline_ = false;  // the line before may begin a spline
};

}  // namespace

Format detect_format(Reader& reader) {
  Detector detector;
  do {
    detector.look(reader.unread());
  } while (detector.format() == Format::automatic && reader.read_ahead());
  detector.look_at_last(reader.unread());
  return detector.format() == Format::commands ? Format::commands : Format::gcode;
}

}  // namespace softcnc::ipr
