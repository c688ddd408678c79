// SPDX-License-Identifier: MIT
// The numbers of G and M codes as GCode::number has them: G06.2 is 62, M30 is 300.
#pragma once

namespace softcnc::ipr {

inline constexpr int kCodesPerNumber = 10;  // GCode::number counts tenths

// Motion, and the curves of several lines.
inline constexpr int kG00 = 0, kG01 = 10, kG02 = 20, kG03 = 30, kG05 = 50, kG051 = 51, kG052 = 52,
                     kG053 = 53, kG061 = 61, kG062 = 62, kG12 = 120, kG13 = 130, kG31 = 310,
                     kG382 = 382, kG384 = 384, kG385 = 385;

// Tables, planes and places.
inline constexpr int kG10 = 100, kG16 = 160, kG17 = 170, kG18 = 180, kG19 = 190, kG28 = 280,
                     kG281 = 281, kG30 = 300;

// Compensation, transformations and coordinate systems.
inline constexpr int kG40 = 400, kG411 = 411, kG42 = 420, kG421 = 421, kG43 = 430, kG432 = 432,
                     kG50 = 500, kG501 = 501, kG51 = 510, kG511 = 511, kG52 = 520, kG53 = 530,
                     kG54 = 540, kG541 = 541, kG59 = 590, kG593 = 593, kG68 = 680, kG92 = 920,
                     kG923 = 923, kG110 = 1100, kG154 = 1540;

// Cycles, patterns, macros and modes of the feed.
inline constexpr int kG47 = 470, kG65 = 650, kG71 = 710, kG72 = 720, kG73 = 730, kG74 = 740,
                     kG76 = 760, kG81 = 810, kG82 = 820, kG83 = 830, kG84 = 840, kG85 = 850,
                     kG86 = 860, kG89 = 890, kG93 = 930, kG95 = 950, kG150 = 1500;

inline constexpr int kM02 = 20, kM30 = 300, kM48 = 480, kM49 = 490, kM50 = 500, kM51 = 510,
                     kM53 = 530, kM62 = 620, kM63 = 630, kM64 = 640, kM67 = 670, kM72 = 720,
                     kM73 = 730, kM98 = 980;

}  // namespace softcnc::ipr
