// SPDX-License-Identifier: MIT
// Random programs of loops, branches and calls: a walk over their tree, which knows no text and no
// labels, makes the same moves as the program written out.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <random>

#include "ipr/interpret.hpp"

namespace softcnc::ipr {
namespace {

struct Node {
  enum class Kind { move, repeat, while_loop, do_loop, branch, call, leave, next };
  Kind kind = Kind::move;
  int id = 0;      // of a move: its length; of others: label and variable
  int rounds = 0;  // of a loop
  int target = 0;  // of leave and next: the loop; of a call: the subprogram
  std::vector<Node> bodies[3];
};
using Body = std::vector<Node>;

/// A program: its own lines, and subprograms that call only those after them.
struct ProgramTree {
  std::vector<Body> subs;  // the first is the main program
};

class Grower {
 public:
  explicit Grower(unsigned seed) : random_(seed) {}

  ProgramTree grow() {
    ProgramTree tree;
    for (int sub = 0; sub < kSubs; ++sub) {
      sub_ = sub;
      tree.subs.push_back(body(0));
    }
    return tree;
  }

 private:
  static constexpr int kSubs = 4, kDeepest = 4;

  int one_of(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  Body body(int depth) {
    Body all;
    for (int i = 1 + one_of(3); i > 0; --i) all.push_back(node(depth));
    return all;
  }

  Node node(int depth) {
    Node made;
    made.id = ++ids_;
    const int choice = depth < kDeepest ? one_of(10) : 0;
    if (choice < 3) return made;
    if (choice == 3 && sub_ + 1 < kSubs) {
      made.kind = Node::Kind::call;
      made.target = sub_ + 1 + one_of(kSubs - sub_ - 1);
    } else if (choice == 4 && !loops_.empty()) {
      made.kind = one_of(2) == 0 ? Node::Kind::leave : Node::Kind::next;
      made.target = loops_[static_cast<std::size_t>(one_of(static_cast<int>(loops_.size())))];
    } else if (choice <= 6) {
      made.kind = Node::Kind::branch;
      for (Body& branch : made.bodies) branch = body(depth + 1);
    } else {
      made.kind = choice == 7   ? Node::Kind::repeat
                  : choice == 8 ? Node::Kind::while_loop
                                : Node::Kind::do_loop;
      made.rounds = one_of(4);
      loops_.push_back(made.id);
      made.bodies[0] = body(depth + 1);
      loops_.pop_back();
    }
    return made;
  }

  std::mt19937 random_;
  int ids_ = 0, sub_ = 0;
  std::vector<int> loops_;
};

/// Makes the moves by going through the tree.
class Walker {
 public:
  static constexpr std::size_t kMost = 3000;

  explicit Walker(const ProgramTree& tree) : tree_(tree) { walk(tree.subs.front()); }
  const std::vector<int>& moves() const { return moves_; }
  bool is_too_long() const { return moves_.size() > kMost || steps_ > 20 * kMost; }

 private:
  struct Way {
    int loop = 0;  // 0: go on
    bool leave = false;
  };

  Way walk(const Body& body) {
    for (const Node& node : body) {
      const Way way = step(node);
      if (way.loop != 0) return way;
    }
    return {};
  }

  Way step(const Node& node) {
    using Kind = Node::Kind;
    if (++steps_ > 20 * kMost) return {};
    switch (node.kind) {
      case Kind::move:
        moves_.push_back(node.id);
        return {};
      case Kind::call:
        walk(tree_.subs[static_cast<std::size_t>(node.target)]);
        return {};
      case Kind::leave:
      case Kind::next:
        return {node.target, node.kind == Kind::leave};
      case Kind::branch:
        return walk(node.bodies[++visits_[node.id] % 3]);
      default:
        return loop(node);
    }
  }

  Way loop(const Node& node) {
    const int rounds = node.kind == Node::Kind::do_loop ? std::max(1, node.rounds) : node.rounds;
    for (int round = 0; round < rounds; ++round) {
      const Way way = walk(node.bodies[0]);
      if (way.loop != 0 && way.loop != node.id) return way;
      if (way.loop != 0 && way.leave) break;
    }
    return {};
  }

