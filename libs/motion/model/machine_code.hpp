// SPDX-License-Identifier: MIT
// M codes that the builder or the user of a machine defines, and its outputs and inputs.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace softcnc {

/// Whether an output or input is on or off, or has any value.
enum class SignalKind : std::uint8_t { digital, analog };
inline constexpr std::array<std::string_view, 2> kSignalKinds{"digital", "analog"};
constexpr std::string_view name(SignalKind kind) noexcept {
  return kSignalKinds[static_cast<std::size_t>(kind)];
}

/// An output that programs set by M62 to M65, M67 and M68, or by an M code of the machine. Digital
/// and analog ones are numbered each by themselves.
struct OutputPort {
  int number = 0;
  SignalKind kind = SignalKind::digital;
  int pin = 0;  // of the parallel port, where it is digital; negative: inverted, 0: none
};

/// Returns whether it is one of the outputs that setpoints carry.
constexpr bool is_switched(const OutputPort& port) noexcept {
  constexpr int kLast = 63;
  return port.kind == SignalKind::digital && port.number <= kLast;
}

/// An input that programs read by M66, and the values that it has in simulation. The n-th M66 on a
/// line takes the n-th entry for that line; without one the input keeps its value.
struct InputPort {
  int number = 0;
  SignalKind kind = SignalKind::digital;
  double value = 0;           // at first
  std::vector<double> lines;  // of M66, one for each entry
  std::vector<double> values;
  std::vector<double> after;  // s after the M66 begins; empty: at once
};

enum class MachineCodeAct : std::uint8_t { ignore, stop, dwell, spindle, coolant, output };
inline constexpr std::array<std::string_view, 6> kMachineCodeActs{"ignore",  "stop",    "dwell",
                                                                  "spindle", "coolant", "output"};
constexpr std::string_view name(MachineCodeAct act) noexcept {
  return kMachineCodeActs[static_cast<std::size_t>(act)];
}

enum class SpindleTurn : std::uint8_t { unset, cw, ccw, off };
inline constexpr std::array<std::string_view, 4> kSpindleTurns{"", "cw", "ccw", "off"};

enum class CoolantSwitch : std::uint8_t { unset, mist, flood, off };
inline constexpr std::array<std::string_view, 4> kCoolantSwitches{"", "mist", "flood", "off"};

/// What an M code of the machine does.
struct MachineCode {
  MachineCodeAct act = MachineCodeAct::ignore;
  double seconds = 0;  // of a dwell
  SpindleTurn direction = SpindleTurn::unset;
  CoolantSwitch coolant = CoolantSwitch::unset;
  std::string output;  // its name or its number
  double value = 0;    // of the output
  std::string words;   // letters that the code takes
};

inline constexpr int kLastMachineCode = 99'999;

/// The numbers of the M codes that softcnc itself defines, in ascending order; a machine cannot
/// define them otherwise. A test of ipr compares them with its table of codes.
inline constexpr std::array kOwnMCodes{0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  29, 30,
                                       48, 49, 50, 51, 52, 53, 60, 61, 62, 63, 64, 65,
                                       66, 67, 68, 70, 71, 72, 73, 97, 98, 99};
constexpr bool is_own_m_code(int number) noexcept {
  return std::find(kOwnMCodes.begin(), kOwnMCodes.end(), number) != kOwnMCodes.end();
}

using OutputPorts = std::map<std::string, OutputPort, std::less<>>;
using InputPorts = std::map<std::string, InputPort, std::less<>>;

/// Returns the output or input of this kind and number, or the end of `ports`.
template <typename Ports>
auto find_port(const Ports& ports, SignalKind kind, int number) noexcept {
  return std::find_if(ports.begin(), ports.end(), [&](const auto& port) {
    return port.second.kind == kind && port.second.number == number;
  });
}

/// Returns the output with this name or, if there is none, the digital one with this number, or
/// else the analog one; the end of `outputs` if there is none either.
inline OutputPorts::const_iterator find_output(const OutputPorts& outputs,
                                               std::string_view name_or_number) {
  const auto named = outputs.find(name_or_number);
  if (named != outputs.end()) return named;
  const auto numbered = [&](SignalKind kind) {
    return std::find_if(outputs.begin(), outputs.end(), [&](const auto& output) {
      return output.second.kind == kind && std::to_string(output.second.number) == name_or_number;
    });
  };
  const auto digital = numbered(SignalKind::digital);
  return digital != outputs.end() ? digital : numbered(SignalKind::analog);
}

}  // namespace softcnc
