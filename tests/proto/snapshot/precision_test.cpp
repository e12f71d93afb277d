// SPDX-License-Identifier: MIT
//
// Every decoded pose is within the precision, and even motion costs few corrections.
#include "jostle/snapshot/precision.h"

#include <gtest/gtest.h>

#include <cmath>

#include "jostle/snapshot/frame_codec.h"
#include "tests/proto/snapshot/motion.h"

namespace jostle::snapshot {
namespace {

Pose turned(double x, double angle) {
    return {{x, 2 * x, -x},
            {std::sin(angle / 2) * 0.6, std::sin(angle / 2) * 0.8, 0, std::cos(angle / 2)}};
}

// Sends the poses of one body, one frame per tick; each frame is decoded by a client.
struct Stream {
    explicit Stream(Precision wanted) : precision(wanted), spec(quant_spec_for(wanted)) {}

    void send(const Pose& pose, bool at_rest = false) {
        SentMotion sent{.last = nullptr, .before_last = nullptr, .last_pose = nullptr};
        if (!frames.empty()) {
            sent.last = &frames.back().entities[0];
            sent.last_pose = &last_pose;
        }
        if (frames.size() > 1) sent.before_last = &frames[frames.size() - 2].entities[0];
        QuantizedFrame frame{.frame = static_cast<std::uint32_t>(frames.size() + 1)};
        frame.entities = {quantize_within(precision, 1, pose, at_rest, sent, spec)};
        const auto before = [&](std::size_t k) {
            return frames.size() < k ? nullptr : &frames[frames.size() - k];
        };
        const Baselines baselines{before(1), before(2), before(3)};
        const auto packed = encode_frame(frame, baselines, spec, Codec::range);
        const auto decoded =
            decode_frame(frame.frame, packed, baselines, spec, default_entities_max, Codec::range);
        ASSERT_TRUE(decoded.ok()) << decoded.error().message;
        EXPECT_EQ(*decoded, frame);
        EXPECT_TRUE(is_within(precision, decoded->entities[0], pose, spec)) << frame.frame;
        if (sent.before_last) {
            const Prediction p = predict(*sent.last, sent.before_last, nullptr, sent.spacing, spec);
            const EntityState& now = frame.entities[0];
            for (std::size_t k = 0; k < 3; k++) {
                corrections += now.position[k] != p.position[k] ? 1 : 0;
                corrections += now.rotation[k] != p.components[k] ? 1 : 0;
            }
        }
        frames.push_back(*decoded);
        last_pose = pose;
    }

    Precision precision;
    QuantSpec spec;
    std::vector<QuantizedFrame> frames;
    Pose last_pose;
    int corrections = 0;  // numbers that differ from their prediction
};

TEST(Precision, each_pose_of_random_motion_is_within_it) {
    for (const Precision precision :
         {Precision{1e-4, 2e-4}, {0.01, 0.001}, {0.05, 0.02}, {1, 0.5}}) {
        Stream stream(precision);
        Random random(11);
        double x = 0, angle = 0, speed = 0, spin = 0;
        for (int frame = 0; frame < 600; frame++) {
            if (frame % 40 == 0) speed = random.in(-0.2, 0.2), spin = random.in(-0.4, 0.4);
            x += speed + random.in(-1e-3, 1e-3);
            angle += spin + random.in(-1e-3, 1e-3);
            ASSERT_NO_FATAL_FAILURE(stream.send(turned(x, angle)));
        }
    }
}

TEST(Precision, even_motion_needs_fewer_than_one_correction_in_ten_numbers) {
    Stream stream({0.01, 0.001});
    for (int frame = 0; frame < 600; frame++)
        ASSERT_NO_FATAL_FAILURE(stream.send(turned(0.0987 * frame, 0.0123 * frame)));
    EXPECT_LT(stream.corrections, 600 * 6 / 10);
}

TEST(Precision, rounding_to_the_nearest_unit_needs_corrections_of_a_quarter_of_them) {
    // The same motion and units, without the choice that the precision allows.
    const QuantSpec spec{.units_per_meter = 100, .rotation_component = 2450};
    std::vector<EntityState> states;
    int corrections = 0;
    for (int frame = 0; frame < 600; frame++) {
        states.push_back(quantize(1, turned(0.0987 * frame, 0.0123 * frame), false, spec));
        if (states.size() < 3) continue;
        const Prediction p =
            predict(states[states.size() - 2], &states[states.size() - 3], nullptr, {}, spec);
        for (std::size_t k = 0; k < 3; k++) {
            corrections += states.back().position[k] != p.position[k] ? 1 : 0;
            corrections += states.back().rotation[k] != p.components[k] ? 1 : 0;
        }
    }
    EXPECT_GT(corrections, 600 * 6 / 4);
}

TEST(Precision, a_body_that_stops_does_not_creep) {
    Stream stream({0.01, 0.001});
    for (int frame = 0; frame < 50; frame++)
        ASSERT_NO_FATAL_FAILURE(stream.send(turned(0.0987 * frame, 0.0123 * frame)));
    for (int frame = 0; frame < 20; frame++)
        ASSERT_NO_FATAL_FAILURE(stream.send(turned(0.0987 * 49, 0.0123 * 49), frame > 10));
    for (std::size_t k = stream.frames.size() - 19; k < stream.frames.size(); k++)
        EXPECT_TRUE(same_pose(stream.frames[k].entities[0], stream.frames[k - 1].entities[0]));
}

TEST(Precision, an_invalid_value_is_refused_with_its_name_and_range) {
    EXPECT_TRUE(check({}, "hello.precision.").ok());
    EXPECT_TRUE(check({0.01, 0.001}, "hello.precision.").ok());
    EXPECT_EQ(check({0.00001, 0.001}, "hello.precision.").error().message,
              "hello.precision.position is 1e-05; it must be from 0.0001 to 1 m");
    EXPECT_EQ(check({0.01, 0}, "hello.precision.").error().message,
              "hello.precision.rotation is 0; it must be from 0.0002 to 0.5 rad");
    EXPECT_FALSE(check({NAN, 0.001}, "").ok());
    EXPECT_FALSE(check({0.01, INFINITY}, "").ok());
}

TEST(Precision, is_rounded_down_to_a_series) {
    EXPECT_EQ(rounded_down({0.01, 0.001}), (Precision{0.01, 0.001}));
    EXPECT_DOUBLE_EQ(rounded_down({0.0499, 0.0199}).position_m, 0.02);
    EXPECT_DOUBLE_EQ(rounded_down({0.0499, 0.0199}).rotation_rad, 0.01);
    EXPECT_EQ(quant_spec_for({}), QuantSpec{});
}

}  // namespace
}  // namespace jostle::snapshot
