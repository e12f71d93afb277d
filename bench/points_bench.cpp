// SPDX-License-Identifier: MIT
//
// points-bench: measures the codec of point objects on the motions of point_motion.h: bits per
// point and bandwidth, for each number of levels.
//
// points-bench --train FOLDER: computes the initial models of that codec from the same motions, at
// other steps and rates. It generated proto/snapshot/src/start_point_models.cpp and
// clients/web/sdk/src/snapshot/start_point_models.ts, which are part of the format: running it
// again after a change produces a different codec.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <deque>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "bench/point_motion.h"
#include "jostle/snapshot/point_serializer.h"

namespace jostle::bench {
namespace {

using namespace snapshot;

using Objects = std::vector<std::unique_ptr<MovingPoints>>;

Objects all_objects() {
    Objects objects;
    objects.push_back(std::make_unique<Flag>());
    objects.push_back(std::make_unique<Rope>());
    objects.push_back(std::make_unique<Fountain>());
    objects.push_back(std::make_unique<Smoke>());
    return objects;
}

double thread_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// The states of a moving object, each linked to the one before it.
class StateHistory {
public:
    const PointState& add(const MovingPoints& object, const PointOrder& order, std::size_t levels) {
        PointState state{.number = ++number_, .values = object.quantized(), .previous = {}};
        coarse_points(object.layout, order, state.values, levels);
        if (object.layout.form == PointForm::loose) state.previous = links(object.ids);
        ids_ = object.ids;
        states_.push_front(std::move(state));
        if (states_.size() > 4) states_.pop_back();
        return states_.front();
    }
    PointBaselines baselines() const {
        const auto at = [&](std::size_t k) { return k < states_.size() ? &states_[k] : nullptr; };
        return {at(1), at(2), at(3)};
    }

private:
    std::vector<std::uint32_t> links(const std::vector<std::uint32_t>& ids) const {
        std::vector<std::uint32_t> made;
        for (const std::uint32_t id : ids) {
            const auto at = std::ranges::lower_bound(ids_, id);
            const bool known = at != ids_.end() && *at == id;
            made.push_back(known ? static_cast<std::uint32_t>(at - ids_.begin()) : no_point);
        }
        return made;
    }

    std::uint32_t number_ = 0;
    std::vector<std::uint32_t> ids_;
    std::deque<PointState> states_;
};

constexpr int ticks = 900, warm_up_ticks = 240;

void measure(MovingPoints& object, std::size_t levels) {
    const PointOrder order =
        object.layout.form == PointForm::loose ? PointOrder() : PointOrder(object.layout);
    StateHistory history;
    double bytes = 0, points = 0, key_bytes = 0, states = 0, encode_s = 0, decode_s = 0;
    for (int tick = 0; tick < ticks; tick++) {
        object.advance();
        if (tick % object.divisor != 0) continue;
        const PointState& state = history.add(object, order, levels);
        const double begun = thread_seconds();
        const PackedPoints packed =
            encode_points(object.layout, order, state, history.baselines(), levels);
        const double encoded = thread_seconds();
        const auto decoded =
            read_points(object.layout, order, state.number, packed.bytes, history.baselines());
        const double ended = thread_seconds();
        if (!decoded.ok()) {
            std::fprintf(stderr, "points-bench: %s\n", decoded.error().message.c_str());
            return;
        }
        if (tick < warm_up_ticks) continue;
        encode_s += encoded - begun;
        decode_s += ended - encoded;
        bytes += static_cast<double>(packed.bytes.size());
        points += static_cast<double>(object.positions.size());
        states++;
        PointState alone{state.number, state.values, {}};
        if (object.layout.form == PointForm::loose)
            alone.previous.assign(object.ids.size(), no_point);
        key_bytes += static_cast<double>(
            encode_points(object.layout, order, alone, {}, levels).bytes.size());
    }
    std::printf("%-9s %7.0f %7.3g %5.0f %6zu %10.2f %10.2f %8.1f %7.0f %7.0f\n",
                object.name.c_str(), points / states, 1000 * object.step_m, 60.0 / object.divisor,
                levels, 8 * bytes / points, 8 * key_bytes / points,
                8 * bytes / states * 60 / object.divisor / 1000, 1e9 * encode_s / points,
                1e9 * decode_s / points);
}

int measure_all() {
    std::printf("%-9s %7s %7s %5s %6s %10s %10s %8s %7s %7s\n", "object", "points", "step/mm", "Hz",
                "levels", "bits/point", "keyframe", "kbit/s", "enc/ns", "dec/ns");
    for (std::size_t k = 0; k < all_objects().size(); k++)
        for (std::size_t levels = point_levels; levels >= 1; levels--) {
            const Objects objects = all_objects();
            if (levels == point_levels || objects[k]->layout.form != PointForm::loose)
                measure(*objects[k], levels);
        }
    return 0;
}

using Counts = std::vector<std::array<double, 2>>;  // numbers of zeros and ones, for each model

// Replaces an encoder and counts bits.
struct Counter {
    static constexpr bool encoding = true;

