// SPDX-License-Identifier: MIT
//
// A sequence of calls of the predictor API: bodies with shapes of every kind, impulses, a grab, a
// frame with a misprediction, and a controlled car. Writes each call and its results as JSON, so
// that a predictor in another program (clients/web/src/predictor_golden.test.ts) can be tested with
// the same calls and must give the same bits.
// predictor_golden > tests/determinism/predictor_golden.json
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "clients/cpp/prediction/wasm/predictor_api.h"
#include "jostle/modules/controlled_entity_state.h"
#include "jostle/modules/vehicle.h"
#include "jostle/physics/world.h"

namespace {

using Numbers = std::vector<double>;

JostlePredictor* predictor = nullptr;
bool first_line = true;

void write_line(const char* call, const Numbers& values) {
    std::printf("%s\n[\"%s\"", first_line ? "" : ",", call);
    for (const double value : values) std::printf(",%.17g", value);
    std::printf("]");
    first_line = false;
}

void put(const Numbers& values) {
    double* numbers = jostle_predictor_buffer(predictor, static_cast<uint32_t>(values.size()));
    for (const double value : values) *numbers++ = value;
    write_line("put", values);
}

Numbers joined(std::initializer_list<Numbers> parts) {
    Numbers all;
    for (const Numbers& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

// --- bodies ---
struct Body {
    uint32_t entity, type;
    double mass;
    Numbers geometry;  // kind, pose and sizes
    double x, y, z;
};

const Numbers no_position{0, 0, 0, 0, 0, 0, 1};
const Numbers usual_touch{0.5, 0, 0, 0, 0, 0, 0, 1, 4, 1, 4294967295, 0, 0, 1000, 0};

const std::vector<Body>& bodies() {
    static const std::vector<Body> all{
        {1, 0, 0, joined({{3}, no_position, {50, 0.5, 50}}), 0, -0.5, 0},
        {2, 2, 125, joined({{3}, no_position, {0.25, 0.25, 0.25}}), 0, 0.25, 0},
        {3, 2, 125, joined({{3}, no_position, {0.25, 0.25, 0.25}}), 1.5, 0.25, 0},
        {4, 2, 30, joined({{1}, no_position, {0.2}}), 0.9, 0.2, 0.9},
        {5, 2, 40, joined({{2}, no_position, {0.15, 0.3}}), -0.9, 0.45, 0.4},
        {6, 2, 40, joined({{5}, no_position, {0.2, 0.25}}), -0.8, 0.25, -0.9},
        {7, 2, 20, joined({{6}, no_position, {0.25, 0.3}}), 0.7, 0.3, -1.2},
        {8, 2, 35,
         joined({{7},
                 no_position,
                 {5, -0.3, -0.2, -0.3, 0.3, -0.2, -0.3, 0, -0.2, 0.4, 0, 0.4, 0, 0.1, -0.1, 0.1}}),
         1.6, 0.2, 1.4},
        {9, 2, 50,
         joined({{10},
                 no_position,
                 {2, 3},
                 no_position,
                 {0.3, 0.1, 0.1},
                 {1, 0.4, 0, 0, 0, 0, 0, 1, 0.15}}),
         -1.8, 0.2, -0.4},
        {10, 0, 0, joined({{8}, no_position, {4,  -1,  0, -1, 1, 0, -1, 1, 0.6, 1,
                                              -1, 0.6, 1, 2,  0, 2, 1,  0, 3,   2}}),
         0, 0, 3},
        {11, 0, 0, joined({{9}, no_position, {2, 2, 2, 2, 0, 0.2, 0.1, 0.3, 0}}), -3, 0, 0},
        {12, 0, 0, joined({{4}, no_position, {0, 1, 0}}), 0, -2, 0},
    };
    return all;
}

void add_bodies() {
    for (const Body& body : bodies()) {
        jostle_predictor_add_body(predictor, body.entity, body.type, body.mass);
        write_line("add_body", {double(body.entity), double(body.type), body.mass});
        const Numbers shapes = joined({{1}, body.geometry, usual_touch});
        put(shapes);
        const auto count = static_cast<uint32_t>(shapes.size());
        const uint32_t understood = jostle_predictor_set_shapes(predictor, body.entity, count);
        write_line("set_shapes", {double(body.entity), double(count), double(understood)});
    }
}

// --- calls ---
void send_frame(uint32_t number, double shift) {
    Numbers values;
    for (const Body& body : bodies())
        for (const double n : {double(body.entity), body.x + (body.entity == 2 ? shift : 0), body.y,
                               body.z, 0.0, 0.0, 0.0, 1.0, 0.0})
            values.push_back(n);
    put(values);
    const auto count = static_cast<uint32_t>(bodies().size());
    write_line("frame", {double(number), double(count),
                         double(jostle_predictor_frame(predictor, number, count))});
}

// The rendered frame at a whole tick: the result of the solver. The requested positions are so far
// away that interpolation does not start.
void expect(uint32_t tick) {
    const uint32_t count = jostle_predictor_predicted(predictor);
    const double* drawn = jostle_predictor_buffer(predictor, count);
    Numbers values;
    for (uint32_t k = 0; k < count; k++)
        for (const double n : {drawn[k], 1e6, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}) values.push_back(n);
    put(values);
    const double now_us = 1e9 + tick * 1e7;
    jostle_predictor_sample(predictor, tick, now_us, count);
    const double* poses = jostle_predictor_buffer(predictor, 8 * count);
    Numbers answer{double(tick), now_us, double(count)};
    answer.insert(answer.end(), poses, poses + 8 * count);
    write_line("sample", answer);
}

void push(uint32_t sequence, uint32_t tick, uint32_t entity, double x, double y, double z) {
    jostle_predictor_push(predictor, sequence, tick, entity, x, y, z);
    write_line("push", {double(sequence), double(tick), double(entity), x, y, z});
}

void push_at(uint32_t sequence, uint32_t tick, uint32_t entity) {
    jostle_predictor_push_at(predictor, sequence, tick, entity, 10, 40, -30, -0.9, 0.7, 0.4);
    write_line("push_at",
               {double(sequence), double(tick), double(entity), 10, 40, -30, -0.9, 0.7, 0.4});
}

void drag(uint32_t sequence, uint32_t tick, double x, double y, double z) {
    jostle_predictor_drag(predictor, sequence, tick, x, y, z);
    write_line("drag", {double(sequence), double(tick), x, y, z});
}

// --- a car ---
constexpr uint32_t car = 13;
const Numbers chassis_half{0.8, 0.25, 2};
constexpr double chassis_mass = 1500;

void send_car_body() {
    jostle_predictor_add_body(predictor, car, 2, chassis_mass);
    write_line("add_body", {double(car), 2, chassis_mass});
    jostle_predictor_set_body(predictor, car, 0.01, 0.02, 1, 0, 1);
    write_line("set_body", {double(car), 0.01, 0.02, 1, 0, 1});
    const Numbers shapes = joined({{1, 3}, no_position, chassis_half, usual_touch});
    put(shapes);
    const auto count = static_cast<uint32_t>(shapes.size());
    const uint32_t understood = jostle_predictor_set_shapes(predictor, car, count);
    write_line("set_shapes", {double(car), double(count), double(understood)});
}

// The state that a server sends for a car that has driven for 1.5 s.
void send_controlled_car(uint32_t tick) {
    using namespace jostle;
    physics::World world;
    const physics::Box floor{{50, 0.5, 50}},
        box{{chassis_half[0], chassis_half[1], chassis_half[2]}};
    world
        .create_body({.type = physics::BodyType::static_body, .pose = {{0, -0.5, 0}, {}}},
                     {.geometry = floor})
        .value();
    const physics::BodyId chassis =
        world.create_body({.pose = {{20, 0.67, 0}, {}}}, {.geometry = box, .mass = chassis_mass})
            .value();
    modules::Vehicles vehicles;
    vehicles.add(world, modules::saloon({.chassis = chassis})).value();
    vehicles.control(world, chassis, {.axes = {0.1, 1}});
    world.add_listener(vehicles).expect();
    for (int k = 0; k < 90; k++) world.step(1.0 / 60).expect();
    const auto words = *modules::encode_controlled_entity(world, vehicles, chassis,
                                                          [](physics::BodyId) { return car; });
    Numbers values;
    for (const char letter : vehicles.tag()) values.push_back(letter);
    for (const std::uint32_t word : words) values.push_back(word);
    put(values);
    const auto letters = static_cast<uint32_t>(vehicles.tag().size()),
               count = static_cast<uint32_t>(words.size());
    write_line("control", {double(car), double(tick), double(letters), double(count),
                           double(jostle_predictor_control(predictor, car, tick, letters, count))});
    const physics::Vec3 at = world.body(chassis)->pose.position;
    put({1, 0, -0.5, 0, 0, 0, 0, 1, 1, car, at.x, at.y, at.z, 0, 0, 0, 1, 0});
    write_line("frame", {double(tick), 2, double(jostle_predictor_frame(predictor, tick, 2))});
}

void steer(uint32_t sequence, uint32_t tick, const Numbers& axes, uint32_t buttons) {
    put(axes);
    const auto count = static_cast<uint32_t>(axes.size());
    jostle_predictor_steer(predictor, sequence, tick, count, buttons);
    write_line("steer", {double(sequence), double(tick), double(count), double(buttons)});
}

void send_control() {
    send_car_body();
    jostle_predictor_follow(predictor, car);
    write_line("follow", {car});
    send_controlled_car(300);
    expect(310);
    steer(40, 311, {-0.7, 1}, 0);
    expect(330);
    steer(41, 340, {0, -1, 0, 0}, 1);
    expect(370);
}

void write_predictor_trace() {
    jostle_predictor_begin(predictor, 60, 0, -9.81, 0, 8);
    write_line("begin", {60, 0, -9.81, 0, 8});
    add_bodies();
    jostle_predictor_follow(predictor, 2);
    write_line("follow", {2});
    send_frame(1, 0);
    expect(2);
    push(1, 3, 2, 625, 0, 0);  // 5 m/s towards the other box
    push_at(2, 4, 5);          // makes the capsule spin
    for (uint32_t tick = 10; tick <= 60; tick += 10) expect(tick);
    jostle_predictor_grab(predictor, 3, 61, 2, 1, 0.3, 0);
    write_line("grab", {3, 61, 2, 1, 0.3, 0});
    for (uint32_t k = 0; k < 30; k++) drag(4 + k, 61 + k, 1 - 0.08 * k, 0.3 + 0.03 * k, 0.01 * k);
    for (uint32_t tick = 70; tick <= 90; tick += 10) expect(tick);
    jostle_predictor_release(predictor, 34, 91);
    write_line("release", {34, 91});
    expect(100);
    // the input was rejected; the grab remains active
    jostle_predictor_result(predictor, 34, 0, 0);
    write_line("result", {34, 0, 0});
    expect(110);
    // the server has the bodies at their start positions, the predictor elsewhere
    send_frame(100, 0.5);
    expect(120);
    expect(150);
    send_control();
}

}  // namespace

void jostle_predictor_request_shapes(JostlePredictor*, uint32_t) {}

int main() {
    predictor = jostle_predictor_create();
    std::printf("[");
    write_predictor_trace();
    std::printf("\n]\n");
    jostle_predictor_destroy(predictor);
}
