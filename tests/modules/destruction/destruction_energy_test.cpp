// SPDX-License-Identifier: MIT
//
// Violent impacts on solids of all kinds create no energy, and nothing falls through the floor.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "jostle/modules/seed_patterns.h"
#include "tests/modules/destruction/walls.h"

namespace jostle::modules {
namespace {

using namespace physics;

struct Hit {
    const char* name;
    SeedPattern pattern;
    int chunks;
    BondMaterial bonds;
    double density, speed, rate;  // kg/m^3, m/s, Hz
    bool stacked;                 // another, loose wall stands on it
    Vec3 half{2, 1, 0.2};
};

constexpr BondMaterial clay{
    .young = 1e9, .tensile = 2e5, .shear = 3e5, .compressive = 2e6, .fracture_energy = 20};
constexpr BondMaterial glass{
    .young = 7e10, .tensile = 4e7, .shear = 4e7, .compressive = 1e9, .fracture_energy = 8};

// Largest energy gain relative to the energy of the ball, and the lowest height of any body.
struct Outcome {
    double gain = 0, lowest = 0;
};

const void* hull_of(const Geometry& geometry) {
    return std::get<Hull>(geometry).data.get();
}

// Energy relative to the floor, J, including static bodies, which the summary of the world omits.
double energy_of(const World& world, const FracturedShape& shape, const DestructibleDef& def) {
    const WorldSummary sum = world.summary();
    double energy = sum.kinetic_energy + sum.potential_energy;
    for (const BodyId id : world.bodies()) {
        if (world.body(id)->type != BodyType::static_body) continue;
        for (const ShapeId s : world.shapes_of(id)) {
            const ShapeState state = world.shape(s).value();
            for (const FractureChunk& chunk : shape.chunks)
                if (std::holds_alternative<Hull>(state.geometry) &&
                    hull_of(chunk.geometry) == hull_of(state.geometry))
                    energy +=
                        def.density * chunk.volume * 9.81 * (chunk.center.y + def.pose.position.y);
        }
    }
    return energy;
}

Outcome outcome_of(const Hit& hit) {
    Stage stage;
    World& world = stage.world;
    world
        .create_body({.type = BodyType::static_body, .pose = {.position = {0, -0.5, 0}}},
                     {.geometry = Box{{60, 0.5, 60}}})
        .value();
    const SeedPatternOptions plan{
        .pattern = hit.pattern, .count = hit.chunks, .center = Vec3{0, 0.3 * hit.half.y, 0}};
    FracturedShape shape =
        fracture_box(hit.half, generate_seeds({-hit.half, hit.half}, plan).value()).value();
    DestructibleDef def{.density = hit.density, .bonds = hit.bonds};
    if (hit.stacked) {
        def.pose.position.y = 3 * hit.half.y + 0.003;
        stage.add(shape, def);
    }
    anchor(shape, {0, -1, 0}, hit.half.y * (1 - 1e-6));
    def.pose.position.y = hit.half.y + 0.001;
    stage.add(shape, def);
    // Bodies that rest on top.
    const double top = hit.half.y * (hit.stacked ? 4 : 2) + 0.01;
    for (const double x : {-1.0, 0.0, 1.0})
        world
            .create_body({.pose = {.position = {x, top + 0.25, 0}}},
                         {.geometry = Box{{0.2, 0.25, 0.2}}})
            .value();
    const int second = static_cast<int>(hit.rate);
    stage.step(second / 2, 1 / hit.rate);
    const double start = energy_of(world, shape, def);
    stage.ball({0.2, 1.2 * hit.half.y, -hit.half.z - 0.6}, {0, 0, hit.speed});
    const double impact_energy = energy_of(world, shape, def) - start;
    Outcome outcome;
    for (int k = 0; k < 2 * second; k++) {
        stage.step(1, 1 / hit.rate);
        const double now = energy_of(world, shape, def);
        EXPECT_TRUE(std::isfinite(now)) << hit.name;
        outcome.gain = std::max(outcome.gain, (now - start - impact_energy) / impact_energy);
        for (const BodyId id : world.bodies()) {
            const Vec3 at = world.body(id)->center;
            if (std::abs(at.x) < 58 && std::abs(at.z) < 58 &&
                world.body(id)->type == BodyType::dynamic)
                outcome.lowest = std::min(outcome.lowest, at.y);
        }
    }
    return outcome;
}

TEST(DestructionEnergy, violent_impacts_add_no_energy_and_nothing_falls_through_the_floor) {
    const BondMaterial concrete;
    const Hit hits[] = {
        // Regression: a body that struck many small chunks at once was thrown back faster than it
        // came.
        {"chunks of four decades",
         SeedPattern::radial,
         150,
         concrete,
         2400,
         20,
         60,
         false,
         {2, 1.5, 0.15}},
        {"wall on wall, clustered", SeedPattern::clustered, 80, clay, 2400, 40, 60, true},
        // Regression: the striking body got its whole energy back, while other bodies retained the
        // energy that it had
        // given them.
        {"wall on wall, slowly", SeedPattern::clustered, 80, clay, 2400, 10, 60, true},
        {"at 120 Hz", SeedPattern::uniform, 100, concrete, 2400, 20, 120, false, {2, 1.5, 0.15}},
        {"at 240 Hz", SeedPattern::uniform, 100, concrete, 2400, 20, 240, false, {2, 1.5, 0.15}},
        {"30 Hz, 300 m/s", SeedPattern::clustered, 80, clay, 2400, 300, 30, true},
        {"thin glass", SeedPattern::radial, 100, glass, 2500, 100, 60, false, {1, 0.6, 0.005}},
    };
    for (const Hit& hit : hits) {
        const Outcome outcome = outcome_of(hit);
        RecordProperty(hit.name, std::to_string(outcome.gain));
        EXPECT_LT(outcome.gain, 0.002) << hit.name;
        EXPECT_GT(outcome.lowest, -0.05) << hit.name;
    }
}

}  // namespace
}  // namespace jostle::modules
