// SPDX-License-Identifier: MIT
// Variables in one array, locals on a stack of levels, names in maps.
#include "ipr/expressions/parameters.hpp"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>

namespace softcnc::ipr {
namespace {

// LinuxCNC: #1 to #30 local, up to #5601; from #5061 on the system has its own among them.
constexpr int kLocals = 30, kFirstSystem = 5000, kVariablesEnd = 5602;
// FANUC: #1 to #33 local, #100 to #199 common; from #500 on those that the system keeps, and its
// own.
constexpr int kFanucLocals = 33, kFanucFirstCommon = 100, kFanucEndVolatile = 200;
constexpr int kFanucFirstKept = 500, kFanucEnd = 1000;

// Haas: those of FANUC, which are all kept from #100 on, and #10000 to #10999, of which #10100 is
// another number of #100.
constexpr int kHaasFirst = 10000, kHaasEnd = 11000;

constexpr int kDebugSwitch = 5599;  // LinuxCNC: (DEBUG,text) is shown unless it is 0

constexpr int kProbedVariables = 5061, kProbedVariablesEnd = 5071;

constexpr bool is_touch(int number) noexcept {
  return number >= kProbedVariables && number < kProbedVariablesEnd;
}

/// Of the fanuc and haas dialects: of X, Y and Z.
constexpr bool is_probed(int number) noexcept {
  return number >= kProbedVariables && number < kProbedVariables + 3;
}

constexpr bool is_fanuc_ordinary(int number) noexcept {
  return (number >= 1 && number <= kFanucLocals) ||
         (number >= kFanucFirstCommon && number < kFanucEndVolatile) ||
         (number >= kFanucFirstKept && number < kFanucEnd);
}

constexpr bool is_haas_general(int number) noexcept {
  return number >= kHaasFirst && number < kHaasEnd;
}

/// Of two numbers for one variable the shorter one.
constexpr int shortest(int number, Dialect dialect) noexcept {
  if (dialect != Dialect::haas || !is_haas_general(number)) return number;
  const int short_number = number - kHaasFirst;
  const bool same = short_number > kFanucLocals && is_fanuc_ordinary(short_number);
  return same ? short_number : number;
}

constexpr int first_system(Dialect dialect) noexcept {
  if (dialect == Dialect::haas) return kFanucFirstCommon;
  return is_fanuc_like(dialect) ? kFanucFirstKept : kFirstSystem;
}

}  // namespace

Parameters::Parameters(Dialect dialect)
    : dialect_(dialect),
      locals_(is_fanuc_like(dialect) ? kFanucLocals : kLocals),
      first_system_(first_system(dialect)) {
  push({});
}

/// Whether the number is that of a variable that only programs use.
bool Parameters::is_ordinary(int number) const noexcept {
  if (is_linuxcnc_like(dialect_)) return number >= 1 && number < kVariablesEnd;
  return is_fanuc_ordinary(number) || (dialect_ == Dialect::haas && is_haas_general(number));
}

/// Whether an error has lost what the system keeps of it.
bool Parameters::is_lost(int number) const {
  return kept_lost_ && is_kept(number) && !known_again_.contains(number);
}

/// Vacant where nothing has been assigned. Expects an ordinary variable.
double Parameters::stored(int number) const noexcept {
  const auto index = static_cast<std::size_t>(number);
  if (number <= locals_) return levels_.back().numbered[index];
  return index < numbered_.size() ? numbered_[index] : unset_;
}

/// Keeps it as one that outlives its call. Expects an ordinary variable.
void Parameters::store(int number, double value) {
  const auto index = static_cast<std::size_t>(number);
  if (index >= numbered_.size()) numbered_.resize(index + 1, unset_);
  numbered_[index] = value;
}

/// Before the first contact, where the machine stands is no contact: vacant.
double Parameters::probed_value(int number) const noexcept {
  if (!probed_point_) return kVacant;
  return (*probed_point_)[static_cast<std::size_t>(number - kProbedVariables)];
}

std::optional<double> Parameters::read(int number) const {
  number = shortest(number, dialect_);
  if (number == 0 && is_fanuc_like(dialect_)) return kVacant;
  if (probed_point_lost_ && is_touch(number)) return kUnknown;
  if (is_fanuc_like(dialect_) && is_probed(number)) return probed_value(number);
  if (!refused_.empty() && refused_.contains(number)) return kUnknown;
  if (is_lost(number)) return kUnknown;
  if (is_system(number) && system_ != nullptr) {
    may_differ_ = may_differ_ || !is_ordinary(number) || is_linuxcnc_like(dialect_);
    if (system_->assumes_unit(number)) assumed_ = number;
    if (const auto value = system_->read(number)) return value;
  }
  if (!is_ordinary(number)) return std::nullopt;
  const double value = stored(number);
  if (is_fanuc_like(dialect_) || !is_vacant(value)) return value;
  return number == kDebugSwitch ? 1 : 0;
}

std::optional<double> Parameters::read_as(int number, Dialect other) const {
  if (is_linuxcnc_like(other)) {
    const auto value = number >= 1 && number < kVariablesEnd ? read(number) : std::nullopt;
    return value && is_vacant(*value) ? 0 : value;
  }
  if (number == 0) return kVacant;
  if (is_fanuc_ordinary(number)) return stored(number);
  const bool known = system_ != nullptr && system_->has(number, other);
  return known ? system_->read(number) : std::nullopt;
}

bool Parameters::is_fanuc_system(int number) const {
  const Dialect own = is_fanuc_like(dialect_) ? dialect_ : Dialect::fanuc;
  return system_ != nullptr && !is_fanuc_ordinary(number) && number < kVariablesEnd &&
         system_->has(number, own) && !system_->has(number, Dialect::linuxcnc);
}

double Parameters::fanuc_unit(int number) const {
  return is_system(number) && system_ != nullptr ? system_->fanuc_unit(number) : 1;
}

bool Parameters::is_fanuc_local(int number) noexcept {
  return number > kLocals && number <= kFanucLocals;
}

const Parameters::Names& Parameters::names_of(std::string_view name) const noexcept {
  return name.starts_with('_') ? global_ : levels_.back().named;
}

/// The variables that describe calls and lines.
std::optional<double> Parameters::own(std::string_view name) const noexcept {
  if (name == "_line") return line_;
  if (name == "_call_level") return level();
  if (name == "_value") return given_back_.value_or(0);
  if (name == "_value_returned") return given_back_ ? 1 : 0;
  return std::nullopt;
}

std::optional<double> Parameters::read(std::string_view name) const {
  may_differ_ = may_differ_ || name.starts_with('_');
  if (const auto value = own(name)) return value;
  const Names& names = names_of(name);
  if (const auto found = names.find(name); found != names.end()) return found->second;
  if (system_ != nullptr)
    if (const auto value = system_->read(name)) return value;
  if (lost_) return kUnknown;
  return std::nullopt;
}

Parameters::Access Parameters::access(int number) const {
  number = shortest(number, dialect_);
  if (number == 0 && is_fanuc_like(dialect_)) return Access::read_only;
  if (is_system(number) && system_ != nullptr && system_->read(number))
    return system_->is_read_only(number) ? Access::read_only : Access::granted;
  return is_ordinary(number) ? Access::granted : Access::no_such;
}

Parameters::Access Parameters::access(std::string_view name) const {
  const bool taken = own(name) || (system_ != nullptr && system_->read(name));
  return taken ? Access::read_only : Access::granted;
}

double Parameters::limit(int number) const {
  number = shortest(number, dialect_);
  const bool of_system = is_system(number) && system_ != nullptr;
  return of_system ? system_->limit(number) : std::numeric_limits<double>::max();
}

void Parameters::write(int number, double value) {
  assert(access(number) == Access::granted);
  number = shortest(number, dialect_);
  may_differ_ = true;
  if (kept_lost_ && is_kept(number)) known_again_.insert(number);
  if (is_system(number) && system_ != nullptr && system_->assumes_unit(number)) assumed_ = number;
  if (number <= locals_)
    levels_.back().numbered[static_cast<std::size_t>(number)] = value;
  else if (!is_system(number) || system_ == nullptr || !system_->write(number, value))
    write_ordinary(number, value);
}

void Parameters::write_ordinary(int number, double value) {
  store(number, value);
  if (system_ != nullptr && kept_.contains(number)) system_->keep(number, value);
}

void Parameters::keep(const std::map<int, double>& values) {
  for (const auto& [number, value] : values) {
    if (number <= locals_ || number >= first_system_) continue;
    store(number, value);
    kept_.insert(number);
  }
}

void Parameters::keep(const std::map<std::string, double>& values) {
  for (const auto& [name, value] : values) {
    if (!name.starts_with('_') || access(name) != Access::granted) continue;
    global_.insert_or_assign(name, value);
    kept_names_.insert(name);
  }
}

bool Parameters::define(std::string_view name, double value) {
  if (!std::isfinite(value)) return false;
  if (name.starts_with('_')) {
    if (access(name) != Access::granted) return false;
    global_.insert_or_assign(std::string(name), value);
    return true;
  }
  int number = 0;
  const char* const end = name.data() + name.size();
  const auto read = std::from_chars(name.data(), end, number);
  if (read.ec != std::errc() || read.ptr != end) return false;
  const bool of_system = system_ != nullptr && is_system(number) && system_->read(number);
  if (number <= locals_ || !is_ordinary(number)) return false;
  if (of_system && (!is_fanuc_like(dialect_) || system_->is_read_only(number))) return false;
  if (std::abs(value) > limit(number)) return false;
  if (is_fanuc_like(dialect_))
    write(number, value);
  else
    store(number, value);
  return true;
}

void Parameters::write(std::string_view name, double value) {
  may_differ_ = true;
  if (!kept_names_.empty() && system_ != nullptr && !is_unknown(value) &&
      kept_names_.contains(name))
    system_->keep(name, value);
  Names& names = name.starts_with('_') ? global_ : levels_.back().named;
  if (const auto found = names.find(name); found != names.end())
    found->second = value;
  else
    names.emplace(name, value);
}

void Parameters::lose_all(bool locals) {
  lose();
  unset_ = kUnknown;
  kept_lost_ = true;
  known_again_.clear();
  std::fill(numbered_.begin(), numbered_.end(), kUnknown);
  for (auto& [name, value] : global_) value = kUnknown;
  give_back(kUnknown);
  if (!locals) return;
  levels_.back().numbered.fill(kUnknown);
  for (auto& [name, value] : levels_.back().named) value = kUnknown;
}

void Parameters::lose_probed_point() {
  if (is_fanuc_like(dialect_))
    probed_point_lost_ = true;
  else
    for (int number = kProbedVariables; number < kProbedVariablesEnd; ++number)
      store(number, kUnknown);
}

void Parameters::keep_probed_point(const std::array<double, 3>& place, bool contact) {
  probed_point_lost_ = false;
  if (is_fanuc_like(dialect_)) {
    probed_point_ = place;
    return;
  }
  for (int number = kProbedVariables; number < kProbedVariablesEnd; ++number) store(number, 0);
  for (std::size_t i = 0; i < place.size(); ++i)
    store(kProbedVariables + static_cast<int>(i), place[i]);
  store(kProbedVariablesEnd - 1, contact ? 1 : 0);
}

void Parameters::push(std::span<const double> arguments) {
  Level& level = levels_.emplace_back();
  level.numbered.fill(kVacant);
  assert(arguments.size() <= static_cast<std::size_t>(locals_));
  std::copy(arguments.begin(), arguments.end(), level.numbered.begin() + 1);
}

void Parameters::pop() {
  assert(level() > 0);
  levels_.pop_back();
}

}  // namespace softcnc::ipr
