// SPDX-License-Identifier: MIT
//
// Every numeric constant of the solver that was chosen, with its unit, its reason and, where it is
// another's, its source. SI throughout the library: metres, kilograms, seconds, radians.
// docs/records/lab_diary.md and the tests say what each was measured to do. What a user may set is in
// WorldDef; what a caller may ask for at most in limits.h. Bounds of an algorithm (rounds,
// tolerances of rounding) stand beside it.
#pragma once

#include <cstdint>

namespace jostle::physics::tuning {

// --- sizes ---
// Lengths and speeds below are for bodies of usual size: the ball around a body has a radius in
// this range. Of smaller and larger ones they are a part or a multiple (foundation/size_scale.h).
inline constexpr double min_usual_size = 0.05, max_usual_size = 5;  // m
inline constexpr double usual_gravity = 9.81;                       // m/s^2

// --- broad phase ---
// A fat box is this much larger on each side than its shape, so that small motion needs no tree
// update.
inline constexpr double fat_margin = 0.04;  // m
// ... and stretched by this many steps of velocity in the direction of motion, as far as that is no
// more than so many radii of the ball around the body; else by those, or one step if that is
// further. A thousand balls of 0.15 m at up to 100 m/s have 12,700 pairs without that bound and
// 2060 with it.
inline constexpr double fat_lookahead_steps = 3;
inline constexpr double fat_lookahead_radii = 2;

// --- narrow phase ---
// Contacts begin this far before the surfaces meet, plus the way the pair moves in one step.
inline constexpr double speculative_margin = 0.02;  // m
// Points closer than this fraction of the body's size (and at most the length below) are the same
// point after a rebuild.
inline constexpr double match_fraction = 0.1;
inline constexpr double match_distance = 0.05;  // m
// A manifold is rebuilt after this much relative motion; until then its gaps are moved with the
// bodies. Reuse saves the narrow phase and is part of the stability of tall stacks.
inline constexpr double reuse_distance = 0.004;  // m
// ... and in every step in which they move faster than this against each other; those of one point,
// where round bodies roll and are cheap to look at, sooner.
inline constexpr double reuse_speed = 0.05;          // m/s
inline constexpr double single_reuse_speed = 0.015;  // m/s

// A composite pair is looked at a little further than it needs, so that it need not be looked at in
// every step.
inline constexpr double composite_slack = 0.01;  // m
// A part of a composite pair goes on as a manifold of the same piece whose normal is this near.
inline constexpr double same_part = 0.9;  // cosine
// What two will touch with is plain once they are this far in each other. A crate slides towards a
// tile that lies flush with the one under it: before they meet the side of the tile is what parts
// them most, and would stop it; past that it is the top. More than contacts overlap at rest.
inline constexpr double just_past = 1e-3;  // m
// A pair that moves less in a step is looked at where it is, not where it will be.
inline constexpr double noticed_motion = 1e-4;  // m
// What a separation bound holds back of its slack: within a kilometre the floats of its direction
// are off by less.
inline constexpr double slack_reserve = 1e-4;  // m
// Of more than four points those that overlap by this are kept first, because they bear.
inline constexpr double bearing_overlap = 0.001;  // m
// Pieces of a surface with normals within five degrees are one manifold, if the ground under it is
// even to this part of the shape's size.
inline constexpr double same_piece = 0.9962;  // cosine of 5 degrees
inline constexpr double even_ground = 1e-3;
// An edge of a surface still pushes along a normal that leans this far beyond what it allows.
inline constexpr double edge_slack = 0.01;  // rad
// Round edges that cross at a small angle touch in a long ellipse (Hertz): in two points where
// their axes are by this part of the radius further from each other than at the nearest.
// Derivation: narrowphase/segments.h; 1/10000 to 1/2000 were tried and are equal.
inline constexpr double crossing_gap = 2e-4;
// Points of a box along a capsule that are deeper by this part of the radius are points of their
// own.
inline constexpr double same_gap = 1e-4;

// --- contact solver (soft contacts after Catto, "Soft Constraints", GDC 2011; "Solver2D", 2024)
// Contact frequency as a fraction of the sub-step rate. 0.125 is the quietest, 0.25 makes brick
// walls buzz.
inline constexpr double contact_stiffness = 0.18;
// What is low does not buzz, and creeps the less the stiffer it is: what its overlaps give way
// moves all that lies on them.
inline constexpr double low_contact_stiffness = 0.36;
// A heap at rest is calm the sooner its overlaps are undone: with 0.36 and 10, which undo a tenth
// in a sub-step where these undo a sixth, 3 to 163 of 5000 poured bodies moved faster than 5 cm/s
// at looks between ten and fifteen seconds, with these 1 to 11. A tower that is put up with these
// bounces for longer.
inline constexpr double pile_contact_stiffness = 0.5;
inline constexpr double pile_contact_damping_ratio = 8;
inline constexpr double contact_damping_ratio = 10;
// At 10 a wall of 30 rows sways at up to 0.15 m/s for ten seconds, at 4 it is still after four. A
// wall of 100 rows, on more sub-steps, creeps at 3 to 5: it leans 49 to 60 mm in half a minute
// instead of 17.
inline constexpr double slender_contact_damping_ratio = 4;
// How fast overlap is undone at most. In a crowd that overlaps two fifths of it stay as speed: the
// relaxing pass does not reach all that the push set in motion. Of 5000 bodies that were put into a
// silo overlapping 37 left it over its walls at 1.5 m/s, 17 at this and 3 at 0.4. At 0.5 the pour
// takes a third more time, as they are longer in each other. At 3 m/s five boxes at half pitch
// throw their top at 6.8.
inline constexpr double push_out_speed = 0.8;  // m/s
inline constexpr double contact_slop =
    5e-5;  // m of overlap aimed at, so that resting contacts stay in touch
// A soft contact gives up only what its impulse deviates from the slow mean over this time: stacks
// do not sag.
inline constexpr double mean_impulse_time = 2.0;  // s
inline constexpr double low_mean_impulse_time =
    0.5;  // s: a heap does not sway, so it may learn faster
// What overlaps by more than this share of the way from a body's middle to where they touch is
// squeezed: something forces it together that no impulse stops, and impulses that give nothing back
// in the relaxing pass grow until the heap bursts. Stacks and heavy loads are as deep for a moment,
// and need all that they learn. Of 200 solids squeezed to 95 % of the volume the fastest reached 14
// m/s at 60 Hz, with this 6.1 and with half of it 4.9; but then stones that lie wedged on rough
// ground stay as much as 6 mm in it.
inline constexpr double squeezed_share = 0.04, never_squeezed = 1e6;
// Gauss-Seidel sweeps over the points of one manifold in a pass. Tall and heavily loaded islands,
// whose sub-steps are short, take one in the relaxing pass. At longer ones the 30-row pyramid would
// sway and not sleep, and deep overlap keep part of the speed with which it was pushed out.
inline constexpr int manifold_sweeps = 2;
// An island so many times as high as it is deep on the ground is slender. One of more layers than
// this takes twice the sub-steps, until it has fewer than the second for so many looks in a row. A
// wall of 100 rows falls on 8 sub-steps and stands on 16.
inline constexpr double tall_layers = 40, tall_layers_end = 32;
inline constexpr double slenderness = 3;
// An island of no more layers than this, all slow, takes half the sub-steps.
inline constexpr double flat_layers = 3;
inline constexpr int tier_interval = 8;  // steps between looks
inline constexpr int tier_patience = 4;  // looks
// In a world with a tolerance each set of islands is measured in every so many steps, and in every
// second step while one of them is not known.
inline constexpr int trial_interval = 8, first_trial_interval = 2;
// An island takes a coarser rung after so many looks at which it would have kept to this part of
// the tolerance there.
inline constexpr int substep_level_patience = 2;  // looks
inline constexpr double substep_level_reserve = 0.5;
// s: how long what a step's contacts got wrong in a velocity goes on, in the mean.
inline constexpr double velocity_error_life = 0.125;
// With a budget rungs are dealt out anew in every so many steps.
inline constexpr int budget_interval = 8;
// Islands of one tier are dealt out among batches that threads solve side by side, none of less
// bodies and manifolds than this, when one has so many times its share; looked at in every so many
// steps. To move a contact from set to set costs as much as two or three steps of it.
inline constexpr int min_batch = 800;
inline constexpr double batch_unequal = 1.15;
inline constexpr int batch_interval = 16;
// Threads share the colours of a set with so many contacts. Those of a smaller one are so short
// that handing them over again and again would cost more than they do.
inline constexpr int shared_contacts = 2000;
// A colour is in order when no more than one in so many contacts is out of it: sorting moves all.
inline constexpr int sorted_share = 256;
// Steps between looks at whether the contacts of a large set lie in the order of their bodies.
inline constexpr int sort_interval = 32;
inline constexpr double standing_speed = 0.1;  // m/s: what is faster falls; one step adds 0.16
// An island in which a body rests on nothing but bodies of so much less mass takes four times the
// sub-steps: five boxes under five of a hundred times their mass fall on 8 and stand on 32.
inline constexpr double heavy_ratio = 100;
inline constexpr double lies_on = 0.3;  // cosine: a normal this near to upright bears
// Impulses of an island are scaled down when it keeps less than this share of its mass in a step.
inline constexpr double noticed_load = 0.95;
// Balls and capsules touch in a small disc, as elastic bodies do: it resists turning about the
// normal with this part of their radius as lever, so that a ball that spins on the spot comes to
// rest, and one that rolls in a trough. Hertz: 3 pi / 16 of the disc's radius, which is (pi density
// g radius load / E)^(1/3) of the ball's; here as of firm rubber (E = 30 MPa) under its own weight,
// or of wood (1 GPa) under 34 times that. A ball of 0.3 m on a floor of friction 0.5 loses 1.6
// rad/s in a second.
inline constexpr double contact_patch = 0.04;
// Slower impacts do not bounce. About twice the speed that gravity adds in one 60 Hz step: below it
// a bounce is noise.
inline constexpr double restitution_speed = 0.3;  // m/s
// A kinematic body stops for nobody: what it hits wakes as if hit by so many times its mass.
inline constexpr double kinematic_mass_ratio = 100;
// An awake body wakes a sleeping one when it will come this near within the step.
inline constexpr double wake_gap = 0.001;  // m
// A contact that pressed counts as touching until its gap exceeds this.
inline constexpr double touch_gap = 0.002;  // m

// Reuse of a manifold: what counts as motion besides slip. A turn against each other by the mean
// distance of the points, at least this, m (a long body may come down beside its only point), and
// the common turn by this, m: the normal does not follow it.
inline constexpr float min_turn_radius = 0.3f;
inline constexpr float common_turn_radius = 0.3f;
// An arm follows the bodies while they moved against each other by less than this part of its
// square: what has moved further no longer meets there.
inline constexpr float arm_follows = 0.1f;
// An impact's Gauss-Seidel sweeps over its points.
inline constexpr int impact_sweeps = 12;

// --- free motion ---
// A body that turns further in a step, with an uneven inertia, takes Euler's equations sub-step by
// sub-step.
inline constexpr double gyroscopic_turn = 0.02;  // rad
// ... that joints hold and nothing touches: what joints do to it depends on where its axes are now,
// and that it stands as it stood at the start of the step is an error of first order.
inline constexpr double jointed_gyroscopic_turn = 5e-4;  // rad

// --- joints ---
// Joint frequency as a fraction of the sub-step rate, and its damping.
inline constexpr double joint_stiffness = 0.25;
inline constexpr double joint_damping_ratio = 2;
// A spring that turns by more of its period in a sub-step is not resolved by it.
inline constexpr double resolved_spring_turn = 1;  // rad
// Ends of a joint that an impact has parted by less need not be brought together at once.
inline constexpr double close_enough = 1e-4;  // m
// Of what points that are solved at once are apart a sub-step takes away so much.
inline constexpr double direct_joint_correction = 0.5;
// A group of joints whose factorisation takes more multiplications than this, times the cubes of
// their rows, is solved sweep by sweep. A chain takes 3, a net of 10 x 10 balls 48 and one of
// 45 x 45 590, whose step would take a hundred times as long as by sweeps.
inline constexpr int direct_work = 64;
// Where a group asks to be solved directly: multiplications of one factorisation of all joints of a
// world.
inline constexpr std::int64_t max_direct_work = 20'000'000;
// A net of more joints is not even looked at: to find out what it costs would take long.
inline constexpr int max_net_joints = 2048;
// Ends that are apart come together at this speed at most. What turns while it is pulled keeps a
// part of that speed, the more the further it turns in a sub-step.
inline constexpr double joint_push_speed = 10;  // m/s
inline constexpr double joint_push_spin = 8;    // rad/s

// --- continuous collision ---
// A body is swept when a point of it may have moved further than this part of its thickness.
inline constexpr double sweep_fraction = 0.5;
// A sweep stops this far before the surfaces meet.
inline constexpr double sweep_gap = 1e-4;  // m
// Two that touch and go into each other faster than this, when an impact has just sent one of them
// that way, meet at once; what is slower is left to the contact solver.
inline constexpr double touching_impact_speed = 0.05;  // m/s
// Bodies that touch hand an impact on until this share of its speed is left.
inline constexpr double min_impact_chain = 0.1;
// The box of a swept body is this much larger on each side.
inline constexpr double swept_margin = 0.01;  // m
// Of what a pair may move without a sweep the sweep looks at a little more, so that nothing falls
// between the two; after an impact at more: contacts did not foresee the new way.
inline constexpr double sweep_share = 0.8, sweep_share_after_impact = 0.4;
// One end of a body may rest while the other comes down: then smaller and smaller parts of the
// thinner body, about its middle, are swept. Of what contacts hold only those by which it may yet
// go through.
inline constexpr double swept_cores[] = {0.95, 0.9, 0.8, 0.65, 0.45, 0.25};
inline constexpr double held_core = 0.7;
// An even turn may miss a gyroscopic body's by this; else its way is cut into legs.
inline constexpr double leg_error = 0.01;  // rad
// ... of a body's step so many at most, then the rest is one leg: 17,000 rad/s at 60 Hz.
inline constexpr int max_legs = 1000;
// Gaps need not be exact to advance safely: a direction that separates by all but this part will
// do.
inline constexpr double loose_gap = 0.1;
inline constexpr int sweep_impacts = 16;  // of one body in one step; then it stays where it is

// --- budget of a step ---
// What things cost, ns on one core of an EPYC, fitted to eleven scenes of the laboratory: the time
// of their steps is .6 to 2 times what their work says. A look at two capsules takes .4 us, at two
// boxes .7 to 1, at two hulls of 32 corners 2.9; this is none of them.
inline constexpr std::int64_t body_work = 500;           // an awake body
inline constexpr std::int64_t narrow_phase_work = 1000;  // a narrow phase call
inline constexpr std::int64_t composite_work = 3000;  // ... with a mesh or a compound, beside that
inline constexpr std::int64_t contact_work = 40;      // a contact in a sub-step
inline constexpr std::int64_t joint_work = 200;       // a joint in a sub-step
inline constexpr std::int64_t sweep_work = 900;       // a look at what may be on a body's way
inline constexpr std::int64_t impact_work = 1000;     // an impact between steps
inline constexpr std::int64_t work_unit = 100;
// Strain falls by a level after so many steps in a row below this share of the budget. Half a
// second: what just gave way does not come and go with every other step. What a level saves is at
// most half of the work where it was measured, so below this share the next level down mostly fits.
inline constexpr int overload_patience = 30;
inline constexpr double cheap_step_ratio = 0.6;
// Under strain a manifold is kept over so many times the drift, however fast its bodies are: 16 mm,
// less than the margin within which points were looked for. Of a drum in which 8000 cubes tumble it
// takes 28 % of the step, as much as no bound of drift but one of four times the speed takes 3 %.
inline constexpr float overload_drift = 4;
inline constexpr float any_motion = 1e6f;  // m in a step

// --- sleep ---
// An island sleeps when none of its bodies moved faster than this for that long: neither its centre
// nor, about that, its surface.
inline constexpr double sleep_speed = 0.05;   // m/s
inline constexpr double time_to_sleep = 0.5;  // s
// What is faster, but not by so much, rests too while none of its points is further than this from
// where its rest began (as Jolt measures it): a stone that rocks by a millimetre between others.
inline constexpr double drift_speed = 0.2;  // m/s
inline constexpr double drift = 0.004;      // m
// Of an island that does not sleep, what has rested this long beside nothing that has not is
// put to sleep in place, if that are so many bodies; looked at in every so many steps.
inline constexpr double partial_sleep_time = 0.5;  // s
inline constexpr int partial_sleep_least = 16;
inline constexpr double partial_sleep_share = 0.8;  // of the island's bodies, at least
inline constexpr int partial_sleep_interval = 8;
// A body that sleeps in place wakes when the force at a contact changes by more than this share of
// what it was and this share of the body's weight. Forces within a heap shift all the time by less:
// a micrometre of overlap bears half a weight.
inline constexpr double wake_load_share = 0.5;
inline constexpr double wake_load_weight = 0.5;
// What is hit wakes with so much around it that all of that together would take over the momentum
// at this speed.
inline constexpr double gentle_speed = 0.1;  // m/s
// An island is not cut again before so many steps: a heap in which something always rolls would be
// flooded in each.
inline constexpr int split_interval = 15;

// A fat box is left a part of its margin early: manifolds begin before surfaces meet.
inline constexpr double fat_margin_reserve = 0.25;

// --- quarantine ---
// Beyond these a state is no longer physics but a number that ran away.
inline constexpr double quarantine_speed = 1e6;       // m/s or rad/s
inline constexpr double quarantine_coordinate = 1e8;  // m

// --- threads ---
// How many are taken at once where threads share a range; fewer than four grains stay on one
// thread. A grain takes some microseconds, ten times a hand-over.
inline constexpr int pair_grain = 64;          // shapes that ask for new pairs
inline constexpr int bound_grain = 512;        // separation bounds
inline constexpr int narrow_phase_grain = 32;  // pairs in the narrow phase
inline constexpr int body_grain = 256;         // bodies
// Free bodies that listeners are shown together where they may be called at once. It decides what
// they see, so it is the same for any number of threads.
inline constexpr int listened_chunk = 256;
inline constexpr int joint_grain = 8;  // blocks of joints
// With fewer blocks in a run of joints, waking another thread costs more than they do.
inline constexpr int shared_joint_blocks = 32;
inline constexpr int contact_grain = 8;  // blocks of contacts
// Steps that take longer are shared among threads without a trial: they gain, and a trial would
// make one late. A trial that gains less is noise. Steps between trials: so many at first, at most.
inline constexpr double long_step_ms = 2;
inline constexpr double trial_gain = 0.95;
inline constexpr int first_trial_pause = 8, longest_trial_pause = 512;
// A task of the solver of no more bodies and contacts is one thread's.
inline constexpr unsigned light_task = 4000;
// From so many moves on the trees are told of them beside other work: a few take less time than to
// wake a thread.
inline constexpr int async_moves_min = 256;

}  // namespace jostle::physics::tuning
