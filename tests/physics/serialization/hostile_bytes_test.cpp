// SPDX-License-Identifier: MIT
//
// Saved worlds that were cut, flipped or forged: refused with a reason, or loaded as a world that
// can be run. Nothing crashes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <optional>
#include <tuple>

#include "physics/src/serialization/checksum.h"
#include "tests/support/test_scenes.h"

namespace jostle::test {
namespace {
using namespace physics;
using testing::HasSubstr;

using Bytes = std::vector<std::byte>;
constexpr std::size_t header_bytes = 28;  // mark 8, version 4, length 8, checksum 8

// A world with something of everything: asleep, awake, touching, kinematic, compound.
const Bytes& sample() {
    static const Bytes bytes = [] {
        World world = yard_scene();
        run(world, 2);
        return save(world);
    }();
    return bytes;
}

void set_word(Bytes& bytes, std::size_t at, std::uint64_t word) {
    for (std::size_t k = 0; k < 8; k++) bytes[at + k] = static_cast<std::byte>(word >> (8 * k));
}

// Makes length and checksum of the header right again, as a forger would.
void restamp(Bytes& bytes) {
    const std::size_t size = bytes.size() - header_bytes;
    const auto version = static_cast<std::uint32_t>(word_at(bytes, 8));
    set_word(bytes, 12, size);
    set_word(bytes, 20, checksum_of_version(version, std::span(bytes).subspan(header_bytes)));
}

void expect_refused(const Bytes& bytes, const char* word) {
    const auto world = load(bytes);
    ASSERT_FALSE(world.ok()) << "accepted; expected a complaint about " << word;
    EXPECT_EQ(world.error().code, ErrorCode::corrupt_data);
    EXPECT_THAT(world.error().message, HasSubstr(word));
}

TEST(HostileBytes, valid_world_with_recomputed_checksum_loads) {
    Bytes bytes = sample();
    restamp(bytes);
    EXPECT_EQ(bytes, sample());  // or the forgeries below would test the checksum alone
    EXPECT_TRUE(load(bytes).ok());
}

TEST(HostileBytes, every_truncation_is_rejected) {
    for (std::size_t size = 0; size < sample().size(); size += size < 64 ? 1 : 97) {
        const Bytes cut(sample().begin(), sample().begin() + static_cast<std::ptrdiff_t>(size));
        const auto world = load(cut);
        ASSERT_FALSE(world.ok()) << size << " bytes";
        EXPECT_EQ(world.error().code, ErrorCode::corrupt_data);
        EXPECT_FALSE(world.error().message.empty());
    }
}

TEST(HostileBytes, forged_truncation_error_names_the_missing_field) {
    for (std::size_t size = header_bytes; size < sample().size(); size += 211) {
        Bytes cut(sample().begin(), sample().begin() + static_cast<std::ptrdiff_t>(size));
        restamp(cut);
        expect_refused(cut, "byte");
    }
    Bytes longer = sample();
    longer.resize(longer.size() + 5);
    restamp(longer);
    expect_refused(longer, "remain after the last field");
}

TEST(HostileBytes, header_errors_name_the_problem) {
    expect_refused({}, "header");
    Bytes bytes = sample();
    bytes[0] ^= std::byte{1};
    expect_refused(bytes, "magic number");
    bytes = sample();
    bytes[8] ^= std::byte{64};
    expect_refused(bytes, "version");
    bytes = sample();
    bytes[12] ^= std::byte{1};
    expect_refused(bytes, "bytes follow");
    bytes = sample();
    bytes.back() ^= std::byte{128};
    expect_refused(bytes, "checksum");
}

// A joint's numbers and vectors are within the ranges that create_joint() holds them to.
TEST(HostileBytes, rejects_out_of_range_joints_by_field_name) {
    World world = make_world();
    const BodyId floor = add_floor(world), box = add(world, {.position = {0, 3, 0}});
    must(world.create_joint(
        {.body_a = floor, .body_b = box, .kind = HingeJoint{.motor = {true, 1, 123.4375}}}));
    must(world.create_joint(
        {.body_a = floor, .body_b = box, .kind = VelocityRow{.linear_b = {0, 345.6875, 0}}}));
    const struct {
        double value;
        const char* name;
    } fields[] = {{123.4375, "max_torque"}, {345.6875, "linear_b.y"}};
    for (const auto& [value, name] : fields) {
        Bytes bytes = save(world);
        std::uint64_t written = 0, forged = 0;
        const double bad = -1e13;
        std::memcpy(&written, &value, 8);
        std::memcpy(&forged, &bad, 8);
        int found = 0;
        for (std::size_t at = header_bytes; at + 8 <= bytes.size(); at++)
            if (word_at(bytes, at) == written) set_word(bytes, at, forged), found++;
        ASSERT_EQ(found, 1) << name;
        restamp(bytes);
        expect_refused(bytes, name);
    }
}

// The byte after a number that is there once.
std::size_t after(const Bytes& bytes, std::uint64_t word) {
    std::size_t found = 0;
    for (std::size_t at = header_bytes; at + 8 <= bytes.size(); at++)
        if (word_at(bytes, at) == word) found = at + 8;
    return found;
}

// A forged tolerance, as wide as it likes or negative, is refused by name.
TEST(HostileBytes, rejects_out_of_range_tolerances) {
    constexpr double tolerance = 0.0123456789;
    const Bytes bytes = save(make_world({.tolerance = tolerance}));
    std::uint64_t bits = 0;
    std::memcpy(&bits, &tolerance, 8);
    const std::size_t at = after(bytes, bits) - 8;
    for (const double forged : {-0.01, 1e-10, 1e4}) {
        Bytes other = bytes;
        std::memcpy(other.data() + at, &forged, 8);
        restamp(other);
        expect_refused(other, "world.tolerance");
    }
}

// How joints are solved stands behind hit_speed and behind a joint's user data: worlds of version
// 13 lack it and are read, and a number that is no solver is refused by name.
TEST(HostileBytes, joint_solvers_are_validated_and_absent_in_older_worlds) {
    constexpr double speed = 321.4375;
    constexpr std::uint64_t data = 0x123456789abcdef1;
    World world = make_world({.hit_speed = speed, .joint_solver = JointSolver::iterative});
    const BodyId box = add(world, {.position = {0, 3, 0}});
    const JointId joint =
        must(world.create_joint({.body_b = box, .user_data = data, .solver = JointSolver::direct}));
    const Bytes bytes = save(world);
    std::uint64_t speed_bits = 0;
    std::memcpy(&speed_bits, &speed, 8);
    const std::size_t of_world = after(bytes, speed_bits), of_joint = after(bytes, data);
    ASSERT_EQ(bytes[of_world], std::byte{1});
    ASSERT_EQ(bytes[of_joint], std::byte{3});
    const World loaded = must(load(bytes));
    EXPECT_EQ(loaded.joint_solver(), JointSolver::iterative);
    EXPECT_EQ(must(loaded.joint(joint)).def.solver, JointSolver::direct);
    for (const auto& [at, value, name] :
         {std::tuple{of_world, 3, "world.joint_solver"}, {of_joint, 4, "joints[0].solver"}}) {
        Bytes forged = bytes;
        forged[at] = static_cast<std::byte>(value);
        restamp(forged);
        expect_refused(forged, name);
    }
    // Behind it, the tolerance and the budget of sub-steps stand what version 15 brought: the
    // step's budget and two bytes of strain; then 16 bytes of steps, the stiffness of version
    // 18, the byte of version 19 and the limit of version 20.
    Bytes older = bytes;
    older.erase(older.begin() + static_cast<std::ptrdiff_t>(of_joint));
    const auto world_at = older.begin() + static_cast<std::ptrdiff_t>(of_world);
    older.erase(world_at + 43, world_at + 56);
    older.erase(world_at + 17, world_at + 27);
    older.erase(world_at);
    older[8] = std::byte{13};
    restamp(older);
    const World old = must(load(older));
    EXPECT_EQ(old.joint_solver(), JointSolver::automatic);
    EXPECT_EQ(must(old.joint(joint)).def.solver, std::nullopt);
    World silent = make_world({.hit_speed = speed});
    must(silent.create_joint({.body_b = add(silent, {.position = {0, 3, 0}}), .user_data = data}));
    EXPECT_EQ(state_hash(old), state_hash(silent)) << "and the hash that it had";
    EXPECT_NE(state_hash(loaded), state_hash(silent));
}

TEST(HostileBytes, overload_level_is_validated) {
    constexpr std::int64_t budget = 0x76543210;
    World world = make_world({.step_budget = budget});
    add(world, {.position = {0, 3, 0}});
    const Bytes bytes = save(world);
    const std::size_t overload_level = after(bytes, static_cast<std::uint64_t>(budget));
    for (const auto& [value, refused] : {std::tuple{3, false}, {4, true}}) {
        Bytes forged = bytes;
        forged[overload_level] = static_cast<std::byte>(value);
        restamp(forged);
        if (refused)
            expect_refused(forged, "world.overload_level");
        else
            EXPECT_EQ(must(load(forged)).overload_level(), value);
    }
}

TEST(HostileBytes, every_flipped_bit_is_detected) {
    Random random(1);
    for (int i = 0; i < 1000; i++) {
        Bytes bytes = sample();
        bytes[random.below(bytes.size())] ^= static_cast<std::byte>(1u << random.below(8));
        ASSERT_FALSE(load(bytes).ok()) << "flip " << i;
    }
}

// With a right checksum, what is inside must stand on its own: either it is refused, or it is a
// world that runs.
TEST(HostileBytes, forged_fields_are_rejected_or_harmless) {
    Random random(2);
    int accepted = 0, refused = 0;
    for (int i = 0; i < 3000; i++) {
        Bytes bytes = sample();
        const int changes = 1 + static_cast<int>(random.below(3));
        for (int k = 0; k < changes; k++) {
            const std::size_t at = header_bytes + random.below(bytes.size() - header_bytes - 8);
            switch (random.below(5)) {
                case 0:
                    bytes[at] ^= static_cast<std::byte>(1u << random.below(8));
                    break;
                case 1:
                    bytes[at] = static_cast<std::byte>(random.bits());
                    break;
                case 2:
                    set_word(bytes, at, random.bits());
                    break;
                case 3:
                    set_word(bytes, at, random.below(2) == 0 ? 0 : ~0ull);
                    break;
                case 4:
                    std::memmove(&bytes[at], &bytes[header_bytes + random.below(bytes.size() / 2)],
                                 8);
                    break;
            }
        }
        restamp(bytes);
        auto world = load(bytes);
        if (!world.ok()) {
            refused++;
            ASSERT_EQ(world.error().code, ErrorCode::corrupt_data);
            ASSERT_FALSE(world.error().message.empty());
            continue;
        }
        accepted++;
        for (int step = 0; step < 3; step++) must(world->step(1.0 / 60));
        std::vector<BodyState> bodies;
        world->copy_bodies(bodies);
    }
    RecordProperty("accepted", accepted);
    RecordProperty("refused", refused);
    EXPECT_GT(refused, 500);
}

TEST(HostileBytes, random_bytes_are_rejected) {
    Random random(3);
    for (int i = 0; i < 500; i++) {
        Bytes bytes(random.below(400));
        for (std::byte& b : bytes) b = static_cast<std::byte>(random.bits());
        ASSERT_FALSE(load(bytes).ok());
        if (bytes.size() < header_bytes) continue;
        std::memcpy(bytes.data(), sample().data(), header_bytes);
        restamp(bytes);
        ASSERT_FALSE(load(bytes).ok());
    }
}

}  // namespace
}  // namespace jostle::test
