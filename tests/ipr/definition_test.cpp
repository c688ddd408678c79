// SPDX-License-Identifier: MIT
// Variables that are set from outside: by --define, and by the state.
#include "ipr/expressions/definition.hpp"

#include <catch2/catch.hpp>

#include "ipr/ends.hpp"
#include "ipr/interpret.hpp"
#include "support/shown.hpp"

namespace softcnc::ipr {
namespace {

std::string read_definition(const std::string& text) {
  const auto definition = parse_definition(text);
  if (!definition) return "nothing";
  return shown_name(*definition) + " " + std::to_string(definition->value);
}

Interpreted run_defined(const std::string& text, const std::vector<std::string>& definitions,
                        const MachineState& state = {}, Dialect dialect = Dialect::linuxcnc) {
  InterpreterOptions options = in(dialect);
  for (const std::string& one : definitions) options.definitions.push_back(*parse_definition(one));
  return interpret(text, {}, options, state);
}

}  // namespace

TEST_CASE("definitions are names or numbers with a value", "[ipr][definition]") {
  CHECK(read_definition("_td=3") == "#<_td> 3.000000");
  CHECK(read_definition("#<_td>=-2.5e1") == "#<_td> -25.000000");
  CHECK(read_definition(" _T D = +.5 ") == "#<_td> 0.500000");
  CHECK(read_definition("500=3.5") == "#500 3.500000");
  CHECK(read_definition("#500=3.5") == "#500 3.500000");
  for (const char* wrong : {"", "=", "_td", "_td=", "_td=x", "_td=1x", "_td=nan", "_td=inf", "td=1",
                            "_=1", "#=1", "0=1", "05=1", "1234567890=1", "_a>b=1", "-5=1", "5.5=1"})
    CHECK(read_definition(wrong) == "nothing");
}

TEST_CASE("a program reads what has been defined", "[ipr][definition]") {
  CHECK(last_x(run_defined("G0 X#<_td>\nM2\n", {"_td=3"})) == 3);
  CHECK(last_x(run_defined("G0 X#<_TD>\nM2\n", {"_td=3", "_Td=4"})) == 4);
  CHECK(last_x(run_defined("G0 X#100\nM2\n", {"100=7"})) == 7);
  CHECK(last_x(run_defined("G0 X#100\nM30\n", {"100=7"}, {}, Dialect::fanuc)) == 7);
  CHECK(
      last_x(run_defined("o1 sub\nG0 X[#<_td> + 1]\no1 endsub\n#<_td>=[#<_td> * 2]\no1 call\nM2\n",
                         {"_td=3"})) == 7);
}

TEST_CASE("variables of the system and of calls cannot be defined", "[ipr][definition]") {
  for (const char* name : {"_x", "_line", "_metric", "5", "30", "5221", "5420", "7000"}) {
    CAPTURE(name);
    const Interpreted result = run_defined("G0 X1\nM2\n", {std::string(name) + "=1"});
    REQUIRE(result.diagnostics.size() == 1);
    CHECK(shows(render(result.diagnostics.front()), "--define: error: #"));
    CHECK(shows(render(result.diagnostics.front()),
                " cannot be defined: it is no variable that outlives calls and belongs to programs "
                "[SC2318]"));
  }
}

TEST_CASE("named globals of the state are read, and kept as the program leaves them",
          "[ipr][definition]") {
  MachineState state;
  state.globals = {{"_td", 3.0}, {"_unchanged", 1.0}, {"_x", 99.0}};
  const Interpreted result =
      run_defined("G0 X#<_td>\n#<_td>=[#<_td> + 2]\n#<_new>=7\n#<td>=8\nM2\n", {}, state);
  CHECK(last_x(result) == 3);
  CHECK(result.state.globals ==
        std::map<std::string, double>{{"_td", 5.0}, {"_unchanged", 1.0}, {"_x", 99.0}});
}

TEST_CASE("a definition goes before the state for one run", "[ipr][definition]") {
  MachineState state;
  state.globals = {{"_td", 3.0}};
  state.parameters = {{500, 1.0}};
  const Interpreted read_only = run_defined("G0 X[#<_td> + #500]\nM2\n", {"_td=4", "500=2"}, state);
  CHECK(last_x(read_only) == 6);
  CHECK(read_only.state == state);
  const Interpreted assigned = run_defined("G0 X1\n#<_td>=[#<_td> + 1]\nM2\n", {"_td=4"}, state);
  CHECK(assigned.state.globals.at("_td") == 5);
}

TEST_CASE("what an error makes unknown is not kept", "[ipr][definition]") {
  MachineState state;
  state.globals = {{"_td", 3.0}};
  const Interpreted result = run_defined("#<_td>=[1/0]\nM2\n", {}, state);
  CHECK(places(result) == std::vector<std::string>{"SC1021 1:11"});
  CHECK(result.state.globals.at("_td") == 3);
}

}  // namespace softcnc::ipr
