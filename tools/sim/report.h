// SPDX-License-Identifier: MIT
//
// Cost and final state of a run.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "jostle/physics/physics.h"
#include "tools/sim/converge.h"
#include "tools/sim/inspect.h"
#include "tools/sim/tolerance_check.h"

namespace jostle::sim {

struct Report {
    std::string scene;
    int threads = 1, substeps = 0;
    double hz = 0;
    std::uint64_t steps = 0;
    int bodies = 0, contacts = 0, awake_bodies = 0;
    double ms_per_step_mean = 0, ms_per_step_p99 = 0;  // wall clock
    // The longest step except the first one, which starts without caches: its number in this run,
    // and its longest stage. 0: there was only one step.
    std::uint64_t worst_step = 0;
    double worst_step_ms = 0, worst_stage_ms = 0;
    physics::Stage worst_stage = physics::Stage::update_pairs;
    double work_mean = 0, work_worst = 0;  // StepProfile::work; work_worst excludes the first step
    std::array<std::uint64_t, physics::max_overload_level + 1> steps_at_overload_level{};
    double cpu_ms_per_step_mean = 0;  // of all threads of the process
    std::uint64_t state_hash = 0;
    double energy_joules = 0;      // kinetic + potential, zero at the origin
    double max_penetration_m = 0;  // at the end
    std::array<double, physics::stage_count> stage_ms_mean{};
    std::optional<ToleranceVerdict> tolerance;  // of a world with an error tolerance
    // Why a stage was skipped in the last step, if it was skipped in every step; otherwise null.
    std::array<const char*, physics::stage_count> stage_skipped{};
};

// Accumulates step profiles.
class StepStatistics {
public:
    // `step_ms`: wall clock of the step with the work of modules before it, which the profile does
    // not contain.
    void add(const physics::StepProfile& profile, double step_ms);
    void fill(Report& report, const physics::World& world) const;

private:
    std::vector<double> step_ms_;
    physics::StepProfile worst_;  // of all steps except the first
    double worst_step_ms_ = 0;
    std::uint64_t worst_step_ = 0;
    double work_ = 0, worst_work_ = 0;
    std::array<std::uint64_t, physics::max_overload_level + 1> steps_at_overload_level_{};
    std::array<double, physics::stage_count> stage_ms_{};
    std::array<bool, physics::stage_count> stage_ran_{};
    std::array<const char*, physics::stage_count> stage_skipped_{};
};

std::string to_text(const Report& report);
std::string to_json(const Report& report);

// Formats the result of jostle-sim --converge: a table with a verdict, or JSON.
std::string to_text(const Convergence& found);
std::string to_json(const Convergence& found);

// Formats the result of jostle-sim --inspect: tables, JSON or CSV.

std::string to_text(const Inspection& found);
std::string to_json(const Inspection& found);

// The residual of the iterative methods after each iteration, one row each. Columns: scene, step
// (of the world), group (index), method, converged (1 or 0, of the method), iteration (from 1),
// residual (relative to b).
std::string residuals_csv(const Inspection& found);

// Sub-steps of the islands and their estimated errors.

// One line per number of sub-steps, then the islands with the largest errors. Reports if there are
// no islands.
std::string to_text(const std::vector<physics::IslandSubsteps>& island_substeps);
std::string to_json(const std::vector<physics::IslandSubsteps>& island_substeps);

}  // namespace jostle::sim
