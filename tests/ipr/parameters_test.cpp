// SPDX-License-Identifier: MIT
// Which variables there are, whose they are, and who may set them.
#include "ipr/expressions/parameters.hpp"

#include <catch2/catch.hpp>
#include <vector>

namespace softcnc::ipr {
namespace {

using Access = Parameters::Access;

/// One variable that may be read and one that may be written too.
class TwoVariables final : public SystemVariables {
 public:
  std::optional<double> read(int number) const override {
    if (number == 5420) return 12.5;
    if (number == 5221) return offset;
    return std::nullopt;
  }
  std::optional<double> read(std::string_view name) const override {
    return name == "_x" ? std::optional(12.5) : std::nullopt;
  }
  bool has(int number, Dialect) const override { return read(number).has_value(); }
  bool is_read_only(int number) const override { return number == 5420; }
  double fanuc_unit(int) const override { return 1; }
  double limit(int number) const override { return number == 5221 ? 1000 : 1e300; }
  bool write(int number, double value) override {
    if (number != 5221) return false;
    offset = value;
    return true;
  }
  void keep(int number, double value) override { kept[number] = value; }
  void keep(std::string_view name, double value) override { kept_names[std::string(name)] = value; }

  double offset = 0;
  std::map<int, double> kept;
  std::map<std::string, double> kept_names;
};

}  // namespace

TEST_CASE("what an earlier program has left counts, and is kept", "[ipr][parameters]") {
  Parameters parameters;
  TwoVariables system;
  parameters.set_system(&system);
  parameters.keep({{7, 1.0}, {31, 2.0}, {500, 3.5}, {5221, 9.0}});
  CHECK(parameters.read(7) == 0.0);  // local to the program
  CHECK(parameters.read(31) == 2.0);
  CHECK(parameters.read(500) == 3.5);
  CHECK(parameters.read(5221) == 0.0);  // an offset, which has a place of its own
  parameters.write(500, 4.5);
  parameters.write(600, 1.0);
  CHECK(parameters.read(500) == 4.5);
  CHECK(system.kept == std::map<int, double>{{500, 4.5}});
}

TEST_CASE("so does what has a name, if it is global and not of the system", "[ipr][parameters]") {
  Parameters parameters;
  TwoVariables system;
  parameters.set_system(&system);
  parameters.keep({{"_td", 3.0}, {"_x", 4.0}, {"td", 5.0}});
  CHECK(parameters.read("_td") == 3.0);
  CHECK(parameters.read("_x") == 12.5);
  CHECK_FALSE(parameters.read("td"));
  parameters.write("_td", 3.5);
  parameters.write("_other", 1.0);
  parameters.write("td", 2.0);
  CHECK(parameters.read("_td") == 3.5);
  CHECK(system.kept_names == std::map<std::string, double>{{"_td", 3.5}});
  parameters.write("_td", kUnknown);
  CHECK(system.kept_names == std::map<std::string, double>{{"_td", 3.5}});
}

TEST_CASE("what is defined counts, and is not kept", "[ipr][parameters]") {
  Parameters parameters;
  TwoVariables system;
  parameters.set_system(&system);
  parameters.keep({{500, 1.0}});
  parameters.keep({{"_td", 1.0}});
  CHECK(parameters.define("_td", 3.0));
  CHECK(parameters.define("500", 3.5));
  CHECK(parameters.define("31", 4.0));
  CHECK(parameters.read("_td") == 3.0);
  CHECK(parameters.read(500) == 3.5);
  CHECK(parameters.read(31) == 4.0);
  CHECK(system.kept.empty());
  CHECK(system.kept_names.empty());
  parameters.write("_td", 6.0);
  CHECK(system.kept_names.at("_td") == 6.0);
  for (const char* refused : {"_x", "td", "30", "0", "5221", "5420", "9999", "", "5x"}) {
    CAPTURE(refused);
    CHECK_FALSE(parameters.define(refused, 1.0));
  }
  CHECK_FALSE(parameters.define("_td", kUnknown));
  CHECK(system.offset == 0);
}

TEST_CASE("FANUC's common variables can be defined, its local ones cannot", "[ipr][parameters]") {
  Parameters parameters(Dialect::fanuc);
  CHECK(parameters.define("100", 2.5));
  CHECK(parameters.read(100) == 2.5);
  CHECK(parameters.define("500", 3.5));
  CHECK(parameters.read(500) == 3.5);
  for (const char* refused : {"33", "200", "5001"}) CHECK_FALSE(parameters.define(refused, 1.0));
}

TEST_CASE("numbered variables of LinuxCNC are 0 until assigned to", "[ipr][parameters]") {
  Parameters parameters;
  CHECK(parameters.read(1) == 0.0);
  CHECK(parameters.read(5601) == 0.0);
  CHECK_FALSE(parameters.read(0));
  CHECK_FALSE(parameters.read(5602));
  CHECK_FALSE(parameters.read(-1));
  parameters.write(31, 4);
  CHECK(parameters.read(31) == 4.0);
  CHECK(parameters.access(0) == Access::no_such);
  CHECK(parameters.access(5602) == Access::no_such);
}

TEST_CASE("numbered variables of FANUC are vacant, and there are gaps", "[ipr][parameters]") {
  Parameters parameters(Dialect::fanuc);
  for (const int number : {0, 1, 33, 100, 199, 500, 999}) {
    REQUIRE(parameters.read(number));
    CHECK(is_vacant(*parameters.read(number)));
  }
  for (const int number : {-1, 34, 99, 200, 499, 1000}) {
    CHECK_FALSE(parameters.read(number));
    CHECK(parameters.access(number) == Access::no_such);
  }
  CHECK(parameters.access(0) == Access::read_only);
  parameters.write(1, 2);
  CHECK(parameters.read(1) == 2.0);
}

TEST_CASE("a call has local variables of its own, the arguments first", "[ipr][parameters]") {
  Parameters parameters;
  parameters.write(1, 10);
  parameters.write(30, 300);
  parameters.write(31, 310);
  parameters.write("local", 1);
  parameters.write("_global", 2);
  parameters.push(std::vector<double>{7, 8});
  CHECK(parameters.level() == 1);
  CHECK(parameters.read(1) == 7.0);
  CHECK(parameters.read(2) == 8.0);
  CHECK(parameters.read(3) == 0.0);
  CHECK(parameters.read(30) == 0.0);
  CHECK(parameters.read(31) == 310.0);
  CHECK_FALSE(parameters.read("local"));
  CHECK(parameters.read("_global") == 2.0);
  parameters.write(1, 70);
  parameters.write(31, 311);
  parameters.write("local", 3);
  parameters.write("_global", 4);
  parameters.pop();
  CHECK(parameters.level() == 0);
  CHECK(parameters.read(1) == 10.0);
  CHECK(parameters.read(30) == 300.0);
  CHECK(parameters.read(31) == 311.0);
  CHECK(parameters.read("local") == 1.0);
  CHECK(parameters.read("_global") == 4.0);
}

TEST_CASE("variables of FANUC that a call gives no argument are vacant", "[ipr][parameters]") {
  Parameters parameters(Dialect::fanuc);
  parameters.push(std::vector<double>{7, kVacant, 9});
  CHECK(parameters.read(1) == 7.0);
  CHECK(is_vacant(*parameters.read(2)));
  CHECK(parameters.read(3) == 9.0);
  CHECK(is_vacant(*parameters.read(33)));
}

TEST_CASE("the system's variables come before those of the program", "[ipr][parameters]") {
  TwoVariables system;
  Parameters parameters;
  parameters.set_system(&system);
  CHECK(parameters.read(5420) == 12.5);
  CHECK(parameters.read("_x") == 12.5);
  CHECK(parameters.access(5420) == Access::read_only);
  CHECK(parameters.access("_x") == Access::read_only);
  CHECK(parameters.access("_y") == Access::granted);
  CHECK(parameters.access(5221) == Access::granted);
  parameters.write(5221, 3);
  CHECK(system.offset == 3);
  CHECK(parameters.read(5221) == 3.0);
  parameters.write(5599, 1);
  CHECK(parameters.read(5599) == 1.0);
}

TEST_CASE("calls and lines can be read by name, and only read", "[ipr][parameters]") {
  Parameters parameters;
  CHECK(parameters.read("_value_returned") == 0.0);
  CHECK(parameters.read("_value") == 0.0);
  parameters.give_back(2.5);
  parameters.push({});
  parameters.set_line(17);
  CHECK(parameters.read("_value") == 2.5);
  CHECK(parameters.read("_value_returned") == 1.0);
  CHECK(parameters.read("_call_level") == 1.0);
  CHECK(parameters.read("_line") == 17.0);
  CHECK(parameters.access("_call_level") == Access::read_only);
}

TEST_CASE("after a lost assignment no name is known to be without a value", "[ipr][parameters]") {
  Parameters parameters;
  CHECK_FALSE(parameters.exists("a"));
  parameters.lose();
  REQUIRE(parameters.read("a"));
  CHECK(is_unknown(*parameters.read("a")));
}

}  // namespace softcnc::ipr