    bool bit(BitModel& model, bool value) {
        counts[static_cast<std::size_t>(&model - all_of(models).data())][value ? 1 : 0]++;
        return value;
    }
    std::uint64_t raw(std::uint64_t value, unsigned) { return value; }

    PointModels& models;
    Counts& counts;
};

// Each motion at steps and rates around the ones that it is measured with; every tenth state is a
// keyframe.
void count(Counts& counts) {
    for (const double step : {0.25, 1.0, 4.0})
        for (const int divisor : {1, 2, 4})
            for (const auto& object : all_objects()) {
                object->step_m *= step;
                const PointOrder order = object->layout.form == PointForm::loose
                                             ? PointOrder()
                                             : PointOrder(object->layout);
                StateHistory history;
                for (int tick = 0; tick < ticks; tick++) {
                    object->advance();
                    if (tick % divisor != 0) continue;
                    PointState state = history.add(*object, order, point_levels);
                    const bool alone = state.number % 10 == 0;
                    if (alone && object->layout.form == PointForm::loose)
                        state.previous.assign(object->ids.size(), no_point);
                    PointModels models;
                    Counter counter{.models = models, .counts = counts};
                    write_points(counter, models, {object->layout, order}, state,
                                 alone ? PointBaselines{} : history.baselines(), point_levels,
                                 [](std::size_t) {});
                }
            }
}

// One character per model (start_models.h). Sizes that no motion had take the counts of the
// nearest smaller class.
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

void write(const std::string& path, const std::string& table, const char* head, const char* row,
           const char* tail) {
    std::ofstream out(path);
    out << head;
    for (std::size_t at = 0; at < table.size(); at += 80) {
        char line[160];
        std::snprintf(line, sizeof line, row, table.substr(at, 80).c_str());
        out << line;
    }
    out << tail;
}

int train(const std::string& folder) {
    Counts counts(point_model_count);
    count(counts);
    const std::string table = letters(counts);
    write(folder + "/start_point_models.cpp", table,
          "// SPDX-License-Identifier: MIT\n//\n// Written by bench/points_bench.cpp; part of the "
          "format.\n#include \"jostle/snapshot/point_models.h\"\n\nnamespace jostle::snapshot "
          "{\n\nconst std::string_view start_point_model_letters =\n",
          "    \"%s\"\n", "    ;\n\n}  // namespace jostle::snapshot\n");
    write(
        folder + "/start_point_models.ts", table,
        "// Written by bench/points_bench.cpp; part of the format (proto/WIRE.md, \"Points\").\n\n"
        "export const INITIAL_POINT_MODELS = [\n",
        "  '%s',\n", "].join('');\n");
    return 0;
}

}  // namespace
}  // namespace jostle::bench

int main(int argc, char** argv) {
    if (argc == 1) return jostle::bench::measure_all();
    if (argc == 3 && std::strcmp(argv[1], "--train") == 0) return jostle::bench::train(argv[2]);
    std::fprintf(stderr, "usage: points-bench [--train FOLDER]\n");
    return 2;
}
