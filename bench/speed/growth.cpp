// SPDX-License-Identifier: MIT
#include "bench/speed/growth.h"

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

GrowthRow measure_growth(GrowthRow row, const EngineKind& kind) {
    scenes::SceneDescription scene = scenes::bench_pile(row.bodies);
    scene.world.threads = row.threads;
    scene.world.sleeping = false;
    const double before = memory_bytes();
    const auto engine = kind.make();
    if (auto status = engine->init(scene); !status) {
        row.failed = status.error().message;
        return row;
    }
    const StepClock clock{row.threads};
    const std::string label = std::to_string(row.bodies) + " bodies, " + row.engine + ", threads " +
                              std::to_string(row.threads);
    step_many(*engine, clock, growth_steps_before, label + ": settling, step ");
    row.ms_mean = rounded(step_many(*engine, clock, growth_steps_timed, label + ": timing, step "));
    row.clock = clock.name();
    row.bytes_per_body = rounded((peak_memory_bytes() - before) / row.bodies);
    return row;
}

}  // namespace

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

GrowthRow measure_growth_in_child(const EngineKind& engine, int threads, int bodies) {
    GrowthRow row{.engine = engine.name, .threads = threads, .bodies = bodies};
    const ChildResult answer =
        run_in_child([&] { return to_json(measure_growth(row, engine)).dump(); });
    show_progress("");
    if (answer.failure.empty()) return growth_row_from(nlohmann::ordered_json::parse(answer.text));
    row.failed = answer.failure;
    return row;
}

}  // namespace jostle::bench
