// SPDX-License-Identifier: MIT
//
// A client with an area of interest, without a network: the updates of each tick, and whether the
// decoded state matches the world.
#include "server/replication/interest_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

#include "jostle/snapshot/quantize.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

constexpr double world_hz = 60, cell_edge_m = 32;

Clock::time_point at(std::uint32_t tick) {
    return Clock::time_point{} + 1h + from_seconds(tick / world_hz);
}

// Bodies on a square of 10 x 10 cells, 4 in each. Each rotates in place, or all are at rest.
struct Field {
    explicit Field(bool moves_) : moves(moves_) {
        auto entities = std::make_shared<EntityList>();
        for (EntityId id = 1; id <= 400; id++) {
            auto entity = std::make_shared<EntityDescription>();
            entity->id = id;
            entity->bounding_radius = 1;
            entities->push_back(entity);
        }
        list = entities;
    }
    FramePtr frame(std::uint32_t tick) {
        auto made = std::make_shared<Frame>();
        made->tick = tick;
        made->entity_list = list;
        std::vector<EntityPose> poses;
        for (EntityId id = 1; id <= 400; id++) {
            const int cell = static_cast<int>(id - 1) / 4;
            const double turn = moves ? 0.05 * tick + id : id;
            poses.push_back({.id = id,
                             .awake = moves,
                             .pose = {{cell % 10 * cell_edge_m + 4.0 + id % 4 * 6 + std::cos(turn),
                                       1, cell / 10 * cell_edge_m + 16 + std::sin(turn)},
                                      {}}});
        }
        made->entities = PoseList(poses);
        return made;
    }
    bool moves;
    std::shared_ptr<const EntityList> list;
};

// Serialization for the test: six numbers, then the packed cell.
std::string put_cell(const EncodedCell& cell) {
    const std::uint32_t head[] = {cell.id,
                                  cell.number,
                                  cell.baselines.baseline,
                                  cell.baselines.baseline2,
                                  cell.baselines.baseline3,
                                  cell.crc};
    std::string bytes(sizeof head + cell.packed.size(), '\0');
    std::memcpy(bytes.data(), head, sizeof head);
    std::memcpy(bytes.data() + sizeof head, cell.packed.data(), cell.packed.size());
    return bytes;
}

// A client that decodes its updates.
struct TestView {
    explicit TestView(double bytes_per_second) : view(bytes_per_second) {}

    void tick(Field& field, std::uint32_t number) {
        const FramePtr frame = field.frame(number);
        const auto cells = feed.cells(frame, [&] {
            snapshot::QuantizedFrame made{.frame = number};
            for (const EntityPose& e : frame->entities)
                made.entities.push_back(snapshot::quantize(
                    e.id, {{e.pose.position.x, e.pose.position.y, e.pose.position.z}, {0, 0, 0, 1}},
                    !e.awake, {}));
            return made;
        });
        std::size_t bytes = 0;
        for (const auto& part : view.pending_cells(feed, *cells, number, at(number))) {
            const auto [sent, is_keyframe] =
                feed.encoding(part.state, part.baselines, snapshot::Codec::bits);
            if (!view.affords(sent->size(), part.fresh)) {
                if (part.fresh) continue;
                break;
            }
            view.spend(sent->size(), part.fresh);
            view.on_sent(part, is_keyframe, number);
            take(*sent);
            bytes += sent->size();
            sent_at[part.state.id].push_back(number);
        }
        for (const CellId cell : view.take_left()) known.erase(cell);
        bytes_of_tick.push_back(bytes);
    }
    void take(const std::string& sent) {
        std::uint32_t head[6];
        std::memcpy(head, sent.data(), sizeof head);
        auto& states = known[head[0]];
        const auto baseline = [&](std::uint32_t number) -> const snapshot::QuantizedFrame* {
            if (number == 0) return nullptr;
            EXPECT_TRUE(states.contains(number)) << "the baseline was never sent";
            return states.contains(number) ? &states[number] : nullptr;
        };
        const auto packed = std::as_bytes(std::span(sent)).subspan(sizeof head);
        auto content = snapshot::decode_frame(
            head[1], packed, {baseline(head[2]), baseline(head[3]), baseline(head[4])}, {});
        ASSERT_TRUE(content.ok()) << content.error().message;
        EXPECT_EQ(snapshot::frame_crc(*content), head[5]);
        states[head[1]] = *std::move(content);
    }
    std::size_t max_bytes_per_second() const {
        std::size_t most = 0, sum = 0;
        for (std::size_t k = 0; k < bytes_of_tick.size(); k++) {
            sum += bytes_of_tick[k];
            if (k >= 60) sum -= bytes_of_tick[k - 60];
            most = std::max(most, sum);
        }
        return most;
    }

