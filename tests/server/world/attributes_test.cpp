// SPDX-License-Identifier: MIT
#include "server/world/attributes.h"

#include <gtest/gtest.h>

#include "tests/support/error_of.h"

namespace jostle::server {
namespace {

using test::error_of;

constexpr AttributeTarget ball{AttributeTargetKind::entity, 7};
constexpr AttributeTarget ann{AttributeTargetKind::player, 3};
constexpr AttributeTarget world{};
constexpr ClientId anns_client = 3;

AttributeChange change(std::string key, AttributeValue value,
                       AttributeVisibility visibility = AttributeVisibility::everyone) {
    return {std::move(key), std::move(value), visibility, 0};
}

Status set(Attributes& attributes, const AttributeTarget& target, ClientId setter,
           std::vector<AttributeChange> changes, const AttributeLimits& limits = {}) {
    return attributes.set(target, anns_client, setter, changes, limits);
}

TEST(Attributes, a_tick_publishes_each_change_once_with_the_earlier_value) {
    Attributes attributes;
    const AttributeTablePtr empty = attributes.publish(1);
    EXPECT_EQ(empty->revision, 0u);
    EXPECT_EQ(attributes.publish(2), empty) << "a world without attributes publishes nothing";

    ASSERT_TRUE(set(attributes, ball, 3, {change("hp", std::int64_t{10}), change("a", true)}).ok());
    ASSERT_TRUE(set(attributes, ball, 3, {change("hp", std::int64_t{9}), {"a", {}}}).ok());
    const AttributeTablePtr first = attributes.publish(5);
    ASSERT_EQ(first->revision, 1u);
    const AttributeChanges& changes = *first->recent.back();
    EXPECT_EQ(changes.tick, 5u);
    ASSERT_EQ(changes.changes.size(), 1u) << "\"a\" was set and removed in the same tick";
    EXPECT_EQ(changes.changes[0].key, "hp");
    EXPECT_FALSE(changes.changes[0].before);
    EXPECT_EQ(changes.changes[0].now->value, AttributeValue(std::int64_t{9}));
    EXPECT_EQ(first->find(ball)->attributes.size(), 1u);

    ASSERT_TRUE(set(attributes, ball, 3, {change("hp", std::int64_t{9})}).ok());
    EXPECT_EQ(attributes.publish(6), first) << "the same value is no change";
    attributes.remove(ball);
    const AttributeTablePtr last = attributes.publish(7);
    EXPECT_EQ(last->recent.back()->ended, std::vector<AttributeTarget>{ball});
    EXPECT_TRUE(last->recent.back()->changes.empty());
    EXPECT_EQ(last->find(ball), nullptr);
    EXPECT_EQ(first->find(ball)->attributes.size(), 1u) << "published tables do not change";
    EXPECT_EQ(attributes.bytes(), 0u);
}

TEST(Attributes, tables_of_many_targets_share_unchanged_buckets) {
    Attributes attributes;
    for (EntityId id = 1; id <= 1000; id++)
        ASSERT_TRUE(
            set(attributes, {AttributeTargetKind::entity, id}, 0, {change("n", double(id))}).ok());
    const AttributeTablePtr before = attributes.publish(1);
    EXPECT_EQ(before->targets().size(), 1000u);
    EXPECT_EQ(before->targets()[499]->target.id, 500u);
    ASSERT_TRUE(set(attributes, ball, 0, {change("n", 0.0)}).ok());
    const AttributeTablePtr after = attributes.publish(2);
    int copied = 0;
    for (std::size_t k = 0; k < AttributeTable::buckets_max; k++)
        copied += before->buckets[k] != after->buckets[k] ? 1 : 0;
    EXPECT_EQ(copied, 1);
}

TEST(Attributes, limits_are_named_and_shrinking_is_always_possible) {
    Attributes attributes;
    const AttributeLimits limits{
        .per_target_max = 2, .text_bytes_max = 8, .client_bytes_max = 60, .world_bytes_max = 100};
    const auto message = [&](const Status& status) {
        EXPECT_EQ(error_of(status).code, ErrorCode::resource_exhausted);
        return error_of(status).message;
    };
    EXPECT_EQ(message(set(attributes, ball, 3, {change("t", std::string(9, 'x'))}, limits)),
              "the text of attribute \"t\" has 9 bytes; world.attribute_text_bytes_max allows 8");
    ASSERT_TRUE(set(attributes, ball, 3, {change("a", 1.0), change("b", 2.0)}, limits).ok());
    EXPECT_EQ(attributes.bytes(), 34u) << "17 bytes each";
    EXPECT_EQ(message(set(attributes, ball, 3, {change("c", 3.0)}, limits)),
              "the attributes of entity 7 would have 3; world.attributes_per_target_max allows 2; "
              "remove attributes first");
    EXPECT_EQ(attributes.size(), 2u) << "all or none";
    EXPECT_EQ(message(set(attributes, ann, 3, {change("c", 3.0), change("d", 4.0)}, limits)),
              "the bytes of the attributes that this client set would have 68; "
              "client.attribute_bytes_max allows 60; remove attributes first");
    ASSERT_TRUE(set(attributes, ann, 4, {change("c", 3.0), change("d", 4.0)}, limits).ok());
    EXPECT_EQ(message(set(attributes, world, 0, {change("e", 1.0), change("f", 1.0)}, limits)),
              "the bytes of all attributes of the world would have 102; "
              "world.attribute_bytes_max allows 100; remove attributes first");
    const AttributeLimits none{0, 0, 0, 0};
    EXPECT_TRUE(set(attributes, ball, 3, {{"a", {}}, change("b", true)}, none).ok());
    EXPECT_EQ(attributes.size(), 3u);
}

TEST(Attributes, a_repeated_key_is_rejected) {
    Attributes attributes;
    EXPECT_EQ(
        error_of(set(attributes, ball, 3, {change("a", 1.0), {"b", {}}, change("a", 2.0)})).message,
        "attribute \"a\" is changed twice");
    EXPECT_TRUE(attributes.empty());
}

TEST(Attributes, clients_cannot_change_what_the_server_set) {
    Attributes attributes;
    ASSERT_TRUE(set(attributes, ann, scene_client, {change("score", std::int64_t{5})}).ok());
    const Error error =
        error_of(set(attributes, ann, 3, {change("x", true), change("score", std::int64_t{9})}));
    EXPECT_EQ(error.code, ErrorCode::permission_denied);
    EXPECT_EQ(error.message,
              "attribute \"score\" of player 3 was set by the server; clients cannot change it");
    EXPECT_EQ(attributes.find(ann, "x"), nullptr);
    EXPECT_TRUE(set(attributes, ann, scene_client, {{"score", {}}}).ok());
    EXPECT_TRUE(set(attributes, ann, 3, {change("score", std::int64_t{9})}).ok());
}

TEST(Attributes, restored_store_has_the_same_content_and_sends_no_old_changes) {
    Attributes attributes;
    ASSERT_TRUE(set(attributes, ball, 3,
                    {change("v", physics::Vec3{1, -2, 3}, AttributeVisibility::owner),
                     change("text", std::string("\xc3\xbc"))})
                    .ok());
    ASSERT_TRUE(set(attributes, world, 0, {{"r", -0.5, AttributeVisibility::roles, 8}}).ok());
    SavedHostState saved;
    attributes.write(saved);
    Attributes copy;
    ASSERT_TRUE(copy.restore(saved).ok());
    EXPECT_EQ(copy.bytes(), attributes.bytes());
    EXPECT_EQ(*copy.find(ball, "v"), *attributes.find(ball, "v"));
    EXPECT_EQ(copy.find(world, "r")->roles, 8u);
    const AttributeTablePtr table = copy.publish(9);
    EXPECT_TRUE(table->recent.empty());
    EXPECT_EQ(table->targets().size(), 2u);
}

TEST(Attributes, keys_and_values_are_checked) {
    for (const char* key : {"a", "hp_max.2", "0123456789abcdef0123456789abcdef"})
        EXPECT_TRUE(check_attribute_change(change(key, true), "").ok()) << key;
    for (const char* key : {"", "A", "a b", "\xc3\xbc", "0123456789abcdef0123456789abcdef0"})
        EXPECT_EQ(error_of(check_attribute_change(change(key, true), "set.")).code,
                  ErrorCode::invalid_argument)
            << key;
    EXPECT_EQ(error_of(check_attribute_change(change("x", 0.0 / 0.0), "set.")).message,
              "set.value of \"x\" is not finite; numbers must be finite");
    EXPECT_FALSE(check_attribute_change(change("x", physics::Vec3{0, 1e308 * 10, 0}), "").ok());
    EXPECT_FALSE(check_attribute_change({"x", true, AttributeVisibility::roles, 0}, "").ok());
    EXPECT_FALSE(check_attribute_change({"x", true, AttributeVisibility::roles, 32}, "").ok());
    EXPECT_FALSE(check_attribute_change({"x", true, AttributeVisibility::everyone, 1}, "").ok());
}

}  // namespace
}  // namespace jostle::server
