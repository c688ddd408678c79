// SPDX-License-Identifier: MIT
// The constants that tune the planner and the interpolator, in one table.
//
// Above each are its unit, its kind and its reason. Kinds: physics (it follows from mathematics
// and is not to be tuned), choice (a trade-off of speed, memory, time and tolerance), rounding
// (far above the rounding of doubles and far below what matters).
//
// After `Test` stands, where that has been tried, another value and the first test of tests/ipo
// that fails with it (its three slowest were left out). Where none fails, the constant costs or
// saves time, or the margins of others cover it; before such a one is changed,
// scripts/stress programs and scripts/generate feed have to be run.
#pragma once

#include <array>
#include <cstddef>

namespace softcnc::ipo::tuning {

// -------------------------------------------------------------------------------------------------
// libs/ipo/limits

namespace limits {

// Of the limit. Choice: what the middles of grid intervals, swings of the curvature and plan
// nodes may add.
// Test, 0: none fails.
inline constexpr double kNormalMargin = 1.5e-3;
// Of the limit. Choice: from this part on the trace names the tangential limit.
inline constexpr double kTangentialBinds = 0.99;
// Of the limit. Choice: on curves, where the direction turns a little between two nodes.
// Test, 0: none fails.
inline constexpr double kAxisVelocityMargin = 3e-4;
// Of the limit. Choice: on curves, likewise.
inline constexpr double kPulseRateMargin = 3e-4;
// Of the tolerance. Choice: the change of curvature between two nodes.
// Test, 0: none fails.
inline constexpr double kChordMargin = 1e-3;
// Pick-feeds. Choice: how far the tip position may move from node to node: the roughness limit
// is steep where the tip cuts.
// Test, x 4: none fails.
inline constexpr double kNearTip = 0.04;
// Of the distance to the tip. Choice: likewise, far from the tip, where the limit is flat.
inline constexpr double kFarFromTip = 0.2;
// Of 1 / radius. Choice: how much the curvature of a valley may change from node to node.
// Test, x 5: none fails.
inline constexpr double kHollowChange = 0.1;

}  // namespace limits

// -------------------------------------------------------------------------------------------------
// libs/ipo/limits/contour_limit, libs/ipo/path/contour_spread

namespace contour {

// Of Kv. Choice: how fast speeds may fall near a bend per distance; slower leaves less of the
// contour, and takes longer. With these three figures bends of 0.05 to 20 mm between lines at 100
// mm/s leave 10.7 um of 10, and a circle of 15 mm after a line at 50 mm/s 12.5; with 0.5 instead of
// 0.4 it leaves 12.9.
inline constexpr double kNearRate = 0.4;
// Of Kv. Choice: likewise, where the speed is more than kNear times that of the bend.
inline constexpr double kFarRate = 1;
// Of the speed of the bend. Choice: where the lag of the faster motion has time to fade.
inline constexpr double kNear = 2.3;
// Of v / Kv. Choice: the distance ahead of a bend in which the speed is that of the bend already.
inline constexpr double kSteady = 1;
// Of v / Kv. Choice: the distance after a bend in which the speed does not rise, since the table is
// still in the bend.
inline constexpr double kLate = 0.6;
// Of the tolerance. Choice: of the lag at rest when a motion goes on; friction adds some.
inline constexpr double kSettled = 0.9;
// Of the radius. Choice: the largest error for which a bend counts as a part of a circle.
inline constexpr double kLargest = 0.1;
// Of 1 / tolerance. Choice: sharper bends are passed like bends of this curvature.
inline constexpr double kSharpest = 1.5;
// Powers of ten below Kv, and circles by angular speed there. Choice: of the table of circle
// errors.
inline constexpr double kDecades = 3;
inline constexpr int kCircles = 120;
// mm. Choice: intervals that are not split further towards a slower place.
inline constexpr double kShortest = 0.1;
// Of the speed. Choice: by which it may fall within an interval.
inline constexpr double kFall = 0.2;

}  // namespace contour

// -------------------------------------------------------------------------------------------------
// libs/ipo/path/grid

namespace grid {

// Of each limit. Choice: deviation of limits from linear between two nodes; the margins above
// and below cover it.
// Test, x 3: "derivatives between two nodes are as good as linear" and 4 more.
inline constexpr double kTolerance = 4e-4;
// Periods. Physics: a joint slows what lies within 3 steps for all within 3 steps of it, and
// one more for a shared step.
// Test, x 0.4: "a spiral of 200 sides: stops at G61.1, rounded corners at G64 P0.05" and 1
// more.
inline constexpr double kFeltPeriods = 8;
// Periods. Choice: the shortest beginning of a line that is settled before what follows it.
inline constexpr double kWorthwhile = 32;
// Halvings. Choice: a bound; the shortest interval ends the refinement before.
inline constexpr int kMaxDepth = 40;
// Parts. Choice: at a time, of what is longer than kSplitEvenly.
inline constexpr int kMostParts = 16;
// mm. Choice: shorter intervals are halved only.
inline constexpr double kSplitEvenly = 1e-4;
// Per step. Choice: where step limits bind and change.
// Test, x 0.25: none fails.
inline constexpr double kStepParts = 8;
// KTolerance. Choice: what a longer x' may add to velocities.
// Test, x 3: none fails.
inline constexpr double kSagParts = 3;
// Physics: a curve is this many times nearer to its chord over half the length.
inline constexpr double kHalfParts = 4;
// KTolerance. Choice: what the curvature may do between looks.
inline constexpr double kSwing = 2;
// KTolerance. Choice: what braking may add; with planner::kAccelerationShare it stays within
// 0.1 %.
inline constexpr double kBrakingParts = 2;
// Of q. Choice: step limits that change less are even.
inline constexpr double kEvenSteps = 0.01;
// mm. Choice: shorter than any machine resolves, and short enough that a hook of 1 nm is passed
// without a rest.
inline constexpr double kShortest = 1e-9;
// mm. Rounding: far above the rounding of positions and lengths.
inline constexpr double kLeastShortest = 1e-10;
// Shortest intervals. Choice: that are passed as one, if no more of them is unfelt.
inline constexpr double kUnresolved = 8;
// Of the acceleration and the jerk. Choice: what a sample may see of a part left out.
inline constexpr double kUnfelt = 0.01;
// Looks. Choice: at a strict velocity limit between two nodes.
// Test, x 0.25: "random curves keep their roughness with both models, with jerk limits and
// without" and 1 more.
inline constexpr int kLooks = 16;
// Of the sag. Choice: what the limit may sag between the looks.
// Test, 0: "over a cylinder the feed keeps the roughness in every row" and 2 more.
inline constexpr double kUnseen = 1.2;
// Of q. Choice: likewise, where the limit has corners.
inline constexpr double kUnseenPart = 2e-4;
// Physics: the most that a slope at an end of a cubic Hermite piece adds inside.
inline constexpr double kHermite = 4.0 / 27;

}  // namespace grid

// -------------------------------------------------------------------------------------------------
// libs/ipo/path/chain

namespace chain {

// rad. Choice: a larger jump of the tangent is a corner, where the machine rests.
// Test, x 3: none fails.
inline constexpr double kTangentTolerance = 0.01;
// rad. Rounding: of the geometry.
inline constexpr double kSameTangent = 1e-9;
// Relative. Rounding: of the geometry.
inline constexpr double kSameCurvature = 1e-9;
// Intervals. Choice: memory reserved at once.
inline constexpr double kMostReserved = 1e4;
// Intervals. Choice: kept left of the front before memory is released.
inline constexpr std::size_t kFewPassed = 1024;
// Of an interval. Rounding: a node nearer to its end is there.
inline constexpr double kNodePart = 1e-6;

}  // namespace chain

// -------------------------------------------------------------------------------------------------
// libs/ipo/path

namespace joints {

// Of the acceleration. Choice: for jumps of velocity beside curves.
// Test, x 3: "chords run exactly take no longer where more jerk is allowed".
inline constexpr double kTangentJumpShare = 0.25;
// Of the acceleration. Choice: the same between straight lines, where what is left is known at
// every speed.
// Test, x 1.2: "a joint that may only be passed slowly takes no longer than a stop, whatever
// the feed".
inline constexpr double kStraightTangentJumpShare = 0.9;
// Of the jerk. Choice: for jumps of velocity within three steps.
// Test, x 1.6: planning takes far longer.
inline constexpr double kTangentJumpJerkShare = 0.7;
// Steps. Physics: the span of a third difference.
// Test, x 0.4: none fails.
inline constexpr double kJerkSteps = 3;
// Of the tolerance. Choice: that curves leave to corners within the same step.
// Test, x 2: none fails.
inline constexpr double kTurnShare = 0.5;
// Periods. Physics: samples up to one period nearer see a jump; they extend one period
// further.
// Test, x 0.5: none fails.
inline constexpr double kTangentJumpPeriods = 2;
// Steps. Choice: towards the speed of a joint.
inline constexpr int kMostSteps = 60;
// Of the tolerance. Choice: of chords at tangent jumps.
// Test, 0: none fails.
inline constexpr double kMargin = 1e-3;
// Choice: what curvature may multiply the jerk along the path by.
inline constexpr double kCurved = 2;
// Steps. Choice: towards the speed of tangent jumps between lines.
inline constexpr int kMostNewtonSteps = 60;
// Relative. Rounding: so that the last step ends below.
inline constexpr double kBeyond = 1e-9;
// Periods. Physics: beyond, the weight w of a curvature jump is 0.
inline constexpr double kJumpPeriods = 2;
// Periods. Physics: up to there w is highest.
inline constexpr double kJumpFlat = 0.5;
// Physics: 3/4 of 18/17: the B-spline leaves 17/18 of it in the middle.
// Test, x 0.5: "where line and arc meet askew of the axes, jump and jerk share the third
// difference".
inline constexpr double kJumpWeight = 0.7942;
// Of q at a node. Choice: of a joint that is passed far more slowly, a plan counts the whole jump
// as it can be at most, and not in proportion to the speed at the node.
inline constexpr double kFarSlower = 0.25;
// Of the jerk. Choice: what may be counted so.
inline constexpr double kWholeJump = 0.5;
// Periods. Choice: plans take joints to be nearer, so that nodes need not lie at the corners
// of w.
inline constexpr double kJumpNearer = 0.1;

}  // namespace joints

// -------------------------------------------------------------------------------------------------
// libs/ipo/path

namespace path {

// mm/s. Rounding: slower is rest.
inline constexpr double kStandstill = 1e-9;
// Halvings. Rounding: towards an instant.
inline constexpr int kHalvings = 60;
// s. Choice: of a motion in closed form; the jerk times this is exceeded at most.
inline constexpr double kShortestPhase = 1e-7;
// Halvings. Rounding: towards the speed at a position.
inline constexpr int kSpeedHalvings = 50;
// Of a speed. Rounding: kept free of the velocity limit of a line.
inline constexpr double kSpeedRounding = 1e-6;
// mm. Rounding: beyond the travel.
inline constexpr double kTravelTolerance = 1e-6;
// Spans. Choice: longer curves are planned in parts; a plan takes some 40 kB per span.
inline constexpr std::size_t kMostSpansAtOnce = 512;
// Spans. Choice: of such a part.
// Test, x 0.1: "the stretches of a long curve are all of it, end to end".
inline constexpr std::size_t kSpansOfPart = 128;

}  // namespace path

// -------------------------------------------------------------------------------------------------
// libs/ipo/acceleration_limited

namespace optimum {

// Of the acceleration. Choice: what the grid tolerance may add on curves.
// Test, 0: none fails.
inline constexpr double kCurveMargin = 5e-4;
// Of q. Rounding: at a limit.
inline constexpr double kRelative = 1e-12;
// Of q. Rounding: at the end of a controllable set.
inline constexpr double kRounding = 1e-9;
// mm. Choice: of where the machine has slowed down.
inline constexpr double kResolution = 1e-3;

}  // namespace optimum

// -------------------------------------------------------------------------------------------------
// libs/ipo/solver

namespace solver {

// Iterations. Choice: a bound.
inline constexpr int kMostIterations = 150;
// Iterations. Choice: a good guess needs no more.
inline constexpr int kFewIterations = 45;
// Of the time. Choice: where all constraints hold and the gap is less, more steps lead there.
// Test, x 0.0001: a curve of chords takes 2.7 s instead of 1.8 s.
inline constexpr double kNearGap = 0.05;
// Of the time. Choice: how near to the optimum.
// Test, x 100: none fails.
inline constexpr double kTimeTolerance = 1e-4;
// Of each bound. Choice: how well constraints hold.
// Test, x 10000: none fails.
inline constexpr double kConstraintTolerance = 1e-7;
// Of the gradient. Choice: of the time.
inline constexpr double kGradientTolerance = 1e-3;
// Of each bound. Choice: constraints then hold well enough to move the tangents.
inline constexpr double kTangentTolerance = 1e-2;
// Iterations. Choice: after which tangents move in any case.
inline constexpr int kStubborn = 5;
// Of the gap. Choice: the least complementarity that a step aims for.
inline constexpr double kLeastCentred = 1e-3;
// Of the gap. Choice: the most; with more, whole curves take up to twice as many steps.
inline constexpr double kMostCentred = 0.1;
// Of the time. Choice: multipliers grow where no solution exists.
inline constexpr double kHopelessGap = 1e6;
// Of the time. Choice: how far from the bounds to start.
inline constexpr double kFirstGap = 100;
// Of each bound. Choice: likewise.
inline constexpr double kFirstSlack = 0.1;
// Of the guess. Choice: in q.
inline constexpr double kFirstSpeed = 0.25;
// Of the acceleration. Choice: that the guess uses; it leaves the rest to the curve.
inline constexpr double kAccelerationPart = 0.7;
// Of the distance. Choice: to the nearest bound, in one step.
inline constexpr double kToBoundary = 0.99;

}  // namespace solver

// -------------------------------------------------------------------------------------------------
// libs/ipo/jerk_limited/speed_guess

namespace guess {

// Nodes. Choice: for a phase of constant jerk.
// Test, x 0.4: "a stop is found in few tries".
inline constexpr double kNodesPerPhase = 12;
// Nodes. Choice: of a long plan; more would only follow axes without jerk limits.
inline constexpr double kMany = 2000;
// Periods. Choice: between two nodes.
inline constexpr double kShortestTime = 0.5;
// Of kShortestTime. Choice: however fast the speed grows.
inline constexpr double kLeastTime = 1e-3;
// Of the speed. Choice: from node to node.
inline constexpr double kGrowth = 0.1;
// Of the acceleration. Choice: that the guess uses.
inline constexpr double kAccelerationPart = 0.8;
// Of the distance. Choice: growth of the spacing since the speed became constant.
inline constexpr double kGrading = 0.15;
// Of the first speed. Choice: the guess never rests.
inline constexpr double kSlowest = 1e-3;
// Of each axis limit. Choice: at a steady speed that hardly accelerates the axes.
inline constexpr double kHardly = 0.1;

}  // namespace guess

// -------------------------------------------------------------------------------------------------
// libs/ipo/jerk_limited/plan_nodes

namespace nodes {

// Nodes. Choice: a plan with more does not fit in bounded memory; normally none exists.
inline constexpr std::size_t kMost = 100'000;
// rad. Choice: between two nodes.
// Test, x 3: "a stop that needs all of the way to a corner ends there, not after it".
inline constexpr double kTurn = 0.06;
// Of q. Choice: change of a roughness limit between two nodes.
inline constexpr double kLimitChange = 0.04;
// Choice: change of the spacing along the path.
inline constexpr double kGrading = 0.15;
// Periods. Choice: what turns faster is not resolved.
// Test, x 4: "a stop that needs all of the way to a corner ends there, not after it".
inline constexpr double kShortestTime = 0.35;
// Of the jerk. Choice: a smaller curvature jump gets no nodes of its own.
// Test, x 20: "where line and arc meet askew of the axes, jump and jerk share the third
// difference".
inline constexpr double kFeltJump = 0.05;
// Relative. Rounding: derivatives that do not jump.
inline constexpr double kSame = 1e-9;

}  // namespace nodes

// -------------------------------------------------------------------------------------------------
// libs/ipo/jerk_limited/rest_ramp

namespace rest_ramp {

// Of the jerk. Choice: the rest is for the curvature of the path.
// Test, x 1.1: "rounding corners never takes longer than resting in them" and 11 more.
inline constexpr double kJerkPart = 0.97;
// Of A / J. Choice: the duration of the ramp.
// Test, x 5: none fails.
inline constexpr double kTimePart = 0.1;
// Periods. Choice: the least duration, if kMostPart allows it.
inline constexpr double kPeriodPart = 0.5;
// Of A / J. Choice: the longest duration.
inline constexpr double kMostPart = 0.5;
// Of the interval. Choice: the longest ramp.
inline constexpr double kLengthPart = 0.05;
// Of the velocity limit. Choice: the highest speed of the ramp.
inline constexpr double kSpeedPart = 0.25;
// Choice: the factor on the duration while the path makes the ramp exceed a limit.
inline constexpr double kShorter = 0.7;
// Times. Choice: how often that factor is applied at most.
inline constexpr int kMostShorter = 20;

}  // namespace rest_ramp

// -------------------------------------------------------------------------------------------------
// libs/ipo/jerk_limited

namespace plan {

// Of the jerk. Choice: in the constraints; check::kJerk allows more between the nodes.
// Test, x 1.006: "a hold where the machine brakes anyway is no fall-back, nor is its release".
inline constexpr double kJerkPart = 0.995;
// Of the jerk. Choice: at the start of a plan that continues another one.
inline constexpr double kFirstJerkPart = 0.999;
// Of the acceleration. Choice: in the constraints.
inline constexpr double kAccelerationPart = 0.998;
// Of the acceleration. Choice: at such a start.
inline constexpr double kFirstAccelerationPart = 0.9995;
// Of q. Choice: in the velocity limits.
// Test, x 1.001: "no plan that goes on from another one is faster than the feed".
inline constexpr double kVelocityPart = 0.9993;
// Of q. Choice: at such a start.
inline constexpr double kFirstVelocityPart = 1;
// Of q. Choice: at the start of a plan that continues none.
// Test, x 0.999: "a lower override slows the machine down as fast as its limits allow" and 1
// more.
inline constexpr double kReplannedVelocityPart = 1.0003;
// Of q. Choice: of strict limits.
// Test, x 1.01: "the roughness costs no more time than its cap asks for" and 2 more.
inline constexpr double kStrictVelocityPart = 0.996;
// Of q. Choice: at a start that continues a plan.
inline constexpr double kFirstStrictVelocityPart = 0.9999;
// Relative. Rounding: derivatives that do not jump.
inline constexpr double kSame = 1e-9;
// Of a limit. Choice: from this part on the trace names it.
inline constexpr double kBinds = 0.99;
// Rounds. Choice: of refinement.
inline constexpr int kMostRounds = 6;
// Intervals. Choice: while no more exceed a limit, there may be twice as many rounds.
inline constexpr std::ptrdiff_t kFewExceed = 2;
// Choice: the smallest factor on a share in one round.
inline constexpr double kTightest = 0.8;
// Of the excess. Choice: by which a share is reduced.
inline constexpr double kTighten = 1.2;
// Choice: a motion that brakes this much too hard stands still.
inline constexpr double kHopeless = 1.1;
// Of each limit. Choice: of the slow motion where no plan is found.
inline constexpr double kCreep = 1.0 / 3;
// Nodes. Choice: on either side that are bounded where the spline exceeds a velocity limit.
inline constexpr std::size_t kAroundLimit = 8;
// Doublings. Choice: of the duration of the slow motion.
inline constexpr int kMostSlower = 30;
// Of the path. Choice: that the last plan had left: its nodes are used again.
inline constexpr double kKept = 0.7;
// Iterations. Choice: the cost of setting up and checking a problem.
inline constexpr int kSetUp = 10;

}  // namespace plan

// -------------------------------------------------------------------------------------------------
// libs/ipo/jerk_limited/plan_check

namespace check {

// Of the jerk. Choice: allowed between nodes; tests and verifier allow 1.005.
// Test, 1 + 4 times the excess over 1: "rounding corners never takes longer than resting in
// them" and 12 more.
inline constexpr double kJerk = 1.0045;
// Of the acceleration. Choice: allowed between nodes; tests and verifier allow 1.001.
// Test, 1 + 4 times the excess over 1: none fails.
inline constexpr double kAcceleration = 1.0007;
// Of q. Choice: allowed of the velocity limit of a node.
inline constexpr double kVelocity = 1.0004;
// Of q. Choice: allowed of the limit at a place: its constraints keep more free.
// Test, 1 + 4 times the excess over 1: none fails.
inline constexpr double kPassing = 1.0012;
// Of q. Rounding: allowed of a strict velocity limit.
inline constexpr double kStrict = 1 + 1e-7;
// Instants. Choice: beside the first, or one per sample.
inline constexpr int kInstants = 4;
// Instants. Choice: the most, however long the ramp.
inline constexpr int kMostInstants = 16;

}  // namespace check

// -------------------------------------------------------------------------------------------------
// libs/ipo/jerk_limited

namespace horizon {

// Stopping distances. Choice: that a plan covers.
// Test, x 0.3: none fails.
inline constexpr double kStops = 10;
// s. Choice: that it lasts while the velocity limit stays.
inline constexpr double kTime = 0.5;
// Stopping distances. Choice: of a plan that are planned again.
// Test, x 0.3: "a ramp to a corner goes over as many lines as it takes" and 3 more.
inline constexpr double kLeft = 1.5;
// Intervals. Choice: at one speed that a plan may cover.
inline constexpr std::size_t kSteady = 256;
// Stopping distances. Choice: the longest interval.
// Test, x 4: "a block that leaves in parts is the block that leaves as a whole" and 1 more.
inline constexpr double kLongest = 0.25;
// Parts. Choice: of an interval.
inline constexpr double kMostParts = 32;
// Choice: factor from one stop that is tried to the next.
inline constexpr double kFurther = 1.12;
// Stopping distances. Choice: for slowing down.
inline constexpr double kLittleMore = 1.5;
// Choice: squared: faster than the new feed.
inline constexpr double kSameSpeed = 1.002;
// Of the stopping distance. Choice: resolution of where the machine has slowed down.
// Test, x 10: none fails.
inline constexpr double kSlowingPart = 0.04;
// mm. Choice: the finest such resolution.
inline constexpr double kResolution = 1e-3;
// Stopping distances. Choice: that a plan covers which only shows whether the machine can slow
// down.
inline constexpr double kSlowedStops = 2;
// Of an interval. Choice: a stop nearer to its end is moved there.
inline constexpr double kNodePart = 0.1;
// Of v^2 / 2A with all axes together. Choice: the first stop that is tried.
inline constexpr double kShortestStop = 0.8;
// Of the jerk. Choice: of the plans that are tried one after another where the solver finds none
// with all of it. One of 0.8 or more has been enough for 15 of 15 plans of random chords.
inline constexpr std::array kLessJerk{0.98, 0.95, 0.9, 0.8, 0.4, 0.16};
// Of a speed. Rounding: at a velocity limit.
inline constexpr double kRounding = 1e-6;
// Of the work left. Choice: for one plan, so that shorter ones can still be tried.
inline constexpr double kOnePlan = 0.7;
// 0.4 us. Choice: work that the plans of a program may take from the start.
inline constexpr double kWorkAtOnce = 4e6;
// 0.4 us. Choice: work for each s of motion; far more than plans that are found need.
// Test, x 0.02: none fails.
inline constexpr double kWorkPerSecond = 4e6;

}  // namespace horizon

// -------------------------------------------------------------------------------------------------
// libs/ipo/planner

namespace planner {

// Intervals. Choice: before the first plan, and before the next where nothing was found.
// Test, x 0.1: none fails.
inline constexpr std::size_t kFewIntervals = 128;
// Of the acceleration. Choice: of a plan that continues another one: the first leaves nothing
// unused; within 0.1 %.
// Test, 1 + 4 times the excess over 1: "a stop at any moment of a jerk-limited program ends at
// rest on the path" and 13 more; 1: none fails.
inline constexpr double kAccelerationShare = 1 + 5e-4;
// mm. Choice: of a stop.
inline constexpr double kStopResolution = 1e-3;
// Of a distance. Rounding: of the longest stop.
inline constexpr double kStopRounding = 1e-6;

}  // namespace planner

// -------------------------------------------------------------------------------------------------
// libs/ipo/queue

namespace queue {

// Of each limit. Choice: values may be higher between the instants.
// Test, x 3: "a slow circle is quiet, a fast one is not" and 3 more.
inline constexpr double kQuietPart = 0.25;
// Of the tolerance. Choice: chords between the samples that are checked.
// Test, x 20: "a slow circle is quiet, a fast one is not" and 1 more.
inline constexpr double kQuietDrawn = 0.1;
// Periods. Choice: a shorter piece is not worth examining.
inline constexpr double kQuietPeriods = 8;
// Instants. Choice: beside the first.
inline constexpr int kQuietInstants = 4;
// Of a period. Rounding: of sums of durations.
inline constexpr double kSameInstant = 1e-9;

}  // namespace queue

// -------------------------------------------------------------------------------------------------
// libs/ipo/smoothing/polyline

namespace polyline {

// mm. Choice: a wider basis function has no benefit.
inline constexpr double kLongest = 10;
// Vertices. Choice: on either side that a basis function may cover.
// Test, x 0.2: "a chopped circle becomes a spline of few spans that bends like it".
inline constexpr std::size_t kMost = 24;
// rad. Rounding: no turn.
inline constexpr double kStraight = 1e-9;
// rad. Choice: a smaller corner can be passed exactly: chain::kTangentTolerance.
inline constexpr double kRests = 0.01;
// Vertices. Choice: dropped at a time.
inline constexpr std::size_t kForgotten = 256;
// Steps. Choice: towards a width limit.
inline constexpr int kNewtonSteps = 40;
// Choice: times as much of the lines must be known as last time.
inline constexpr double kLookAgain = 1.5;
// Of the tolerance. Choice: left unused by a width limit.
inline constexpr double kEnough = 1e-6;
// Of the tolerance. Choice: where more turns than kFew count.
// Test, x 20: "along a chopped curve a span reaches over many lines".
inline constexpr double kEnoughOfMany = 0.03;
// Turns. Choice: where more count, kEnoughOfMany is used instead of kEnough.
inline constexpr int kFew = 4;
// Of a width. Choice: knots are no closer together than this.
// Test, x 0.1: none fails.
inline constexpr double kCrowded = 1.0 / 32;
// Of a width. Choice: the steps in which a width is reduced until they are not.
inline constexpr double kLess = 1.0 / 256;
// Steps. Choice: the most such steps.
inline constexpr int kTries = 48;
// Vertices. Choice: whose knots may be close.
inline constexpr std::size_t kLastVertices = 72;
// Widths. Choice: the longest line that counts as dense.
inline constexpr double kShort = 1.0;
// Widths. Choice: the greatest length of four such lines together.
// Test, x 2: none fails.
inline constexpr double kDense = 3.2;

}  // namespace polyline

// -------------------------------------------------------------------------------------------------
// libs/ipo/smoothing

namespace knots {

// Of a width. Choice: knots that need no proof of being near enough.
inline constexpr double kNear = 0.5;
// Choice: from one spacing to the next.
// Test, x 1.5: none fails.
inline constexpr double kGrowth = 1.25;
// Spacings. Choice: turns within them may use near knots.
inline constexpr double kAhead = 4;
// Spacings. Choice: turns within them may use other knots.
inline constexpr double kWideAhead = 2;
// Near spacings. Choice: more than what shapes the spans between.
inline constexpr double kContinuation = 6;
// Tries. Choice: for the spacing of the last knots.
inline constexpr int kLastTries = 4;
// rad. Choice: that a spacing may turn.
// Test, x 3: none fails.
inline constexpr double kTurn = 0.3;
// Of the tolerance. Choice: that it may use.
// Test, x 4: none fails.
inline constexpr double kShare = 0.3;
// Lines. Choice: that it may cover.
inline constexpr std::size_t kLines = 16;
// Lines. Choice: before knots are tried again.
inline constexpr std::size_t kAwaited = 8;
// Basis functions. Choice: fixed at a time.
inline constexpr std::size_t kFixed = 5;
// Basis functions. Choice: not fixed at most.
inline constexpr std::size_t kFree = 12;
// Basis functions. Physics: before it shape the next span of a cubic.
inline constexpr std::size_t kShaping = 3;
// Choice: factor on a spacing that was too wide.
inline constexpr double kNarrower = 0.6;
// Times. Choice: before near knots are used.
inline constexpr int kRetreats = 5;
// Vertices. Choice: of one curve.
// Test, x 0.2: "chopped curves are as smooth as the curves were".
inline constexpr std::size_t kMostInPiece = 16;
// Lines. Choice: of one curve.
inline constexpr std::size_t kMostLines = 192;
// Vertices. Choice: that have been passed; more than polyline::kLastVertices.
inline constexpr std::size_t kKept = 80;
// mm. Rounding: parameters that are one.
inline constexpr double kSamePlace = 1e-9;
// Basis functions. Physics: that shape what follows the ones dropped.
inline constexpr std::size_t kKeptBases = 4;
// Basis functions. Choice: dropped at a time.
inline constexpr std::size_t kForgottenBases = 16;

}  // namespace knots

// -------------------------------------------------------------------------------------------------
// libs/ipo/smoothing/chord_merge

namespace chords {

// Of the tolerance. Choice: for chords.
// Test, x 8: "chords are joined up to the sagitta of the tolerance" and 2 more.
inline constexpr double kPart = 1.0 / 16;
// Lines. Choice: in one chord.
inline constexpr std::size_t kMostLines = 64;
// Rounding: of a tolerance.
inline constexpr double kMargin = 1 - 1e-9;

}  // namespace chords

// -------------------------------------------------------------------------------------------------
// libs/ipo/solver/tube_program

namespace tube_program {

// Of half the distance of two bounds. Choice: the first slack.
inline constexpr double kInside = 0.1;
// Of the slope times half the distance. Choice: the first barrier.
inline constexpr double kFirstBarrier = 0.1;
// Rounding: a slope of the scaled cost is none.
inline constexpr double kLeastSlope = 1e-12;
// Of a diagonal. Rounding: added to it.
inline constexpr double kRegular = 1e-13;
// Of the way to a bound. Choice: that a step goes.
inline constexpr double kToTheBound = 0.995;
// Steps. Choice: there is no solution if it was not found by then.
inline constexpr int kMostSteps = 40;
// mm. Rounding: outside the bounds.
inline constexpr double kOutside = 1e-9;
// Of the cost. Choice: how much less it could be.
inline constexpr double kGap = 3e-3;
// Of the scaled cost. Rounding: likewise.
inline constexpr double kLeastGap = 1e-9;

}  // namespace tube_program

// -------------------------------------------------------------------------------------------------
// libs/ipo/rebuild

namespace rebuild {

// Choice: of the width of a rounding, so much longer are the lines beside a corner. Chords within
// 9/8 P of their curve are part of it then, those that a CAM system has cut at P among them.
// Test, x 2/3: of 200 programs with random lines, curves cut at 3/4 P or more take up to 1.04 times
// as long as without curves, instead of 1.003.
inline constexpr double kBesideCorner = 1.5;
// mm. Choice: the longest knot span.
inline constexpr double kLongestSpan = 1;
// mm. Choice: the shortest.
inline constexpr double kShortestSpan = 0.002;
// rad. Choice: that a span may turn.
inline constexpr double kSpanTurn = 0.35;
// Choice: by how much of their distance neighbouring spans may differ.
inline constexpr double kGrowth = 0.3;
// Of the shorter line at a vertex. Choice: on either side, over which it turns.
inline constexpr double kHalf = 0.5;
// Tolerances. Choice: the shortest such distance.
inline constexpr double kTurnRange = 2;
// Of the way to brake. Choice: how far a window looks ahead.
inline constexpr double kAhead = 0.4;
// mm. Choice: at least.
inline constexpr double kLeastAhead = 8;
// mm. Choice: at most.
inline constexpr double kMostAhead = 24;
// Of that. Choice: how much a window settles.
inline constexpr double kStep = 0.5;
// mm. Choice: behind a window, within which its end is chosen.
inline constexpr double kEndMargin = 3;
// Places. Choice: among which it is chosen.
inline constexpr int kEnds = 24;
// Of the half-width of a basis function that uses all of the tolerance. Choice: the span where a
// curve becomes straight.
inline constexpr double kEndSpan = 0.25;
// Choice: spans are halved until they are this part of what they are at first.
inline constexpr double kFinest = 0.2;
// mm. Choice: of lines behind the last knot, which bear on its place.
inline constexpr double kMargins = kEndMargin + 4.4;
// Spans. Choice: before a window, the last ones of which are measured with it.
inline constexpr std::size_t kSpansBefore = 6;
// Choice: solutions for a window, each with the speeds that the last one permits.
inline constexpr int kRounds = 2;
// Choice: solutions at most, with tighter bounds where the curve is too far from the lines.
inline constexpr int kMostRounds = 8;
// Of the tolerance. Choice: for which bounds are tightened.
inline constexpr double kGoal = 0.98;
// Of the tolerance. Choice: the bounds, which hold at some places of the curve.
inline constexpr double kMargin = 0.98;
// Of the cost of a curve that meets the jerk limit. Choice: of one that meets the tolerance.
inline constexpr double kMiddle = 0.1;
// Choice: the largest ratio of jerk limits that shapes curves; at 40 they are a third slower.
inline constexpr double kJerkRatio = 4;
// Choice: where jerk limits differ more, lines are rounded: curves are then planned badly, at 200
// ten times slower.
inline constexpr double kUnlikeAxes = 10;
// Of the tolerance. Choice: kept from the ends of travel, at some places of the curve.
inline constexpr double kTravelMargin = 0.05;
// Of a direction. Choice: across the path, near enough to that of an axis.
inline constexpr double kAcross = 0.3;
// Of the limit of acceleration. Choice: by which speeds change beside bends.
inline constexpr double kRamp = 0.1;
// Of the jerk limit. Choice: that the jerk of a circle may be.
inline constexpr double kJerkOfCircle = 3;
// Places. Choice: over which the first estimate of curvature is a mean.
inline constexpr std::size_t kSmoothed = 9;
// mm/s. Choice: slower than this no curve is run.
inline constexpr double kLeastSpeed = 2;
// rad. Choice: the slip along the lines is the tolerance by this share of the turn.
inline constexpr double kSlipTurn = 0.4;
// Tolerances. Choice: the most it may be.
inline constexpr double kSlip = 15;
// Of a span. Choice: a shorter line is held at its ends only.
inline constexpr double kFewTies = 0.25;
// Of a span. Choice: from one place at which a line is held to the next.
inline constexpr double kTies = 0.5;
// Of the tolerance. Choice: left to places that settled control points shape.
inline constexpr double kSlack = 1e-3;
// Of the tolerance. Choice: nearer than this need not be known.
inline constexpr double kNearEnough = 0.9;
// Choice: of a distance from the lines.
inline constexpr double kAccuracy = 0.01;
// Choice: halvings of a curve while a bound of its distance is not low enough.
inline constexpr int kHalvings = 10;
// Steps. Choice: of Newton's method, to the nearest point.
inline constexpr int kFootSteps = 6;
// mm. Choice: how exactly that is found.
inline constexpr double kFootPlace = 1e-6;
// Square of the speed by the parameter. Rounding: at least.
inline constexpr double kSlowest = 1e-6;
// Tolerances. Choice: along the lines, to those that may be nearer.
inline constexpr double kNearby = 4;
// mm. Choice: a shorter part of the curve is none.
inline constexpr double kShortestPart = 1e-6;
// mm. Choice: of a long line, that may be part of the curve next to it.
inline constexpr double kLine = 8;
// mm. Choice: a longer arc stays one.
inline constexpr double kLongestArc = 24;
// Of the tolerance. Choice: the distance of an arc from its chords.
inline constexpr double kArcShare = 1.0 / 32;
// Lines. Choice: fewer are no run.
inline constexpr std::size_t kFewestLines = 4;

}  // namespace rebuild

// -------------------------------------------------------------------------------------------------
// libs/ipo/smoothing/blend

namespace blend {

// Cosine. Choice: below, the path turns back and the machine stops: a curve is hardly faster
// there, and takes long to plan.
// Test, x 0.5: "between two lines the middle is 3/16 d |t1 - t0| from the corner" and 4 more.
inline constexpr double kTurnsBack = -0.87;
// Of the cut. Choice: the first control point.
// Test, x 1.4: "between two lines the middle is 3/16 d |t1 - t0| from the corner" and 3 more.
inline constexpr double kFirstControl = 0.4;
// mm. Choice: a shorter blend is none.
inline constexpr double kShortest = 1e-5;
// rad. Choice: of a path within the cut.
inline constexpr double kMostTurn = 0.6;
// Samples. Choice: of that.
inline constexpr int kTurnSamples = 8;
// Samples. Choice: of the curve, on either side of its middle.
inline constexpr std::size_t kSamples = 16;
// Of a second difference. Choice: between samples; 1/8 for a parabola.
// Test, 0: none fails.
inline constexpr double kRise = 1.5 / 8;
// Knots. Choice: of a NURBS within the cut: samples see what is between.
inline constexpr int kMostKnots = 4;
// Rounds. Choice: of regula falsi.
inline constexpr int kRounds = 12;

}  // namespace blend

// -------------------------------------------------------------------------------------------------
// libs/ipo/smoothing

namespace corners {

// Of a path. Choice: for the corner at either end.
// Test, x 1.8: none fails.
inline constexpr double kHalf = 0.5;
// Of a path. Choice: that always remains.
inline constexpr double kRest = 1.0 / 64;
// rad. Rounding: the tangent jumps.
inline constexpr double kTurn = 1e-9;
// rad. Choice: too small to slow down a machine without jerk limits.
// Test, x 100: none fails.
inline constexpr double kSmallTurn = 2e-4;
// 1/mm. Choice: the curvature jumps.
inline constexpr double kCurvatureJump = 1e-6;
// rad. Choice: a smaller corner can be passed exactly: chain::kTangentTolerance.
inline constexpr double kRests = 0.01;
// rad. Choice: of a NURBS, which is cut in two there.
inline constexpr double kInnerCorner = 0.01;
// mm. Rounding: a shorter part of a path is none.
inline constexpr double kShortestPart = 1e-9;
// Of the time of the paths beside a corner. Choice: a rest that saves less is not worth it, and
// plans under a jerk limit are no nearer to the optimum.
inline constexpr double kNotWorth = 1.001;
// Parts. Choice: of a curve, between places where it is seen whether the feed can be kept.
inline constexpr int kLooks = 16;

}  // namespace corners

}  // namespace softcnc::ipo::tuning
