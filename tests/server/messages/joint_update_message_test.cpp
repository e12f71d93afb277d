// SPDX-License-Identifier: MIT
#include "server/messages/joint_update_message.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "jostle/v1/play.pb.h"

namespace jostle::server {
namespace {

using namespace physics;

std::shared_ptr<const JointDescription> joint(std::uint32_t id, EntityId a, EntityId b,
                                              const JointDef& def = {}) {
    return std::make_shared<const JointDescription>(JointDescription{id, a, b, def});
}

JointDef def(Vec3 at_a, Vec3 at_b, const JointKind& kind = BallJoint{}) {
    return {.frame_a = {.position = at_a}, .frame_b = {.position = at_b}, .kind = kind};
}

// All fields of the change; null `from`: the client's list is unknown.
std::vector<SharedBytes> fields_of(const JointList* from, const JointList& to) {
    JointListChange change(from ? std::make_shared<const JointList>(*from) : nullptr,
                           std::make_shared<const JointList>(to));
    std::vector<SharedBytes> fields;
    for (bool is_last = false; !is_last;) {
        const auto field = change.field(fields.size());
        if (field.bytes) fields.push_back(field.bytes);
        is_last = field.is_last;
    }
    EXPECT_EQ(change.field(fields.size()).bytes, nullptr);
    return fields;
}

v1::JointUpdate parsed(const SharedBytes& field) {
    v1::Snapshot snapshot;
    EXPECT_TRUE(snapshot.ParseFromString(*field));
    return snapshot.joints();
}

// Chain of three links that hangs from the world, and a motor; then a link breaks and a rope is
// added. proto/golden_joints.txt has the bytes.
JointList golden_before() {
    JointDef hinge = def({1, 2, 3}, {});
    hinge.frame_b.rotation = {0, std::numbers::sqrt2 / 2, 0, std::numbers::sqrt2 / 2};
    hinge.kind = HingeJoint{.limit = {true, -1, 0.5}, .motor = {true, 2, 10}};
    return {joint(1, 0, 2, def({0, 4, 0}, {0, 0.5, 0})),
            joint(2, 2, 3, def({0, -0.5, 0}, {0, 0.5, 0})),
            joint(3, 3, 4, def({0, -0.5, 0}, {-0.0, 0.5, 0.000001})), joint(4, 1, 5, hinge)};
}
JointList golden_after(const JointList& before) {
    return {before[0], before[1], before[3],
            joint(5, 4, 5, def({}, {0.25, 0, 0}, DistanceJoint{.min_length = 0, .max_length = 3}))};
}

std::string hex(const std::string& bytes) {
    std::string text;
    for (const char c : bytes) {
        text += "0123456789abcdef"[static_cast<unsigned char>(c) / 16];
        text += "0123456789abcdef"[static_cast<unsigned char>(c) % 16];
    }
    return text;
}

TEST(JointUpdateMessage, matches_the_golden_bytes) {
    std::ifstream in(GOLDEN_JOINTS);
    std::vector<std::string> expected;
    for (std::string line; std::getline(in, line);)
        if (line.starts_with("update ")) expected.push_back(line.substr(7));
    const JointList before = golden_before(), after = golden_after(before);
    std::vector<std::string> encoded;
    for (const auto& fields : {fields_of(nullptr, before), fields_of(&before, after)})
        for (const SharedBytes& field : fields) encoded.push_back(hex(*field));
    EXPECT_EQ(encoded, expected);
}

TEST(JointUpdateMessage, equal_joints_share_a_form) {
    JointList chain;
    for (std::uint32_t id = 1; id <= 500; id++)
        chain.push_back(joint(id, id, id + 1, def({0, -0.5, 0}, {0, 0.5, 0})));
    const auto fields = fields_of(nullptr, chain);
    ASSERT_EQ(fields.size(), 1u);
    EXPECT_EQ(parsed(fields[0]).forms_size(), 1);
    EXPECT_EQ(parsed(fields[0]).added_size(), 500);
    EXPECT_LT(fields[0]->size(), 6000u) << "at most 12 bytes per joint";
}

TEST(JointUpdateMessage, is_empty_for_equal_lists_unless_the_client_has_none) {
    const JointList list = golden_before();
    EXPECT_TRUE(fields_of(&list, list).empty());
    const auto none = fields_of(nullptr, {});
    ASSERT_EQ(none.size(), 1u);
    EXPECT_TRUE(parsed(none[0]).complete());
}

TEST(JointUpdateMessage, replaces_joints_of_another_registry_with_the_same_ids) {
    const JointList before = golden_before(), other = golden_before();
    const v1::JointUpdate update = parsed(fields_of(&before, other).at(0));
    EXPECT_EQ(update.removed_size(), 4);
    EXPECT_EQ(update.added_size(), 4);
}

TEST(JointUpdateMessage, splits_100_000_joints_over_snapshots) {
    JointList list;
    for (std::uint32_t id = 1; id <= 100000; id++)
        list.push_back(joint(id, 0, id, def({std::sin(id), 0, 0}, {})));
    const auto fields = fields_of(nullptr, list);
    int added = 0;
    for (const SharedBytes& field : fields) {
        EXPECT_LT(field->size(), 80u << 10);
        EXPECT_EQ(parsed(field).complete(), field == fields.front());
        added += parsed(field).added_size();
    }
    EXPECT_EQ(added, 100000);
}

// A client that is late must not make the others wait: one field is encoded at a time.
TEST(JointUpdateMessage, encodes_a_field_when_it_is_needed) {
    auto list = std::make_shared<JointList>();
    for (std::uint32_t id = 1; id <= 20000; id++)
        list->push_back(joint(id, 0, id, def({std::sin(id), 0, 0}, {})));
    JointListChange change(nullptr, list);
    const auto first = change.field(0);
    EXPECT_FALSE(first.is_last);
    EXPECT_EQ(change.field(0).bytes, first.bytes) << "clients share it";
    EXPECT_NE(change.field(1).bytes, first.bytes);
}

TEST(JointUpdateMessage, removes_before_it_adds_over_all_fields) {
    JointList before, after;
    for (std::uint32_t id = 1; id <= 40000; id++) {
        if (id <= 20000) before.push_back(joint(id, 0, id));
        if (id > 20000) after.push_back(joint(id, 0, id));
    }
    const auto fields = fields_of(&before, after);
    ASSERT_GT(fields.size(), 2u);
    int removed = 0;
    bool adds = false;
    for (const SharedBytes& field : fields) {
        const v1::JointUpdate update = parsed(field);
        EXPECT_FALSE(adds && update.removed_size() > 0);
        adds = adds || update.added_size() > 0;
        removed += update.removed_size();
    }
    EXPECT_EQ(removed, 20000);
}

}  // namespace
}  // namespace jostle::server
