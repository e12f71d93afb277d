// SPDX-License-Identifier: MIT
#include "server/auth/authorizer.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "tests/support/error_of.h"
#include "tests/support/temp_folder.h"
#include "tests/support/tokens.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using test::error_of;
using test::Json;
using test::LoginService;

constexpr const char* create = "jostle.v1.WorldService/CreateWorld";
constexpr const char* remove_world = "jostle.v1.WorldService/DeleteWorld";
constexpr const char* join = "jostle.v1.WorldService/JoinWorld";
constexpr const char* play = "jostle.v1.PlayService/Play";
constexpr const char* debug = "jostle.v1.QueryService/Debug";
constexpr const char* home = "192.0.2.7";

class AuthorizerTest : public testing::Test {
protected:
    void SetUp() override {
        config.auth = {.issuer = LoginService::issuer,
                       .audience = LoginService::audience,
                       .keys = folder.write("keys.json", login.published()),
                       .audit_log = folder / "audit"};
        open();
    }
    void open() {
        authorizer.reset();
        Result<std::unique_ptr<Authorizer>> opened = Authorizer::open(config);
        ASSERT_TRUE(opened.ok()) << opened.error().message;
        authorizer = std::move(*opened);
    }

    std::string token(const std::string& subject, const std::string& role,
                      const Json& more = Json::object()) const {
        Json claims = LoginService::claims(subject, role, now.wall);
        claims.update(more);
        return login.token(claims);
    }
    Identity known(const std::string& subject, const std::string& role,
                   const Json& more = Json::object()) {
        return authorizer->identify({.bearer = token(subject, role, more), .address = home}, now)
            .value();
    }
    Identity anonymous() { return authorizer->identify({.address = home}, now).value(); }
    Status admit(const Identity& who, const char* call,
                 const WorldTarget& world = {"w1", "arena", ""}, const char* address = home) {
        return authorizer->admit(who, {.call = call, .world = world, .address = address}, now);
    }
    std::vector<Json> audited() {
        EXPECT_TRUE(authorizer->audit().flush(5s));
        std::vector<Json> lines;
        std::istringstream in(folder.read("audit"));
        for (std::string line; std::getline(in, line);) lines.push_back(Json::parse(line));
        return lines;
    }