    InterestView view;
    CellSnapshotCache feed{cell_edge_m, snapshot::QuantSpec(), put_cell};
    std::map<CellId, std::map<std::uint32_t, snapshot::QuantizedFrame>> known;
    std::map<CellId, std::vector<std::uint32_t>> sent_at;
    std::vector<std::size_t> bytes_of_tick;
};

TEST(InterestView, selects_only_cells_within_the_radius) {
    Field field(false);
    TestView client(0);
    client.view.set_interest({.x_m = 16, .z_m = 16, .radius_m = 50});
    for (std::uint32_t tick = 1; tick < 60; tick++) client.tick(field, tick);
    std::size_t expected = 0;
    for (int x = 0; x < 10; x++)
        for (int z = 0; z < 10; z++)
            expected += client.feed.distance(CellGrid::id_of({x, z}), 16, 16) <= 50;
    EXPECT_EQ(client.known.size(), expected);
    EXPECT_EQ(expected, 6u) << "three cells along each edge and one between them";
    for (const auto& [cell, times] : client.sent_at)
        EXPECT_EQ(times.size(), 1u) << "a cell at rest must be sent once";
}

TEST(InterestView, moving_focus_enters_and_leaves_cells) {
    Field field(true);
    TestView client(0);
    for (std::uint32_t tick = 1; tick < 600; tick++) {
        client.view.set_interest({.x_m = 0.5 * tick, .z_m = 16, .radius_m = 40});
        client.tick(field, tick);
    }
    for (const auto& [cell, states] : client.known)
        EXPECT_LE(client.feed.distance(cell, 300, 16), 40 + cell_edge_m / 4);
    EXPECT_GT(client.sent_at.size(), client.known.size() + 5)
        << "other cells must have been sent earlier";
}

TEST(InterestView, sends_distant_cells_less_often) {
    Field field(true);
    TestView client(0);
    client.view.set_interest({.x_m = 16, .z_m = 16, .radius_m = 200});
    for (std::uint32_t tick = 1; tick <= 240; tick++) client.tick(field, tick);
    const auto count = [&](int x) {
        return static_cast<int>(client.sent_at[CellGrid::id_of({x, 0})].size());
    };
    EXPECT_NEAR(count(0), 240, 3);
    EXPECT_NEAR(count(4), 120, 3) << "112 m is more than half of the radius";
    EXPECT_NEAR(count(6), 60, 3) << "176 m is more than three quarters of the radius";
    EXPECT_EQ(count(7), 0);
}

