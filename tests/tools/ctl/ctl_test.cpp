// SPDX-License-Identifier: MIT
//
// jostlectl against a real server, both as child processes: commands and their output.
#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <thread>

#include "google/rpc/error_details.pb.h"
#include "google/rpc/status.pb.h"
#include "jostle/v1/admin.grpc.pb.h"
#include "jostle/v1/world.grpc.pb.h"
#include "tests/system/player.h"
#include "tests/system/server_process.h"

namespace jostle::test {
namespace {

using namespace std::chrono_literals;

class CtlTest : public testing::Test {
protected:
    CtlTest()
        : folder_(std::filesystem::temp_directory_path() /
                  ("jostlectl-" + std::to_string(getpid()))) {
        std::filesystem::create_directories(folder_);
    }
    ~CtlTest() override { std::filesystem::remove_all(folder_); }

    std::string file(const char* name) const { return (folder_ / name).string(); }
    void write(const char* name, const std::string& text) const {
        std::ofstream(file(name)) << text;
    }
    static std::string read(const std::string& path) {
        std::ifstream in(path);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    // Runs jostlectl and returns its exit status; the output is in out and err.
    int run(const std::string& arguments, const std::string& address = {}) {
        const std::string command =
            "JOSTLE_SERVER=" + (address.empty() ? server.grpc_address() : address) + " " +
            JOSTLECTL + " " + arguments + " > " + file("out") + " 2> " + file("err");
        const int status = std::system(command.c_str());
        out = read(file("out"));
        err = read(file("err"));
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    nlohmann::json json() const { return nlohmann::json::parse(out); }
    bool says(const std::string& text) const { return out.find(text) != std::string::npos; }
    bool complains(const std::string& text) const { return err.find(text) != std::string::npos; }

    ServerProcess server{{"--scene", "stack", "--listen", "127.0.0.1:0", "--http", "127.0.0.1:0"}};
    std::string out, err;

private:
    std::filesystem::path folder_;
};

TEST_F(CtlTest, suggests_the_nearest_command_flag_and_scene) {
    EXPECT_EQ(run("wrolds"), 2);
    EXPECT_TRUE(complains("jostlectl: unknown command \"wrolds\"; did you mean \"worlds\"?"))
        << err;
    EXPECT_EQ(run("world crate x"), 2);
    EXPECT_TRUE(complains("jostlectl world: unknown command \"crate\"; did you mean \"create\"?"))
        << err;
    EXPECT_EQ(run("world create x --scen stack"), 2);
    EXPECT_TRUE(complains("unknown flag \"--scen\"; did you mean \"--scene\"?")) << err;
    EXPECT_EQ(run("worlds --jsn"), 2);
    EXPECT_TRUE(complains("did you mean \"--json\"?")) << err;
    EXPECT_EQ(run("worlds --quite-different"), 2);
    EXPECT_TRUE(complains("jostlectl worlds: unknown flag \"--quite-different\"\n")) << err;
    EXPECT_EQ(run("world create x --scene domino"), 1);
    EXPECT_TRUE(complains("there is no scene \"domino\"; did you mean \"dominoes\"?")) << err;
}

// A height field of 547,600 samples: 4.4 MB as a message, more as JSON. gRPC's default limit is 4
// MiB.
TEST_F(CtlTest, creates_again_what_it_exported_beyond_4_mib) {
    {
        std::ofstream scene(file("big.json"));
        const int n = 740;
        scene
            << R"({"name": "big", "bodies": [{"type": "BODY_TYPE_STATIC", "shapes": [{)"
            << R"("height_field": {"columns": 740, "rows": 740, "spacing_x": 0.1, "spacing_z": 0.1, )"
            << R"("heights": [)" << std::setprecision(17);
        for (int k = 0; k < n * n; k++)
            scene << (k == 0 ? "" : ",") << (k / n * 13 + k % n * 7) % 101 / 997.0;
        scene << "]}}]}]}";
    }
    ASSERT_EQ(run("world create big --file " + file("big.json")), 0) << err;
    ASSERT_EQ(run("export big " + file("copy.json")), 0) << err;
    EXPECT_GT(read(file("copy.json")).size(), std::size_t{8} << 20);
    ASSERT_EQ(run("world create again --file " + file("copy.json")), 0) << err;
    ASSERT_EQ(run("export again " + file("again.json")), 0) << err;
    EXPECT_TRUE(read(file("again.json")) == read(file("copy.json")));

    // With the default limits of gRPC: too large in one message, but not in pieces.
    const auto channel =
        grpc::CreateChannel(server.grpc_address(), grpc::InsecureChannelCredentials());
    const auto admin = v1::AdminService::NewStub(channel);
    v1::ExportWorldRequest whole;
    whole.set_world("big");
    v1::ExportWorldResponse exported;
    grpc::ClientContext too_large;
    EXPECT_EQ(admin->ExportWorld(&too_large, whole, &exported).error_code(),
              grpc::StatusCode::RESOURCE_EXHAUSTED);
    v1::DownloadWorldRequest request;
    request.set_world("big");
    std::string bytes;
    for (;;) {
        v1::DownloadWorldResponse piece;
        grpc::ClientContext context;
        const grpc::Status status = admin->DownloadWorld(&context, request, &piece);
        ASSERT_TRUE(status.ok()) << status.error_message();
        if (piece.data().empty()) break;
        bytes += piece.data();
        request.set_id(piece.id());
        request.set_offset(bytes.size());
    }
    EXPECT_GT(bytes.size(), std::size_t{4} << 20);
    ASSERT_TRUE(exported.ParseFromString(bytes));
    v1::CreateWorldRequest create;
    create.set_name("third");
    *create.mutable_scene() = exported.scene();
    v1::CreateWorldResponse created;
    grpc::ClientContext context;
    const auto worlds = v1::WorldService::NewStub(channel);
    const grpc::Status status = worlds->CreateWorld(&context, create, &created);
    EXPECT_TRUE(status.ok()) << status.error_message();
    EXPECT_EQ(created.world().bodies(), 1u);
}

TEST_F(CtlTest, a_scene_as_text_has_errors_with_positions) {
    const auto worlds = v1::WorldService::NewStub(
        grpc::CreateChannel(server.grpc_address(), grpc::InsecureChannelCredentials()));
    v1::CreateWorldRequest request;
    v1::CreateWorldResponse created;
    request.set_scene_json("{\"name\": \"a\",\n \"bodys\": []}");
    grpc::ClientContext wrong;
    EXPECT_EQ(worlds->CreateWorld(&wrong, request, &created).error_message(),
              "line 2, column 11: bodys: unknown field; did you mean \"bodies\"?");
    // As many errors, and as long, as a response may have.
    std::string many = "{\"name\": \"a\", \"bodies\": [\n";
    for (int i = 0; i < 30; i++)
        many += (i == 0 ? "" : ",\n") + std::string("{\"") + std::string(60, 'x') + "\": 1}";
    request.set_scene_json(many + "]}");
    grpc::ClientContext long_one;
    const grpc::Status status = worlds->CreateWorld(&long_one, request, &created);
    EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT) << status.error_message();
    EXPECT_TRUE(status.error_message().ends_with("more errors may follow"));
    google::rpc::Status details;
    google::rpc::BadRequest violations;
    ASSERT_TRUE(details.ParseFromString(status.error_details()));
    ASSERT_TRUE(details.details(1).UnpackTo(&violations));
    EXPECT_GE(violations.field_violations_size(), 6);
    EXPECT_EQ(violations.field_violations(1).field(), "bodies[1]." + std::string(60, 'x'));
    request.set_scene_json(R"({"name": "a", "$schema": "scene.schema.json"})");
    grpc::ClientContext good;
    EXPECT_TRUE(worlds->CreateWorld(&good, request, &created).ok());
}

// Errors that the client finds, that the scene reader of the server finds, and that a module finds.
TEST_F(CtlTest, reports_the_errors_of_a_scene_with_positions) {
    write("fields.json", "{\"name\": \"a\",\n \"bodys\": [],\n \"world\": {\"gravty\": 1}}");
    EXPECT_EQ(run("world create bad --file " + file("fields.json")), 2);
    const std::string fields = file("fields.json") + ": line ";
    EXPECT_TRUE(complains(fields + "2, column 11: bodys: unknown field; did you mean \"bodies\"?"))
        << err;
    EXPECT_TRUE(
        complains(fields + "3, column 22: world.gravty: unknown field; did you mean \"gravity\"?"))
        << err;
    write("values.json",
          "{\"name\": \"a\",\n \"world\": {\"hz\": 1},\n \"bodies\": [{\"mass\": -1}]}");
    EXPECT_EQ(run("world create bad --file " + file("values.json")), 1);
    const std::string values = file("values.json") + ": line ";
    EXPECT_TRUE(complains(values + "2, column 18: world.hz: 1 is out of range")) << err;
    EXPECT_TRUE(complains(values + "3, column 22: bodies[0].mass: -1 is out of range")) << err;
    write("modules.json",
          "{\"name\": \"a\", \"modules\": [\n  {\"tag\": \"fields\", \"settings\": "
          "{\"waves_levle\": 1}}]}");
    EXPECT_EQ(run("world create bad --file " + file("modules.json")), 1);
    EXPECT_TRUE(complains(file("modules.json") + ": line 2, column 3: modules[0] 'fields': "))
        << err;
    EXPECT_TRUE(complains("did you mean \"waves_level\"?")) << err;
}

TEST_F(CtlTest, lists_creates_and_deletes_worlds) {
    ASSERT_EQ(run("worlds"), 0) << err;
    EXPECT_TRUE(says("ID  NAME") || says("ID           NAME")) << out;
    EXPECT_TRUE(says("stack")) << out;
    ASSERT_EQ(run("world create arena --scene dominoes"), 0) << err;
    EXPECT_TRUE(says("\"arena\" runs with")) << out;
    ASSERT_EQ(run("--json worlds"), 0);
    ASSERT_EQ(json()["worlds"].size(), 2u);
    EXPECT_EQ(json()["worlds"][1]["name"], "arena");
    EXPECT_EQ(json()["worlds"][1]["clients"], 0) << "JSON includes zero values";
    EXPECT_EQ(run("world create arena --scene dominoes"), 1);
    EXPECT_TRUE(complains("a world named \"arena\" exists")) << err;
    ASSERT_EQ(run("world delete arena"), 0) << err;
    EXPECT_EQ(run("world delete arena"), 1);
    EXPECT_TRUE(complains("arena")) << err;
}

TEST_F(CtlTest, creates_shows_and_moderates_a_room) {
    write("room.json", R"({"title": "Yard", "tags": ["build"], "capacity": 4})");
    ASSERT_EQ(run("world create yard --scene stack --room " + file("room.json")), 0) << err;
    ASSERT_EQ(run("worlds --tags build --not-full"), 0) << err;
    EXPECT_TRUE(says("Yard")) << out;
    EXPECT_TRUE(says("0/4")) << out;
    EXPECT_FALSE(says("\"stack\""));
    ASSERT_EQ(run("world create --template race"), 0) << err;
    ASSERT_EQ(run("room protect yard tower --min -1 0 -1 --max 1 9 1 --role owner"), 0) << err;
    ASSERT_EQ(run("room show yard --json"), 0) << err;
    EXPECT_EQ(json().at("settings").at("areas").at(0).at("minRole"), "owner");
    write("closed.json", R"({"title": "Closed", "joinCode": "sesame"})");
    ASSERT_EQ(run("room update yard " + file("closed.json")), 0) << err;
    ASSERT_EQ(run("room show yard"), 0) << err;
    EXPECT_TRUE(says("Closed")) << out;
    EXPECT_FALSE(says("sesame")) << out;
    EXPECT_EQ(run("room kick yard 42"), 1);
    EXPECT_TRUE(complains("client 42 is not in the room")) << err;
    EXPECT_EQ(run("room role yard 42 king"), 2);
    EXPECT_EQ(run("room show stack"), 1);
    EXPECT_TRUE(complains("has no room")) << err;
}

TEST_F(CtlTest, inspects_edits_clones_and_joins_bodies) {
    ASSERT_EQ(run("inspect stack 2"), 0) << err;
    EXPECT_TRUE(says("entity            2")) << out;
    EXPECT_TRUE(says("kg/m^3, friction ")) << out;
    ASSERT_EQ(run("edit stack 2 --position 40 5 0 --mass 20 --color '#ff8000' --freeze"), 1);
    EXPECT_TRUE(complains("entity 2 is frozen; only velocity, mass and density")) << err;
    ASSERT_EQ(run("edit stack 2 --position 40 5 0 --mass 20 --color '#ff8000'"), 0) << err;
    EXPECT_EQ(out, "entity 2 of stack is changed\n");
    ASSERT_EQ(run("edit stack 2 --freeze"), 0) << err;
    ASSERT_EQ(run("inspect stack 2 --json"), 0) << err;
    EXPECT_NEAR(json()["body"]["position"]["x"].get<double>(), 40, 0.01);
    EXPECT_EQ(json()["body"]["frozen"], true);
    ASSERT_EQ(run("clone stack 2 --offset 0 0 30 --json"), 0) << err;
    const unsigned copy = json()["entity"];
    ASSERT_EQ(run("inspect stack " + std::to_string(copy) + " --json"), 0) << err;
    EXPECT_NEAR(json()["body"]["position"]["z"].get<double>(), 30, 0.01);
    EXPECT_EQ(json()["body"]["owner"], 0) << "the server owns nothing";
    const std::string body = std::to_string(copy);
    ASSERT_EQ(run("edit stack " + body + " --unfreeze"), 0) << err;
    ASSERT_EQ(run("joint create stack hinge 0 " + body +
                  " --at 40 6 30 --axis 1 0 0 --limit -1 1 --motor 2 300 --break-force 1e6 --json"),
              0)
        << err;
    const std::string joint = std::to_string(json()["joint"].get<unsigned>());
    ASSERT_EQ(run("inspect stack --joint " + joint), 0) << err;
    EXPECT_TRUE(says("kind              hinge")) << out;
    EXPECT_TRUE(says("bodies            the world and " + body)) << out;
    EXPECT_TRUE(says("breaks at         1e+06 N, unbreakable")) << out;
    ASSERT_EQ(run("inspect stack " + body), 0) << err;
    EXPECT_TRUE(says("joints: 1\n")) << out;
    ASSERT_EQ(run("joint delete stack " + joint), 0) << err;
    EXPECT_EQ(run("joint delete stack " + joint), 1);
    EXPECT_TRUE(complains("joint " + joint + " does not exist")) << err;
    write("rope.json", R"({"distance": {"maxLength": 3, "spring": {"hertz": 2}}})");
    ASSERT_EQ(run("joint create stack file 0 " + body + " --file " + file("rope.json")), 0) << err;
}

TEST_F(CtlTest, explains_wrong_edits_and_joints) {
    EXPECT_EQ(run("inspect stack"), 2);
    EXPECT_TRUE(complains("either ENTITY or --joint JOINT")) << err;
    EXPECT_EQ(run("inspect stack 999"), 1);
    EXPECT_TRUE(complains("entity 999 does not exist")) << err;
    EXPECT_EQ(run("edit stack 2"), 1);
    EXPECT_TRUE(complains("the edit changes nothing")) << err;
    EXPECT_EQ(run("edit stack 2 --color red"), 2);
    EXPECT_TRUE(complains("\"red\" is no colour; write six hexadecimal digits")) << err;
    EXPECT_EQ(run("edit stack 2 --mass 1e9"), 1);
    EXPECT_TRUE(complains("mass")) << err;
    EXPECT_EQ(run("edit stack 1 --position 0 9 0"), 1);
    EXPECT_TRUE(complains("entity 1 is not dynamic")) << err;
    EXPECT_EQ(run("joint create stack weld 0 2 --at 0 1 0"), 2);
    EXPECT_TRUE(complains("write ball, hinge, slider, fixed or distance")) << err;
    EXPECT_EQ(run("joint create stack hinge 0 2"), 2);
    EXPECT_TRUE(complains("needs its point in the world: --at 0 2 0")) << err;
    EXPECT_EQ(run("joint create stack fixed 0 2 --at 0 1 0 --motor 1 2"), 2);
    EXPECT_TRUE(complains("--motor is for hinge and slider joints, not for fixed")) << err;
    EXPECT_EQ(run("joint create stack distance 0 2"), 2);
    EXPECT_TRUE(complains("shortest and longest length")) << err;
    EXPECT_EQ(run("joint create stack file 0 2"), 2);
    EXPECT_TRUE(complains("KIND file and --file FILE together")) << err;
    EXPECT_EQ(run("joint create stack fixed 2 2 --at 0 1 0"), 1);
    EXPECT_TRUE(complains("entity_a and entity_b are equal")) << err;
    EXPECT_EQ(run("undo stack 17 --newest"), 1);
    EXPECT_TRUE(complains("the client has no action to undo")) << err;
    ASSERT_EQ(run("joint create --help"), 0);
    EXPECT_TRUE(says("Example: jostlectl joint create")) << out;
}

TEST_F(CtlTest, undoes_the_newest_action_of_a_client) {
    const auto player = grpc_player(server.grpc_address());
    player->hello();
    player->send_inputs({spawn_ball(0, 20, 0)});
    ASSERT_TRUE(player->wait_until([](const PlayState& state) { return !state.results.empty(); }));
    const std::string client =
        std::to_string(player->with_state([](const PlayState& state) { return state.client_id; }));
    ASSERT_EQ(run("undo stack " + client + " --newest"), 0) << err;
    EXPECT_TRUE(says("the newest action of client " + client + " is undone; it concerned entity "))
        << out;
    EXPECT_EQ(run("undo stack " + client + " --newest"), 1);
}

TEST_F(CtlTest, controls_the_time_of_a_room) {
    write("room.json", R"({"title": "Lab", "timelineSeconds": 60})");
    ASSERT_EQ(run("world create lab --scene stack --room " + file("room.json")), 0) << err;
    ASSERT_EQ(run("room speed lab 25"), 0) << err;
    EXPECT_EQ(out, "lab runs at 25 % of real time\n");
    EXPECT_EQ(run("room speed lab 7"), 1);
    EXPECT_TRUE(complains("multiple of 5")) << err;
    for (int k = 0; k < 100; k++)  // from the next tick on
        if (run("room ticks lab --json") != 0 || json()["speedPercent"] == 25) break;
    EXPECT_EQ(json()["speedPercent"], 25);
    ASSERT_EQ(run("room speed lab 100"), 0) << err;
    ASSERT_EQ(run("room ticks lab"), 0) << err;
    const std::string first = out.substr(0, out.find('\n'));
    ASSERT_EQ(run("pause lab"), 0) << err;
    ASSERT_EQ(run("room step lab 3"), 0) << err;
    EXPECT_TRUE(says("3 steps taken")) << out;
    EXPECT_EQ(run("room rewind lab 4000000000"), 1);
    EXPECT_TRUE(complains("tick 4000000000 cannot be restored; the timeline has ")) << err;
    ASSERT_EQ(run("resume lab"), 0) << err;
    ASSERT_EQ(run("room rewind lab " + first), 0) << err;
    EXPECT_TRUE(says("lab continues from its state after tick " + first)) << out;
    ASSERT_EQ(run("room settings lab " + file("saved.json")), 0) << err;
    ASSERT_EQ(run("room update lab " + file("saved.json")), 0) << err;
    ASSERT_EQ(run("room settings lab"), 0) << err;
    EXPECT_EQ(json()["timelineSeconds"], 60);
    write("short.json", R"({"title": "Lab"})");
    ASSERT_EQ(run("room update lab " + file("short.json")), 0) << err;
}

TEST_F(CtlTest, lists_the_reports_of_players) {
    ASSERT_EQ(run("reports"), 0) << err;
    EXPECT_EQ(out, "There are no reports of players.\n");
    const auto player = grpc_player(server.grpc_address());
    player->hello("", "ada");
    ASSERT_TRUE(player->wait_until([](const PlayState& state) { return state.client_id != 0; }));
    const unsigned client =
        player->with_state([](const PlayState& state) { return state.client_id; });
    v1::Input input;
    v1::SendMessageInput& report = *input.mutable_send_message();
    report.set_topic("report");
    report.set_to_server(true);
    report.set_data(R"({"client":)" + std::to_string(client) +
                    R"(,"name":"bob","reason":"Spam","messages":["buy\u001b[2J now"]})");
    player->send_inputs({input});
    ASSERT_TRUE(player->wait_until([](const PlayState& state) { return !state.results.empty(); }));
    ASSERT_EQ(run("reports stack --json"), 0) << err;
    ASSERT_EQ(json()["reports"].size(), 1u);
    const nlohmann::json found = json()["reports"][0];
    EXPECT_EQ(found["from"], client);
    EXPECT_EQ(found["client"], client);
    EXPECT_EQ(found["name"], "ada") << "the server knows the name";
    EXPECT_EQ(found["reason"], "Spam");
    EXPECT_GT(found["tick"], 0);
    ASSERT_EQ(run("reports"), 0) << err;
    EXPECT_TRUE(says("Spam")) << out;
    EXPECT_EQ(out.find('\x1b'), std::string::npos) << "no control characters";
    EXPECT_EQ(run("reports nowhere"), 1);
    EXPECT_TRUE(complains("there is no world \"nowhere\"")) << err;
}

TEST_F(CtlTest, lists_and_kicks_clients) {
    ASSERT_EQ(run("clients"), 0);
    EXPECT_EQ(out, "No clients are connected.\n");
    const auto player = grpc_player(server.grpc_address());
    player->hello("", "Ann\x1b[2J");
    for (int i = 0; i < 60; i++) {
        player->send_inputs({});  // contains an ack
        std::this_thread::sleep_for(16ms);
    }
    ASSERT_EQ(run("clients stack"), 0) << err;
    EXPECT_TRUE(says("Ann?[2J")) << out;
    ASSERT_EQ(run("clients --json"), 0) << "flags are accepted before and after the command";
    const auto client = json()["clients"][0];
    EXPECT_EQ(client["worldName"], "stack");
    EXPECT_GT(client["kbitPerSecond"], 0.1);
    EXPECT_GT(client["roundTripMs"], 0);
    EXPECT_GT(client["connectedSeconds"], 0);
    EXPECT_TRUE(client.contains("snapshotsSkipped"));
    ASSERT_EQ(run("kick " + std::to_string(client["id"].get<int>()) + " --reason 'be kind'"), 0)
        << err;
    ASSERT_TRUE(player->wait_for_end());
    EXPECT_EQ(*player->end(), "7: an operator removed the client: be kind");  // PERMISSION_DENIED
    EXPECT_EQ(run("kick 999"), 1);
    EXPECT_TRUE(complains("there is no client 999")) << err;
}

TEST_F(CtlTest, lists_players_and_sets_roles_attributes_and_messages) {
    ASSERT_EQ(run("players stack"), 0) << err;
    EXPECT_EQ(out, "The world has no players.\n");
    const auto player = grpc_player(server.grpc_address());
    v1::ClientMessage hello;
    hello.mutable_hello()->set_protocol(1);
    hello.mutable_hello()->set_name("Ann\xc3\xab");
    hello.mutable_hello()->set_color(0xff8000);
    hello.mutable_hello()->add_topics("chat");
    player->send(hello);
    ASSERT_TRUE(player->wait_until([](const PlayState& state) { return state.client_id != 0; }));
    const std::string id =
        std::to_string(player->with_state([](const PlayState& state) { return state.client_id; }));
    for (int i = 0; i < 100 && (run("players stack --json") != 0 || json()["players"].empty()); i++)
        player->send_inputs({});
    EXPECT_EQ(json()["players"][0]["name"], "Ann\xc3\xab");
    EXPECT_EQ(json()["players"][0]["role"], "PLAYER_ROLE_PLAYER");
    ASSERT_EQ(run("role stack " + id + " builder"), 0) << err;
    EXPECT_EQ(run("role stack 999 builder"), 1);
    EXPECT_TRUE(complains("player 999 does not exist")) << err;
    EXPECT_EQ(run("role stack " + id + " king"), 2);
    EXPECT_TRUE(complains("\"king\" is no role; write spectator, player, builder or owner")) << err;
    for (const char* set : {"score 12", "ratio 0.5", "ready true", "at 1,2,-3", "code 12 --text",
                            "secret x --visibility owner", "tool y --visibility builder,owner"}) {
        player->send_inputs({});
        ASSERT_EQ(run("set-attribute stack player:" + id + " " + set), 0) << set << err;
    }
    ASSERT_EQ(run("set-attribute stack player:" + id + " ratio --remove"), 0) << err;
    for (int i = 0; i < 100 && (run("attributes stack player:" + id + " --json") != 0 ||
                                json()["sets"][0]["attributes"].size() != 6);
         i++)
        player->send_inputs({});
    const auto attributes = json()["sets"][0]["attributes"];
    ASSERT_EQ(attributes.size(), 6u) << out;
    EXPECT_EQ(attributes[0]["vector"]["z"], -3);
    EXPECT_EQ(attributes[1]["text"], "12");
    EXPECT_EQ(attributes[2]["boolean"], true);
    EXPECT_EQ(attributes[3]["integer"], "12") << "64 bits";
    EXPECT_EQ(attributes[4]["visibility"], "ATTRIBUTE_VISIBILITY_OWNER");
    EXPECT_EQ(attributes[5]["roles"], 24);
    EXPECT_TRUE(attributes[5]["readOnly"]);
    ASSERT_EQ(run("attributes stack"), 0) << err;
    EXPECT_TRUE(says("roles:builder,owner")) << out;
    EXPECT_EQ(run("attributes stack planet:3"), 2);
    EXPECT_EQ(run("set-attribute stack world Key 1"), 1);
    EXPECT_TRUE(complains("set.attributes[0].key is invalid") || complains("key is invalid"))
        << err;
    EXPECT_EQ(run("set-attribute stack world key"), 2);
    ASSERT_EQ(run("say stack 'the match starts' --to " + id), 0) << err;
    EXPECT_TRUE(says("message 1 was sent to 1 player")) << out;
    EXPECT_EQ(run("say stack hello --to 999"), 1);
    ASSERT_TRUE(player->wait_until(
        [](const PlayState& state) { return state.newest_message == "the match starts"; }));
}

TEST_F(CtlTest, bans_lists_and_unbans) {
    ASSERT_EQ(run("bans"), 0) << err;
    EXPECT_EQ(out, "There are no bans.\nThe server has no database: bans end when it stops.\n");
    const auto player = grpc_player(server.grpc_address());
    player->hello();
    player->send_inputs({});
    ASSERT_EQ(run("ban --network 127.0.0.0/8 --hours 2 --reason 'be kind'"), 0) << err;
    EXPECT_TRUE(says("127.0.0.0/8 is banned until ")) << out;
    EXPECT_TRUE(says("the ban ends when the server stops")) << out;
    ASSERT_TRUE(player->wait_for_end());
    EXPECT_TRUE(player->end()->starts_with("7: this network is banned until ")) << *player->end();
    EXPECT_TRUE(player->end()->ends_with(": be kind")) << *player->end();
    EXPECT_EQ(run("worlds"), 1);
    EXPECT_TRUE(complains("this network is banned")) << err;
    ASSERT_EQ(run("ban --subject eve --json"), 0) << "administrators can still call AdminService";
    EXPECT_EQ(json()["ban"]["subject"], "eve");
    EXPECT_EQ(json()["persisted"], false);
    ASSERT_EQ(run("bans"), 0) << err;
    EXPECT_TRUE(says("SUBJECT  NETWORK")) << out;
    ASSERT_EQ(run("--json bans"), 0);
    ASSERT_EQ(json()["bans"].size(), 2u);
    EXPECT_EQ(json()["bans"][1]["reason"], "be kind");
    ASSERT_EQ(run("unban --network 127.0.0.0/8"), 0) << err;
    EXPECT_TRUE(says("127.0.0.0/8 is no longer banned")) << out;
    EXPECT_EQ(run("unban --network 127.0.0.0/8"), 1);
    EXPECT_EQ(run("worlds"), 0) << err;
    EXPECT_EQ(run("ban --network 127.0.0.1/8"), 1);
    EXPECT_TRUE(complains("the network is 127.0.0.0/8")) << err;
    EXPECT_EQ(run("ban"), 2);
    EXPECT_EQ(run("ban --subject eve --network 10.0.0.0/8"), 2);
    EXPECT_EQ(run("ban --subject eve --hours -1"), 2);
}

TEST_F(CtlTest, bans_survive_a_restart_with_a_database) {
    const std::vector<std::string> flags = {
        "--scene", "stack",       "--listen", "127.0.0.1:0",
        "--http",  "127.0.0.1:0", "--set",    "persistence.database=" + file("worlds.db")};
    {
        ServerProcess first{flags};
        ASSERT_EQ(run("ban --subject eve", first.grpc_address()), 0) << err;
        EXPECT_EQ(out, "eve is banned\n");
    }
    const ServerProcess second{flags};
    ASSERT_EQ(run("--json bans", second.grpc_address()), 0) << err;
    EXPECT_EQ(json()["bans"][0]["subject"], "eve");
    EXPECT_EQ(json()["persisted"], true);
}

TEST_F(CtlTest, pauses_lists_and_resumes_a_world) {
    EXPECT_EQ(run("step stack"), 1);
    EXPECT_TRUE(complains("pause it first")) << err;
    ASSERT_EQ(run("pause stack --reason 'a look'"), 0) << err;
    ASSERT_EQ(run("worlds"), 0);
    EXPECT_TRUE(says("paused: a look")) << out;
    ASSERT_EQ(run("--json step stack 7"), 0) << err;
    EXPECT_EQ(json()["stepsTaken"], 7);
    ASSERT_EQ(run("resume stack"), 0) << err;
    ASSERT_EQ(run("worlds"), 0);
    EXPECT_TRUE(says("runs")) << out;
}

TEST_F(CtlTest, creates_a_world_from_an_exported_scene) {
    ASSERT_EQ(run("export stack " + file("stack.json")), 0) << err;
    EXPECT_TRUE(says("contains tick")) << out;
    ASSERT_EQ(run("world create again --file " + file("stack.json")), 0) << err;
    ASSERT_EQ(run("--json worlds"), 0);
    EXPECT_EQ(json()["worlds"][0]["bodies"], json()["worlds"][1]["bodies"]);
    ASSERT_EQ(run("export again -"), 0) << err;
    EXPECT_EQ(json()["name"], "stack") << "standard output contains only the scene";
    EXPECT_EQ(run("export stack /nowhere/x.json"), 2);
    EXPECT_TRUE(complains("cannot write /nowhere/x.json")) << err;
    write("bad.json", "{\"bodies\": 7");
    EXPECT_EQ(run("world create bad --file " + file("bad.json")), 2);
    EXPECT_TRUE(complains(file("bad.json") + ": not valid JSON: parse error at line 1, column 13"))
        << err;
}

TEST_F(CtlTest, restores_and_rewinds_a_persisted_world) {
    EXPECT_EQ(run("rewind stack --to 1"), 1);
    EXPECT_TRUE(complains("set persistence.database to persist worlds")) << err;
    const ServerProcess kept{{"--scene", "stack", "--listen", "127.0.0.1:0", "--http",
                              "127.0.0.1:0", "--set", "persistence.database=" + file("worlds.db")}};
    const std::string at = kept.grpc_address();
    ASSERT_EQ(run("world create what-if --from stack --at 1", at), 0) << err;
    EXPECT_TRUE(says("\"what-if\" runs with 11 bodies")) << out;
    ASSERT_EQ(run("--json worlds", at), 0);
    EXPECT_EQ(json()["worlds"][0]["oldestRestorableTick"], 1);
    const unsigned before = json()["worlds"][0]["tick"];
    ASSERT_EQ(run("rewind stack --to 1", at), 0) << err;
    EXPECT_TRUE(says("stack was restored to its state after tick 1; ticks continue from ")) << out;
    ASSERT_EQ(run("--json worlds", at), 0);
    EXPECT_GT(json()["worlds"][0]["tick"], before) << "ticks never decrease";
    EXPECT_EQ(run("rewind stack --to 4000000000", at), 1);
    EXPECT_TRUE(complains("tick 4000000000 is not retained; the last retained tick is")) << err;
    EXPECT_EQ(run("world create what-if --from stack --at 1", at), 1);
    EXPECT_TRUE(complains("a world named \"what-if\" exists")) << err;
    EXPECT_EQ(run("world create --from stack --at 1", at), 2);
    EXPECT_EQ(run("world create why --from nowhere --at 1", at), 1);
    EXPECT_TRUE(complains("there is no world \"nowhere\"")) << err;
}

TEST_F(CtlTest, writes_a_profile_for_a_trace_viewer) {
    ASSERT_EQ(run("profile stack " + file("t.json") + " --seconds 1"), 0) << err;
    EXPECT_TRUE(says("ui.perfetto.dev")) << out;
    const auto trace = nlohmann::json::parse(read(file("t.json")));
    EXPECT_GT(trace["traceEvents"].size(), 60u);
}

TEST_F(CtlTest, drain_stops_the_server) {
    ASSERT_EQ(run("drain"), 0) << err;
    EXPECT_TRUE(says("0 clients notified, timeout 5 s")) << out;
    EXPECT_EQ(server.wait(5s), 0) << server.log();
    EXPECT_EQ(run("worlds"), 1);
    EXPECT_TRUE(complains("Check that jostle-server is running")) << err;
}

TEST_F(CtlTest, exits_with_2_and_an_error_message_on_invalid_flags) {
    EXPECT_EQ(run(""), 2);
    EXPECT_EQ(run("dance"), 2);
    EXPECT_EQ(run("kick"), 2);
    EXPECT_EQ(run("kick ann"), 2);
    EXPECT_EQ(run("world create arena"), 2);
    EXPECT_TRUE(complains("--scene NAME, --template NAME, --file FILE, or --from WORLD --at TICK"))
        << err;
    EXPECT_EQ(run("profile stack x --seconds 31"), 2);
    EXPECT_EQ(run("--cert a.pem worlds"), 2);
    EXPECT_TRUE(complains("--cert and --key must be given together")) << err;
    EXPECT_EQ(run("--token-file /nowhere worlds"), 2);
    EXPECT_TRUE(complains("cannot read /nowhere")) << err;
    write("token", "abc\n");
    EXPECT_EQ(run("--token-file " + file("token") + " worlds", "game.example.org:1"), 2);
    EXPECT_TRUE(complains("a token requires TLS")) << err;
    write("no.pem", "hello");
    EXPECT_EQ(run("--ca " + file("no.pem") + " worlds"), 2);
    EXPECT_TRUE(complains("is not a PEM file")) << err;
    EXPECT_EQ(run("--help"), 0);
    EXPECT_TRUE(says("jostlectl kick 17 --reason")) << "the help contains examples";
}

}  // namespace
}  // namespace jostle::test
