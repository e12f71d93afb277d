// SPDX-License-Identifier: MIT
//
// jostle-sim --converge: a user's own scene at many rates and sub-steps, until two runs agree. What
// agrees is taken for the truth, and every setting gets an error and a cost.
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
    // Ascending; each a multiple of the first. Empty: from half the scene's rate on, doubled until
    // two runs agree, up to finest_hz.
    std::vector<double> rates;
    double finest_hz = 1920;
    std::vector<int> substeps;                // empty: a quarter, half, all and twice the scene's
    std::vector<double> tolerances = {0.01};  // of errors as below; the last is the smallest
    double scale = 0;                         // m; 0: diagonal of the box in which the bodies move
    double budget_seconds = 120;              // of processor time for all runs
};

// Errors are the larger of two numbers: RMS distance of the bodies' centres over the scale, and RMS
// angle in radians.
struct ConvergenceRow {
    StepSettings setting;
    double error = 0;  // over all samples, against the finest run; the doubt, where that is more
    double end_error = 0;          // at the last sample
    double distance = 0;           // m, over all samples
    double angle = 0;              // rad, likewise
    double agreement_seconds = 0;  // s: from then on it is further away than the largest tolerance
    std::optional<double> order;   // from the next lower rate with as many sub-steps to this one
    double cpu_us_per_second = 0;  // of the thread, per simulated second
    std::string failure;           // why the run is worth nothing; empty: it is not
};

enum class Verdict {
    converged,      // the two finest runs are within the smallest tolerance
    not_converged,  // they are not, but come closer with the rate
    chaotic,        // they are not, and starts that hardly differ part just as far
};

struct Convergence {
    std::string scene;
    double seconds = 0, scale = 0;
    int bodies = 0;
    std::vector<double> tolerances;
    Verdict verdict = Verdict::converged;
    StepSettings finest;  // against whose run all errors are
    double reference_error =
        0;  // error of the run at the next lower rate: how well the truth is known
    double agreement_seconds = 0;           // s: the two finest runs, within the largest tolerance
    std::optional<double> reference_order;  // of the last refinement: how fast the doubt falls
    double perturbation = 0;                // m/s by which a twin run starts faster
    double perturbation_error = 0;          // and how far that takes it by the end
    double growth = 0;                      // of the nudge's own way until then
    std::string skipped_runs;               // which runs the budget left out; empty: none
    std::vector<ConvergenceRow> rows;       // by sub-steps, then rate

    // The cheapest row whose error is at most the tolerance. None either where the finest runs
    // differ by more: then nobody knows.
    std::optional<ConvergenceRow> cheapest(double tolerance) const;
};

// Says which run is next, for a progress line.
using ProgressCallback = std::function<void(const std::string&)>;

// What is wrong with the question, or with the scene, is said before anything runs.
physics::Result<Convergence> converge(const scenes::SceneDescription& scene,
                                      const ConvergenceOptions& options,
                                      const ProgressCallback& on_progress);

}  // namespace jostle::sim
