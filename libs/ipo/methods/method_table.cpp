// SPDX-License-Identifier: MIT
#include "ipo/methods/method_table.hpp"

#include <array>

namespace softcnc::ipo {
namespace {

constexpr std::string_view kWithinPeriod = "limits within a period";
constexpr std::string_view kAndChord = "limits within a period, the chord tolerance in the plan";
constexpr std::string_view kAllButFeed = "all limits except feed and travel";
constexpr std::string_view kPulseRules = "the path between two pulses";

constexpr auto kTable = std::to_array<MethodEntry>({
    {Method::arc_length, "softcnc", ""},
    {Method::taylor1, "000, equation 6", kWithinPeriod, {taylor1_increment}},
    {Method::taylor2, "004, equation 7", kWithinPeriod, {taylor2_increment}},
    {Method::curvature3p,
     "000, section 3.2",
     kAndChord,
     {three_point_increment, three_point_longest}},
    {Method::rk4, "Kutta 1901", kWithinPeriod, {rk4_increment}},
    {Method::yeh_hsu_1999, "Yeh and Hsu 1999", kWithinPeriod, {yeh_hsu_1999_increment}},
    {Method::yeh_hsu_2002,
     "Yeh and Hsu 2002",
     kAndChord,
     {yeh_hsu_2002_increment, yeh_hsu_2002_longest}},
    {Method::chords, "000, figure 10", kAllButFeed},
    {Method::acc_dec_linear, "000, section 2", kAllButFeed},
    {Method::acc_dec_bell, "000, section 2", kAllButFeed},
    {Method::two_step, "000, figure 1", kAllButFeed},
    {Method::sam, "003, Table 2", kPulseRules},
    {Method::m_sam, "003, Table 2", kPulseRules},
    {Method::dsm, "003, Table 2", kPulseRules},
    {Method::m_dsm, "003, Table 2", kPulseRules},
    {Method::dda, "003, Table 2", kPulseRules},
});
static_assert(kTable.size() == kMethodNames.size());

}  // namespace

std::span<const MethodEntry> method_table() noexcept { return kTable; }

}  // namespace softcnc::ipo
