// SPDX-License-Identifier: MIT
#include "jostle/client/point_objects.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jostle::client {
namespace {

using snapshot::PointState;
using testing::HasSubstr;

// A strand of two points whose second one moves by 6 mm per state, and a snapshot with its states.
class MovingStrand {
public:
    v1::Snapshot next(std::uint32_t tick, bool is_keyframe = false) {
        v1::Snapshot snapshot;
        if (states_.empty()) {
            v1::PointObject& object = *snapshot.add_point_objects();
            object.set_id(3);
            object.set_form(v1::POINT_FORM_STRANDS);
            object.set_step_um(1000);
            object.set_points(2);
            object.add_strands(2);
        }
        const auto number = static_cast<std::int32_t>(states_.size() + 1);
        states_.push_back({static_cast<std::uint32_t>(number), {0, 0, 0, 6 * number, 0, 0}, {}});
        const snapshot::PointLayout layout{.form = snapshot::PointForm::strands,
                                           .points = 2,
                                           .columns = 0,
                                           .strands = {2},
                                           .triangles = {}};
        const bool is_first = states_.size() == 1 || is_keyframe;
        const snapshot::PointBaselines baselines{is_first ? nullptr : &states_[states_.size() - 2],
                                                 nullptr, nullptr};
        const auto packed = snapshot::encode_points(layout, snapshot::PointOrder(layout),
                                                    states_.back(), baselines);
        v1::PointUpdate& update = *snapshot.add_points();
        update.set_object(3);
        update.set_number(static_cast<std::uint32_t>(number));
        update.set_back(is_first ? 0 : 2);
        update.set_tick(tick);
        update.set_packed(packed.bytes.data(), packed.bytes.size());
        update.set_crc(packed.crc);
        return snapshot;
    }

private:
    std::vector<PointState> states_;
};

v1::ChannelKind every(std::uint32_t divisor) {
    v1::ChannelKind kind;
    kind.set_divisor(divisor);
    return kind;
}

TEST(PointObjects, interpolate_between_states_and_lag_by_their_interval) {
    PointObjects objects;
    objects.begin({every(3)});
    MovingStrand strand;
    for (std::uint32_t k = 0; k < 5; k++) ASSERT_TRUE(objects.apply(strand.next(1 + 3 * k)).ok());
    PointObjectView& view = objects.objects().at(3);
    EXPECT_EQ(view.newest()[1][0], 0.03);
    // Tick 12 shows tick 10, which is the fourth state, at 24 mm.
    EXPECT_NEAR(view.sample(12, 60)[1][0], 0.024, 1e-12);
    EXPECT_NEAR(view.sample(13.5, 60)[1][0], 0.027, 1e-12);
    EXPECT_NEAR(view.sample(15, 60)[1][0], 0.030, 1e-12);
    EXPECT_NEAR(view.sample(18, 60)[1][0], 0.036, 1e-12) << "extrapolated";
    EXPECT_NEAR(view.sample(30, 60)[1][0], 0.036, 1e-12) << "for at most 50 ms";
}

TEST(PointObjects, object_that_rested_moves_only_in_its_last_interval) {
    PointObjects objects;
    objects.begin({every(3)});
    MovingStrand strand;
    for (const std::uint32_t tick : {1u, 4u, 7u, 100u})
        ASSERT_TRUE(objects.apply(strand.next(tick)).ok());
    PointObjectView& view = objects.objects().at(3);
    EXPECT_NEAR(view.sample(90, 60)[1][0], 0.018, 1e-12);
    EXPECT_NEAR(view.sample(99, 60)[1][0], 0.018, 1e-12) << "97 in its own time";
    EXPECT_NEAR(view.sample(100.5, 60)[1][0], 0.021, 1e-12);
}

TEST(PointObjects, need_a_keyframe_after_a_lost_state) {
    PointObjects objects;
    objects.begin({every(1)});
    MovingStrand strand;
    ASSERT_TRUE(objects.apply(strand.next(1)).ok());
    strand.next(2);
    const Status lost = objects.apply(strand.next(3));
    ASSERT_FALSE(lost.ok());
    EXPECT_THAT(lost.error().message, HasSubstr("point object 3: points: state 3 is based on"));
    EXPECT_TRUE(objects.needs_keyframe());
    EXPECT_EQ(objects.objects().at(3).newest()[1][0], 0.006) << "the last valid state stays";
    ASSERT_TRUE(objects.apply(strand.next(4, true)).ok());
    EXPECT_FALSE(objects.needs_keyframe());
}

TEST(PointObjects, end_and_are_limited) {
    PointObjects objects;
    objects.begin({});
    MovingStrand strand;
    ASSERT_TRUE(objects.apply(strand.next(1)).ok());
    v1::Snapshot snapshot;
    snapshot.add_points_ended(3);
    for (std::uint32_t id = 10; id < 13; id++) {
        v1::PointObject& object = *snapshot.add_point_objects();
        object.set_id(id);
        object.set_form(v1::POINT_FORM_GRID);
        object.set_step_um(1000);
        object.set_points(snapshot::points_max);
        object.set_columns(256);
    }
    const Status applied = objects.apply(snapshot);
    ASSERT_FALSE(applied.ok());
    EXPECT_THAT(applied.error().message, HasSubstr("too many objects or points"));
    EXPECT_EQ(objects.objects().size(), 2u);
    v1::Snapshot loose;
    loose.add_point_objects()->set_id(20);
    loose.mutable_point_objects(0)->set_form(v1::POINT_FORM_LOOSE);
    loose.mutable_point_objects(0)->set_step_um(1000);
    const auto packed = snapshot::encode_points({}, {}, {1, {1, 2, 3}, {snapshot::no_point}}, {});
    v1::PointUpdate& update = *loose.add_points();
    update.set_object(20);
    update.set_number(1);
    update.set_packed(packed.bytes.data(), packed.bytes.size());
    update.set_crc(packed.crc);
    EXPECT_THAT(objects.apply(loose).error().message, HasSubstr("too many points"))
        << "loose points count too";
    EXPECT_EQ(objects.objects().size(), 2u);
    v1::Snapshot bad;
    bad.add_point_objects()->set_id(20);
    EXPECT_THAT(objects.apply(bad).error().message, HasSubstr("step 0 um"));
}

}  // namespace
}  // namespace jostle::client
