// SPDX-License-Identifier: MIT
#include "server/messages/attribute_message.h"

#include <gtest/gtest.h>

#include "tests/support/error_of.h"

namespace jostle::server {
namespace {

using test::error_of;

v1::AttributeUpdate update_of(const std::string& bytes) {
    v1::Snapshot fields;
    EXPECT_TRUE(fields.ParseFromString(bytes));
    EXPECT_EQ(fields.attributes_size(), bytes.empty() ? 0 : 1);
    return bytes.empty() ? v1::AttributeUpdate() : fields.attributes(0);
}

TEST(AttributeMessage, every_value_survives_the_way_to_a_client_and_back) {
    const AttributeValue values[] = {true, std::int64_t{-9'000'000'000'000}, 0.1,
                                     std::string("Zo\xc3\xab"), physics::Vec3{1, -2, 3e9}};
    for (const AttributeValue& value : values) {
        v1::AttributeSet set;
        write_target(set, {AttributeTargetKind::entity, 7});
        write_attribute(*set.add_attributes(), "k",
                        {value, AttributeVisibility::roles, 6, /*setter=*/3});
        const Result<SetAttributesCommand> read = to_attribute_changes(set, "set.");
        ASSERT_TRUE(read.ok());
        EXPECT_EQ(read->target, (AttributeTarget{AttributeTargetKind::entity, 7}));
        EXPECT_EQ(read->changes.at(0),
                  (AttributeChange{"k", value, AttributeVisibility::roles, 6}));
        EXPECT_FALSE(set.attributes(0).read_only());
    }
}

TEST(AttributeMessage, a_set_needs_a_target_and_a_known_visibility) {
    v1::AttributeSet set;
    EXPECT_EQ(error_of(to_attribute_changes(set, "set.")).message,
              "set.target is not set; set entity, player, or world to true");
    set.set_world(false);
    EXPECT_FALSE(to_attribute_changes(set, "set.").ok());
    set.set_world(true);
    set.add_attributes()->set_visibility(static_cast<v1::AttributeVisibility>(9));
    EXPECT_EQ(error_of(to_attribute_changes(set, "set.")).message,
              "set.attributes[0].visibility is 9; it must be EVERYONE, OWNER or ROLES");
}

TEST(AttributeMessage, changes_are_split_into_a_shared_and_an_own_part) {
    const AttributeTarget ball{AttributeTargetKind::entity, 7};
    const Attribute all{1.0, AttributeVisibility::everyone, 0, 3},
        own{2.0, AttributeVisibility::owner, 0, 3}, builders{3.0, AttributeVisibility::roles, 8, 3};
    const AttributeChanges changes{.tick = 5,
                                   .changes = {{ball, 3, "a", {}, all},
                                               {ball, 3, "b", all, own},
                                               {ball, 3, "c", own, builders},
                                               {ball, 3, "d", builders, std::nullopt}},
                                   .ended = {{AttributeTargetKind::player, 9}},
                                   .has_owner_only = true};
    const auto keys = [](const v1::AttributeUpdate& update) {
        std::string text;
        for (const v1::AttributeSet& set : update.sets())
            for (const v1::Attribute& attribute : set.attributes())
                text += (attribute.value_case() == v1::Attribute::VALUE_NOT_SET ? "-" : "+") +
                        attribute.key();
        return text;
    };
    const auto shared = [&](PlayerRole role) {
        return update_of(encode_attribute_changes(changes, role));
    };
    EXPECT_EQ(keys(shared(PlayerRole::player)), "+a-b");
    EXPECT_EQ(keys(shared(PlayerRole::builder)), "+a-b+c-d");
    EXPECT_EQ(shared(PlayerRole::player).players_ended(0), 9u);
    EXPECT_EQ(shared(PlayerRole::player).tick(), 5u);
    const auto own_of = [&](ClientId client, PlayerRole role) {
        return keys(update_of(encode_own_attribute_changes(changes, client, role)));
    };
    EXPECT_EQ(own_of(3, PlayerRole::player), "+b-c");
    EXPECT_EQ(own_of(3, PlayerRole::builder), "+b") << "the shared part has c";
    EXPECT_EQ(own_of(4, PlayerRole::player), "");
}

}  // namespace
}  // namespace jostle::server