    const test::TempFolder folder;
    const LoginService login;
    Config config;
    ClockPair now{Clock::time_point{}, WallTime(1'790'000'000s)};
    std::unique_ptr<Authorizer> authorizer;
};

TEST_F(AuthorizerTest, identifies_callers_by_token_certificate_or_as_anonymous) {
    const Identity anna = known("anna", "player");
    EXPECT_EQ(anna.subject, "anna");
    EXPECT_EQ(anna.role, Role::player);
    const Identity operator_ =
        authorizer->identify({.certificate = "CN=operator", .address = home}, now).value();
    EXPECT_EQ(operator_.subject, "certificate:CN=operator");
    EXPECT_EQ(operator_.role, Role::admin);
    EXPECT_EQ(
        authorizer
            ->identify(
                {.bearer = token("anna", "viewer"), .certificate = "CN=operator", .address = home},
                now)
            ->role,
        Role::viewer)
        << "a token has priority";
    EXPECT_TRUE(anonymous().anonymous);
    EXPECT_EQ(anonymous().role, Role::none) << "with keys, anonymous clients have no role";
    const Error error = authorizer->identify({.bearer = "rubbish", .address = home}, now).error();
    EXPECT_EQ(error.code, ErrorCode::unauthenticated);
}

TEST_F(AuthorizerTest, anonymous_permissions_follow_the_configured_role) {
    for (const auto& [setting, role] :
         {std::pair("none", Role::none), std::pair("viewer", Role::viewer),
          std::pair("player", Role::player), std::pair("director", Role::director),
          std::pair("admin", Role::admin), std::pair("", Role::none)}) {
        config.auth.anonymous_role = setting;
        open();
        EXPECT_EQ(anonymous().role, role) << setting;
    }
    config.auth = {.audit_log = folder / "audit"};
    open();
    EXPECT_EQ(anonymous().role, Role::admin) << "without keys, on loopback";
    EXPECT_EQ(authorizer->identify({.bearer = token("anna", "admin"), .address = home}, now)
                  .error()
                  .message,
              "this server accepts no tokens: auth.keys is not set");
    config.listen = "0.0.0.0:50051";
    open();
    EXPECT_EQ(anonymous().role, Role::director) << "without keys, on a non-loopback address";
}

// Checks every row of the table with every role. Lower roles are rejected; anonymous clients are
// asked to authenticate.
TEST_F(AuthorizerTest, every_row_requires_its_minimum_role) {
    int refused = 0;
    for (const AccessRow& row : access_table()) {
        for (const Role role :
             {Role::none, Role::viewer, Role::player, Role::director, Role::admin}) {
            for (const bool is_anonymous : {false, true}) {
                const Identity who{.subject = is_anonymous ? "anonymous" : "anna",
                                   .role = role,
                                   .anonymous = is_anonymous};
                // One address each, so that no quota applies.
                const std::string address = "10.0.0." + std::to_string(++refused % 250);
                const Status status = authorizer->admit(
                    who, {.call = row.call, .world = {"w1", "a", who.subject}, .address = address},
                    now);
                EXPECT_EQ(status.ok(), role >= row.min_role) << row.call << " by " << name_of(role);
                if (!status.ok()) {
                    EXPECT_EQ(status.error().code, is_anonymous ? ErrorCode::unauthenticated
                                                                : ErrorCode::permission_denied);
                }
            }
        }
    }
}

TEST_F(AuthorizerTest, directors_delete_only_their_own_worlds_and_admins_any_world) {
    const Identity anna = known("anna", "director"), boss = known("boss", "admin");
    EXPECT_TRUE(admit(anna, remove_world, {"w1", "arena", "anna"}).ok());
    EXPECT_EQ(error_of(admit(anna, remove_world, {"w1", "arena", "berta"})).code,
              ErrorCode::permission_denied);
    EXPECT_FALSE(admit(anna, remove_world, {"w1", "arena", ""}).ok()) << "a world of the server";
    EXPECT_TRUE(admit(boss, remove_world, {"w1", "arena", "berta"}).ok());
    EXPECT_TRUE(admit(boss, remove_world, {"w1", "arena", ""}).ok());
    config.auth.anonymous_role = "director";
    open();
    EXPECT_FALSE(admit(anonymous(), remove_world, {"w1", "arena", ""}).ok());
    EXPECT_FALSE(admit(anonymous(), remove_world, {"w1", "arena", "anna"}).ok());
    EXPECT_TRUE(admit(anonymous(), remove_world, {"w1", "arena", "anonymous"}).ok());
}

TEST_F(AuthorizerTest, token_for_one_world_is_rejected_for_other_worlds) {
    const Identity by_id = known("anna", "player", {{"world", "w1"}}),
                   by_name = known("berta", "player", {{"world", "arena"}}),
                   director = known("carla", "director", {{"world", "w1"}});
    for (const char* call : {join, play, debug, play_inputs.data()}) {
        EXPECT_TRUE(admit(by_id, call, {"w1", "arena", ""}).ok()) << call;
        EXPECT_TRUE(admit(by_name, call, {"w1", "arena", ""}).ok()) << call;
        EXPECT_EQ(error_of(admit(by_id, call, {"w2", "pit", ""})).message,
                  "the token is for another world")
            << call;
        EXPECT_FALSE(admit(by_name, call, {"w2", "pit", ""}).ok()) << call;
        EXPECT_FALSE(admit(by_id, call, {}).ok()) << "the call names no world: " << call;
    }
    EXPECT_TRUE(admit(by_id, "jostle.v1.WorldService/ListWorlds", {}).ok());
    EXPECT_FALSE(admit(director, create, {}).ok());
}

TEST_F(AuthorizerTest, administrator_of_two_worlds_does_not_administrate_the_server) {
    const Identity boss = known("boss", "admin", {{"world", {"w1", "pit"}}});
    EXPECT_EQ(boss.worlds, (std::vector<std::string>{"w1", "pit"}));
    const char* rewind = "jostle.v1.AdminService/RewindWorld";
    EXPECT_TRUE(admit(boss, rewind, {"w1", "arena", ""}).ok());
    EXPECT_TRUE(admit(boss, rewind, {"w2", "pit", ""}).ok());
    EXPECT_EQ(error_of(admit(boss, rewind, {"w3", "yard", "boss"})).code,
              ErrorCode::permission_denied);
    const Error error = error_of(admit(boss, "jostle.v1.AdminService/Drain", {}));
    EXPECT_EQ(error.code, ErrorCode::permission_denied);
    EXPECT_EQ(error.message,
              "this call concerns the entire server; the token is limited to certain worlds (claim "
              "world)");
}

TEST_F(AuthorizerTest, banned_callers_may_call_only_what_is_open) {
    const Identity eve = known("eve", "player"), boss = known("boss", "admin"),
                   max = known("max", "player");
    const std::string ticket = authorizer->issue_ticket(eve, "w1", home, now).value();
    const std::uint64_t before = authorizer->revision();
    ASSERT_TRUE(authorizer->bans()
                    .add({.target = {"eve", {}},
                          .reason = "griefing",
                          .by = "boss",
                          .created = now.wall,
                          .expires = now.wall + 1h},
                         now.wall)
                    .ok());
    EXPECT_NE(authorizer->revision(), before);
    const std::string refusal =
        "the subject of the token is banned until 2026-09-21T15:13:20.000Z: griefing";
    for (const char* call : {join, play, debug, play_inputs.data()}) {
        const Error error = error_of(admit(eve, call));
        EXPECT_EQ(error.code, ErrorCode::permission_denied);
        EXPECT_EQ(error.message, refusal);
        EXPECT_TRUE(admit(max, call).ok());
    }
    EXPECT_EQ(error_of(authorizer->check_session(eve, home, now)).message, refusal);
    EXPECT_EQ(authorizer->redeem_ticket(ticket, "", home, now).error().message, refusal);
    EXPECT_TRUE(admit(eve, "GET /healthz").ok());
    now.wall += 59min;
    EXPECT_FALSE(admit(eve, play).ok());
    now.wall += 1min;
    EXPECT_TRUE(authorizer->check_session(eve, home, now).ok()) << "the ban has expired";
    EXPECT_TRUE(admit(known("eve", "player"), play).ok());

    ASSERT_TRUE(authorizer->bans()
                    .add({.target = {{}, parse_network("192.0.2.0/24").value()}}, now.wall)
                    .ok());
    EXPECT_EQ(error_of(admit(known("max", "player"), play)).message, "this network is banned");
    EXPECT_FALSE(admit(known("max", "player"), play, {"w1", "arena", ""}, "::ffff:192.0.2.9").ok());
    EXPECT_TRUE(admit(known("max", "player"), play, {"w1", "arena", ""}, "192.0.3.7").ok());
    const Identity operator_ = known("boss", "admin");
    EXPECT_TRUE(admit(operator_, "jostle.v1.AdminService/Unban", {}).ok());
    EXPECT_FALSE(admit(operator_, play).ok());
    ASSERT_TRUE(authorizer->bans().add({.target = {"boss", {}}}, now.wall).ok());
    EXPECT_FALSE(admit(operator_, "jostle.v1.AdminService/Unban", {}).ok());
}

TEST_F(AuthorizerTest, bans_are_stored_next_to_the_database) {
    config.persistence.database = folder / "worlds.db";
    open();
    ASSERT_TRUE(authorizer->bans().add({.target = {"eve", {}}}, now.wall).ok());
    open();
    EXPECT_FALSE(admit(known("eve", "player"), play).ok());
    folder.write("worlds.db.bans.json", "{");
    const auto opened = Authorizer::open(config);
    ASSERT_FALSE(opened.ok());
    EXPECT_NE(opened.error().message.find("worlds.db.bans.json is damaged"), std::string::npos);
}

TEST_F(AuthorizerTest, identity_expires_with_its_token) {
    const Identity anna = known("anna", "player");
    now.wall += 1h + 29s;
    EXPECT_TRUE(admit(anna, debug).ok());
    now.wall += 1s;
    EXPECT_EQ(error_of(admit(anna, debug)).code, ErrorCode::unauthenticated);
    EXPECT_TRUE(admit(anna, "GET /healthz").ok()) << "public calls remain available";
}

TEST_F(AuthorizerTest, rejects_calls_without_a_row_even_for_admins) {
    EXPECT_EQ(error_of(admit(known("boss", "admin"), "jostle.v1.WorldService/Explode")).code,
              ErrorCode::permission_denied);
    EXPECT_FALSE(admit(known("boss", "admin"), "").ok());
}

TEST_F(AuthorizerTest, rate_limited_callers_receive_retry_delay) {
    config.quota.creates_per_minute = 3;
    open();
    const Identity anna = known("anna", "director");
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(admit(anna, create, {}).ok());
    const Error error = error_of(admit(anna, create, {}));
    EXPECT_EQ(error.code, ErrorCode::resource_exhausted);
    EXPECT_EQ(error.message, "too many new worlds; retry in 20.0 s");
    EXPECT_NEAR(error.retry_after_ms, 20000, 2);
    EXPECT_TRUE(admit(anna, debug).ok()) << "other calls are not affected";
    now.steady += std::chrono::milliseconds(error.retry_after_ms);
    EXPECT_TRUE(admit(anna, create, {}).ok());
}

TEST_F(AuthorizerTest, throttles_addresses_after_rejected_tokens) {
    config.quota.refused_logins_per_minute = 5;
    open();
    const auto login_with = [&](const std::string& bearer, const char* address) {
        return authorizer->identify({.bearer = bearer, .address = address}, now);
    };
    const std::string good = token("anna", "player");
    std::string forged = good;
    forged[forged.size() - 5] ^= 1;
    for (int i = 0; i < 5; ++i)
        EXPECT_EQ(login_with(forged, home).error().code, ErrorCode::unauthenticated);
    const Error error = login_with(forged, home).error();
    EXPECT_EQ(error.code, ErrorCode::resource_exhausted);
    EXPECT_NEAR(error.retry_after_ms, 12000, 2);
    EXPECT_FALSE(login_with(good, home).ok())
        << "the address is blocked without checking the token";
    EXPECT_TRUE(login_with(good, "192.0.2.8").ok());
    now.steady += 12s;
    EXPECT_TRUE(login_with(good, home).ok());
    EXPECT_TRUE(login_with(good, home).ok()) << "valid tokens do not consume the quota";
}

TEST_F(AuthorizerTest, ticket_admits_its_holder_once) {
    const Identity anna = known("anna", "player");
    const std::string ticket = authorizer->issue_ticket(anna, "w1", home, now).value();
    const Authorizer::Entry entry = authorizer->redeem_ticket(ticket, "", home, now).value();
    EXPECT_EQ(entry.who.subject, "anna");
    EXPECT_EQ(entry.who.role, Role::player);
    EXPECT_EQ(entry.world_id, "w1");
    EXPECT_TRUE(admit(entry.who, play_inputs.data()).ok());
}

// All failures return the same message to the client. Only the audit log contains the reason.
TEST_F(AuthorizerTest, ticket_failure_reason_appears_only_in_audit_log) {
    const Identity anna = known("anna", "player");
    const auto issue = [&] { return authorizer->issue_ticket(anna, "w1", home, now).value(); };
    const std::string used = issue(), elsewhere = issue(), outlived = issue();
    ASSERT_TRUE(authorizer->redeem_ticket(used, "w1", home, now).ok());
    std::vector<Error> errors;
    const auto redeem = [&](const std::string& ticket, const char* world) {
        errors.push_back(authorizer->redeem_ticket(ticket, world, home, now).error());
    };
    redeem(used, "w1");
    redeem(std::string(32, '0'), "w1");
    redeem(elsewhere, "w2");
    now.wall += 2h;
    redeem(outlived, "w1");
    now.wall -= 2h;
    const std::string old = issue();
    now.steady += 31s;
    redeem(old, "w1");
    std::vector<std::string> reasons;
    for (const Json& line : audited())
        if (line["what"] == "ticket" && line["outcome"] == "refused")
            reasons.push_back(line["reason"]);
    EXPECT_EQ(reasons, (std::vector<std::string>{
                           "the ticket was already used", "the ticket is unknown",
                           "the ticket is for another world",
                           "the token behind the ticket has expired", "the ticket has expired"}));
    for (const Error& error : errors) {
        EXPECT_EQ(error.code, ErrorCode::unauthenticated);
        EXPECT_EQ(error.message, errors[0].message);
    }
}

TEST_F(AuthorizerTest, audits_grants_refusals_and_changes_but_not_reads) {
    const Identity anna = known("anna", "director", {{"jti", "t-9"}});
    const AccessRequest made{.call = create, .world = {"w7", "pit", "anna"}, .address = home};
    EXPECT_TRUE(admit(anna, create, {}).ok());
    authorizer->record(anna, made, {}, now);
    authorizer->record(anna, made, Error{ErrorCode::already_exists, "the name is taken"}, now);
    EXPECT_TRUE(admit(anna, debug).ok());
    EXPECT_TRUE(admit(anna, "GET /healthz").ok());
    EXPECT_TRUE(admit(anna, join).ok());
    EXPECT_FALSE(admit(anna, "jostle.v1.AdminService/Drain").ok());
    std::vector<std::string> entries;
    for (const Json& line : audited()) {
        EXPECT_EQ(line["subject"], "anna");
        EXPECT_EQ(line["role"], "director");
        EXPECT_EQ(line["token_id"], "t-9");
        EXPECT_EQ(line["address"], home);
        EXPECT_EQ(line["time"], "2026-09-21T14:13:20.000Z");
        entries.push_back(
            line["what"].get<std::string>() + " " + line["outcome"].get<std::string>() + " " +
            line["world"].get<std::string>() + " " + line["reason"].get<std::string>());
    }
    EXPECT_EQ(entries,
              (std::vector<std::string>{
                  "login granted  ", "create granted  ", "create done w7 ",
                  "create failed w7 the name is taken", "join granted w1 ",
                  "admin refused w1 this call requires the role admin; your role is director"}));
}

TEST_F(AuthorizerTest, audits_each_token_login_once) {
    for (int i = 0; i < 100; ++i) known("anna", "viewer");
    known("anna", "viewer", {{"jti", "another"}});
    EXPECT_EQ(audited().size(), 2u);
}

TEST_F(AuthorizerTest, limits_audited_refusals_per_address) {
    config.quota.refusals_audited_per_minute = 10;
    open();
    for (int i = 0; i < 500; ++i) EXPECT_FALSE(admit(anonymous(), create, {}).ok());
    EXPECT_FALSE(admit(anonymous(), create, {}, "192.0.2.8").ok());
    authorizer.reset();  // the destructor writes the final count
    std::size_t refusals = 0, muted = 0;
    std::istringstream in(folder.read("audit"));
    for (std::string text; std::getline(in, text);) {
        const Json line = Json::parse(text);
        if (line["what"] == "unwritten") {
            muted += line["muted"].get<std::size_t>();
        } else {
            ++refusals;
        }
    }
    EXPECT_EQ(refusals, 11u) << "ten of the first address, one of the second";
    EXPECT_EQ(muted, 490u);
}

// Forged, expired, missing, non-expiring, foreign and replayed tokens are rejected and audited. No
// part of them is logged.
TEST_F(AuthorizerTest, never_logs_tokens_or_tickets) {
    std::vector<std::string> secrets;
    const auto show = [&](const std::string& bearer) {
        secrets.push_back(bearer);
        return authorizer->identify({.bearer = bearer, .address = home}, now).ok();
    };
    EXPECT_TRUE(show(token("anna", "player")));
    EXPECT_FALSE(show(token("anna", "player", {{"exp", 1}})));
    EXPECT_FALSE(show(token("anna", "player", {{"aud", "mail"}})));
    EXPECT_FALSE(show(token("anna", "boss")));
    EXPECT_FALSE(show(LoginService().token(LoginService::claims("anna", "player", now.wall))));
    Json endless = LoginService::claims("anna", "player", now.wall);
    endless.erase("exp");
    EXPECT_FALSE(show(login.token(endless)));
    EXPECT_FALSE(show(test::assemble(R"({"alg":"none"})", endless.dump(),
                                     [](const std::string&) { return std::string(); })));
    const std::string ticket =
        authorizer->issue_ticket(known("anna", "player"), "w1", home, now).value();
    secrets.push_back(ticket);
    EXPECT_TRUE(authorizer->redeem_ticket(ticket, "w1", home, now).ok());
    EXPECT_FALSE(authorizer->redeem_ticket(ticket, "w1", home, now).ok());
    int refused = 0;
    for (const Json& line : audited()) refused += line["outcome"] == "refused" ? 1 : 0;
    EXPECT_EQ(refused, 7);
    const std::string text = folder.read("audit");
    for (const std::string& secret : secrets) {
        EXPECT_EQ(text.find(secret), std::string::npos);
        const std::size_t dot = secret.find('.');
        if (dot == std::string::npos) continue;
        EXPECT_EQ(text.find(secret.substr(0, dot)), std::string::npos)
            << "a part of a token was logged";
        if (secret.size() > secret.rfind('.') + 1) {
            EXPECT_EQ(text.find(secret.substr(secret.rfind('.') + 1)), std::string::npos);
        }
    }
}

TEST_F(AuthorizerTest, reloads_key_set_at_run_time) {
    const LoginService renewed{.key_id = "second"};
    const std::string of_new = renewed.token(LoginService::claims("anna", "player", now.wall));
    const auto is_good = [&](const std::string& bearer) {
        return authorizer->identify({.bearer = bearer, .address = home}, now).ok();
    };
    EXPECT_FALSE(is_good(of_new));
    folder.write("keys.json", renewed.published());
    now.steady += 1s;
    authorizer->poll(now);
    EXPECT_TRUE(is_good(of_new));
    EXPECT_FALSE(is_good(token("anna", "player"))) << "the old key was removed";
    folder.write("keys.json", login.published());
    authorizer->reload();
    EXPECT_TRUE(is_good(token("anna", "player")));
}

TEST_F(AuthorizerTest, error_names_invalid_settings) {
    config.auth.keys = folder / "missing.json";
    EXPECT_FALSE(Authorizer::open(config).ok());
    config.auth.keys.clear();
    config.auth.audit_log = "/no/such/folder/audit";
    EXPECT_FALSE(Authorizer::open(config).ok());
}

TEST_F(AuthorizerTest, supports_concurrent_calls_during_key_reload) {
    const std::string bearer = token("anna", "player");
    std::atomic<int> accepted = 0;
    {
        std::vector<std::jthread> threads;
        for (int t = 0; t < 4; ++t)
            threads.emplace_back([&, t] {
                const std::string address = "10.0.0." + std::to_string(t);
                for (int i = 0; i < 50; ++i) {
                    const auto who =
                        authorizer->identify({.bearer = bearer, .address = address}, now);
                    if (!who.ok()) continue;
                    const auto ticket = authorizer->issue_ticket(*who, "w1", address, now);
                    if (ticket.ok() && authorizer->redeem_ticket(*ticket, "w1", address, now).ok())
                        ++accepted;
                }
            });
        for (int i = 0; i < 20; ++i) {
            folder.write("keys.json", login.published());
            authorizer->reload();
        }
    }
    EXPECT_EQ(accepted, 200);
}

TEST(BearerIn, parses_bearer_token_from_header) {
    EXPECT_EQ(parse_bearer("").value(), "");
    EXPECT_EQ(parse_bearer("Bearer a.b.c").value(), "a.b.c");
    EXPECT_EQ(parse_bearer("bearer a.b.c").value(), "a.b.c");
    for (const char* header :
         {"Bearer", "Bearer ", "Basic YTpi", "a.b.c", "Bearer\ta.b.c", "BearerX a.b.c"})
        EXPECT_EQ(parse_bearer(header).ok() ? "ok" : parse_bearer(header).error().message,
                  "the Authorization header is not \"Bearer TOKEN\"")
            << header;
}

}  // namespace
}  // namespace jostle::server
