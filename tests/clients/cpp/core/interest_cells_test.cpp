// SPDX-License-Identifier: MIT
#include "clients/cpp/core/src/interest_cells.h"

#include <gtest/gtest.h>

#include "jostle/snapshot/baseline_frames.h"
#include "jostle/snapshot/quantize.h"

namespace jostle::client {
namespace {

using States = std::vector<std::pair<std::uint32_t, double>>;  // entity, x in m

snapshot::QuantizedFrame state(std::uint32_t number, const States& entities) {
    snapshot::QuantizedFrame made{.frame = number, .entities = {}};
    for (const auto& [id, x] : entities)
        made.entities.push_back(snapshot::quantize(id, {{x, 0, 0}, {0, 0, 0, 1}}, false, {}));
    return made;
}

void add_cell(v1::Snapshot& snapshot, std::uint32_t cell, const snapshot::QuantizedFrame& now,
              const snapshot::QuantizedFrame* base = nullptr) {
    v1::CellUpdate& part = *snapshot.add_cells();
    part.set_cell(cell);
    part.set_number(now.frame);
    if (base)
        part.set_baselines(snapshot::encode_baseline_frames(now.frame, {.baseline = base->frame}));
    const auto packed = snapshot::encode_frame(now, {base, nullptr, nullptr}, {});
    part.set_packed(packed.data(), packed.size());
    part.set_crc(snapshot::frame_crc(now));
}

class InterestCellsTest : public testing::Test {
protected:
    Status apply(const v1::Snapshot& snapshot) {
        return cells.apply(snapshot, {}, snapshot::Codec::bits);
    }
    std::vector<std::uint32_t> seen() const {
        std::vector<std::uint32_t> ids;
        for (const auto& entity : cells.frame(1).entities) ids.push_back(entity.id);
        return ids;
    }
    double x_of(std::uint32_t id) const {
        for (const auto& entity : cells.frame(1).entities)
            if (entity.id == id) return snapshot::dequantize(entity, {}).position[0];
        return -1;
    }
    // Position in a rendered frame of that tick.
    double rendered_frame(std::uint32_t number, std::uint32_t id) const {
        for (const auto& entity : cells.rendered_frame(number, {}, 1e6 / 60).entities)
            if (entity.id == id) return snapshot::dequantize(entity, {}).position[0];
        return -1;
    }
    InterestCells cells;
};

TEST_F(InterestCellsTest, adds_updates_and_removes_cells) {
    const auto a = state(10, {{1, 5}, {4, 6}}), b = state(10, {{2, 40}});
    v1::Snapshot first;
    add_cell(first, 7, a);
    add_cell(first, 8, b);
    ASSERT_TRUE(apply(first).ok());
    EXPECT_EQ(seen(), (std::vector<std::uint32_t>{1, 2, 4}));
    const auto a2 = state(12, {{1, 5.5}, {4, 6}});
    v1::Snapshot second;
    add_cell(second, 7, a2, &a);
    second.add_cells_left(8);
    ASSERT_TRUE(apply(second).ok());
    EXPECT_EQ(seen(), (std::vector<std::uint32_t>{1, 4}));
    EXPECT_NEAR(x_of(1), 5.5, 0.001);
}

TEST_F(InterestCellsTest, uses_the_newer_state_of_an_entity_in_two_cells) {
    v1::Snapshot snapshot;
    add_cell(snapshot, 1, state(20, {{3, 31.9}}));
    add_cell(snapshot, 2, state(24, {{3, 36.1}}));
    ASSERT_TRUE(apply(snapshot).ok());
    EXPECT_EQ(seen(), (std::vector<std::uint32_t>{3}));
    EXPECT_NEAR(x_of(3), 36.1, 0.001);
}

TEST_F(InterestCellsTest, rejects_a_corrupt_cell_without_changing_state) {
    const auto a = state(10, {{1, 5}});
    v1::Snapshot first;
    add_cell(first, 7, a);
    ASSERT_TRUE(apply(first).ok());
    v1::Snapshot spoilt;
    add_cell(spoilt, 9, state(11, {{2, 1}}));
    add_cell(spoilt, 7, state(11, {{1, 6}}), &a);
    spoilt.mutable_cells(1)->set_crc(5);
    EXPECT_EQ(apply(spoilt).error().message, "cell 7 of tick 11: CRC mismatch");
    EXPECT_EQ(seen(), (std::vector<std::uint32_t>{1})) << "the valid cell is not applied either";
    v1::Snapshot unknown;
    const auto never = state(9, {});
    add_cell(unknown, 7, state(12, {}), &never);
    EXPECT_EQ(apply(unknown).error().message, "cell 7 of tick 12: unknown baseline 9");
    v1::Snapshot old;
    add_cell(old, 7, state(10, {}), &never);
    EXPECT_EQ(apply(old).error().message, "cell 7 of tick 10 is not newer than the last one");
}

TEST_F(InterestCellsTest, restarts_a_cell_from_an_absolute_update) {
    for (const double x : {5.0, 7.0}) {
        v1::Snapshot whole;
        add_cell(whole, 7, state(10, {{1, x}}));
        ASSERT_TRUE(apply(whole).ok());
        EXPECT_NEAR(x_of(1), x, 0.001);
    }
}

// Both entities move at 12 m/s, 0.2 m per tick. Near cells are sent with every snapshot, distant
// ones with every fourth. Without interpolation the distant entity would move in steps of 0.8 m.
TEST_F(InterestCellsTest, interpolates_entities_with_a_lower_update_rate) {
    snapshot::QuantizedFrame near_before, far_before;
    double near_worst = 0, far_worst = 0, far_least = 1;
    double last_near = 0, last_far = 0;
    for (std::uint32_t tick = 1; tick <= 100; tick++) {
        const double x = 0.2 * tick;
        v1::Snapshot snapshot;
        snapshot.set_frame(tick);
        const auto near = state(tick, {{1, x}}), far = state(tick, {{2, 100 + x}});
        add_cell(snapshot, 7, near, tick > 1 ? &near_before : nullptr);
        if (tick % 4 == 1) {
            add_cell(snapshot, 8, far, tick > 1 ? &far_before : nullptr);
            far_before = far;
        }
        near_before = near;
        ASSERT_TRUE(apply(snapshot).ok());
        EXPECT_NEAR(rendered_frame(tick, 1), x, 0.002)
            << "near entities are rendered without delay";
        if (tick > 20) {
            near_worst = std::max(near_worst, rendered_frame(tick, 1) - last_near);
            far_worst = std::max(far_worst, rendered_frame(tick, 2) - last_far);
            far_least = std::min(far_least, rendered_frame(tick, 2) - last_far);
            EXPECT_NEAR(rendered_frame(tick, 2), 100 + x - 0.6, 0.003) << "delayed by three ticks";
        }
        last_near = rendered_frame(tick, 1);
        last_far = rendered_frame(tick, 2);
    }
    EXPECT_LT(near_worst, 0.204);
    EXPECT_LT(far_worst, 0.204);
    EXPECT_GT(far_least, 0.196);
}

TEST_F(InterestCellsTest, shows_a_woken_entity_immediately) {
    snapshot::QuantizedFrame before;
    std::uint32_t tick = 1;
    const auto tell = [&](double x) {
        v1::Snapshot snapshot;
        snapshot.set_frame(tick);
        const auto now = state(tick, {{1, x}});
        add_cell(snapshot, 7, now, tick > 1 ? &before : nullptr);
        before = now;
        ASSERT_TRUE(apply(snapshot).ok());
    };
    for (; tick < 10; tick++) tell(0.1 * tick);
    for (; tick < 100; tick++) {  // the distant cell is not sent
        v1::Snapshot snapshot;
        snapshot.set_frame(tick);
        ASSERT_TRUE(apply(snapshot).ok());
    }
    tell(1.2);
    EXPECT_NEAR(rendered_frame(tick, 1), 1.2, 0.002);
}

}  // namespace
}  // namespace jostle::client
