// SPDX-License-Identifier: MIT
#include "bench/speed/growth.h"

#include <algorithm>
#include <cmath>

#include "bench/measure.h"
#include "bench/processes/program.h"
#include "bench/result_file.h"
#include "bench/speed/field_json.h"
#include "jostle/scenes/bench_scenes.h"

namespace jostle::bench {
namespace {

// The list of fields, for reading and writing.
template <class Row, class Field>
void visit_fields(Row& row, Field&& field) {
    field("scene", row.scene);
    field("engine", row.engine);
    field("threads", row.threads);
    field("bodies", row.bodies);
    field("failed", row.failed);
    field("ms_mean", row.ms_mean);
    field("clock", row.clock);
    field("bytes_per_body", row.bytes_per_body);
}

double step_many(Engine& engine, const StepClock& clock, int steps, const std::string& label) {
    double seconds = 0;
    for (int k = 0; k < steps; k++) {
        if (k % 10 == 0) show_progress(label + std::to_string(k));
        const double began = clock.seconds();
        engine.step();
        seconds += clock.seconds() - began;
    }
    return 1e3 * seconds / steps;
}

// The first link is fixed.
scenes::SceneDescription chain_of(int bodies) {
    return scenes::bench_chain(bodies + 1);
}

constexpr GrowthScene growing[] = {{"pile", scenes::bench_pile}, {"chain", chain_of}};

GrowthRow measure_growth(GrowthRow row, const GrowthScene& growth_scene, const EngineKind& kind) {
    scenes::SceneDescription scene = growth_scene.make(row.bodies);
    scene.world.threads = row.threads;
    scene.world.sleeping = false;
    const double before = memory_bytes();
    const auto engine = kind.make();
    if (auto status = engine->init(scene); !status) {
        row.failed = status.error().message;
        return row;
    }
    const StepClock clock{row.threads};
    const std::string label = row.scene + " of " + std::to_string(row.bodies) + " bodies, " +
                              row.engine + ", threads " + std::to_string(row.threads);
    step_many(*engine, clock, growth_steps_before, label + ": settling, step ");
    row.ms_mean = rounded(step_many(*engine, clock, growth_steps_timed, label + ": timing, step "));
    row.clock = clock.name();
    row.bytes_per_body = rounded((peak_memory_bytes() - before) / row.bodies);
    return row;
}

// The slope of the line of least squares through the points.
std::optional<double> slope(const std::vector<double>& x, const std::vector<double>& y) {
    double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
    for (std::size_t k = 0; k < x.size(); k++) {
        mean_x += x[k] / static_cast<double>(x.size());
        mean_y += y[k] / static_cast<double>(x.size());
    }
    for (std::size_t k = 0; k < x.size(); k++) {
        xx += (x[k] - mean_x) * (x[k] - mean_x);
        xy += (x[k] - mean_x) * (y[k] - mean_y);
    }
    const bool has_two = std::ranges::any_of(x, [&](double value) { return value != x[0]; });
    return has_two ? std::optional(xy / xx) : std::nullopt;
}

std::optional<double> exponent_of(std::span<const GrowthRow> rows, const GrowthFit& fit) {
    std::vector<double> log_bodies, log_ms;
    for (const GrowthRow& row : rows) {
        if (row.failed || row.ms_mean <= 0) continue;
        if (row.engine != fit.engine || row.threads != fit.threads) continue;
        log_bodies.push_back(std::log(row.bodies));
        log_ms.push_back(std::log(row.ms_mean));
    }
    return slope(log_bodies, log_ms);
}

}  // namespace

std::span<const GrowthScene> growth_scenes() {
    return growing;
}

const GrowthScene* find_growth_scene(std::string_view name) {
    for (const GrowthScene& scene : growing)
        if (name == scene.name) return &scene;
    return nullptr;
}

nlohmann::ordered_json to_json(const GrowthRow& row) {
    nlohmann::ordered_json json;
    visit_fields(row, FieldWriter{json});
    return json;
}

GrowthRow growth_row_from(const nlohmann::ordered_json& json) {
    GrowthRow row;
    visit_fields(row, FieldReader{json});
    return row;
}

GrowthRow measure_growth_in_child(const GrowthScene& scene, const EngineKind& engine, int threads,
                                  int bodies) {
    GrowthRow row{.scene = scene.name, .engine = engine.name, .threads = threads, .bodies = bodies};
    const ChildResult answer =
        run_in_child([&] { return to_json(measure_growth(row, scene, engine)).dump(); });
    show_progress("");
    if (answer.failure.empty()) return growth_row_from(nlohmann::ordered_json::parse(answer.text));
    row.failed = answer.failure;
    return row;
}

std::vector<GrowthFit> fit_growth(std::span<const GrowthRow> rows) {
    std::vector<GrowthFit> fits;
    for (const GrowthRow& row : rows)
        if (std::ranges::none_of(fits, [&](const GrowthFit& fit) {
                return fit.engine == row.engine && fit.threads == row.threads;
            }))
            fits.push_back({.engine = row.engine, .threads = row.threads, .exponent = {}});
    for (GrowthFit& fit : fits) fit.exponent = exponent_of(rows, fit);
    return fits;
}

nlohmann::ordered_json to_json(const GrowthFit& fit) {
    nlohmann::ordered_json json{{"engine", fit.engine}, {"threads", fit.threads}};
    FieldWriter{json}("exponent",
                      fit.exponent ? std::optional(rounded(*fit.exponent)) : std::nullopt);
    return json;
}

}  // namespace jostle::bench
