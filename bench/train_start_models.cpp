// SPDX-License-Identifier: MIT
//
// train-start-models FOLDER: computes the initial models of codec 2 from statistics over scenes of
// the catalogue. It generated proto/snapshot/src/start_models.cpp and
// clients/web/src/start_models.ts, which are part of the format: running it again, over scenes that
// have changed since, produces a different codec.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <fstream>

#include "bench/captured_scene.h"
#include "jostle/snapshot/range_frame_serializer.h"

namespace jostle::bench {
namespace {

using snapshot::Baselines;
using snapshot::BitModel;
using snapshot::FrameModels;

// Without katamari: the scene for comparing codecs should not be part of the training data.
constexpr const char* scenes[] = {"pile",       "sandbox",   "ragdolls", "bench_player_901",
                                  "demolition", "race_track"};
constexpr int ages[2][2] = {{1, 2}, {6, 3}};  // ticks to the base, for each table
constexpr double seconds = 15;

using Counts = std::vector<std::array<double, 2>>;  // numbers of zeros and ones, for each model

// Replaces an encoder and counts bits.
struct Counter {
    static constexpr bool encoding = true;

    bool bit(BitModel& model, bool value) {
        counts[static_cast<std::size_t>(&model - snapshot::all_of(models).data())][value ? 1 : 0]++;
        return value;
    }
    std::uint64_t raw(std::uint64_t value, unsigned) { return value; }

    FrameModels& models;
    Counts& counts;
};

void count(Counts& counts, const snapshot::QuantizedFrame& frame, const Baselines& baselines) {
    FrameModels models;
    Counter counter{.models = models, .counts = counts};
    const snapshot::QuantSpec spec;
    const snapshot::EntityDiff to = snapshot::entity_diff(frame, baselines);
    snapshot::EntityChanges lists = snapshot::entity_changes_of(to);
    snapshot::RangeFrameSerializer walk(counter, models, spec);
    walk.entities(lists, baselines, frame.entities.size());
    std::vector<snapshot::EntityState> none;
    walk.survivors(to.surviving, none, to.survivors, snapshot::spacing_of(frame.frame, baselines));
}

// No entities appear or disappear in these scenes; this function removes one body in twenty,
// alternating every half second.
snapshot::QuantizedFrame with_absences(const snapshot::QuantizedFrame& frame) {
    snapshot::QuantizedFrame some{.frame = frame.frame, .entities = {}};
    for (const snapshot::EntityState& entity : frame.entities)
        if ((frame.frame / 30 + 7 * entity.id) % 20 != 0) some.entities.push_back(entity);
    return some;
}

void count(Counts& counts, const std::vector<snapshot::QuantizedFrame>& frames, std::size_t age) {
    Counts comings(counts.size()), stays(counts.size());
    count(comings, frames[0], {});
    for (std::size_t i = 3 * age; i < frames.size(); i++) {
        count(stays, frames[i], {&frames[i - age], &frames[i - 2 * age], &frames[i - 3 * age]});
        const snapshot::QuantizedFrame now = with_absences(frames[i]),
                                       base = with_absences(frames[i - age]);
        count(comings, now, {&base, nullptr, nullptr});
    }
    const std::size_t sections = offsetof(FrameModels, none_wake) / sizeof(BitModel);
    for (std::size_t i = 0; i < counts.size(); i++)
        for (std::size_t bit = 0; bit < 2; bit++)
            counts[i][bit] += (i < sections ? comings : stays)[i][bit];
}

// One character per model (start_models.h).
std::string letters(const Counts& counts) {
    static constexpr char alphabet[] =
        "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%&()*+,-./:;<=>";
    std::string text;
    for (const auto& [zeros, ones] : counts) {
        const double odds = std::log((ones + 0.4) / (zeros + 0.4));
        const long level = std::clamp(std::lround(odds / 0.4 + 19.5), 0l, 39l);
        text += alphabet[2 * level + (zeros + ones < 4 ? 0 : 1)];
    }
    return text;
}

void write(const std::string& path, const std::string (&tables)[2], const char* head,
           const char* row, const char* between, const char* tail) {
    std::ofstream out(path);
    out << head;
    for (const std::string& table : tables) {
        for (std::size_t at = 0; at < table.size(); at += 80) {
            char line[160];
            std::snprintf(line, sizeof line, row, table.substr(at, 80).c_str());
            out << line;
        }
        if (&table == &tables[0]) out << between;
    }
    out << tail;
}

}  // namespace

int train(const std::string& folder) {
    Counts counts[2];
    for (Counts& table : counts) table.resize(snapshot::frame_model_count);
    for (const char* scene : scenes) {
        const auto recorded = capture_scene(scene, seconds, {});
        if (!recorded.ok()) {
            std::fprintf(stderr, "train-start-models: %s\n", recorded.error().message.c_str());
            return 1;
        }
        for (std::size_t table = 0; table < 2; table++)
            for (const int age : ages[table])
                count(counts[table], recorded->frames, static_cast<std::size_t>(age));
    }
    const std::string tables[2] = {letters(counts[0]), letters(counts[1])};
    write(
        folder + "/start_models.cpp", tables,
        "// SPDX-License-Identifier: MIT\n//\n// Written by bench/train_start_models.cpp; part of "
        "the format.\n#include \"jostle/snapshot/start_models.h\"\n\nnamespace jostle::snapshot "
        "{\n\nconst "
        "std::string_view start_model_letters[2] = {\n",
        "    \"%s\"\n", "    ,\n", "};\n\n}  // namespace jostle::snapshot\n");
    write(folder + "/start_models.ts", tables,
          "// Written by bench/train_start_models.cpp; part of the format (proto/WIRE.md, "
          "\"Initial models\").\n\nexport const INITIAL_MODELS = [\n  [\n",
          "    '%s',\n", "  ].join(''),\n  [\n", "  ].join(''),\n] as const;\n");
    return 0;
}

}  // namespace jostle::bench

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: train-start-models FOLDER\n");
        return 2;
    }
    return jostle::bench::train(argv[1]);
}
