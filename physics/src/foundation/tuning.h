// SPDX-License-Identifier: MIT
//
// Tuned constants of the solver, each with its unit, its reason and, if it is not our own, its
// source. SI units throughout the library: metres, kilograms, seconds, radians.
// docs/records/lab_diary.md and the tests record the measured effect of each. User settings are in
// WorldDef, limits of arguments in limits.h. Parameters of an algorithm (iteration limits, rounding
// tolerances) are declared next to it.
#pragma once

#include <cstdint>

namespace jostle::physics::tuning {

// --- sizes ---
// Lengths and speeds below apply to bodies of usual size: the radius of the bounding sphere is in
// this range. For smaller and larger bodies they are scaled (foundation/size_scale.h).
inline constexpr double min_usual_size = 0.05, max_usual_size = 5;  // m
inline constexpr double usual_gravity = 9.81;                       // m/s^2

// --- broad phase ---
// A fat box is this much larger than its shape on each side, so that small motions need no tree
// update.
inline constexpr double fat_margin = 0.04;  // m
// Fat boxes are also extended by this many steps of velocity, up to this many radii of the bounding
// sphere, but at least by one step. With a thousand balls of 0.15 m at up to 100 m/s there are
// 12,700 pairs without the second bound and 2060 with it.
inline constexpr double fat_lookahead_steps = 3;
inline constexpr double fat_lookahead_radii = 2;

// --- narrow phase ---
// Contacts begin at this gap plus the displacement of the pair in one step.
inline constexpr double speculative_margin = 0.02;  // m
// After a manifold is rebuilt, points that are closer than this fraction of the body's size (at
// most the length below) are treated as the same point.
inline constexpr double match_fraction = 0.1;
inline constexpr double match_distance = 0.05;  // m
// A manifold is rebuilt after this much relative motion; until then its gaps are updated from the
// motion of the bodies. Reuse avoids narrow-phase tests and contributes to the stability of tall
// stacks.
inline constexpr double reuse_distance = 0.004;  // m
// A manifold is also rebuilt in every step in which the bodies move faster than this relative to
// each other. Manifolds of one point (rolling round bodies, cheap to test) have a lower threshold.
inline constexpr double reuse_speed = 0.05;          // m/s
inline constexpr double single_reuse_speed = 0.015;  // m/s

// Composite pairs are tested with this extra margin, so that they need not be tested in every step.
inline constexpr double composite_slack = 0.01;  // m
// A part of a composite pair continues as a manifold of the same piece if their normals are this
// close.
inline constexpr double same_part = 0.9;  // cosine
// The features that will touch are determined at this penetration. Example: a crate slides towards
// a tile that is flush with the tile below the crate. Before contact, the side of the tile has the
// largest separation and would stop the crate; beyond this depth it is the top. Larger than the
// overlap of resting contacts.
inline constexpr double just_past = 1e-3;  // m
// A pair that moves less than this in a step is tested at its current pose instead of the predicted
// one.
inline constexpr double noticed_motion = 1e-4;  // m
// Reserve subtracted from the slack of a separation bound. Within 1 km, the rounding error of its
// single-precision direction is smaller.
inline constexpr double slack_reserve = 1e-4;  // m
// If a manifold has more than four points, points that penetrate by at least this are selected
// first because they carry load.
inline constexpr double bearing_overlap = 0.001;  // m
// Pieces of a surface whose normals are within five degrees form one manifold if the surface below
// the shape is flat to this fraction of the shape's size.
inline constexpr double same_piece = 0.9962;  // cosine of 5 degrees
inline constexpr double even_ground = 1e-3;
// Corners of triangles within this distance count as one corner: coordinates that are rounded to
// 0.01 mm along each axis differ by up to 0.035 mm.
inline constexpr double weld_distance = 4e-5;  // m
// Pieces of a floor whose heights differ by less than this, and less than even_ground of the size
// of the shape on them, are flush.
inline constexpr double flush_distance = 1e-3;  // m
// Tests of a pair for triangles that cover a contact at an open edge. A box on a mesh without
// shared vertices needs a few hundred; a soup of 40,000 triangles would need their square.
inline constexpr int max_seam_tests = 4096;
// An edge of a surface accepts normals that lean this far beyond its range.
inline constexpr double edge_slack = 1e-4;  // rad
// Round edges that cross at a small angle touch in an elongated ellipse (Hertz). They get two
// points, where the distance of their axes exceeds the minimum by this fraction of the radius.
// Derivation: narrowphase/segments.h. Values from 1/10000 to 1/2000 gave equal results.
inline constexpr double crossing_gap = 2e-4;
// Points of a box along a capsule that are deeper by this fraction of the radius are separate
// points.
inline constexpr double same_gap = 1e-4;

// --- contact solver (soft contacts after Catto, "Soft Constraints", GDC 2011; "Solver2D", 2024)
// Contact frequency as a fraction of the sub-step rate. 0.125 is the most stable value; 0.25 makes
// brick walls buzz.
inline constexpr double contact_stiffness = 0.18;
// For low islands, which do not buzz. Stiffer contacts creep less: where an overlap gives way,
// everything above it moves.
inline constexpr double low_contact_stiffness = 0.36;
// For resting piles, which settle sooner if overlaps are corrected faster. With 0.36 and 10, which
// correct a tenth per sub-step, 3 to 163 of 5000 poured bodies moved faster than 5 cm/s in samples
// between 10 and 15 s; with these values, which correct a sixth, 1 to 11. A tower of blocks bounces
// longer with these values.
inline constexpr double pile_contact_stiffness = 0.5;
inline constexpr double pile_contact_damping_ratio = 8;
inline constexpr double contact_damping_ratio = 10;
// With 10, a wall of 30 rows sways at up to 0.15 m/s for 10 s; with 4 it is at rest after 4 s. With
// 3 to 5, a wall of 100 rows, which takes more sub-steps, creeps: it leans 49 to 60 mm in 30 s
// instead of 17 mm.
inline constexpr double slender_contact_damping_ratio = 4;
// Maximum speed at which overlap is corrected. In an overlapping cluster two fifths of it remain as
// velocity, because the relaxing pass does not reach everything that the correction set in motion.
// Of 5000 bodies placed in a silo with overlap, 37 left it over its walls at 1.5 m/s, 17 at this
// value and 3 at 0.4 m/s. At 0.5 m/s the pour takes a third more time, because bodies overlap
// longer. At 3 m/s, five boxes at half pitch throw the top one at 6.8 m/s.
inline constexpr double push_out_speed = 0.8;  // m/s
// Target overlap, so that resting contacts stay in contact.
inline constexpr double contact_slop = 5e-5;  // m
// A soft contact relaxes only the deviation of its impulse from the slow mean over this time, so
// that stacks do not sag.
inline constexpr double mean_impulse_time = 2.0;  // s
// A pile does not sway, so its mean may adapt faster.
inline constexpr double low_mean_impulse_time = 0.5;  // s
// A contact that overlaps by more than this fraction of its lever arm (centre of mass to contact
// point) is squeezed: forces that no impulse can balance push the bodies together. Impulses that
// are not relaxed would grow until the pile explodes. Stacks and heavily loaded contacts reach this
// depth only briefly and need their complete mean impulse. Of 200 solids squeezed to 95 % of their
// volume, the fastest reached 14 m/s at 60 Hz; with this value 6.1 m/s, with half of it 4.9 m/s,
// but then stones wedged on rough ground penetrate it by up to 6 mm.
inline constexpr double squeezed_share = 0.04, never_squeezed = 1e6;
// Contacts become stiffer over this many steps after the step has become shorter. If they followed
// at once, an overlap of a long step would be pushed out in a short one so fast that the next long
// step would carry the bodies far: with steps of 1/15 and 1/900 s in turn, a stack of ten moves by
// 9 m.
inline constexpr double stiffening_steps = 20;
// Gauss-Seidel sweeps over the points of one manifold in a pass. Tall and heavily loaded islands,
// whose sub-steps are short, use one in the relaxing pass. With longer sub-steps, one sweep would
// let a 30-row pyramid sway and never sleep, and deep overlaps would retain part of their
// correction velocity.
inline constexpr int manifold_sweeps = 2;
// An island is slender if its height is this many times its depth on the ground. A slender island
// of more than tall_layers layers takes twice the sub-steps, until it has fewer than
// tall_layers_end layers in several consecutive tests. A wall of 100 rows collapses with 8
// sub-steps and stands with 16.
inline constexpr double tall_layers = 40, tall_layers_end = 32;
inline constexpr double slenderness = 3;
// An island of at most this many layers, all slow, takes half the sub-steps.
inline constexpr double flat_layers = 3;
inline constexpr int tier_interval = 8;  // steps between tests
// An island takes the lowest size level whose factor, times this, reaches the ratio of the time
// scales (foundation/size_scale.h). Ten cubes of 5 cm stand with 8 sub-steps at 60 Hz and sway by
// 1.4 % of their size; ten of 1 cm fall.
inline constexpr double size_level_reserve = 1.25;
inline constexpr int size_level_interval = 64;  // steps between tests for lower levels
inline constexpr int tier_patience = 4;         // tests
// In a world with a tolerance, each set of islands is measured at this interval in steps, and at
// the second interval while the error of one of them is unknown.
inline constexpr int trial_interval = 8, first_trial_interval = 2;
// An island moves to a coarser sub-step level after this many tests in which it would have met this
// fraction of the tolerance at that level.
inline constexpr int substep_level_patience = 2;  // tests
inline constexpr double substep_level_reserve = 0.5;
// Mean lifetime of a velocity error caused by the contacts of a step, s.
inline constexpr double velocity_error_life = 0.125;
// With a budget, sub-step levels are reassigned at this interval in steps.
inline constexpr int budget_interval = 8;
// Islands of one tier are distributed over batches that threads solve in parallel. A batch has at
// least this many bodies and manifolds. Islands are redistributed if one batch exceeds its share by
// this factor, tested at this interval in steps. Moving a contact between sets costs as much as two
// or three steps of it.
inline constexpr int min_batch = 800;
inline constexpr double batch_unequal = 1.15;
inline constexpr int batch_interval = 16;
// Threads share the colours of a set with at least this many contacts. The colours of smaller sets
// are so short that handing them over costs more than solving them.
inline constexpr int shared_contacts = 2000;
// A colour counts as sorted while at most one contact in this many is out of order, because sorting
// moves all of them.
inline constexpr int sorted_share = 256;
// Interval in steps at which the contact order of a large set is tested against the order of its
// bodies.
inline constexpr int sort_interval = 32;
// m/s; faster bodies fall, since one step adds 0.16 m/s.
inline constexpr double standing_speed = 0.1;
// m/s relative to the others, spin included; an island with a faster body is not solved directly.
inline constexpr double tumbling_speed = 1;
// An island in which a body rests only on bodies that are lighter by this ratio takes four times
// the sub-steps. Five boxes below five boxes of 100 times their mass collapse with 8 sub-steps and
// stand with 32.
inline constexpr double heavy_ratio = 100;
// Islands with a body that carries this many times its mass per layer above it are solved directly
// if they have at most so many bodies and manifolds.
inline constexpr double direct_load_ratio = 2.5;
inline constexpr std::uint32_t max_group_bodies = 64, max_group_manifolds = 100;
// Work of such an island, and of all of them, after which the rest of a step is sweeps. In products
// of 6 x 6 blocks, 0.05 us each.
inline constexpr std::int64_t max_group_work = 120'000, max_direct_step_work = 240'000;
inline constexpr double lies_on = 0.3;  // cosine; a normal this close to vertical supports load
// Impulses of an island are scaled down if it retains less than this fraction of its mass in a
// step.
inline constexpr double noticed_load = 0.95;
// Spheres and capsules touch in a small disc, as elastic bodies do. The disc resists rotation about
// the normal with this fraction of the radius as lever arm, so that a ball that spins in place or
// rolls in a trough comes to rest. Hertz: 3 pi / 16 of the radius of the disc, which is (pi density
// g radius load / E)^(1/3) of the radius of the ball. The value corresponds to firm rubber (E = 30
// MPa) under its own weight, or wood (1 GPa) under 34 times its weight. A ball of 0.3 m on a floor
// of friction 0.5 loses 1.6 rad/s per second.
inline constexpr double contact_patch = 0.04;
// Slower impacts do not bounce. About twice the speed that gravity adds in one step at 60 Hz;
// slower bounces are noise.
inline constexpr double restitution_speed = 0.3;  // m/s
inline constexpr double usual_rate = 60;          // Hz
// Contacts do not slow a kinematic body. Bodies that it hits wake as if it had this many times
// their mass.
inline constexpr double kinematic_mass_ratio = 100;
// An awake body wakes a sleeping one if the gap within the step falls below this.
inline constexpr double wake_gap = 0.001;  // m
// A contact that touched counts as touching until its gap exceeds this.
inline constexpr double touch_gap = 0.002;  // m

// Manifold reuse: rotations that count as motion in addition to slip. Relative rotation counts
// times the mean distance of the points, at least this in m (a long body may come down next to its
// only point). Common rotation counts times this in m, because the normal is not updated.
inline constexpr float min_turn_radius = 0.3f;
inline constexpr float common_turn_radius = 0.3f;
// A lever arm is updated while the relative motion of the bodies is less than this fraction of its
// square. Beyond that, the bodies no longer touch at that point.
inline constexpr float arm_follows = 0.1f;
// Gauss-Seidel sweeps over the points of an impact.
inline constexpr int impact_sweeps = 12;

// --- free motion ---
// A body with an uneven inertia that rotates further than this in a step integrates Euler's
// equations in each sub-step.
inline constexpr double gyroscopic_turn = 0.02;  // rad
// The same for a body that is held by joints and touches nothing. The effect of joints depends on
// the current axes of the body, and using those of the start of the step is a first-order error.
inline constexpr double jointed_gyroscopic_turn = 5e-4;  // rad

// --- joints ---
// Joint frequency as a fraction of the sub-step rate, and its damping.
inline constexpr double joint_stiffness = 0.25;
inline constexpr double joint_damping_ratio = 2;
// A spring whose phase advances further in a sub-step is not resolved by it.
inline constexpr double resolved_spring_turn = 1;  // rad
// Ends of a joint that an impact separated by less than this need not be rejoined immediately.
inline constexpr double close_enough = 1e-4;  // m
// Fraction of the position error of directly solved points that a sub-step corrects.
inline constexpr double direct_joint_correction = 0.5;
// A group of joints is solved iteratively if its factorization takes more multiplications than
// this, relative to the sum of the cubes of the row counts. A chain takes 3, a net of 10 x 10 balls
// 48, and a net of 45 x 45 balls 590, whose step would take a hundred times as long as the
// iterative one.
inline constexpr int direct_work = 64;
// For groups that request the direct solver: multiplications per factorization, summed over all
// joints of a world.
inline constexpr std::int64_t max_direct_work = 20'000'000;
// Nets of more joints are rejected without analysis, because computing their cost would take long.
inline constexpr int max_net_joints = 2048;
// Maximum speed at which separated ends of a joint are rejoined. A body that rotates while it is
// pulled retains a part of that speed, which grows with its rotation per sub-step.
inline constexpr double joint_push_speed = 10;  // m/s
inline constexpr double joint_push_spin = 8;    // rad/s

// --- narrow phase ---
// Overlap of two polyhedra, as a fraction of the size of the smaller one, up to which the axis of
// the previous test is used again without a search for a better one.
inline constexpr double trusted_overlap = 5e-4;

// --- continuous collision ---
// A body is swept if one of its points may have moved further than this fraction of its thickness.
inline constexpr double sweep_fraction = 0.5;
// Sweeps of a step (StepProfile::sweeps_after_impacts) after which impacts between dynamic bodies
// are left to the contact solver: a base, and a number for each awake body. Only sweeps find the
// time of a bounce, so the limit is higher if some bodies may bounce.
inline constexpr int min_sweep_limit = 2048, sweeps_per_body = 2;
inline constexpr int min_bounce_sweep_limit = 16384, bounce_sweeps_per_body = 16;
// A sweep stops at this gap.
inline constexpr double sweep_gap = 1e-4;  // m
// If an impact has just moved a body towards another one that it touches, a speed above this is an
// immediate impact. Slower approaches are left to the contact solver.
inline constexpr double touching_impact_speed = 0.05;  // m/s
// Touching bodies propagate an impact until its speed falls below this fraction.
inline constexpr double min_impact_chain = 0.1;
// Margin on each side of the box of a swept body.
inline constexpr double swept_margin = 0.01;  // m
// Sweeps start at this fraction of the motion that a pair may make without a sweep, so that no
// motion is missed. The fraction is smaller after an impact, because contacts did not predict the
// new motion.
inline constexpr double sweep_share = 0.8, sweep_share_after_impact = 0.4;
// One end of a body may rest while the other end comes down. Scaled-down copies of the thinner body
// about its centre are then swept, with these scales. Copies held by contacts are swept only if the
// body may still pass through them.
inline constexpr double swept_cores[] = {0.95, 0.9, 0.8, 0.65, 0.45, 0.25};
inline constexpr double held_core = 0.7;
// A linear sweep may deviate from the motion of a gyroscopic body by this; otherwise its path is
// divided into legs.
inline constexpr double leg_error = 0.01;  // rad
// Maximum number of legs per step; the rest of the step is then one leg. Reached at 17,000 rad/s at
// 60 Hz.
inline constexpr int max_legs = 1000;
// Conservative advancement does not need exact gaps: a direction that separates by all but this
// fraction suffices.
inline constexpr double loose_gap = 0.1;
inline constexpr int sweep_impacts = 16;  // of one body in one step; then it stops where it is

// --- budget of a step ---
// Cost of operations in ns on one core of an EPYC, fitted to eleven benchmark scenes: the measured
// time of a step is 0.6 to 2 times its work. A narrow-phase test takes 0.4 us for two capsules, 0.7
// to 1 us for two boxes and 2.9 us for two hulls of 32 vertices; narrow_phase_work is an average.
inline constexpr std::int64_t body_work = 500;           // an awake body
inline constexpr std::int64_t narrow_phase_work = 1000;  // a narrow-phase test
inline constexpr std::int64_t composite_work = 3000;   // additional cost with a mesh or a compound
inline constexpr std::int64_t contact_work = 40;       // a contact in a sub-step
inline constexpr std::int64_t joint_work = 200;        // a joint in a sub-step
inline constexpr std::int64_t sweep_work = 900;        // a continuous collision test
inline constexpr std::int64_t impact_work = 1000;      // an impact in the continuous stage
inline constexpr std::int64_t direct_block_work = 50;  // a product of 6 x 6 blocks
inline constexpr std::int64_t work_unit = 100;
// The overload level falls by one after this many consecutive steps below this fraction of the
// budget. Half a second, so that the level does not oscillate. One level saves at most half of the
// work in the measured scenes, so below this fraction the next lower level usually fits into the
// budget.
inline constexpr int overload_patience = 30;
inline constexpr double cheap_step_ratio = 0.6;
// At an overload level, manifolds are reused over this many times the usual motion, at any speed:
// 16 mm, which is less than the margin within which points are computed. In a drum in which 8000
// cubes tumble this saves 28 % of the step, as much as an unlimited drift; a fourfold speed limit
// saves 3 %.
inline constexpr float overload_drift = 4;
inline constexpr float any_motion = 1e6f;  // m in a step

// --- sleep ---
// An island falls asleep if none of its bodies moved faster than this for that time: neither the
// centre of mass nor, relative to it, the surface.
inline constexpr double sleep_speed = 0.05;   // m/s
inline constexpr double time_to_sleep = 0.5;  // s
// A body that is faster, up to this speed, also counts as resting while none of its points is
// further than this from its position at the start of the rest (the criterion of Jolt): for example
// a stone that rocks by 1 mm between others.
inline constexpr double drift_speed = 0.2;  // m/s
inline constexpr double drift = 0.004;      // m
// In an island that does not sleep, bodies that have rested for this long and touch only resting
// bodies are put to sleep in place, if they are at least this many and this fraction of the island.
// Tested at this interval in steps.
inline constexpr double partial_sleep_time = 0.5;  // s
inline constexpr int partial_sleep_least = 16;
inline constexpr double partial_sleep_share = 0.8;  // fraction of the bodies of the island
inline constexpr int partial_sleep_interval = 8;
// A body that sleeps in place wakes if the force at a contact changes by more than this fraction of
// its value and this fraction of the weight of the body. Forces within a pile vary by less all the
// time: 1 um of overlap carries half a weight.
inline constexpr double wake_load_share = 0.5;
inline constexpr double wake_load_weight = 0.5;
// A body that is hit wakes together with enough of its surroundings to absorb the momentum at this
// speed.
inline constexpr double gentle_speed = 0.1;  // m/s
// An island is split again only after this many steps. A pile in which a body always rolls would be
// traversed in every step.
inline constexpr int split_interval = 15;

// A body leaves its fat box this fraction of the margin early, because manifolds begin before
// surfaces touch.
inline constexpr double fat_margin_reserve = 0.25;

// --- quarantine ---
// Beyond these values a state is considered diverged.
inline constexpr double quarantine_speed = 1e6;       // m/s or rad/s
inline constexpr double quarantine_coordinate = 1e8;  // m

// --- threads ---
// Grain sizes of parallel ranges. Ranges of fewer than four grains stay on one thread. A grain
// takes several microseconds, ten times a hand-over between threads.
inline constexpr int pair_grain = 64;                // shapes that search for new pairs
inline constexpr std::size_t min_pair_limit = 4096;  // WorldDef::max_pairs_per_shape adds to it
// Grains that search at once in a world that limits its pairs. It determines which pairs are
// skipped, so it does not depend on the number of threads.
inline constexpr int limited_pair_grains = 16;
inline constexpr int bound_grain = 512;        // separation bounds
inline constexpr int narrow_phase_grain = 32;  // pairs in the narrow phase
inline constexpr int body_grain = 256;         // bodies
// Free bodies per group of listeners that allow concurrent calls. It determines what a listener
// sees, so it does not depend on the number of threads.
inline constexpr int listened_chunk = 256;
inline constexpr int joint_grain = 8;  // blocks of joints
// With fewer blocks in a run of joints, waking another thread costs more than solving them.
inline constexpr int shared_joint_blocks = 32;
inline constexpr int contact_grain = 8;  // blocks of contacts
// All threads take part in a step if the last step had at least this work (StepProfile::work, about
// 0.1 us each). TODO(threshold)
inline constexpr std::int64_t shared_work = 10'000, still_shared_work = 7'500;
// A solver task of at most this many bodies and contacts runs on one thread.
inline constexpr unsigned light_task = 4000;
// From this many moves on, the trees are updated on another thread. Fewer moves take less time than
// waking a thread.
inline constexpr int async_moves_min = 256;

}  // namespace jostle::physics::tuning
