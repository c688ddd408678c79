// SPDX-License-Identifier: MIT
// What values of M codes, outputs and inputs must have in common.
#include <map>
#include <tuple>

#include "hal/files/number.hpp"
#include "hal/machine/device_keys.hpp"

namespace softcnc::hal {
namespace {

struct NeededKey {
  MachineCodeAct act;
  std::string_view name;
};
constexpr NeededKey kNeeded[] = {
    {MachineCodeAct::dwell, "seconds"},   {MachineCodeAct::spindle, "direction"},
    {MachineCodeAct::coolant, "coolant"}, {MachineCodeAct::output, "output"},
    {MachineCodeAct::output, "value"},
};

std::string mcode_table(int number) { return "mcode." + std::to_string(number); }

class Checks {
 public:
  Checks(const Machine& machine, const std::function<bool(const std::string&)>& is_given)
      : machine_(machine), is_given_(is_given) {}

  std::vector<DeviceClash> all() {
    for (const auto& [number, code] : machine_.m_codes) check(number, code);
    check_numbers(machine_.outputs, "output");
    check_numbers(machine_.inputs, "input");
    for (const auto& [name, port] : machine_.outputs) check(name, port);
    for (const auto& [name, port] : machine_.inputs) check(name, port);
    for (const auto& [name, body] : machine_.contacts) check(name, body);
    return std::move(clashes_);
  }

 private:
  void add(Code code, std::vector<std::string> keys, std::string message) {
    clashes_.push_back({code, std::move(keys), std::move(message)});
  }

  void check(int number, const MachineCode& code) {
    const std::string table = mcode_table(number);
    const std::string act = table + ".do = '" + std::string(name(code.act)) + "'";
    for (const NeededKey& needed : kNeeded) {
      const std::string key = table + '.' + std::string(needed.name);
      if (needed.act == code.act && !is_given_(key))
        add(Code::SC7024, {table + ".do", table}, act + " needs " + key);
      if (needed.act != code.act && is_given_(key))
        add(Code::SC7024, {key, table + ".do"}, key + " does not go with " + act);
    }
    if (code.act == MachineCodeAct::output) check_output(table, code);
  }

  void check_output(const std::string& table, const MachineCode& code) {
    if (!is_given_(table + ".output")) return;
    const auto found = find_output(machine_.outputs, code.output);
    if (found == machine_.outputs.end())
      return add(Code::SC7026, {table + ".output"},
                 table + ".output = '" + code.output + "' is no output of the machine");
    if (found->second.kind == SignalKind::digital && is_given_(table + ".value"))
      check_digital(table + ".value", code.value, "output", found->first);
  }

  void check_digital(const std::string& key, double value, const std::string& what,
                     const std::string& name) {
    if (value == 0 || value == 1) return;
    add(Code::SC7027, {key, what + '.' + name + ".kind"},
        key + " = " + number_text(value) + ", and " + what + " '" + name +
            "' is digital: it takes 0 or 1");
  }

  template <typename Ports>
  void check_numbers(const Ports& ports, const std::string& what) {
    std::map<std::pair<SignalKind, int>, std::string> taken;
    for (const auto& [name, port] : ports) {
      const auto [first, is_new] = taken.try_emplace({port.kind, port.number}, name);
      const std::string table = what + '.' + name;
      if (!is_new)
        add(Code::SC7025, {table + ".number", table + ".kind", table},
            table + " has the number of " + what + '.' + first->second + ": " +
                std::string(softcnc::name(port.kind)) + ' ' + std::to_string(port.number));
    }
  }

  void check(const std::string& name, const OutputPort& port) {
    const std::string table = "output." + name;
    if (port.pin != 0 && !is_switched(port))
      add(Code::SC7027, {table + ".pin", table + ".kind", table + ".number"},
          table + ".pin: only a digital output with a number up to 63 has a pin");
  }

  void check(const std::string& name, const InputPort& port) {
    const std::string table = "input." + name;
    const std::size_t count = port.lines.size();
    if (port.values.size() != count)
      add(Code::SC7027, {table + ".values", table + ".lines"},
          table + ".values has " + std::to_string(port.values.size()) + " entries, and " + table +
              ".lines " + std::to_string(count));
    if (!port.after.empty() && port.after.size() != count)
      add(Code::SC7027, {table + ".after_s"},
          table + ".after_s has " + std::to_string(port.after.size()) + " entries, and " + table +
              ".lines " + std::to_string(count));
    if (port.kind == SignalKind::analog) return;
    check_digital(table + ".value", port.value, "input", name);
    for (const double value : port.values) check_digital(table + ".values", value, "input", name);
  }

  void check(const std::string& name, const ContactBody& body) {
    const std::string table = "contact." + name;
    if ((body.max - body.min).minCoeff() > 0) return;
    add(Code::SC7027, {table + ".max_mm", table + ".min_mm", table},
        table + ".max_mm must lie above " + table + ".min_mm on every axis");
  }

  const Machine& machine_;
  const std::function<bool(const std::string&)>& is_given_;
  std::vector<DeviceClash> clashes_;
};

}  // namespace

std::vector<DeviceClash> device_clashes(const Machine& machine,
                                        const std::function<bool(const std::string&)>& is_given) {
  return Checks(machine, is_given).all();
}

}  // namespace softcnc::hal
