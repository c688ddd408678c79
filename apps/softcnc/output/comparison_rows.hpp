// SPDX-License-Identifier: MIT
// A comparison of interpolation methods as text, CSV or JSON.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "motion/model/machine.hpp"
#include "runtime/comparison/spread.hpp"

namespace softcnc::app {

/// One method on one program and machine.
struct ComparisonRow {
  std::string program, machine;  // their names
  std::string machine_file;      // empty: the built-in machine
  Method method = Method::arc_length;
  int phases = 0;  // places within the period at which the program was begun
  std::vector<std::optional<runtime::Spread>> spreads;  // as long as runtime::compared_figures()
  std::string note;  // why the method cannot run the program; empty: it can
};

/// Tables for a person: one for the medians and one for the worst values of each program and
/// machine, or a single one where there is one phase. What means nothing is "-", and a method that
/// cannot run the program has its reason instead of figures. Rows of the same program and machine
/// must follow one another.
std::string comparison_text(std::span<const ComparisonRow> rows);

/// A header, then a line for each row: the names, then median and worst of each figure, then the
/// note. What means nothing is empty. Numbers are in the shortest form that reads back exactly;
/// fields with commas, quotation marks or line ends are quoted (RFC 4180).
std::string comparison_csv(std::span<const ComparisonRow> rows);

/// {"schema":1,"rows":[...]}: an object for each row, with the keys of comparison_csv(). What means
/// nothing is null.
std::string comparison_json(std::span<const ComparisonRow> rows);

}  // namespace softcnc::app
