// SPDX-License-Identifier: MIT
//
// Points of point objects: decoding restores every coordinate, coarse levels approximate the
// object, and malformed bytes are rejected with a reason.
#include "jostle/snapshot/point_codec.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "jostle/snapshot/point_history.h"
#include "tests/proto/snapshot/golden_points.h"

namespace jostle::snapshot {
namespace {

using testing::HasSubstr;

PointHistory history_of(const PointLayout& layout) {
    Result<PointHistory> made = PointHistory::create(layout);
    EXPECT_TRUE(made.ok()) << made.error().message;
    return *std::move(made);
}

// A sheet that hangs in folds of 0.8 m, 6 cm between its points, in mm.
std::vector<std::int32_t> folded_sheet(std::uint32_t columns, std::uint32_t rows) {
    std::vector<std::int32_t> values;
    for (std::uint32_t row = 0; row < rows; row++)
        for (std::uint32_t column = 0; column < columns; column++) {
            const auto x = static_cast<std::int32_t>(60 * column), phase = x % 800 - 400;
            values.insert(values.end(),
                          {x, -60 * static_cast<std::int32_t>(row), phase * phase / 1600});
        }
    return values;
}

TEST(PointCodec, round_trips_every_form_with_refinements_and_keyframes) {
    for (const GoldenPoints& object : golden_points()) {
        PointHistory history = history_of(object.layout);
        for (const PointUpdate& update : object.updates) {
            const Status added =
                history.add(update.number, 7, update.back, update.packed.bytes, update.packed.crc);
            ASSERT_TRUE(added.ok()) << object.name << ": " << added.error().message;
            const DecodedPoints& points = history.states().back().points;
            ASSERT_EQ(points.state.values, update.state.values)
                << object.name << ", state " << update.number;
            EXPECT_EQ(points.levels, update.levels);
        }
    }
}

TEST(PointCodec, golden_file_is_unchanged) {
    std::ifstream in(GOLDEN_FOLDER "/points.jpnt", std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(in)), {});
    const std::vector<std::byte> made = golden_point_file();
    ASSERT_EQ(bytes.size(), made.size());
    EXPECT_TRUE(std::equal(bytes.begin(), bytes.end(), made.begin(),
                           [](char a, std::byte b) { return static_cast<std::byte>(a) == b; }));
}

TEST(PointCodec, resting_points_cost_a_hundredth_of_a_bit_each) {
    const PointLayout layout = grid_layout(PointForm::grid, 50, 50);
    const PointOrder order(layout);
    const PointState before{1, folded_sheet(50, 50), {}}, now{2, before.values, {}};
    const PackedPoints packed = encode_points(layout, order, now, {&before, nullptr, nullptr});
    EXPECT_LT(packed.bytes.size(), 50u * 50 * 3 / 100);
}

TEST(PointCodec, uniform_motion_is_predicted_and_costs_nothing) {
    const PointLayout layout = strand_layout({200});
    const PointOrder order(layout);
    std::vector<PointState> states;
    for (std::uint32_t number = 1; number <= 3; number++) {
        PointState state{number, {}, {}};
        for (std::int32_t k = 0; k < 600; k++)
            state.values.push_back(100 * k + 37 * static_cast<std::int32_t>(number));
        states.push_back(std::move(state));
    }
    const std::size_t still =
        encode_points(layout, order, {3, states[1].values, {}}, {&states[1], nullptr, nullptr})
            .bytes.size();
    EXPECT_LE(
        encode_points(layout, order, states[2], {&states[1], &states[0], nullptr}).bytes.size(),
        still + 2);
}

TEST(PointCodec, coarse_levels_of_a_sheet_are_small_and_close) {
    const PointLayout layout = grid_layout(PointForm::grid, 65, 65);
    const PointOrder order(layout);
    const PointState full{1, folded_sheet(65, 65), {}};
    const std::size_t full_bytes = encode_points(layout, order, full, {}).bytes.size();
    double share = 1.1;
    constexpr double error_mm = 40;
    for (std::size_t levels = point_levels; levels >= 2; levels--) {
        PointState coarse = full;
        coarse_points(layout, order, coarse.values, levels);
        const PackedPoints packed = encode_points(layout, order, coarse, {}, levels);
        EXPECT_LT(static_cast<double>(packed.bytes.size()), share * static_cast<double>(full_bytes))
            << levels;
        share *= 0.6;
        double most = 0;
        for (std::size_t k = 0; k < full.values.size(); k++)
            most = std::max(most, std::abs(static_cast<double>(coarse.values[k] - full.values[k])));
        EXPECT_LE(most, error_mm) << levels;
    }
}

TEST(PointCodec, sizes_of_coarse_levels_are_known_from_the_complete_encoding) {
    const PointLayout layout = grid_layout(PointForm::grid, 65, 65);
    const PointOrder order(layout);
    const PointState full{1, folded_sheet(65, 65), {}};
    const PackedPoints packed = encode_points(layout, order, full, {});
    for (std::size_t levels = 1; levels < point_levels; levels++) {
        PointState coarse = full;
        coarse_points(layout, order, coarse.values, levels);
        const double bytes =
            static_cast<double>(encode_points(layout, order, coarse, {}, levels).bytes.size());
        EXPECT_NEAR(static_cast<double>(packed.bytes_of_levels[levels - 1]), bytes,
                    0.2 * bytes + 8);
    }
    PointState loose{1, {}, std::vector<std::uint32_t>(64, no_point)};
    for (std::int32_t k = 0; k < 192; k++) loose.values.push_back(k * k % 1000);
    const PackedPoints all = encode_points({}, {}, loose, {});
    EXPECT_EQ(all.bytes_of_levels[1], all.bytes.size() / 4) << "a quarter of the points";
}

TEST(PointCodec, holds_65536_loose_points_and_rejects_one_more) {
    const PointLayout loose;
    PointState state{1, {}, std::vector<std::uint32_t>(points_max, no_point)};
    for (std::size_t k = 0; k < 3 * points_max; k++)
        state.values.push_back(static_cast<std::int32_t>(k % 1000));
    const PackedPoints packed = encode_points(loose, {}, state, {});
    const auto read = read_points(loose, {}, 1, packed.bytes, {});
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(read->state.values, state.values);
    state.previous.push_back(no_point);
    state.values.insert(state.values.end(), {1, 2, 3});
    const auto too_many = read_points(loose, {}, 1, encode_points(loose, {}, state, {}).bytes, {});
    ASSERT_FALSE(too_many.ok());
    EXPECT_THAT(too_many.error().message, HasSubstr("more points than the limit"));
}

TEST(PointCodec, rejects_flipped_bits_and_missing_bytes) {
    for (const GoldenPoints& object : golden_points()) {
        const PointUpdate& update = object.updates.front();
        std::vector<std::byte> bytes = update.packed.bytes;
        for (std::size_t bit = 0; bit < 8 * bytes.size(); bit++) {
            PointHistory history = history_of(object.layout);
            bytes[bit / 8] ^= static_cast<std::byte>(1 << bit % 8);
            const Status added = history.add(update.number, 1, 0, bytes, update.packed.crc);
            bytes[bit / 8] ^= static_cast<std::byte>(1 << bit % 8);
            if (added.ok())  // the last bits of the last byte may be redundant
                EXPECT_EQ(history.states().back().points.state.values, update.state.values);
            else
                EXPECT_THAT(added.error().message, HasSubstr("points: "));
        }
        for (std::size_t size = 0; size + 5 < bytes.size(); size++) {
            PointHistory history = history_of(object.layout);
            EXPECT_FALSE(
                history.add(update.number, 1, 0, std::span(bytes).first(size), update.packed.crc)
                    .ok());
        }
    }
}

TEST(PointHistory, rejects_a_state_whose_baseline_it_does_not_have) {
    const std::vector<GoldenPoints> objects = golden_points();
    const std::vector<PointUpdate>& updates = objects[2].updates;
    PointHistory history = history_of(objects[2].layout);
    const PointUpdate& second = updates[4];
    const Status early =
        history.add(second.number, 1, second.back, second.packed.bytes, second.packed.crc);
    ASSERT_FALSE(early.ok());
    EXPECT_THAT(early.error().message, HasSubstr("the newest known one is 0"));
    EXPECT_TRUE(history.states().empty());
}

TEST(PointHistory, keeps_eight_states_for_rendering) {
    MovingPointObject moving(5, strand_layout({9}));
    PointHistory history = history_of(moving.layout());
    for (std::uint32_t k = 0; k < 30; k++) {
        const PointUpdate update = moving.next(k == 0);
        ASSERT_TRUE(
            history.add(update.number, 3 * k, update.back, update.packed.bytes, update.packed.crc)
                .ok());
    }
    EXPECT_EQ(history.states().size(), PointHistory::states_max);
    EXPECT_EQ(history.states().back().tick, 87u);
}

TEST(PointLayout, rejects_what_no_object_has) {
    const auto reason = [](const PointLayout& layout) {
        const Status checked = check_layout(layout);
        return checked.ok() ? std::string() : checked.error().message;
    };
    EXPECT_THAT(reason({.form = static_cast<PointForm>(9)}), HasSubstr("unknown form 9"));
    EXPECT_THAT(reason({.form = PointForm::grid}), HasSubstr("no points"));
    EXPECT_THAT(reason(grid_layout(PointForm::grid, 400, 400)), HasSubstr("160000 points"));
    PointLayout ragged = grid_layout(PointForm::grid, 7, 3);
    ragged.points = 20;
    EXPECT_THAT(reason(ragged), HasSubstr("7 columns do not divide 20 points"));
    PointLayout short_strands = strand_layout({4, 4});
    short_strands.points = 9;
    EXPECT_THAT(reason(short_strands), HasSubstr("strands have 8 points"));
    EXPECT_THAT(reason(strand_layout({4, 0})), HasSubstr("empty strand"));
    PointLayout mesh = mesh_layout(3, 3);
    mesh.triangles.back() = 10;
    EXPECT_THAT(reason(mesh), HasSubstr("corner 10"));
    mesh.triangles.pop_back();
    EXPECT_THAT(reason(mesh), HasSubstr("incomplete triangle"));
    PointLayout mixed = strand_layout({4});
    mixed.columns = 2;
    EXPECT_THAT(reason(mixed), HasSubstr("fields of another form"));
    EXPECT_EQ(reason({}), "");
}

TEST(PointOrder, codes_every_point_once_after_its_sources) {
    for (const PointLayout& layout :
         {strand_layout({1, 2, 3, 8, 9, 10, 64, 65}), grid_layout(PointForm::grid, 1, 9),
          grid_layout(PointForm::grid, 22, 13), mesh_layout(14, 9)}) {
        const PointOrder order(layout);
        std::vector<bool> coded(layout.points);
        std::size_t count = 0;
        for (std::size_t level = 0; level < point_levels; level++)
            for (const PointPredictor& point : order.level(level)) {
                std::int32_t sum = 0;
                for (std::uint32_t k = 0; k < point.sources; k++) {
                    EXPECT_TRUE(coded[point.from[k]]);
                    sum += point.weight[k];
                }
                EXPECT_TRUE(sum == 16 || point.sources == 0);
                EXPECT_FALSE(coded[point.point]);
                coded[point.point] = true;
                count++;
            }
        EXPECT_EQ(count, layout.points);
    }
}

}  // namespace
}  // namespace jostle::snapshot