TEST(InterestView, respects_the_byte_budget_and_prefers_near_cells) {
    Field field(true);
    TestView all(0);
    for (std::uint32_t tick = 1; tick <= 300; tick++) all.tick(field, tick);
    const std::size_t wants = all.max_bytes_per_second();
    const double rate = 0.3 * static_cast<double>(wants);
    TestView client(rate);
    client.view.set_interest({.x_m = 16, .z_m = 16});
    for (std::uint32_t tick = 1; tick <= 900; tick++) client.tick(field, tick);
    RecordProperty("bytes_of_worst_second", static_cast<int>(client.max_bytes_per_second()));
    EXPECT_LE(static_cast<double>(client.max_bytes_per_second()), rate);
    std::size_t total = 0;
    for (std::size_t k = 600; k < 900; k++) total += client.bytes_of_tick[k];
    EXPECT_GE(static_cast<double>(total), 0.95 * 5 * rate) << "the bandwidth must be used";
    EXPECT_EQ(client.known.size(), 100u) << "the client must receive the complete world";
    const auto since = [&](int x, int z) {
        const auto& times = client.sent_at[CellGrid::id_of({x, z})];
        return std::ranges::count_if(times, [](auto tick) { return tick > 600; });
    };
    EXPECT_GE(since(0, 0), 3 * since(9, 9)) << "near cells must be sent more often";
    EXPECT_GE(since(9, 9), 5) << "far cells must still be sent";
}

TEST(InterestView, entering_a_dense_area_does_not_starve_known_cells) {
    Field field(true);
    TestView client(20'000);
    client.view.set_interest({.x_m = 16, .z_m = 16, .radius_m = 20});
    std::uint32_t tick = 1;
    for (; tick <= 120; tick++) client.tick(field, tick);
    const std::size_t previous = client.sent_at[CellGrid::id_of({0, 0})].size();
    client.view.set_interest({.x_m = 16, .z_m = 16, .radius_m = 1000});
    for (; tick <= 180; tick++) client.tick(field, tick);
    EXPECT_GE(client.sent_at[CellGrid::id_of({0, 0})].size() - previous, 20u)
        << "at least 20 of 60 ticks";
    for (; tick <= 1200; tick++) client.tick(field, tick);
    EXPECT_EQ(client.known.size(), 100u);
}

// An entity that flies leaves empty cells behind. They are removed, and clients are notified.
TEST(CellSnapshotCache, removes_cells_that_stay_empty) {
    TestView client(0);
    const auto fly = [&](std::uint32_t tick) {
        auto list = std::make_shared<EntityList>();
        auto flier = std::make_shared<EntityDescription>();
        flier->id = 1;
        list->push_back(flier);
        auto frame = std::make_shared<Frame>();
        frame->tick = tick;
        frame->entity_list = list;
        const auto cells = client.feed.cells(frame, [&] {
            return snapshot::QuantizedFrame{
                .frame = tick,
                .entities = {snapshot::quantize(1, {{1.0 * tick, 1, 0}, {0, 0, 0, 1}}, false, {})}};
        });
        for (const auto& part : client.view.pending_cells(client.feed, *cells, tick, at(tick)))
            client.view.on_sent(part, part.baselines.baseline == 0, tick);
        return cells->size();
    };
    std::size_t most = 0, left = 0;
    for (std::uint32_t tick = 1; tick < 5000; tick++) {
        most = std::max(most, fly(tick));
        left += client.view.take_left().size();
    }
    EXPECT_LE(most, CellSnapshotCache::empty_ticks / cell_edge_m + 3);
    EXPECT_GE(left, 140u) << "of 156 crossed cells";
}

TEST(CellSnapshotCache, clients_share_encoded_cells) {
    Field field(true);
    TestView one(0);
    const FramePtr frame = field.frame(1);
    one.tick(field, 1);
    const auto cells = one.feed.cells(frame, [] { return snapshot::QuantizedFrame(); });
    const SharedBytes a = one.feed.encoding((*cells)[5].near, {}, snapshot::Codec::bits).bytes;
    EXPECT_EQ(one.feed.encoding((*cells)[5].near, {}, snapshot::Codec::bits).bytes, a)
        << "a cached encoding must be reused";
    EXPECT_NE(one.feed.encoding((*cells)[5].near, {}, snapshot::Codec::range).bytes, a);
}

}  // namespace
}  // namespace jostle::server