  const ProgramTree& tree_;
  std::vector<int> moves_;
  std::map<int, int> visits_;
  std::size_t steps_ = 0;
};

/// Writes the tree as a program; subprograms stand before the main lines, or after M2.
class Writer {
 public:
  Writer(const ProgramTree& tree, bool subs_first, bool by_number) : by_number_(by_number) {
    if (subs_first && !by_number) write_subs(tree);
    line("G91");
    write(tree.subs.front());
    line("M2");
    if (!subs_first || by_number) write_subs(tree);
  }
  const std::string& text() const { return text_; }

 private:
  void line(const std::string& words) { text_ += words + '\n'; }

  void write_subs(const ProgramTree& tree) {
    for (std::size_t i = 1; i < tree.subs.size(); ++i) {
      const std::string name = "O" + std::to_string(9000 + i);
      line(by_number_ ? name : name + " sub");
      write(tree.subs[i]);
      line(by_number_ ? "M99" : name + " endsub");
    }
  }

  void write(const Body& body) {
    for (const Node& node : body) write(node);
  }

  void write(const Node& node) {
    using Kind = Node::Kind;
    const std::string label = "o" + std::to_string(node.id) + " ";
    const std::string variable = "#" + std::to_string(100 + node.id);
    const std::string more = variable + "=[" + variable + "+1]";
    const std::string below = "[" + variable + " LT " + std::to_string(node.rounds) + "]";
    switch (node.kind) {
      case Kind::move:
        return line("G0 X" + std::to_string(node.id));
      case Kind::call:
        return line((by_number_ ? "M98 P" : "o") + std::to_string(9000 + node.target) +
                    (by_number_ ? "" : " call"));
      case Kind::leave:
      case Kind::next:
        return line("o" + std::to_string(node.target) +
                    (node.kind == Kind::leave ? " break" : " continue"));
      case Kind::repeat:
        line(label + "repeat [" + std::to_string(node.rounds) + "]");
        write(node.bodies[0]);
        return line(label + "endrepeat");
      case Kind::while_loop:
        line(variable + "=0");
        line(label + "while " + below);
        line(more);
        write(node.bodies[0]);
        return line(label + "endwhile");
      case Kind::do_loop:
        line(variable + "=0");
        line(label + "do");
        line(more);
        write(node.bodies[0]);
        return line(label + "while " + below);
      case Kind::branch:
        line(more);
        line(label + "if [[" + variable + " MOD 3] EQ 0]");
        write(node.bodies[0]);
        line(label + "elseif [[" + variable + " MOD 3] EQ 1]");
        write(node.bodies[1]);
        line(label + "else");
        write(node.bodies[2]);
        return line(label + "endif");
    }
  }

  bool by_number_;
  std::string text_;
};

std::vector<int> lengths(const std::string& text) {
  std::vector<int> all;
  Machine machine;
  for (const Block& block : blocks_of(text, machine)) {
    const auto* move = std::get_if<Move>(&block.what);
    if (move == nullptr) continue;
    all.push_back(static_cast<int>(std::lround(length(move->path))));
  }
  return all;
}

}  // namespace

TEST_CASE("programs make the moves of their trees", "[ipr][flow][property]") {
  int moves = 0, programs = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    const ProgramTree tree = Grower(seed).grow();
    const Walker walker(tree);
    if (walker.is_too_long()) continue;
    for (const bool subs_first : {true, false})
      for (const bool by_number : {false, true}) {
        const std::string text = Writer(tree, subs_first, by_number).text();
        INFO("seed " << seed << "\n" << text);
        REQUIRE(lengths(text) == walker.moves());
      }
    ++programs;
    moves += static_cast<int>(walker.moves().size());
  }
  CHECK(programs > 300);
  CHECK(moves > 10000);
}

}  // namespace softcnc::ipr
