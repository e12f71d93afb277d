// SPDX-License-Identifier: MIT
//
// jostle-sim --converge: runs a scene at many rates and numbers of sub-steps until two runs agree.
// The finest run is the reference; every setting gets an error and a cost.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "jostle/scenes/scene.h"
#include "tools/sim/trajectory.h"

namespace jostle::sim {

struct ConvergenceOptions {
    double seconds = 10;
    // Ascending; each is a multiple of the first. Empty: from half the scene's rate, doubled until
    // two runs agree, up to finest_hz.
    std::vector<double> rates;
    double finest_hz = 1920;
    std::vector<int> substeps;  // empty: a quarter, half, all and twice the scene's number
    std::vector<double> tolerances = {0.01};  // of the error defined below, descending
    double scale = 0;             // m; 0: the diagonal of the box in which the bodies move
    double budget_seconds = 120;  // of CPU time for all runs
};

// The error of a run is the larger of the RMS distance of the bodies' centres divided by the scale
// and the RMS angle in radians.
struct ConvergenceRow {
    StepSettings setting;
    double error = 0;      // over all samples, against the finest run; at least the reference error
    double end_error = 0;  // at the last sample
    double distance = 0;   // m, over all samples
    double angle = 0;      // rad, likewise
    double agreement_seconds = 0;  // time until the error exceeds the largest tolerance
    std::optional<double> order;   // from the next lower rate with the same sub-steps to this one
    // A lower rate with the same sub-steps whose error is less than 3/4 of this one, Hz: the one
    // with the least error.
    std::optional<double> worse_than_hz;
    double cpu_us_per_second = 0;  // of the thread, per simulated second
    std::string failure;           // why the run failed; empty: it did not
};

enum class Verdict {
    converged,      // the two finest runs are within the smallest tolerance
    not_converged,  // they are not, but the error decreases with the rate
    chaotic,        // they are not, and perturbed runs diverge as much
};

struct Convergence {
    std::string scene;
    double seconds = 0, scale = 0;
    int bodies = 0;
    std::vector<double> tolerances;
    Verdict verdict = Verdict::converged;
    StepSettings finest;                    // setting of the reference run
    double reference_error = 0;             // difference of the two finest runs
    double agreement_seconds = 0;           // of the two finest runs, within the largest tolerance
    std::optional<double> reference_order;  // order of the last refinement
    double perturbation = 0;                // m/s added to the initial velocities of a run
    double perturbation_error = 0;          // resulting error at the end
    double growth = 0;                      // ratio of that error to the unamplified displacement
    std::string skipped_runs;               // runs skipped because of the budget; empty: none
    std::vector<ConvergenceRow> rows;       // sorted by sub-steps, then rate

    // The cheapest row whose error is at most the tolerance. Of rows that tie, which means that
    // their times are within 15 %, or their rates and errors are equal, the one with the fewest
    // sub-steps. Nothing if the two finest runs differ by more, because errors are then unknown.
    std::optional<ConvergenceRow> cheapest(double tolerance) const;
};

// Sets worse_than_hz of the rows that a lower rate with the same sub-steps beats by more than a
// third.
void mark_worse(std::vector<ConvergenceRow>& rows);

// Receives the name of the next run, for a progress line.
using ProgressCallback = std::function<void(const std::string&)>;

// Runs the analysis. Invalid options or scenes are reported before any run.
physics::Result<Convergence> converge(const scenes::SceneDescription& scene,
                                      const ConvergenceOptions& options,
                                      const ProgressCallback& on_progress);

}  // namespace jostle::sim
