// SPDX-License-Identifier: MIT
//
// Lists of rooms with filters, room templates, and joining or creating a room.
#include "server/services/world_list.h"

#include <gtest/gtest.h>

#include "jostle/scenes/catalog.h"
#include "jostle/v1/world.pb.h"
#include "server/services/room_templates.h"
#include "server/services/world_control.h"
#include "tests/server/server_parts.h"
#include "tests/support/error_of.h"

namespace jostle::server {
namespace {

using test::error_of;

const Identity director{.subject = "ada", .role = Role::director, .anonymous = false};
const Identity viewer{.subject = "bob", .role = Role::viewer, .anonymous = false};

class WorldListTest : public testing::Test, protected ServerParts {
protected:
    WorldListTest() : ServerParts(10, 8, {.own_ticks = false}) {}
    void room(const std::string& name, RoomProperties properties) {
        ASSERT_TRUE(
            worlds.create(name, *scenes::find_scene("stack"), "ada", std::move(properties)).ok());
    }
    std::string list(const v1::ListWorldsRequest& request, const Identity& who = viewer) {
        v1::ListWorldsResponse response;
        EXPECT_TRUE(control.list(request, response, who).ok());
        std::string names;
        for (const v1::WorldInfo& world : response.worlds()) names += world.name() + " ";
        return names;
    }
    template <class Change>
    std::string filtered(Change change) {
        v1::ListWorldsRequest request;
        change(*request.mutable_filter());
        return list(request);
    }
    Result<v1::JoinOrCreateWorldResponse> join_or_create(
        const v1::JoinOrCreateWorldRequest& request, const Identity& who) {
        v1::JoinOrCreateWorldResponse response;
        const Status done = control.join_or_create(request, response, who, "192.0.2.7");
        if (!done.ok()) return done.error();
        return response;
    }

    WorldControl control{context};
};

TEST_F(WorldListTest, filters_match_all_of_their_fields) {
    ASSERT_TRUE(worlds.create("plain", *scenes::find_scene("dominoes")).ok());
    room("cars", {.title = "Night Race", .tags = {"race", "cars"}, .capacity = 1});
    room("boats", {.tags = {"race"}, .join_code = "sesame"});
    room("hidden", {.unlisted = true});
    EXPECT_EQ(list({}), "plain cars boats ");
    EXPECT_EQ(list({}, director), "plain cars boats hidden ") << "the owner";
    EXPECT_EQ(filtered([](auto& f) { f.add_tags("race"); }), "cars boats ");
    EXPECT_EQ(filtered([](auto& f) { f.add_tags("race"), f.add_tags("cars"); }), "cars ");
    EXPECT_EQ(filtered([](auto& f) { f.set_text("night r"); }), "cars ");
    EXPECT_EQ(filtered([](auto& f) { f.set_is_public(true); }), "cars ");
    EXPECT_EQ(filtered([](auto& f) { f.set_scene("dominoes"); }), "plain ");
    EXPECT_EQ(filtered([](auto& f) { f.set_owner("ada"), f.set_scene("stack"); }), "cars boats ");
    ASSERT_TRUE(sessions.enter(worlds.find("cars")->id(), "network").ok());
    EXPECT_EQ(filtered([](auto& f) { f.set_not_full(true); }), "boats ");
    v1::ListWorldsRequest limited;
    limited.set_limit(2);
    EXPECT_EQ(list(limited), "plain cars ");
    limited.mutable_filter()->set_text(std::string(65, 'x'));
    v1::ListWorldsResponse response;
    EXPECT_EQ(error_of(control.list(limited, response, viewer)).message,
              "filter.text has 65 bytes; at most 64 are allowed");
}

TEST_F(WorldListTest, description_has_live_counts_and_no_join_code) {
    room("cars", {.title = "Night Race", .capacity = 8, .join_code = "sesame"});
    const auto world = worlds.find("cars");
    world->mailbox().enter(1, {.member = "subject/ann"});
    world->mailbox().enter(2, {.member = "subject/tim", .spectator = true});
    world->tick(Clock::now());
    v1::WorldInfo info;
    write_world(info, *world, sessions);
    EXPECT_EQ(info.room().title(), "Night Race");
    EXPECT_EQ(info.room().players(), 1u);
    EXPECT_EQ(info.room().spectators(), 1u);
    EXPECT_TRUE(info.room().is_private());
    EXPECT_EQ(info.owner(), "ada");
    EXPECT_EQ(info.SerializeAsString().find("sesame"), std::string::npos);
}

TEST_F(WorldListTest, every_template_creates_a_room) {
    v1::ListWorldsResponse listed;
    ASSERT_TRUE(control.list({}, listed, director).ok());
    ASSERT_EQ(listed.templates_size(), 4);
    for (const v1::RoomTemplate& one : listed.templates()) {
        v1::CreateWorldRequest request;
        request.set_room_template(one.name());
        request.mutable_room()->set_capacity(3);
        v1::CreateWorldResponse response;
        ASSERT_TRUE(control.create(request, response, director, "").ok()) << one.name();
        EXPECT_EQ(response.world().scene(), one.scene());
        EXPECT_EQ(response.world().room().title(), one.room().title());
        EXPECT_EQ(response.world().room().capacity(), 3u) << "replaces that of the template";
    }
    v1::CreateWorldRequest unknown;
    unknown.set_room_template("castle");
    v1::CreateWorldResponse response;
    EXPECT_EQ(error_of(control.create(unknown, response, director, "")).code, ErrorCode::not_found);
}

TEST_F(WorldListTest, second_caller_joins_the_room_that_the_first_one_created) {
    v1::JoinOrCreateWorldRequest request;
    request.mutable_filter()->add_tags("race");
    EXPECT_EQ(error_of(join_or_create(request, director)).code, ErrorCode::not_found);
    request.mutable_create()->set_scene_name("stack");
    request.mutable_create()->mutable_room()->add_tags("race");
    EXPECT_EQ(error_of(join_or_create(request, viewer)).code, ErrorCode::permission_denied)
        << "a viewer creates no worlds";
    const auto first = join_or_create(request, director), second = join_or_create(request, viewer);
    ASSERT_TRUE(first.ok() && second.ok());
    EXPECT_TRUE(first->created());
    EXPECT_FALSE(second->created());
    EXPECT_EQ(first->join().world().id(), second->join().world().id());
    EXPECT_EQ(second->join().ticket().size(), 32u);
}

TEST_F(WorldListTest, join_or_create_skips_full_and_private_rooms) {
    room("full", {.tags = {"race"}, .capacity = 1});
    room("private", {.tags = {"race"}, .join_code = "sesame"});
    ASSERT_TRUE(sessions.enter(worlds.find("full")->id(), "network").ok());
    v1::JoinOrCreateWorldRequest request;
    request.mutable_filter()->add_tags("race");
    EXPECT_EQ(error_of(join_or_create(request, viewer)).code, ErrorCode::not_found);
    request.set_join_code("sesame");
    const auto joined = join_or_create(request, viewer);
    ASSERT_TRUE(joined.ok());
    EXPECT_EQ(joined->join().world().name(), "private");
    v1::JoinWorldRequest wrong;
    wrong.set_world("private");
    wrong.set_join_code("open");
    v1::JoinWorldResponse response;
    EXPECT_EQ(error_of(control.join(wrong, response, viewer, "")).code,
              ErrorCode::permission_denied);
}

}  // namespace
}  // namespace jostle::server
