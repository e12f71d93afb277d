#!/usr/bin/env python3
"""Tests mirror the solver's sources: fails, naming the file, for every source that no test is known to exercise.

Usage: check_tests.py ROOT
physics/src/state/wake.cpp has tests/physics/state/wake_test.cpp. A header without a .cpp counts if it holds a function body.
What has no test of its own name has a line in COVERED_BY: the tests that exercise it, and why they do. A line is a promise that
somebody looked: what a tool counted as executed is not yet proved.
"""

import pathlib
import re
import sys

SOURCES, TESTS = "physics/src", "tests/physics"

# Source, from physics/src: the tests, from tests, that exercise it, and why they do.
COVERED_BY = {
    "collision/broadphase/broad_phase_index.h":
        (["physics/collision/broadphase/broad_phase_test.cpp"], "the face that all three kinds are asked through"),
    "collision/broadphase/fat_box.h":
        (["physics/state/shape_proxy_test.cpp"], "one function: the boxes of a slow and of two fast balls, in numbers"),
    "collision/broadphase/sort_and_sweep.cpp":
        (["physics/collision/broadphase/broad_phase_test.cpp"], "of_every_kind: as a loop over all boxes answers"),
    "collision/broadphase/uniform_grid.cpp":
        (["physics/collision/broadphase/broad_phase_test.cpp"], "of_every_kind: as a loop over all boxes answers"),
    "collision/narrowphase/collide_boxes.cpp":
        (["physics/collision/narrowphase/collide_test.cpp"], "boxes against a search over all directions; four points at rest"),
    "collision/narrowphase/collide_plane.cpp":
        (["physics/collision/narrowphase/collide_test.cpp"], "every convex kind against a plane and a search over all directions"),
    "collision/narrowphase/manifold.h":
        (["physics/collision/narrowphase/collide_test.cpp"], "two lines: pairs are looked at from both sides"),
    "collision/narrowphase/nearest_point.cpp":
        (["physics/world/query_test.cpp"], "closest_point against signed distances of every kind"),
    "collision/narrowphase/sweep_lanes.h":
        (["physics/collision/narrowphase/sweep_surface_test.cpp"],
         "which boxes a sweep may leave out: every kind against a search triangle by triangle"),
    "constraint_graph/wide_rows.h":
        (["physics/constraint_graph/contact_constraint_wide_test.cpp"], "two lines: a vector into a lane and out of it"),
    "constraints/contact_group/group_problem.h":
        (["physics/constraints/contact_group/interior_point_test.cpp"], "the rows of all its problems, with closed forms"),
    "constraints/contact_group/six.h":
        (["physics/constraints/contact_group/skyline_cholesky_test.cpp"], "every operation, in the residuals of chains and rings"),
    "constraints/body_kernel.h":
        (["physics/constraints/kernels_test.cpp"], "one body accelerated and advanced by every instruction set"),
    "constraints/contact_kernel.h":
        (["physics/constraints/kernels_test.cpp", "behaviour/friction_test.cpp", "behaviour/restitution_test.cpp"],
         "a ball that is stopped; friction and bounces as Coulomb and Newton say"),
    "stages/step_scratch.h":
        (["physics/world/stop_stepping_test.cpp"], "a step ends after the sub-step in which it is told to, and leaves a whole world"),
    "world/island_substeps.cpp":
        (["physics/stages/islands/choose_substep_levels_test.cpp", "tools/sim/sim_test.cpp"], "who takes how many sub-steps, with which error"),
    "constraints/direct/ball_tree_energy.cpp":
        (["physics/constraints/direct/ball_tree_test.cpp"], "a loaded chain beside the code for all kinds of joints"),
    "constraints/direct/step_tolerances.h":
        (["physics/constraints/direct/ball_tree_test.cpp", "physics/constraints/direct/direct_group_test.cpp"],
         "gaps and energy of chains, linkages and bridges"),
    "constraints/direct/block_pattern.cpp":
        (["physics/constraints/direct/block_ldl_test.cpp"], "against elimination of the dense matrix; a chain costs in proportion to its links"),
    "constraints/direct/joint_net.h":
        (["physics/constraints/direct/block_ldl_test.cpp"], "the work of a clique against the pattern of the same joints"),
    "constraints/direct/direct_body.h":
        (["physics/math/principal_axes_test.cpp", "physics/constraints/direct/direct_group_test.cpp"],
         "its tensor in any axes; its momenta, kept to rounding"),
    "constraints/direct/direct_bounds.cpp":
        (["physics/constraints/direct/free_axis_test.cpp"], "limits, motors, friction and springs against closed forms"),
    "constraints/direct/direct_kinds.cpp":
        (["physics/constraints/direct/free_axis_test.cpp", "physics/constraints/direct/direct_warm_start_test.cpp"],
         "sliders, a cardan joint, ropes and shoulders move as they should; the rows of each mix of axes"),
    "constraints/direct/direct_pattern.cpp":
        (["physics/constraints/direct/direct_group_test.cpp", "physics/constraints/direct/free_axis_test.cpp"],
         "loops, of balls and hinges; springs in the matrix"),
    "constraints/direct/direct_joint.cpp":
        (["physics/constraints/direct/direct_group_test.cpp", "behaviour/joints_test.cpp"],
         "balls, hinges, motors and limits against closed forms; every kind that it knows"),
    "constraints/direct/direct_system.cpp":
        (["physics/constraints/direct/direct_group_test.cpp"], "loops, motors, limits, ends that are apart"),
    "constraints/direct/energy_guard.cpp":
        (["physics/constraints/direct/direct_group_test.cpp"], "linkages, loaded chains and straight bridges keep their energy"),
    "constraints/direct/energy_step.cpp":
        (["physics/constraints/direct/direct_group_test.cpp"], "a whip of a thousand times the mass is too stiff for any other step"),
    "constraints/direct/rattle_step.cpp":
        (["physics/constraints/direct/direct_group_test.cpp"], "a pendulum comes back in the period of the elliptic integral"),
    "constraints/joints/axes_kernel.h":
        (["behaviour/axis_joints_test.cpp"], "sliders, six-dofs and wheels against closed forms"),
    "constraints/joints/gear_ends.cpp":
        (["behaviour/gear_joints_test.cpp"], "gears, racks and pulleys against closed forms"),
    "constraints/joints/gear_kernel.h":
        (["behaviour/gear_joints_test.cpp"], "gears, racks and pulleys against closed forms"),
    "constraints/joints/joint_lane.h":
        (["behaviour/joints_test.cpp", "behaviour/axis_joints_test.cpp"], "every number of a joint goes through it"),
    "constraints/joints/write_axes.cpp":
        (["behaviour/axis_joints_test.cpp"], "limits, motors, springs and friction of every axis are written there"),
    "constraint_graph/joint_memory.h":
        (["behaviour/axis_joints_test.cpp"], "what joints keep is saved, loaded and goes on"),
    "constraints/joints/batch_kernel.h":
        (["physics/constraints/joints/joint_batches_test.cpp", "behaviour/jointed_contacts_test.cpp"], "a chain in two solves"),
    "constraints/joints/batch_matrix.h":
        (["physics/constraints/joints/joint_batches_test.cpp", "behaviour/jointed_contacts_test.cpp"], "a chain in two solves"),
    "constraints/joints/joint_kernel.h":
        (["behaviour/joints_test.cpp"], "every kind of joint against a closed form"),
    "constraints/joints/joint_kinds.h":
        (["behaviour/joints_test.cpp", "behaviour/velocity_rows_test.cpp"], "every kind of joint against a closed form"),
    "constraints/joints/joint_pair.h":
        (["behaviour/joints_test.cpp"], "every kind of joint against a closed form"),
    "constraints/joints/write_joint.cpp":
        (["behaviour/joints_test.cpp"], "limits, motors, springs and forces of every kind are written there"),
    "constraints/kernel_table.h":
        (["determinism/golden_hashes_test.cpp"], "whole worlds by every instruction set of the machine, bit by bit"),
    "constraints/kernels_avx2.cpp":
        (["determinism/golden_hashes_test.cpp"], "an include and a name: whole worlds where the machine has it"),
    "constraints/kernels_avx512.cpp":
        (["determinism/golden_hashes_test.cpp"], "an include and a name: whole worlds where the machine has it"),
    "constraints/kernels_avx512_two.cpp":
        (["determinism/golden_hashes_test.cpp"], "whole worlds where the machine has it"),
    "constraints/kernels_baseline.cpp":
        (["determinism/golden_hashes_test.cpp"], "an include and a name: whole worlds where the machine has it"),
    "constraints/kernels_scalar.cpp":
        (["determinism/golden_hashes_test.cpp"], "an include and a name: whole worlds on every machine"),
    "constraints/planar_kernel.h":
        (["behaviour/planar_test.cpp"], "discs, beams and pyramids in planar worlds against closed forms"),
    "geometry/def_checks.cpp":
        (["physics/world/checks_test.cpp", "physics/state/validate_test.cpp"], "what calls and saved worlds may not hold"),
    "state/validate_numbers.cpp":
        (["physics/state/validate_test.cpp"], "each kind of number, forged and named"),
    "foundation/threads.h":
        (["physics/foundation/thread_pool_test.cpp", "physics/serialization/module_state_test.cpp"],
         "names for the standard library's own, used by teams and by the register of modules"),
    "foundation/prefetch.h":
        (["physics/stages/contacts/update_contacts_test.cpp"], "a hint to the processor: nothing to see but that all goes on"),
    "geometry/transformed_shape.h":
        (["physics/geometry/bounds_test.cpp"], "one line: shapes in any pose"),
    "serialization/byte_visitors.h":
        (["physics/serialization/save_load_test.cpp", "physics/serialization/hostile_bytes_test.cpp"], "a saver and a loader, and forged bytes"),
    "serialization/derive.cpp":
        (["physics/serialization/save_load_test.cpp"], "a loaded world goes on with the same bits"),
    "serialization/field_list.h":
        (["physics/serialization/save_load_test.cpp", "physics/serialization/state_hash_test.cpp", "physics/serialization/divergence_test.cpp"],
         "its four visitors: save, load, hash and first difference"),
    "serialization/hash_visitor.h":
        (["physics/serialization/state_hash_test.cpp", "physics/serialization/restore_point_test.cpp"], "of a world, and of a kept moment"),
    "serialization/saved_world.h":
        (["physics/serialization/save_load_test.cpp", "physics/serialization/restore_point_test.cpp"], "of a world, and of a kept moment"),
    "serialization/module_visitor.h":
        (["physics/serialization/module_state_test.cpp"], "modules saved, loaded, hashed, compared and restored"),
    "serialization/shared_geometry.cpp":
        (["physics/serialization/save_load_test.cpp", "physics/serialization/hostile_bytes_test.cpp"],
         "worlds of hulls, meshes, fields and compounds; and such bytes forged"),
    "stages/contacts/call_contact_listeners.cpp":
        (["behaviour/listeners_test.cpp"], "one-way platforms, frictions and belts by what a listener answers"),
    "stages/contacts/begin_contacts.cpp":
        (["behaviour/contact_events_test.cpp", "physics/state/validate_test.cpp"],
         "a world's manifolds begin there; the stores agree after each step"),
    "stages/contacts/update_touching.cpp":
        (["physics/stages/contacts/update_contacts_test.cpp", "behaviour/contact_events_test.cpp", "behaviour/sleeping_test.cpp"],
         "how often pairs are looked at; each touch begins and ends once; who is met asleep wakes"),
    "stages/contacts/find_seam_neighbours.cpp":
        (["behaviour/floors_test.cpp"], "bodies that slide over floors of several shapes and bodies feel no bump"),
    "stages/contacts/narrow_phase_pair.cpp":
        (["physics/stages/contacts/update_contacts_test.cpp", "behaviour/friction_test.cpp", "behaviour/rocking_test.cpp"],
         "what passes by, what slides over seams, what rocks"),
    "stages/continuous/ccd_candidates.cpp":
        (["behaviour/continuous_test.cpp", "behaviour/fast_bodies_test.cpp"], "nothing passes through anything"),
    "stages/continuous/solve_continuous.cpp":
        (["behaviour/continuous_test.cpp", "behaviour/fast_bodies_test.cpp"], "nothing passes through anything"),
    "stages/continuous/resolve_toi_impact.cpp":
        (["behaviour/impacts_test.cpp", "behaviour/restitution_test.cpp", "behaviour/listeners_test.cpp"],
         "momentum, energy and spin after an impact; listeners that disable one"),
    "stages/continuous/toi_motion.cpp":
        (["behaviour/restitution_test.cpp", "behaviour/fast_bodies_test.cpp"], "where and how fast falling bodies meet"),
    "stages/continuous/toi_state.cpp":
        (["physics/stages/continuous/toi_policy_test.cpp", "physics/stages/continuous/impact_queue_test.cpp"],
         "their scene adds its TOI bodies by it"),
    "stages/continuous/update_dependents.cpp":
        (["physics/stages/continuous/start_toi_bodies_test.cpp", "behaviour/impacts_test.cpp"],
         "a deflected body hits a third one; rows of balls propagate an impact"),
    "stages/continuous/swept_motions.h":
        (["behaviour/continuous_test.cpp"], "bullets that meet, beads in their order"),
    "stages/finalize/finalize.cpp":
        (["behaviour/stacks_test.cpp", "behaviour/sleeping_test.cpp"], "what rests comes back from the solver to the millimetre"),
    "stages/finalize/integrate_free.cpp":
        (["behaviour/free_motion_test.cpp"], "parabolas; the formula is constraints/free_motion's"),
    "stages/islands/merge_islands.cpp":
        (["behaviour/contact_events_test.cpp", "physics/state/validate_test.cpp"],
         "each touch begins and ends once; the stores agree after each step"),
    "stages/pairs/update_triggers.cpp":
        (["behaviour/triggers_test.cpp"], "who enters, stays and leaves, and when"),
    "stages/publish_events.cpp":
        (["behaviour/contact_events_test.cpp", "behaviour/contact_reports_test.cpp"], "order of events; impulses of what stays"),
    "stages/sleep/put_parts_to_sleep.cpp":
        (["behaviour/partial_sleep_test.cpp"], "who sleeps in place and what wakes it"),
    "stages/sleep/update_sleep.cpp":
        (["behaviour/sleeping_test.cpp"], "what rests falls asleep, what is carried or may not does not"),
    "stages/sleep/wake_bodies.cpp":
        (["behaviour/sleeping_test.cpp", "behaviour/partial_sleep_test.cpp", "behaviour/continuous_test.cpp"],
         "who is disturbed, and who is hit by a bullet; the rules are state/wake's"),
    "stages/solver/contact_groups.cpp":
        (["physics/stages/islands/heavy_load_test.cpp", "behaviour/stacks_test.cpp"], "stacks of any mass ratio that must not move; the limit of the work"),
    "stages/solver/solver_velocities.cpp":
        (["behaviour/listeners_test.cpp", "behaviour/force_fields_test.cpp"], "jointed and floating bodies in the middle of the solve"),
    "stages/solver/solve_constraints.cpp":
        (["behaviour/stacks_test.cpp", "behaviour/friction_test.cpp", "behaviour/kinematic_test.cpp",
          "physics/stages/islands/assign_batches_test.cpp"],
         "stacks, slopes and lifts; batches side by side"),
    "stages/solver/gather_bodies.cpp":
        (["physics/world/profile_test.cpp", "physics/stages/islands/assign_batches_test.cpp"], "how many bodies the solver takes, by tier"),
    "stages/solver/integrate_gyroscopic.cpp":
        (["behaviour/free_motion_test.cpp", "behaviour/joints_test.cpp"], "tops and rods that rotate far in a step"),
    "stages/solver/schedule_tasks.cpp":
        (["physics/stages/islands/assign_batches_test.cpp", "determinism/threads_test.cpp"],
         "batches side by side; the same bits with 1, 2 and 4 threads"),
    "stages/solver/solve_task.cpp":
        (["behaviour/stacks_test.cpp", "behaviour/jointed_contacts_test.cpp"], "the order of the passes of a sub-step"),
    "stages/solver/solve_joint_batches.cpp":
        (["behaviour/jointed_contacts_test.cpp"], "its passes are those of any step in which jointed bodies touch"),
    "stages/solver/solve_joints.cpp":
        (["behaviour/joints_test.cpp"], "every kind of joint; the order is constraint_graph/joint_levels'"),
    "stages/solver/apply_joint_impacts.cpp":
        (["behaviour/impacts_test.cpp"], "a cradle on threads at three rates: the last ball swings out, the others hang still"),
    "stages/solver/solver_scratch.h":
        (["physics/stages/islands/assign_batches_test.cpp"], "one line: the bodies of a task's colour sets"),
    "stages/step_world.cpp":
        (["physics/world/profile_test.cpp", "physics/world/world_test.cpp"], "each stage ran or says why not; steps are counted"),
    "state/contact_modifiers.cpp":
        (["behaviour/listeners_test.cpp"], "answers are kept as long as a manifold and forgotten with it"),
    "state/contact_store.h":
        (["physics/state/contact_graph_test.cpp"], "its lists and keys are walked there"),
    "state/force_fields.cpp":
        (["behaviour/force_fields_test.cpp"], "each kind against a closed form"),
    "state/impulse_scale.cpp":
        (["behaviour/stacks_test.cpp"], "a stack awake and one asleep keep still when steps change their length"),
    "state/joint_store.h":
        (["physics/state/joint_graph_test.cpp"], "its lists are walked there"),
    "state/listener_store.h":
        (["physics/world/listeners_test.cpp", "physics/serialization/module_state_test.cpp"],
         "added, removed, in their order before and after a load"),
    "state/shape_store.h":
        (["physics/state/shape_proxy_test.cpp"], "two lines: planes, and a shape where its body takes it"),
    "state/world_access.h":
        (["physics/state/wake_test.cpp"], "tests reach a world's stores by nothing else"),
    "state/world_state.h":
        (["physics/state/wake_test.cpp"], "the mass that a momentum wakes"),
    "state/world_stores.h":
        (["physics/state/body_sets_test.cpp"], "a body's record is found in whichever set it is"),
    "world/body_change.cpp":
        (["physics/world/body_motion_test.cpp", "physics/world/body_settings_test.cpp"], "every call that pushes or changes a body"),
    "world/contact_view.cpp":
        (["physics/world/inspect_test.cpp"], "contacts awake and asleep, with their points"),
}

