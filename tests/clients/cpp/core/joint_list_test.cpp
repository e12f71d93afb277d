// SPDX-License-Identifier: MIT
#include "jostle/client/joint_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

namespace jostle::client {
namespace {

using testing::HasSubstr;

v1::JointUpdate update_of(std::uint32_t id, std::uint32_t a, std::uint32_t b,
                          std::uint32_t form = 0) {
    v1::JointUpdate update;
    update.add_forms()->mutable_ball();
    v1::JointInfo& joint = *update.add_added();
    joint.set_id(id);
    joint.set_entity_a(a);
    joint.set_entity_b(b);
    joint.set_form(form);
    return update;
}

std::string from_hex(const std::string& text) {
    std::string bytes;
    for (std::size_t k = 0; k + 1 < text.size(); k += 2)
        bytes += static_cast<char>(std::stoi(text.substr(k, 2), nullptr, 16));
    return bytes;
}

// The same file as for the TypeScript client.
TEST(JointList, decodes_the_golden_updates) {
    std::ifstream in(GOLDEN_JOINTS);
    JointList list;
    std::vector<std::string> expected, actual;
    int updates = 0;
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with("joint ")) {
            expected.push_back(line);
            continue;
        }
        v1::Snapshot snapshot;
        ASSERT_TRUE(snapshot.ParseFromString(from_hex(line.substr(7))));
        ASSERT_TRUE(list.apply(snapshot.joints()).ok());
        updates++;
        for (const auto& [id, joint] : list.joints()) {
            const auto* kind = joint.form->GetReflection()->GetOneofFieldDescriptor(
                *joint.form, joint.form->GetDescriptor()->FindOneofByName("kind"));
            std::ostringstream text;
            text << "joint " << id << ' ' << joint.entity_a << ' ' << joint.entity_b << ' '
                 << kind->name();
            actual.push_back(text.str());
        }
    }
    EXPECT_EQ(updates, 2);
    EXPECT_EQ(actual, expected);
}

TEST(JointList, rejects_malformed_updates_and_keeps_its_joints) {
    JointList list;
    ASSERT_TRUE(list.apply(update_of(1, 0, 5)).ok());
    const auto error_of = [&](v1::JointUpdate update) {
        update.set_complete(true);
        return list.apply(update).error().message;
    };
    EXPECT_THAT(error_of(update_of(0, 1, 2)), HasSubstr("joint 0: the id must not be 0"));
    EXPECT_THAT(error_of(update_of(7, 1, 0)), HasSubstr("entity_b must not be 0"));
    EXPECT_THAT(error_of(update_of(7, 3, 3)), HasSubstr("entity_a and entity_b are both 3"));
    EXPECT_THAT(error_of(update_of(7, 3, 4, 1)), HasSubstr("form 1 does not exist; there are 1"));
    EXPECT_EQ(list.joints().size(), 1u);
}

TEST(JointList, limits_the_number_of_joints) {
    JointList list;
    v1::JointUpdate update = update_of(1, 0, 5);
    for (std::size_t k = 0; k < joints_max; k++) *update.add_added() = update.added(0);
    EXPECT_THAT(list.apply(update).error().message, HasSubstr("at most 1048576 are allowed"));
    EXPECT_TRUE(list.joints().empty());
}

}  // namespace
}  // namespace jostle::client
