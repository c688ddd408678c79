// SPDX-License-Identifier: MIT
// Values of expressions, precedence in both dialects, and where an error is reported.
#include "ipr/expressions/expression.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "support/property.hpp"

namespace softcnc::ipr {
namespace {

/// The value of a whole text; kUnknown where it has none.
double value_of(std::string_view text, const Parameters& parameters) {
  Lexer lexer(text);
  Expression expression(lexer, parameters);
  const double value = expression.value();
  INFO(text);
  CHECK_FALSE(expression.error());
  CHECK(lexer.peek() == 0);
  return value;
}

double linuxcnc(std::string_view text) { return value_of(text, Parameters(Dialect::linuxcnc)); }
double fanuc(std::string_view text) { return value_of(text, Parameters(Dialect::fanuc)); }

/// "SC1021 4+1": code, column and length of the error.
std::string fault_of(std::string_view text, Dialect dialect = Dialect::linuxcnc) {
  const Parameters parameters(dialect);
  Lexer lexer(text);
  Expression expression(lexer, parameters);
  const double value = expression.value();
  if (!expression.error()) return expression.broke_off() ? "mark" : "none";
  CHECK(is_unknown(value));
  const LineError& error = *expression.error();
  return "SC" + std::to_string(static_cast<int>(error.code)) + " " + std::to_string(error.column) +
         "+" + std::to_string(error.length);
}

/// An expression as a tree, whose value is worked out at its joints and not from its text.
struct ExpressionTree {
  int level = 9;     // precedence of what joins it: 9 is a number
  std::string text;  // with no more brackets than it needs
  double value = 0;
};

struct Joint {
  const char* name;
  int linuxcnc, fanuc;
  double (*give)(double, double);
};

constexpr Joint kJoints[] = {
    {"+", 3, 2, [](double a, double b) { return a + b; }},
    {"-", 3, 2, [](double a, double b) { return a - b; }},
    {"*", 4, 3, [](double a, double b) { return a * b; }},
    {"LT", 2, 1, [](double a, double b) { return a < b ? 1.0 : 0.0; }},
    {"GE", 2, 1, [](double a, double b) { return a < b ? 0.0 : 1.0; }},
    {"NE", 2, 1, [](double a, double b) { return a == b ? 0.0 : 1.0; }},
};
constexpr Joint kLogic[] = {
    {"AND", 1, 3, [](double a, double b) { return a != 0 && b != 0 ? 1.0 : 0.0; }},
    {"OR", 1, 2, [](double a, double b) { return a != 0 || b != 0 ? 1.0 : 0.0; }},
    {"XOR", 1, 2, [](double a, double b) { return (a != 0) != (b != 0) ? 1.0 : 0.0; }},
};

/// In brackets if it binds weaker than what it stands in.
std::string within(const ExpressionTree& tree, int level) {
  return tree.level < level ? "[" + tree.text + "]" : tree.text;
}

ExpressionTree joined(const Joint& joint, const ExpressionTree& left, const ExpressionTree& right,
                      Dialect dialect) {
  const int level = dialect == Dialect::fanuc ? joint.fanuc : joint.linuxcnc;
  const bool compares = dialect == Dialect::fanuc && level == 1;
  return {level,
          within(left, compares ? level + 1 : level) + " " + joint.name + " " +
              within(right, level + 1),
          joint.give(left.value, right.value)};
}

ExpressionTree random_tree(int depth, Dialect dialect) {
  const int choice = *rc::gen::inRange(0, depth > 0 ? 10 : 2);
  if (choice < 2) {
    const int number = *rc::gen::inRange(0, 9);
    return choice == 0 ? ExpressionTree{9, std::to_string(number), double(number)}
                       : ExpressionTree{9, "-" + std::to_string(number), -double(number)};
  }
  const ExpressionTree left = random_tree(depth - 1, dialect);
  if (choice == 2) return {9, "ABS[" + left.text + "]", std::abs(left.value)};
  const ExpressionTree right = random_tree(depth - 1, dialect);
  if (choice > 7 && dialect == Dialect::linuxcnc)
    return joined(kLogic[*rc::gen::inRange(0, 3)], left, right, dialect);
  return joined(kJoints[*rc::gen::inRange(0, 6)], left, right, dialect);
}

}  // namespace

TEST_CASE("an expression has the value of its tree", "[ipr][expression]") {
  for (const Dialect dialect : {Dialect::linuxcnc, Dialect::fanuc})
    test::holds([dialect] {
      const ExpressionTree tree = random_tree(6, dialect);
      const std::string text = "[" + tree.text + "]";
      const Parameters parameters(dialect);
      Lexer lexer(text);
      Expression expression(lexer, parameters);
      RC_LOG() << text;
      RC_ASSERT(expression.value() == tree.value);
      RC_ASSERT(!expression.error());
    });
}

// The values of this table are those that rs274 of LinuxCNC 2.9 gives, but for its rounding.
TEST_CASE("operators have the precedence of LinuxCNC and group from the left",
          "[ipr][expression]") {
  CHECK(linuxcnc("[1+2*3]") == 7);
  CHECK(linuxcnc("[2*3**2]") == 18);
  CHECK(linuxcnc("[2**3**2]") == 64);
  CHECK(linuxcnc("[-2**2]") == 4);
  CHECK(linuxcnc("[7-2-1]") == 4);
  CHECK(linuxcnc("[16/4/2]") == 2);
  CHECK(linuxcnc("[1 OR 0 AND 0]") == 0);
  CHECK(linuxcnc("[1 AND 2 EQ 2]") == 1);
  CHECK(linuxcnc("[1 XOR 1 + 1]") == 0);
  CHECK(linuxcnc("[3 LT 2 + 2]") == 1);
  CHECK(linuxcnc("[10 MOD 4 * 2]") == 4);
  CHECK(linuxcnc("[10 MOD -3]") == 1);
  CHECK(linuxcnc("[-10 MOD 3]") == 2);
  CHECK(linuxcnc("[1 EQ 1.00005]") == 1);
  CHECK(linuxcnc("[1 NE 1.00015]") == 1);
  CHECK(linuxcnc("[1 GE 1.00005]") == 0);
}

TEST_CASE("in FANUC AND binds like * and OR like +, and both work on bits", "[ipr][expression]") {
  CHECK(fanuc("[6 AND 3]") == 2);
  CHECK(fanuc("[6 OR 3]") == 7);
  CHECK(fanuc("[6 XOR 3]") == 5);
  CHECK(fanuc("[1 OR 0 AND 0]") == 1);
  CHECK(fanuc("[[1 EQ 1] AND [2 EQ 2]]") == 1);
  CHECK(fanuc("[1 + 2 EQ 2 + 1]") == 1);
  CHECK(fanuc("[1 EQ 1.00005]") == 0);
  CHECK(fanuc("[-10 MOD 3]") == -1);
  CHECK(fanuc("[9.6 MOD 4]") == 2);
  CHECK(fault_of("[1 EQ 1 EQ 1]", Dialect::fanuc) == "SC1019 9+2");
  CHECK(fault_of("[1.5 AND 1]", Dialect::fanuc) == "SC1022 2+9");
}

TEST_CASE("functions give what their names say, angles in degrees", "[ipr][expression]") {
  CHECK(linuxcnc("ABS[-3]") == 3);
  CHECK(linuxcnc("ACOS[-1]") == 180);
  CHECK(linuxcnc("ASIN[0.5]") == Approx(30).epsilon(1e-15));
  CHECK(linuxcnc("ATAN[1]/[-1]") == Approx(135).epsilon(1e-15));
  CHECK(linuxcnc("ATAN[-1,-1]") == Approx(-135).epsilon(1e-15));
  CHECK(linuxcnc("BCD[12]") == 18);
  CHECK(linuxcnc("BIN[18]") == 12);
  CHECK(linuxcnc("COS[60]") == 0.5);
  CHECK(linuxcnc("EXP[1]") == Approx(2.718281828459045).epsilon(1e-15));
  CHECK(linuxcnc("FIX[2.8]") == 2);
  CHECK(linuxcnc("FIX[-2.8]") == -3);
  CHECK(linuxcnc("FUP[2.2]") == 3);
  CHECK(linuxcnc("FUP[-2.8]") == -2);
  CHECK(linuxcnc("LN[10]") == Approx(2.302585092994046).epsilon(1e-15));
  CHECK(linuxcnc("POW[2,10]") == 1024);
  CHECK(linuxcnc("ROUND[-2.5]") == -3);
  CHECK(linuxcnc("SIN[30]") == 0.5);
  CHECK(linuxcnc("SQRT[2]") == Approx(1.4142135623730951).epsilon(1e-15));
  CHECK(linuxcnc("TAN[45]") == 1);
}

TEST_CASE("in FANUC FIX cuts, FUP goes away from 0, and angles are not negative",
          "[ipr][expression]") {
  CHECK(fanuc("FIX[-2.8]") == -2);
  CHECK(fanuc("FUP[-2.2]") == -3);
  CHECK(fanuc("FIX[2.8]") == 2);
  CHECK(fanuc("ATAN[-1]/[1]") == Approx(315).epsilon(1e-15));
  CHECK(fanuc("ASIN[-0.5]") == Approx(330).epsilon(1e-15));
  CHECK(fanuc("ATAN[-1]") == Approx(-45).epsilon(1e-15));
  CHECK(fanuc("[ATAN[1]/2]") == Approx(22.5).epsilon(1e-15));
}

TEST_CASE("sine and cosine are exact where they are 0, a half or 1", "[ipr][expression]") {
  const std::vector<double> halves{0, 1, 2, 1, 0, -1, -2, -1};  // at 0, 30, 90, 150, ...
  const std::vector<int> angles{0, 30, 90, 150, 180, 210, 270, 330};
  for (std::size_t i = 0; i < angles.size(); ++i)
    for (const int turn : {-720, -360, 0, 360, 3600}) {
      CHECK(linuxcnc("SIN[" + std::to_string(angles[i] + turn) + "]") * 2 == halves[i]);
      CHECK(linuxcnc("COS[" + std::to_string(90 - angles[i] + turn) + "]") * 2 == halves[i]);
    }
}

TEST_CASE("blanks, lower case and comments are allowed anywhere", "[ipr][expression]") {
  CHECK(linuxcnc(" [ 1 + ( one ) 1 0 . 5 ] ") == 11.5);
  CHECK(linuxcnc("s Q r T [ 1 6 ]") == 4);
  CHECK(linuxcnc("[1mod2or0]") == 1);
  CHECK(linuxcnc("[10modsqrt[9]]") == 1);
}

TEST_CASE("signs may stand before every operand", "[ipr][expression]") {
  CHECK(linuxcnc("[1--1]") == 2);
  CHECK(linuxcnc("[1 - + - 1]") == 2);
  CHECK(linuxcnc("-[-SIN[90]]") == 1);
}

TEST_CASE("variables are read by number, by expression and by name", "[ipr][expression]") {
  Parameters parameters;
  parameters.write(1, 2);
  parameters.write(2, 7);
  parameters.write("feed rate", 0);
  parameters.write("feedrate", 5);
  CHECK(value_of("#1", parameters) == 2);
  CHECK(value_of("# 1", parameters) == 2);
  CHECK(value_of("##1", parameters) == 7);
  CHECK(value_of("#[#1+0]", parameters) == 7);
  CHECK(value_of("-#[1]", parameters) == -2);
  CHECK(value_of("#<Feed Rate>", parameters) == 5);
  CHECK(value_of("EXISTS[#<feedrate>]", parameters) == 1);
  CHECK(value_of("EXISTS[#<other>]", parameters) == 0);
  CHECK(value_of("EXISTS[#5000]", parameters) == 1);
  CHECK(value_of("EXISTS[#6000]", parameters) == 0);
}

TEST_CASE("a vacant variable equals only what is vacant", "[ipr][expression]") {
  CHECK(is_vacant(fanuc("#1")));
  CHECK(is_vacant(fanuc("-#0")));
  CHECK(fanuc("[#1 EQ #0]") == 1);
  CHECK(fanuc("[#1 EQ 0]") == 0);
  CHECK(fanuc("[#1 NE 0]") == 1);
  CHECK(fanuc("[#1 GE 0]") == 1);
  CHECK(fanuc("[#1 * 5]") == 0);
  CHECK(fanuc("ABS[#1]") == 0);
  CHECK(fanuc("EXISTS[#1]") == 0);
}

TEST_CASE("an error has the place of its cause", "[ipr][expression]") {
  CHECK(fault_of("[1/0]") == "SC1021 4+1");
  CHECK(fault_of("[1/[2-2]+1]") == "SC1021 4+5");
  CHECK(fault_of("[5 MOD 0]") == "SC1021 8+1");
  CHECK(fault_of("[0**-1]") == "SC1021 5+2");
  CHECK(fault_of("POW[0,-1]") == "SC1021 4+6");
  CHECK(fault_of("[-2**0.5]") == "SC1022 2+7");
  CHECK(fault_of("SQRT[-1]") == "SC1022 5+4");
  CHECK(fault_of("LN[0]") == "SC1022 3+3");
  CHECK(fault_of("ACOS[2]") == "SC1022 5+3");
  CHECK(fault_of("ASIN[-1.1]") == "SC1022 5+6");
  CHECK(fault_of("TAN[-90]") == "SC1022 4+5");
  CHECK(fault_of("BIN[10]") == "SC1022 4+4");
  CHECK(fault_of("EXP[1000]") == "SC1023 4+6");
  CHECK(fault_of("[10**300*10**300]") == "SC1023 2+15");
  CHECK(fault_of("#<a>") == "SC1024 1+4");
  CHECK(fault_of("[1+#6000]") == "SC1025 4+5");
  CHECK(fault_of("#[1.5]") == "SC1025 2+5");
  CHECK(fault_of("#0") == "SC1025 1+2");
  CHECK(fault_of("[]") == "SC1016 2+1");
  CHECK(fault_of("[1+]") == "SC1016 4+1");
  CHECK(fault_of("[1+") == "SC1016 3+1");
  CHECK(fault_of("[.]") == "SC1016 2+1");
  CHECK(fault_of("[1+[2") == "SC1017 4+1");
  CHECK(fault_of("SIN 30") == "SC1017 1+3");
  CHECK(fault_of("ATAN[1]") == "SC1017 1+7");
  CHECK(fault_of("POW[1]") == "SC1017 1+6");
  CHECK(fault_of("SINE[30]") == "SC1018 1+4");
  CHECK(fault_of("[1 = 2]") == "SC1019 4+1");
  CHECK(fault_of("[1 PLUS 2]") == "SC1019 4+4");
  CHECK(fault_of("[1(c)2]") == "SC1019 6+1");
  CHECK(fault_of("[1.2.3]") == "SC1004 2+5");
  CHECK(fault_of("[1234567890]") == "SC1005 2+10");
  CHECK(fault_of("[1E5]") == "SC1006 2+2");
  CHECK(fault_of("#<a") == "SC1030 2+1");
  CHECK(fault_of("# < >") == "SC1030 3+3");
}

TEST_CASE("what the lexer can tell is left to it", "[ipr][expression]") {
  CHECK(fault_of("[1+(") == "mark");
  CHECK(fault_of("[1 $ 2]") == "mark");
  CHECK(fault_of(std::string_view("[1\0]", 4)) == "mark");
}

TEST_CASE("brackets nest to a limit, not to the end of the stack", "[ipr][expression]") {
  const auto nested = [](std::size_t depth) {
    return std::string(depth, '[') + "1" + std::string(depth, ']');
  };
  CHECK(linuxcnc(nested(63)) == 1);
  CHECK(fault_of(nested(64)) == "SC1027 65+1");
  CHECK(fault_of(nested(5000)) == "SC1027 65+1");
  CHECK(fault_of(std::string(5000, '-') + "1") == "SC1027 65+1");
  CHECK(fault_of(std::string(5000, '#')) == "SC1027 65+1");
}

TEST_CASE("what rests on an earlier error is no error again", "[ipr][expression]") {
  Parameters parameters;
  parameters.write(1, kUnknown);
  for (const std::string text : {"#1", "[1/#1]", "-#1", "##1", "SQRT[-#1]", "ATAN[1]/[#1]"}) {
    Lexer lexer(text);
    Expression expression(lexer, parameters);
    INFO(text);
    CHECK(is_unknown(expression.value()));
    CHECK_FALSE(expression.error());
    CHECK_FALSE(expression.broke_off());
  }
}

}  // namespace softcnc::ipr