COMMENT_OR_STRING = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\])*"', re.S)
# ") {", ") const {", ") noexcept : member(0) {": where a function's body begins.
BODY = re.compile(r"\)\s*(?:const\s*)?(?:noexcept\s*)?(?:->\s*[^;{}()]+)?(?::[^;{}]*)?\{")


def holds_logic(header):
    return BODY.search(COMMENT_OR_STRING.sub("", header.read_text(encoding="utf-8"))) is not None


def sources(root):
    """Every .cpp, and every header with a function body that has no .cpp."""
    found = sorted((root / SOURCES).rglob("*.cpp"))
    for header in sorted((root / SOURCES).rglob("*.h")):
        if not header.with_suffix(".cpp").exists() and holds_logic(header):
            found.append(header)
    return [str(path.relative_to(root)) for path in found]


def mirror_of(source):
    """physics/src/state/wake.cpp -> tests/physics/state/wake_test.cpp"""
    return TESTS + source.removeprefix(SOURCES).rsplit(".", 1)[0] + "_test.cpp"


def faults(root):
    found, all_sources = [], sources(root)
    mirrored = {source for source in all_sources if (root / mirror_of(source)).exists()}
    for source in all_sources:
        if source not in mirrored and source.removeprefix(f"{SOURCES}/") not in COVERED_BY:
            found.append(f"{source}: no test. Write {mirror_of(source)}, or say in check_tests.py which test exercises it and why")
    named = set()
    for name, (tests, _) in COVERED_BY.items():
        source, tests = f"{SOURCES}/{name}", [f"tests/{test}" for test in tests]
        named.update(tests)
        if source in mirrored:
            found.append(f"check_tests.py: {source} has a test of its own now; take its line off COVERED_BY")
        elif source not in all_sources:
            found.append(f"check_tests.py: {source} is gone, or holds no function any more; take its line off COVERED_BY")
        for test in tests:
            if not (root / test).exists():
                found.append(f"check_tests.py: {source} is said to be exercised by {test}, which does not exist")
    lists = "".join(path.read_text(encoding="utf-8") for path in sorted((root / TESTS).rglob("CMakeLists.txt")))
    mirrors = {mirror_of(source) for source in all_sources}
    for path in sorted((root / TESTS).rglob("*_test.cpp")):
        test = str(path.relative_to(root))
        if re.search(rf"\b{re.escape(path.name)}\b", lists) is None:
            found.append(f"{test}: is in no CMakeLists.txt, so nobody runs it")
        if test not in mirrors and test not in named:
            found.append(f"{test}: mirrors no source. Give it the name of what it exercises, or name it in COVERED_BY")
    return found, len(all_sources), len(mirrored)


def main():
    found, count, mirrored = faults(pathlib.Path(sys.argv[1]))
    for fault in found:
        print(fault)
    print(f"tests: {count} sources, {mirrored} with a test of their name, {len(COVERED_BY)} exercised by others, {len(found)} faults")
    return 1 if found or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
