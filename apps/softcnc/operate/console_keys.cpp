// SPDX-License-Identifier: MIT
// The keys of the main page.
#include <array>

#include "operate/console.hpp"

namespace softcnc::app {
namespace {

constexpr double kTenth = 0.1;

/// The next of the overrides of rapids: 1, 25, 50 and 100 %.
double next_rapid(double now, bool faster) {
  constexpr std::array<double, 4> kRapids{0.01, 0.25, 0.5, 1};
  if (faster) {
    for (const double rapid : kRapids)
      if (rapid > now) return rapid;
    return kRapids.back();
  }
  for (std::size_t i = kRapids.size(); i-- > 0;)
    if (kRapids[i] < now) return kRapids[i];
  return kRapids.front();
}

Requests::Switches toggled(Requests::Switches switches, bool Requests::Switches::*which) {
  switches.*which = !(switches.*which);
  return switches;
}

}  // namespace

std::span<const Console::Binding> Console::bindings() noexcept {
  static constexpr Binding kBindings[] = {
      {' ', "space", "hold: come to rest", [](Console& c) { c.hold(); }},
      {'s', "s", "start the program", [](Console& c) { c.start(); }},
      {'a', "a", "abort the program, or the jog", [](Console& c) { c.requests_.abort(); }},
      {'e', "e", "emergency stop, with no ramp", [](Console& c) { c.requests_.estop(); }},
      {'u', "u", "unlock after an alarm", [](Console& c) { c.requests_.unlock(); }},
      {'r', "r", "reset; spindle and coolant off", [](Console& c) { c.requests_.reset(); }},
      {'h', "h", "home", [](Console& c) { c.requests_.home(); }},
      {'k', "k", "say where the machine stands",
       [](Console& c) {
         c.open({Prompt::For::position, "the machine stands at, in mm, as X0 Y0 Z0: "});
       }},
      {'m', "m", "type lines to run (MDI)",
       [](Console& c) {
         c.open({Prompt::For::line, "line: "});
       }},
      {'l', "l", "load a part program",
       [](Console& c) {
         c.open({Prompt::For::program, "part program: "});
       }},
      {'c', "c", "check with the present offsets", [](Console& c) { c.check(); }},
      {'v', "v", "view what the check has found", [](Console& c) { c.show(Page::found); }},
      {'t', "t", "touch off at work coordinates",
       [](Console& c) {
         c.open({Prompt::For::touch_off, "work coordinates here in mm, as X0 Y-3: "});
       }},
      {'p', "p", "probe, and touch off there",
       [](Console& c) {
         c.open({Prompt::For::probe, "probe (Z-20=0, bore X9 Y9, boss X9 Y9 Z5, corner X9 Y9): "});
       }},
      {'w', "w", "work offsets", [](Console& c) { c.show(Page::work); }},
      {'o', "o", "tools and their offsets", [](Console& c) { c.show(Page::tools); }},
      {',', ",", "shorter steps of the jog keys",
       [](Console& c) { c.state_.jog_step -= c.state_.jog_step > 0 ? 1 : 0; }},
      {'.', ".", "longer steps of the jog keys",
       [](Console& c) { c.state_.jog_step += c.state_.jog_step + 1 < kJogSteps.size() ? 1 : 0; }},
      {'f', "f", "the next feed of the jog keys",
       [](Console& c) { c.state_.jog_feed = (c.state_.jog_feed + 1) % kJogFeeds.size(); }},
      {'[', "[", "feed 10 % less",
       [](Console& c) { c.requests_.override_feed(c.requests_.overrides().feed - kTenth); }},
      {']', "]", "feed 10 % more",
       [](Console& c) { c.requests_.override_feed(c.requests_.overrides().feed + kTenth); }},
      {'{', "{", "rapids slower: 50, 25, 1 %",
       [](Console& c) {
         c.requests_.override_rapid(next_rapid(c.requests_.overrides().rapid, false));
       }},
      {'}', "}", "rapids faster",
       [](Console& c) {
         c.requests_.override_rapid(next_rapid(c.requests_.overrides().rapid, true));
       }},
      {'<', "<", "spindle 10 % slower",
       [](Console& c) { c.requests_.override_spindle(c.requests_.overrides().spindle - kTenth); }},
      {'>', ">", "spindle 10 % faster",
       [](Console& c) { c.requests_.override_spindle(c.requests_.overrides().spindle + kTenth); }},
      {'=', "=", "all of them 100 %",
       [](Console& c) {
         c.requests_.override_feed(1);
         c.requests_.override_rapid(1);
         c.requests_.override_spindle(1);
       }},
      {'b', "b", "single block",
       [](Console& c) {
         c.requests_.set(toggled(c.requests_.switches(), &Requests::Switches::single_block));
       }},
      {'n', "n", "optional stop (M01)",
       [](Console& c) {
         c.requests_.set(toggled(c.requests_.switches(), &Requests::Switches::optional_stop));
       }},
      {'/', "/", "block skip",
       [](Console& c) {
         c.requests_.set(toggled(c.requests_.switches(), &Requests::Switches::block_skip));
       }},
      {'?', "?", "this page", [](Console& c) { c.show(Page::keys); }},
      {'q', "q", "quit, at rest", [](Console& c) { c.quit(); }},
  };
  return kBindings;
}

}  // namespace softcnc::app
