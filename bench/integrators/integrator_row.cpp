// SPDX-License-Identifier: MIT
#include "bench/integrators/integrator_row.h"

#include <algorithm>
#include <cmath>

#include "bench/measure.h"
#include "bench/result_file.h"
#include "jostle/analysis/work_error.h"

namespace jostle::bench::integrators {
namespace {

constexpr double distance_max = 1e6;       // m
constexpr double run_seconds_min = 0.002;  // s of CPU time: a run is repeated until then

long steps_of(const ParticleField& field, double rate_hz) {
    return std::lround(field.seconds * rate_hz);
}

double time_of_steps(const ParticleField& field, const IntegratorKind& kind, double rate_hz) {
    const long steps = steps_of(field, rate_hz);
    const double began = cpu_seconds();
    long done = 0;
    while (done == 0 || cpu_seconds() - began < run_seconds_min) {
        const auto integrator = kind.make(field);
        ParticleState state = field.start;
        for (long k = 0; k < steps; k++)
            integrator->step(state, static_cast<double>(k) / rate_hz, 1 / rate_hz);
        done += steps;
    }
    return (cpu_seconds() - began) / static_cast<double>(done);
}

IntegratorRow row_of(const ParticleField& field, const IntegratorKind& kind, double rate_hz) {
    IntegratorRow row{.field = field.name, .method = kind.name, .rate_hz = rate_hz};
    const auto integrator = kind.make(field);
    const double energy = field.energy ? field.energy(field.start) : 0;
    ParticleState state = field.start;
    analysis::Rms error;
    double drift = 0;
    for (long k = 0; k < steps_of(field, rate_hz); k++) {
        integrator->step(state, static_cast<double>(k) / rate_hz, 1 / rate_hz);
        error.add(
            length_squared(state.position - field.truth(static_cast<double>(k + 1) / rate_hz)));
        if (field.energy) drift = std::max(drift, std::abs(field.energy(state) / energy - 1));
        if (!(length(state.position) < distance_max)) break;
    }
    row.error = error.value();
    if (field.energy) row.energy_drift = drift;
    row.ns_per_step = 1e9 * time_of_steps(field, kind, rate_hz);
    return row;
}

}  // namespace

std::vector<IntegratorRow> integrator_rows(const ParticleField& field, const IntegratorKind& kind,
                                           const std::vector<double>& rates) {
    std::vector<IntegratorRow> rows;
    for (const double rate : rates) {
        IntegratorRow row = row_of(field, kind, rate);
        if (!rows.empty())
            row.order =
                analysis::observed_order(rows.back().error, row.error, rate / rows.back().rate_hz);
        rows.push_back(std::move(row));
    }
    return rows;
}

nlohmann::ordered_json to_json(const IntegratorRow& row) {
    nlohmann::ordered_json json = {{"field", row.field},
                                   {"method", row.method},
                                   {"rate_hz", row.rate_hz},
                                   {"error_m", rounded(row.error)}};
    if (row.order) json["order"] = rounded(*row.order);
    if (row.energy_drift) json["energy_drift"] = rounded(*row.energy_drift);
    json["ns_per_step"] = rounded(row.ns_per_step);
    return json;
}

}  // namespace jostle::bench::integrators
