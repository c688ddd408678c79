// SPDX-License-Identifier: MIT
// The operator's console: what each key does.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "operate/console_state.hpp"
#include "operate/requests.hpp"
#include "operate/screen.hpp"

namespace softcnc::app {

/// Keys in, requests to the machine, a screen out. It has no clock and no terminal of its own:
/// instants are those of the calls, in s.
class Console {
 public:
  /// What a key does on the main page.
  struct Binding {
    char key;
    std::string_view name;  // as the page of keys shows it
    std::string_view help;
    void (*act)(Console&);
  };

  /// Both must outlive it. `is_stopped` is asked now and then while a program is checked.
  Console(AttendedMachine& machine, Journal& journal, std::function<bool()> is_stopped = {});

  /// Loads a part program, and checks it where the machine knows its place.
  void load(const std::string& file);
  void key(const Key& key, double now);
  /// Moves on to `now`. Errors: those of AttendedMachine::advance(); the machine is held then.
  Status advance(double now);
  void draw(Screen& screen) const;

  /// Nobody is there any more: the machine comes to rest, and after operate.alone_s the spindle
  /// goes off and the console is over. With `at_once` that is as soon as the machine rests.
  void leave_alone(bool at_once);
  bool is_over() const noexcept { return is_over_; }

  static std::span<const Binding> bindings() noexcept;

 private:
  void key_of_page(const Key& key);
  void key_of_list(const Key& key);
  void key_of_tools(const Key& key);
  void key_of_prompt(const Key& key);
  void jog_key(Key::Kind key);
  void act_on_jog(JogKeys::Act act, Key::Kind key);
  void open(Prompt prompt);
  void show(Page page);
  void take(const std::string& text);
  void take_probe(const std::string& text);
  void ask_for_row();
  std::optional<int> selected_tool() const;
  bool take_place(const std::string& text,
                  bool (Requests::*request)(const AxisWords&, const std::string&));
  bool check();
  bool read_again();
  void start();
  void hold();
  void go_on();
  void quit();
  void settle();
  void restore_modes();
  void wait_alone();

  AttendedMachine& machine_;
  Journal& journal_;
  std::function<bool()> is_stopped_;
  Requests requests_;
  ConsoleState state_;
  LineEditor lines_, answers_;  // of the prompt for lines, and of all others
  JogKeys jog_keys_;
  double now_ = 0;                     // s
  std::optional<double> alone_since_;  // s: at rest, with nobody there
  bool probes_ = false;                // with the modes of before kept by M70
  bool is_alone_ = false, ends_at_once_ = false, is_over_ = false;
};

}  // namespace softcnc::app
