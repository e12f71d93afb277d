// SPDX-License-Identifier: MIT
//
// One integrator in one field at one rate.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/integrators/integrator_kinds.h"

namespace jostle::bench::integrators {

struct IntegratorRow {
    std::string field, method;
    double rate_hz = 0;
    double error = 0;                    // m: RMS distance from the exact solution over all steps
    std::optional<double> order;         // from the previous rate to this one
    std::optional<double> energy_drift;  // largest drift relative to the initial energy
    double ns_per_step = 0;              // CPU time
};

// Rates must ascend. A run ends when the particle is farther than 1e6 m from the origin; the error
// covers the steps until then.
std::vector<IntegratorRow> integrator_rows(const ParticleField& field, const IntegratorKind& kind,
                                           const std::vector<double>& rates);

nlohmann::ordered_json to_json(const IntegratorRow& row);

}  // namespace jostle::bench::integrators
