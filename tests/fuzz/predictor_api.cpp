// SPDX-License-Identifier: MIT
//
// A predictor called by a host that hands on what a server sent: bodies of any shapes, frames and
// answers in any order. Records: which call, and doubles.
#include "clients/cpp/prediction/wasm/predictor_api.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>
#include <vector>

#include "tests/fuzz/mutate_numbers.h"
#include "tests/fuzz/reader.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

namespace {

constexpr int calls_max = 64;
constexpr std::uint32_t steps_max = 150;  // a slow input is no report

struct Destroy {
    void operator()(JostlePredictor* p) const { jostle_predictor_destroy(p); }
};

std::uint32_t whole(double x) {
    return x >= 1 && x <= 300 ? static_cast<std::uint32_t>(x) : 1;
}

// As many numbers as there are bytes for; zeros past the end.
std::uint32_t put(JostlePredictor* p, Reader& in) {
    const std::size_t count = std::min<std::size_t>(in.rest().size() / sizeof(double), 4096);
    double* numbers = jostle_predictor_buffer(p, static_cast<std::uint32_t>(count));
    for (std::size_t k = 0; k < count; k++) numbers[k] = in.number<double>();
    return static_cast<std::uint32_t>(count);
}

void draw(JostlePredictor* p, double position, double now_us) {
    const std::uint32_t count = jostle_predictor_predicted(p);
    double* numbers = jostle_predictor_buffer(p, count);
    const std::vector<double> drawn(numbers, numbers + count);
    expect(std::is_sorted(drawn.begin(), drawn.end()), "who is drawn comes in order");
    numbers = jostle_predictor_buffer(p, 8 * count);
    std::fill(numbers, numbers + 8 * count, 0.0);
    for (std::uint32_t k = 0; k < count; k++) {
        numbers[8 * k] = drawn[k];
        numbers[8 * k + 7] = 1;
    }
    if (jostle_predictor_sample(p, position, now_us, count) == 0) return;
    for (std::uint32_t k = 0; k < 8 * count; k++)
        expect(std::isfinite(numbers[k]), "what is drawn is somewhere");
}

// Words as they come, of a module that there is or one that there is not.
void drive(JostlePredictor* p, std::uint32_t entity, std::uint32_t tick, Reader& in) {
    constexpr std::string_view tags[] = {"vehicle", "character", "boat"};
    const std::string_view tag = tags[tick % 3];
    std::vector<double> told(tag.begin(), tag.end());
    while (in.rest().size() >= sizeof(std::uint32_t) && told.size() < 4096)
        told.push_back(in.number<std::uint32_t>());
    std::ranges::copy(told, jostle_predictor_buffer(p, static_cast<std::uint32_t>(told.size())));
    jostle_predictor_control(p, entity, tick, static_cast<std::uint32_t>(tag.size()),
                             static_cast<std::uint32_t>(told.size() - tag.size()));
}

void call(JostlePredictor* p, std::uint8_t kind, Reader in) {
    const std::uint32_t entity = whole(in.number<double>()), tick = whole(in.number<double>());
    switch (kind % 12) {
        case 0:
            return jostle_predictor_add_body(p, entity, tick % 3, in.number<double>());
        case 1:
            jostle_predictor_set_shapes(p, entity, put(p, in));
            return;
        case 2:
            jostle_predictor_frame(p, tick, put(p, in) / 9);
            return;
        case 3:
            return draw(p, in.number<double>(), in.number<double>());
        case 4: {
            const auto x = in.number<double>(), y = in.number<double>(), z = in.number<double>();
            if (entity % 3 == 0) return jostle_predictor_push(p, entity, tick, 1, x, y, z);
            if (entity % 3 == 1) return jostle_predictor_grab(p, entity, tick, 1, x, y, z);
            return jostle_predictor_drag(p, entity, tick, x, y, z);
        }
        case 5:
            return jostle_predictor_result(p, entity, tick, kind > 127);
        case 6:
            return jostle_predictor_follow(p, entity);
        case 7:
            jostle_predictor_velocities(p, put(p, in) / 7);
            return;
        case 8:
            return jostle_predictor_remove_body(p, entity);
        case 9: {
            const auto linear = in.number<double>(), angular = in.number<double>();
            return jostle_predictor_set_body(p, entity, linear, angular, in.number<double>(), tick,
                                             kind >> 6);
        }
        case 10:
            return jostle_predictor_steer(p, entity, tick, put(p, in), kind);
        default:
            return drive(p, entity, tick, in);
    }
}

}  // namespace

void run(Bytes input) {
    Reader in(input);
    const std::unique_ptr<JostlePredictor, Destroy> p(jostle_predictor_create());
    jostle_predictor_begin(p.get(), 60, 0, -9.81, 0, 8);
    for (int k = 0; k < calls_max && !in.done(); k++) {
        const Record record = take_record(in);
        call(p.get(), record.kind, Reader(record.bytes));
        if (jostle_predictor_stat(p.get(), 2) > steps_max) return;
    }
}

}  // namespace jostle::fuzz

void jostle_predictor_request_shapes(JostlePredictor*, uint32_t) {}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t size_max, unsigned seed) {
    return jostle::fuzz::mutate_numbers(data, size, size_max, seed);
}
