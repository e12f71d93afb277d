// SPDX-License-Identifier: MIT
#include "server/replication/pose_cache.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "server/replication/interest_view.h"

namespace jostle::server {
namespace {

constexpr double cell_m = 32;
constexpr EntityId bodies = 100;

// A hundred bodies in a row of 200 m, some moving.
physics::Transform pose_of(EntityId id, std::uint32_t tick) {
    const double s = id % 3 == 0 ? 0 : 0.037 * tick, angle = 0.021 * s * id;
    return {{2.0 * id + std::sin(0.1 * s), s, 0.3 * std::cos(0.2 * s)},
            {0, std::sin(angle / 2), 0, std::cos(angle / 2)}};
}

struct World {
    World() {
        auto entities = std::make_shared<EntityList>();
        for (EntityId id = 1; id <= bodies; id++) {
            auto entity = std::make_shared<EntityDescription>();
            entity->id = id;
            entity->bounding_radius = 1;
            entities->push_back(entity);
        }
        list = entities;
    }
    FramePtr frame(std::uint32_t tick) const {
        auto made = std::make_shared<Frame>();
        made->tick = tick;
        made->entity_list = list;
        std::vector<EntityPose> poses;
        for (EntityId id = 1; id <= bodies; id++)
            poses.push_back({.id = id, .awake = id % 3 != 0, .pose = pose_of(id, tick)});
        made->entities = PoseList(poses);
        return made;
    }
    std::shared_ptr<const EntityList> list;
};

int misses(const snapshot::QuantizedFrame& frame, std::uint32_t tick,
           const snapshot::Precision& precision, const snapshot::QuantSpec& spec) {
    int missed = 0;
    for (const snapshot::EntityState& state : frame.entities) {
        const physics::Transform pose = pose_of(state.id, tick);
        const physics::Vec3& p = pose.position;
        const physics::Quat& q = pose.rotation;
        missed +=
            !snapshot::is_within(precision, state, {{p.x, p.y, p.z}, {q.x, q.y, q.z, q.w}}, spec);
    }
    return missed;
}

TEST(PoseCache, every_quantized_pose_is_within_the_precision) {
    const World world;
    const StreamPrecision precision{{0.01, 0.001}, 1};
    PoseCache cache(
        precision, cell_m, [](const EncodedSnapshot&) { return std::string(); },
        [](const EncodedCell&) { return std::string(); });
    std::mt19937 generator(5);
    const auto random = [&] { return static_cast<std::uint32_t>(generator()); };
    // In any order of ticks and with gaps, as network threads request them.
    std::uint32_t tick = 1;
    for (int k = 0; k < 200; k++) {
        tick += 1 + random() % 4;
        const std::uint32_t late = tick > 10 && random() % 5 == 0 ? tick - random() % 8 : tick;
        const auto frame = cache.snapshots().quantized(world.frame(late));
        ASSERT_EQ(frame.entities.size(), bodies);
        EXPECT_EQ(misses(frame, late, precision.near, cache.snapshots().spec()), 0) << late;
    }
}

TEST(PoseCache, distant_cells_have_the_same_entities_in_the_far_precision) {
    const World world;
    const StreamPrecision precision{{0.002, 0.001}, 50};
    PoseCache cache(
        precision, cell_m, [](const EncodedSnapshot&) { return std::string(); },
        [](const EncodedCell&) { return std::string(); });
    int coarser = 0;
    for (std::uint32_t tick = 1; tick <= 120; tick++) {
        const auto cells = cache.cells_of(world.frame(tick));
        for (const auto& [near, far] : *cells) {
            ASSERT_EQ(near.id, far.id);
            ASSERT_EQ(near.content->entities.size(), far.content->entities.size());
            if (near.number == tick) {
                EXPECT_EQ(misses(*near.content, tick, precision.near, cache.snapshots().spec()), 0);
            }
            if (far.number == tick) {
                EXPECT_EQ(misses(*far.content, tick, precision.far(), cache.snapshots().spec()), 0);
            }
            coarser += near.content->entities != far.content->entities;
        }
    }
    EXPECT_GT(coarser, 100);
}

TEST(PoseCache, a_cell_changes_its_precision_with_the_distance_as_a_keyframe) {
    const World world;
    PoseCache cache(
        {{0.002, 0.001}, 50}, cell_m, [](const EncodedSnapshot&) { return std::string(); },
        [](const EncodedCell&) { return std::string(); });
    InterestView view(0);
    const auto at = [](std::uint32_t tick) {
        return Clock::time_point{} + std::chrono::hours(1) + from_seconds(tick / 60.0);
    };
    std::map<CellId, bool> far_of;
    int changes = 0, keyframes = 0;
    for (std::uint32_t tick = 1; tick <= 300; tick++) {
        view.set_interest({.x_m = tick * 0.5, .z_m = 0, .radius_m = 100});
        const auto cells = cache.cells_of(world.frame(tick));
        for (const auto& part : view.pending_cells(cache.cells(), *cells, tick, at(tick))) {
            const auto known = far_of.find(part.state.id);
            if (known != far_of.end() && known->second != part.state.far) {
                changes++;
                keyframes += part.baselines.baseline == 0;
            }
            far_of[part.state.id] = part.state.far;
            view.on_sent(part, part.baselines.baseline == 0, tick);
        }
        for (const CellId cell : view.take_left()) far_of.erase(cell);
    }
    EXPECT_GE(changes, 4);
    EXPECT_LE(changes, 24);  // no alternation at the border
    EXPECT_EQ(keyframes, changes);
}

TEST(StreamPrecision, a_factor_out_of_range_is_refused) {
    EXPECT_TRUE(check(StreamPrecision{{0.01, 0.001}, 0}, "hello.precision.").ok());
    EXPECT_EQ(check(StreamPrecision{{0.01, 0.001}, 2000}, "hello.precision.").error().message,
              "hello.precision.far_factor is 2000; it must be 0 or from 1 to 1000");
    EXPECT_EQ(granted({{0.013, 0.0011}, 7}), (StreamPrecision{{0.01, 0.001}, 5}));
}

}  // namespace
}  // namespace jostle::server
