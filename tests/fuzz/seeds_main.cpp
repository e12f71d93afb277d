// SPDX-License-Identifier: MIT
//
// Writes what fuzzing begins with, from the tests' own data and from what the server itself says:
// FOLDER/TARGET/NAME for each target, and FOLDER/dictionaries. scripts/fuzz --update-corpus makes
// the committed corpora of them.
#include <google/protobuf/util/json_util.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>

#include "jostle/datagram/content.h"
#include "jostle/datagram/packet.h"
#include "jostle/modules/character.h"
#include "jostle/modules/controlled_entity_state.h"
#include "jostle/modules/fracture_file.h"
#include "jostle/physics/serialization.h"
#include "jostle/scenes/catalog.h"
#include "jostle/scenes/scene_file.h"
#include "jostle/v1/admin.pb.h"
#include "jostle/v1/play.pb.h"
#include "jostle/v1/query.pb.h"
#include "jostle/v1/world.pb.h"
#include "server/recovery/checkpoint_data.h"
#include "server/recovery/journal_codec.h"
#include "server/recovery/world_definition.h"
#include "server/session/client_session.h"
#include "server/world/hosted_world.h"
#include "server/world/saved_host_state.h"
#include "tests/fuzz/reader.h"
#include "tests/fuzz/saved_world.h"
#include "tests/fuzz/seed_dictionaries.h"
#include "tests/fuzz/seed_scenes.h"
#include "tests/fuzz/small_server.h"
#include "tests/modules/ragdoll/gltf/gltf_skeleton.h"
#include "tests/proto/snapshot/channel_motion.h"
#include "tests/proto/snapshot/golden.h"
#include "tests/proto/snapshot/golden_entities.h"
#include "tests/server/messages/golden_tools.h"
#include "tests/support/tokens.h"

namespace jostle::fuzz {

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

std::string read_file(const std::string& path) {
    std::ifstream in(fs::path(PROJECT_FOLDER) / path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// One target's seeds, counted as they come.
class Seeds {
public:
    Seeds(const fs::path& folder, const std::string& target) : folder_(folder / target) {
        fs::create_directories(folder_);
    }
    void add(std::string_view bytes) {
        std::ofstream out(folder_ / std::to_string(count_++), std::ios::binary);
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    }
    void add(const google::protobuf::Message& message) { add(message.SerializeAsString()); }

private:
    fs::path folder_;
    int count_ = 0;
};

std::string record(std::uint8_t kind, std::string_view bytes = {}) {
    std::string out{static_cast<char>(kind), static_cast<char>(bytes.size() & 0xff),
                    static_cast<char>(bytes.size() >> 8)};
    return out.append(bytes);
}

template <class T>
void put(std::string& out, T value) {
    out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

// ---- what clients and servers say ----

v1::ClientMessage hello(bool events) {
    v1::ClientMessage message;
    message.mutable_hello()->set_protocol(1);
    message.mutable_hello()->set_name("seed");
    message.mutable_hello()->set_events(events);
    message.mutable_hello()->set_snapshot_hz(events ? 20 : 0);
    if (!events) return message;
    message.mutable_hello()->set_players(true);
    message.mutable_hello()->set_attributes(true);
    message.mutable_hello()->add_topics("*");
    message.mutable_hello()->set_color(0x336699);
    return message;
}

void set(v1::Vec3& v, double x, double y, double z) {
    v.set_x(x);
    v.set_y(y);
    v.set_z(z);
}

// One of every kind of input, from `first` on.
v1::ClientMessage inputs(std::uint32_t first) {
    v1::ClientMessage message;
    v1::InputBatch& batch = *message.mutable_input();
    batch.set_first_sequence(first);
    batch.set_client_time_us(1234);
    v1::SpawnInput& ball = *batch.add_inputs()->mutable_spawn();
    ball.mutable_shape()->mutable_sphere()->set_radius(0.4);
    set(*ball.mutable_position(), 0.1, 3, 0);
    set(*ball.mutable_linear_velocity(), 0, -5, 1);
    ball.set_color(0x123456);
    v1::SpawnInput& hull = *batch.add_inputs()->mutable_spawn();
    for (int k = 0; k < 6; k++)
        set(*hull.mutable_shape()->mutable_hull()->add_points(), k == 0 ? 1 : -0.2 * k,
            k % 2 == 0 ? 0.5 : -0.5, k < 3 ? 0.5 : -0.4);
    hull.mutable_shape()->set_friction(0.3);
    hull.mutable_rotation()->set_w(1);
    set(*hull.mutable_position(), 1, 4, 0);
    v1::ImpulseInput& push = *batch.add_inputs()->mutable_impulse();
    push.set_entity(2);
    set(*push.mutable_impulse(), 500, 0, 10);
    set(*push.mutable_point(), 0, 1, 0);
    batch.add_inputs()->mutable_grab()->set_entity(3);
    set(*batch.add_inputs()->mutable_drag()->mutable_target(), 1, 3, 1);
    batch.add_inputs()->mutable_release();
    batch.add_inputs()->mutable_delete_()->set_entity(5);
    v1::ExplodeInput& bang = *batch.add_inputs()->mutable_explode();
    set(*bang.mutable_center(), 0, 1, 0);
    bang.set_radius(5);
    bang.set_speed(10);
    v1::AttributeSet& attributes = *batch.add_inputs()->mutable_set_attributes()->mutable_set();
    attributes.set_player(1);
    v1::Attribute& number = *attributes.add_attributes();
    number.set_key("speed");
    number.set_number(1.5);
    number.set_visibility(v1::ATTRIBUTE_VISIBILITY_ROLES);
    number.set_roles(12);
    v1::Attribute& text = *attributes.add_attributes();
    text.set_key("label");
    text.set_text("red");
    text.set_visibility(v1::ATTRIBUTE_VISIBILITY_OWNER);
    attributes.add_attributes()->set_key("gone");
    v1::SendMessageInput& chat = *batch.add_inputs()->mutable_send_message();
    chat.set_topic("chat");
    chat.set_data("hello");
    chat.add_to(1);
    batch.add_inputs()->mutable_rename()->set_name("other");
    batch.add_inputs()->mutable_room()->mutable_vote_kick()->set_client(7);
    (*batch.add_inputs()->mutable_room()->mutable_settings()->mutable_quotas())["player.bodies"] =
        5;
    batch.mutable_ack()->set_frame(3);
    return message;
}

// The inputs that build and that control the time of a room.
v1::ClientMessage tool_inputs() {
    v1::ClientMessage message = server::golden_tool_inputs();
    v1::InputBatch& batch = *message.mutable_input();
    batch.mutable_inputs(0)->mutable_edit()->set_entity(3);
    batch.mutable_inputs(1)->mutable_clone()->set_entity(3);
    v1::CreateJointInput& joint = *batch.mutable_inputs(2)->mutable_create_joint();
    joint.set_entity_b(3);
    batch.mutable_inputs(3)->mutable_delete_joint()->set_joint(1);
    v1::CreateJointInput& spring = *batch.add_inputs()->mutable_create_joint();
    spring.set_entity_a(2);
    spring.set_entity_b(3);
    v1::DistanceJoint& distance = *spring.mutable_joint()->mutable_distance();
    distance.set_max_length(3);
    distance.set_rest_length(1);
    distance.mutable_spring()->set_hertz(2);
    return message;
}

v1::ClientMessage with(const std::function<void(v1::ClientMessage&)>& change) {
    v1::ClientMessage message;
    change(message);
    return message;
}

v1::ClientMessage ping() {
    return with([](auto& m) { m.mutable_ping()->set_client_time_us(99); });
}

v1::ClientMessage leave() {
    return with([](auto& m) { m.mutable_leave(); });
}

std::vector<v1::ClientMessage> client_messages() {
    return {hello(false), hello(true),   inputs(1),
            inputs(12),   tool_inputs(), with([](auto& m) { m.mutable_ack()->set_frame(7); }),
            ping(),       leave()};
}

// Kinds of records: tests/fuzz/client_session.cpp.
std::string write_conversation(bool events) {
    std::string out = record(0, hello(events).SerializeAsString()) + record(3);
    for (std::uint32_t round = 0; round < 3; round++) {
        out += record(0, inputs(1 + 11 * round).SerializeAsString());
        out += record(1, "\3") + record(2, std::string("\x40\0", 2)) + record(3) + record(5, "\1");
    }
    v1::ClientMessage tools = tool_inputs();
    tools.mutable_input()->set_first_sequence(40);
    out += record(0, tools.SerializeAsString()) + record(1, "\1") + record(3);
    out += record(4) + record(0, ping().SerializeAsString());
    return out + record(0, leave().SerializeAsString()) + record(3);
}

// What a server says to a client who plays, each message for itself.
std::vector<std::string> server_messages(bool events) {
    SmallServer small;
    server::Clock::time_point now = server::Clock::time_point() + 1000s;
    server::ClientSession link(small.context,
                               server::Peer{.name = "seed",
                                            .address = "127.0.0.1",
                                            .call = "jostle.v1.PlayService/Play",
                                            .who = small.anybody()},
                               now);
    std::vector<std::string> said;
    const auto listen = [&] {
        while (const auto out = link.take_message(now)) said.push_back(out->concatenated());
    };
    link.receive(hello(events).SerializeAsString(), now);
    for (std::uint32_t round = 0; round < 4; round++) {
        listen();
        link.receive(ping().SerializeAsString(), now);
        link.receive(inputs(1 + 11 * round).SerializeAsString(), now);
        small.worlds.find("")->tick(now += 60ms);
    }
    listen();
    return said;
}

void write_play(const fs::path& folder) {
    Seeds messages(folder, "play_message"), link(folder, "client_link"),
        client(folder, "client_conversation");
    for (const v1::ClientMessage& message : client_messages()) messages.add(message);
    for (const bool events : {false, true}) {
        link.add(write_conversation(events));
        std::string all;
        for (const std::string& message : server_messages(events)) {
            client.add(record(0, message));
            all += record(0, message);
            if (message.size() % 3 == 0) all += record(1, std::string("\x20\0", 2));
        }
        client.add(all + record(1) + record(3) + record(2) + record(4));
    }
}

// ---- frames ----

// Kinds of records: tests/fuzz/frames.h, how far back each base lies, and the codec.
std::string frames_of(const snapshot::GoldenSequence& golden, snapshot::Codec codec) {
    std::string out(1, golden.name == "precise" ? '\1' : '\0');
    const auto find = [&](std::uint32_t number) -> const snapshot::QuantizedFrame* {
        for (const snapshot::GoldenFrame& g : golden.frames)
            if (number != 0 && g.frame.frame == number) return &g.frame;
        return nullptr;
    };
    std::uint32_t newest = 0;
    for (std::size_t i = 0; i < 8; i++) {
        const snapshot::GoldenFrame& g = golden.frames[i];
        const auto packed = encode_frame(
            g.frame, {find(g.base), find(g.baseline2), find(g.baseline3)}, golden.spec, codec);
        std::string bytes(1, static_cast<char>(g.frame.frame - newest - 1));
        bytes.append(reinterpret_cast<const char*>(packed.data()), packed.size());
        const int baselines = (g.base != 0) + (g.baseline2 != 0) + (g.baseline3 != 0);
        const int kind = (0b010101 & ((1 << 2 * baselines) - 1)) | (codec == snapshot::Codec::range)
                                                                       << 7;
        out += record(static_cast<std::uint8_t>(kind), bytes);
        newest = g.frame.frame;
    }
    return out;
}

void write_frames(const fs::path& folder) {
    Seeds decode(folder, "frame_decode"), round_trip(folder, "frame_round_trip");
    for (const snapshot::GoldenSequence& golden : snapshot::golden_sequences())
        for (const snapshot::Codec codec : {snapshot::Codec::bits, snapshot::Codec::range})
            decode.add(frames_of(golden, codec));
    Seeds lists(folder, "entity_list_decode");
    for (const snapshot::GoldenEntities& list : snapshot::golden_entity_lists()) {
        if (list.prototypes > 255) continue;  // one byte in a record
        const auto packed = snapshot::encode_entity_list(list.entities, list.prototypes);
        lists.add(record(static_cast<std::uint8_t>(list.prototypes),
                         {reinterpret_cast<const char*>(packed.data()), packed.size()}));
    }
    Seeds channels(folder, "channel_decode");
    snapshot::ChangingChannels changing(7);
    for (int k = 0; k < 8; k++) {
        // Against nothing, then against it: of the records of an input the first finds no base.
        const snapshot::Channels first = changing.step(), second = changing.step();
        const auto bytes = [](const snapshot::PackedChannels& packed) {
            return std::string(reinterpret_cast<const char*>(packed.bytes.data()),
                               packed.bytes.size());
        };
        channels.add(record(0, bytes(snapshot::encode_channels(first, {}, ~0ull))) +
                     record(1, bytes(snapshot::encode_channels(second, first, ~0ull))));
    }
    for (std::uint32_t seed = 1; seed <= 4; seed++) {
        snapshot::Random random(seed);
        std::string out(1, static_cast<char>(seed % 3));
        for (int k = 0; k < 300; k++) out += static_cast<char>(random.below(256));
        round_trip.add(out);
    }
}

// ---- scenes and worlds ----

constexpr std::size_t saved_bytes_max = 4096;  // more would be one world in a thousand runs

// The particles of every_module.json, alone.
v1::Scene particle_scene() {
    v1::Scene whole, piece;
    static_cast<void>(google::protobuf::util::JsonStringToMessage(
        read_file("tests/scenes/data/every_module.json"), &whole));
    piece.set_name("particles");
    *piece.add_bodies() = whole.bodies(0);
    for (const v1::Module& module : whole.modules())
        if (module.has_particles()) *piece.add_modules() = module;
    return piece;
}

void write_scenes(const fs::path& folder) {
    Seeds message(folder, "scene_message"), json(folder, "scene_json"),
        saved(folder, "saved_world");
    for (const char* path :
         {"tests/scenes/data/every_field.json", "tests/scenes/data/every_module.json",
          "tests/scenes/data/planar.json", "scenes/data/carousel.json", "scenes/data/chain.json",
          "scenes/data/crater.json", "scenes/data/gate.json", "scenes/data/linkage.json",
          "scenes/data/towers.json"})
        json.add(read_file(path));
    const auto add = [&](const physics::World& world) {
        const auto bytes = save(world);
        const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        if (bytes.size() <= saved_bytes_max) saved.add(text);
    };
    v1::Scene whole;
    static_cast<void>(google::protobuf::util::JsonStringToMessage(
        read_file("tests/scenes/data/every_field.json"), &whole));
    whole.clear_modules();  // of the tests alone
    std::vector<v1::Scene> pieces = single_feature_scenes(whole);
    pieces.push_back(scenes::to_message(scenes::find_scene("hovercraft").value()));
    pieces.push_back(particle_scene());
    for (const v1::Scene& scene : pieces) {
        message.add(scene);
        const auto description = scenes::from_message(scene).value();
        json.add(scenes::write_scene_json(description));
        auto built = scenes::build_scene(description).value();
        for (int k = 0; k < 30; k++) built.world.step(1.0 / 60).expect();
        add(built.world);
    }
    for (const physics::World& world : small_worlds()) add(world);
}

// ---- geometry ----

void write_geometry(const fs::path& folder) {
    Seeds hull(folder, "hull_points"), terrain(folder, "terrain");
    hull.add(std::string("\0\0\0\0\20\0\0\0\20\0\0\0\20\20\20\20", 16));
    snapshot::Random random(7);
    std::string cloud(1, '\1'), box(1, '\2');
    for (int k = 0; k < 3 * 40; k++) put(cloud, static_cast<std::int32_t>(random.in(-1e8, 1e8)));
    for (int k = 0; k < 8; k++)
        for (int axis = 0; axis < 3; axis++) put(box, (k >> axis & 1) != 0 ? 0.5 : -0.5);
    hull.add(cloud);
    hull.add(box);
    // The target makes the head: tests/fuzz/fracture_file.cpp.
    Seeds fracture(folder, "fracture_file");
    const physics::Vec3 half{1, 0.5, 0.25};
    modules::FracturedShape boxes = modules::split_box(half, 3, 1, 1).value();
    modules::anchor(boxes, {-1, 0, 0}, 0.99);
    for (const auto& shape :
         {boxes, modules::fracture_box(half, modules::random_seeds(half, 4, 1)).value()}) {
        const auto bytes = modules::write_fracture(shape).value();
        fracture.add(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size())
                         .substr(modules::fracture_header_bytes));
    }
    // Four vertices on the grid and two triangles; then a height field of 4 x 4.
    terrain.add(std::string("\0\0\4\0\0\0\20\0\0\20\0\20\0\1\20\0\1\2\0\2\3", 21));
    std::string field("\1\4\4\1\20\20", 6);
    for (int k = 0; k < 16; k++) field += static_cast<char>(random.below(20));
    terrain.add(field + std::string("\0\0\1\0\0\0\0\0\0", 9));
}

std::string call(std::uint8_t kind, std::initializer_list<double> numbers) {
    std::string bytes;
    for (const double x : numbers) put(bytes, x);
    return record(kind, bytes);
}

// Of a character that walks, for entity 4 and tick 7: what its module tells of it.
std::string controlled_character() {
    physics::World world;
    world
        .create_body({.type = physics::BodyType::static_body, .pose = {{0, -0.5, 0}, {}}},
                     {.geometry = physics::Box{{50, 0.5, 50}}})
        .value();
    modules::Characters crowd;
    const modules::CharacterId hero = crowd.add(world, {.feet = {0, 0.02, 0}}).value();
    const physics::BodyId body = crowd.state(world, hero)->body;
    std::string bytes;
    put(bytes, 4.0);
    put(bytes, 7.0);
    const auto words = modules::encode_controlled_entity(world, crowd, body, [](physics::BodyId) {
                           return 4u;
                       }).value();
    for (const std::uint32_t word : words) put(bytes, word);
    return bytes;
}

// Kinds of calls: tests/fuzz/predictor_api.cpp. A crate on a floor is pushed, held and put right.
void write_predictor(const fs::path& folder) {
    Seeds calls(folder, "predictor_calls");
    const auto box = [](double entity, double x, double y) {
        return call(
            1,
            {entity,       1, 1, 3,    0, 0, 0, 0, 0, 0, 1, x, y, x, 0.5, 0, 0, 0, 0, 0, 0, 1, 4, 1,
             4294967295.0, 0, 0, 1000, 0});
    };
    const auto frame = [](double number, double x) {
        return call(2, {1, number, 1, 0, -0.5, 0, 0, 0, 0, 1, 1, 2, x, 0.25, 0, 0, 0, 0, 1, 0});
    };
    calls.add(call(0, {1, 3, 0}) + box(1, 50, 0.5) + call(0, {2, 2, 100}) + box(2, 0.25, 0.25) +
              call(6, {2, 1}) + frame(5, 0) + call(3, {1, 1, 8.5, 1e6}) +
              call(4, {3, 9, 300, 0, 0}) + call(3, {1, 1, 10, 1.02e6}) + call(4, {4, 11, 0, 1, 0}) +
              call(4, {5, 12, 1, 1, 1}) + frame(8, 0.2) + call(5, {5, 30}) + frame(40, 1) +
              call(3, {1, 1, 50, 1.3e6}) + call(7, {2, 1}) + frame(41, 1));
    // A character that is driven: kind 69 is set_body of one that a module moves.
    calls.add(call(0, {1, 3, 0}) + box(1, 50, 0.5) + call(0, {4, 1, 0}) +
              call(1, {4, 1, 1, 2, 0, 0.9,          0, 0, 0,    0, 1, 0.28, 0.6, 0.5, 0, 0, 0, 0,
                       0, 0, 1, 4, 1, 4294967295.0, 0, 0, 1000, 0}) +
              call(69, {4, 1, 0, 0, 1}) + call(6, {4, 1}) + record(11, controlled_character()) +
              call(2, {1, 7, 1, 0, -0.5, 0, 0, 0, 0, 1, 1, 4, 0, 0, 0, 0, 0, 0, 1, 1}) +
              call(10, {1, 9, 0, 1}) + call(3, {1, 1, 20, 1e6}));
}

// Kinds of the first byte: tests/fuzz/gltf_skeleton.cpp. Without a mesh it is small.
void write_skeletons(const fs::path& folder) {
    Seeds skeletons(folder, "gltf_skeleton");
    const auto add = [&](char kind, const std::vector<std::byte>& file) {
        skeletons.add(kind + std::string(reinterpret_cast<const char*>(file.data()), file.size()));
    };
    modules::GltfSkeleton skeleton;
    add('1', skeleton.with_external_buffer());
    for (const char* part : {"meshes", "accessors", "bufferViews"}) skeleton.json.erase(part);
    skeleton.json["skins"][0].erase("inverseBindMatrices");
    skeleton.json["nodes"].erase(skeleton.json["nodes"].size() - 1);  // which shows the mesh
    skeleton.buffer = "none";
    add('0', skeleton.gltf());
    add('0', skeleton.glb());
}

// ---- text and requests ----

void write_text(const fs::path& folder) {
    Seeds config(folder, "config_text"), script(folder, "bot_script"),
        target(folder, "http_target"), head(folder, "http_head"), socket(folder, "websocket"),
        routes(folder, "http_routes"), token(folder, "json_web_token"), keys(folder, "key_set");
    config.add(read_file("server/jostle-server.toml"));
    config.add("listen = \"[::1]:0\"\nscenes = [\"stack\"]\n[client]\ninputs_per_second = 1e3\n");
    script.add(read_file("clients/bot/scripts/sandbox.bots"));
    script.add("wander weight=2 period=0.5 strength=4 # so\npush\nthrow keep=3\nwatch weight=0\n");
    for (const char* path :
         {"/", "/index.html", "/assets/app.js?v=1", "/a%20b/c#d", "/api/worlds", "/%2e%2e/secret",
          "/debug/profile?world=my%20arena&seconds=5", "/.git/config", "/a//b/", "/\xc3\xa4.png"}) {
        target.add(path);
        routes.add("GET\n" + std::string(path) + "\nlocalhost\n\n\n\n");
    }
    const std::string get = "GET /play HTTP/1.1\r\nHost: localhost:8080\r\n";
    head.add("\xff" + get + "\r\n");
    head.add(
        "\4POST /api/worlds HTTP/1.1\r\nHost: a\r\nOrigin: http://a\r\nContent-Type: "
        "application/json\r\nContent-Length: 2\r\n\r\n{}GET / HTTP/1.0\r\n\r\n");
    head.add(
        "\xffPUT / HTTP/1.1\r\nTransfer-Encoding: chunked\r\nExpect: 100-continue\r\n\r\n"
        "3;x=y\r\nabc\r\n0\r\nTrailer: t\r\n\r\n");
    const std::string upgrade = get +
                                "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Key: "
                                "dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n";
    head.add("\xff" + upgrade);
    // Frames of a client are masked: binary in two pieces, text, ping, close.
    socket.add(upgrade + std::string("\2\202abcd\1\2\200\201abcd\3", 15));
    socket.add(upgrade + std::string("\201\203abcd\xc4\xa5y\211\200abcd", 15));
    socket.add(upgrade + std::string("\210\202abcd\x62\x8a", 8));
    test::LoginService login;
    const test::Json claims =
        test::LoginService::claims("anna", "player", server::WallTime(1'790'000'000s));
    token.add("1" + login.header().dump() + "\n" + claims.dump());
    token.add("0" + login.token(claims));
    keys.add(login.published());
    const std::string post = "\nlocalhost\n\napplication/json\n\n\n";
    routes.add("POST\n/api/worlds" + post + R"({"name":"x","sceneName":"stack"})");
    routes.add("POST\n/api/worlds" + post +
               R"({"scene":{"name":"a","bodies":[{"shapes":[{"sphere":{"radius":0.5}}]}]}})");
    routes.add("DELETE\n/api/worlds/w1" + post);
    routes.add("POST\n/api/query/CastRays" + post +
               R"({"rays":[{"origin":{"y":5},"motion":{"y":-9}}],"mode":"HIT_MODE_ALL"})");
    routes.add("POST\n/api/query/Overlap" + post +
               R"({"shape":{"box":{"halfExtents":{"x":1,"y":1,"z":1}}},"filter":{"ignore":2}})");
    routes.add("POST\n/api/query/Debug" + post + R"({"contacts":true,"bounds":true})");
}

// The first byte names the method: tests/fuzz/rpc_request.cpp.
void write_requests(const fs::path& folder) {
    Seeds seeds(folder, "rpc_request");
    const auto add = [&](char method, const google::protobuf::Message& message) {
        seeds.add(method + message.SerializeAsString());
    };
    v1::CastRaysRequest rays;
    set(*rays.add_rays()->mutable_origin(), 0, 5, 0);
    set(*rays.mutable_rays(0)->mutable_motion(), 0, -9, 0);
    rays.set_mode(v1::HIT_MODE_ALL);
    rays.mutable_filter()->set_ignore(2);
    add(0, rays);
    v1::CastShapesRequest shapes;
    v1::MovingShape& moving = *shapes.add_shapes();
    moving.mutable_shape()->mutable_sphere()->set_radius(0.2);
    set(*moving.mutable_shape()->mutable_position(), 0, 5, 0);
    set(*moving.mutable_motion(), 0, -9, 0);
    add(1, shapes);
    v1::OverlapRequest overlap;
    set(*overlap.mutable_shape()->mutable_box()->mutable_half_extents(), 1, 2, 1);
    add(2, overlap);
    v1::ClosestPointsRequest closest;
    set(*closest.add_points(), 1, 2, 3);
    add(3, closest);
    v1::DebugRequest debug;
    for (int k = 0; k < debug.GetDescriptor()->field_count(); k++)
        if (const auto* field = debug.GetDescriptor()->field(k);
            field->cpp_type() == google::protobuf::FieldDescriptor::CPPTYPE_BOOL)
            debug.GetReflection()->SetBool(&debug, field, true);
    add(4, debug);
    v1::CreateWorldRequest create;
    *create.mutable_scene() = scenes::to_message(test::small_scene());
    create.set_name("second");
    add(5, create);
    add(6, v1::JoinWorldRequest());
    v1::GetWorldRequest get;
    get.set_world("w1");
    add(7, get);
    v1::DeleteWorldRequest remove;
    remove.set_world("w1");
    add(8, remove);
    add(9, v1::ListClientsRequest());
    v1::KickRequest kick;
    kick.set_client(1);
    add(10, kick);
    v1::SetPausedRequest pause;
    pause.set_world("w1");
    pause.set_paused(true);
    add(11, pause);
    v1::ListPlayersRequest players;
    players.set_world("w1");
    add(14, players);
    v1::GetAttributesRequest attributes;
    attributes.set_world("w1");
    attributes.mutable_target()->set_world(true);
    add(15, attributes);
}

// ---- HTTP/2 ----

std::string http2_frame(std::uint8_t type, std::uint8_t flags, std::uint8_t stream,
                        std::size_t length) {
    std::string out{0,
                    static_cast<char>(length >> 8),
                    static_cast<char>(length),
                    static_cast<char>(type),
                    static_cast<char>(flags),
                    0,
                    0,
                    0,
                    static_cast<char>(stream)};
    return out + std::string(length, 'x');
}

void write_http2(const fs::path& folder) {
    Seeds seeds(folder, "frame_guard");
    const std::string hello = "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n" + http2_frame(4, 0, 0, 36);
    seeds.add(hello + http2_frame(4, 1, 0, 0) + http2_frame(1, 4, 1, 60) +
              http2_frame(0, 1, 1, 40) + http2_frame(8, 0, 0, 4) + http2_frame(6, 1, 0, 8));
    seeds.add(hello + http2_frame(1, 0, 1, 20) + http2_frame(9, 0, 1, 20) +
              http2_frame(9, 4, 1, 20) + http2_frame(3, 0, 1, 4) + http2_frame(7, 0, 0, 8));
    std::string resets = hello;
    for (std::uint8_t stream = 1; stream < 120; stream += 2)
        resets += http2_frame(1, 5, stream, 1) + http2_frame(3, 0, stream, 4);
    seeds.add(resets);
    seeds.add(hello + http2_frame(2, 0, 1, 5) + http2_frame(5, 0, 1, 9));
    seeds.add("GET / HTTP/1.1\r\n");
}

// A packet, and contents: whole, in parts that come in disorder, a question, an answer.
// A world in which a few things were done, and what was done.
void write_persisted(const fs::path& folder) {
    Seeds seeds(folder, "kept_bytes");
    auto world = server::HostedWorld::create(*scenes::find_scene("stack"), {}, 1);
    world->enable_journal();
    server::SpawnCommand ball;
    ball.shape.geometry = physics::Sphere{0.3};
    ball.pose.position = {5, 9, 0};
    ball.color = 0x336699;
    const server::SetAttributesCommand attributes{
        {server::AttributeTargetKind::player, 1},
        {{"speed", 1.5, server::AttributeVisibility::roles, 8},
         {"label", std::string("red"), server::AttributeVisibility::owner},
         {"at", physics::Vec3{1, 2, 3}},
         {"ready", true},
         {"score", std::int64_t{-3}}}};
    const server::Action actions[] = {
        server::JoinCommand{"ada", server::PlayerRole::owner, 0x336699},
        attributes,
        server::SendMessageCommand{"chat", "hello", {1}},
        server::RenameCommand{"bea"},
        server::SetRoleCommand{1, server::PlayerRole::builder},
        ball,
        server::GrabCommand{11, {5, 9, 0}},
        server::DragCommand{{6, 9, 0}},
        server::ImpulseCommand{3, {1, 2, 3}, physics::Vec3{0, 1, 0}},
        server::ExplodeCommand{{0, 1, 0}, 3, 2},
        server::EditCommand{.entity = 11, .mass = 20, .color = 0xff8000, .frozen = true},
        server::CloneCommand{11, {3, 0, 0}, true},
        server::CreateJointCommand{
            .entity_b = 11,
            .frame = physics::Transform{{5, 9, 0}, {}},
            .joint = {.kind = physics::HingeJoint{.limit = {true, -1, 1}}, .break_force = 500}},
        server::DeleteJointCommand{1},
        server::UndoCommand{},
        server::DeleteCommand{11},
        server::PossessCommand{2},
        server::ControlCommand{},
        server::DisconnectCommand{},
        server::LeaveCommand{true}};
    server::JournalSegment journal{{}, {{2, 4}}};
    std::uint32_t tick = 0;
    for (const server::Action& action : actions) {
        tick++;
        world->apply({.client = 1, .sequence = tick, .action = action, .reply = {}}, tick);
        seeds.add(server::encode_host_state(world->host_state(tick)));
        journal.ticks.push_back({tick, world->take_journal()});
        seeds.add(server::encode_journal({{journal.ticks.back()}, {}}));
    }
    seeds.add(server::encode_journal(journal));
    world->set_room(server::new_room({.title = "Yard", .tags = {"race"}}, "ada"));
    const server::RoomCommand commands[] = {
        {server::EnterRoom{.member = "subject/ada"}},
        {server::ProtectArea{{"tower", {-1, 0, -1}, {1, 9, 1}}}},
        {server::BanClient{1, 60, "spam"}},
        {server::UpdateRoom{}}};
    for (const server::RoomCommand& command : commands) {
        tick++;
        world->apply({.client = 2, .sequence = tick, .action = command, .reply = {}}, tick);
        seeds.add(server::encode_host_state(world->host_state(tick)));
        seeds.add(server::encode_journal({{{tick, world->take_journal()}}, {}}));
    }
    seeds.add(server::encode_journal(
        {.ticks = {}, .paused_ticks = {}, .rewind = server::Rewind{90, 30}}));
    seeds.add(server::encode_journal(
        {.ticks = {}, .paused_ticks = {}, .rewind = {}, .undo = server::Undo{90, 30, 1}}));
    server::CheckpointCopy moment{
        .tick = tick, .bodies = {}, .host_state = world->host_state(tick)};
    moment.bodies.capture(world->world());
    seeds.add(server::encode_checkpoint(moment).value().bytes);
    seeds.add(server::encode_world_definition(
        {.owner = "ada",
         .scene = std::make_shared<const scenes::SceneDescription>(*scenes::find_scene("stack")),
         .limits = {},
         .work_per_second = 1e6}));
}

void write_datagrams(const fs::path& folder) {
    Seeds seeds(folder, "datagram_packet");
    datagram::Credentials ticket{.id = 0x0807060504030201};
    ticket.key.fill(7);
    const auto client = datagram::PacketCipher::make(ticket, datagram::Side::client).value();
    const std::string small = "snapshot", large(2500, 'x');
    const auto contents = [](std::string_view message, std::uint32_t number) {
        return datagram::encode_message(std::span(&message, 1), number);
    };
    seeds.add(client->encrypt(contents(small, 1)[0]));
    seeds.add(record(0, contents(small, 1)[0]) +
              record(0, datagram::encode(datagram::PathChallenge{7})) +
              record(0, datagram::encode(datagram::PathResponse{7})));
    const auto parts = contents(large, 2), next = contents(large, 3);
    seeds.add(record(0, parts[2]) + record(0, next[0]) + record(0, parts[0]) + record(0, parts[1]) +
              record(0, next[1]));
}

// What a server says to a sink: a welcome and a snapshot, over each transport. The first byte says
// which.
void write_passive_client_streams(const fs::path& folder) {
    Seeds seeds(folder, "sink_stream");
    v1::ServerMessage welcome, snapshot;
    welcome.mutable_welcome()->set_client_id(1);
    welcome.mutable_welcome()->set_tick_hz(60);
    welcome.mutable_welcome()->set_ack_interval_ms(100);
    snapshot.mutable_snapshot()->set_frame(5);
    snapshot.mutable_snapshot()->set_late_us(-100);
    std::string raw("\1"), socket("\0HTTP/1.1 101 x\r\ns3pPLMBiTxaQ9kYGzzhZRbK+xOo=\r\n\r\n", 49);
    std::string http2 = "\2" + http2_frame(4, 0, 0, 0) + http2_frame(1, 4, 1, 1);
    for (const auto& message : {welcome, snapshot}) {
        const std::string bytes = message.SerializeAsString();
        const char size = static_cast<char>(bytes.size());
        raw += size + std::string(3, '\0') + bytes;
        socket += std::string("\202") + size + bytes;
        http2 += http2_frame(0, 0, 1, 0).replace(2, 1, 1, static_cast<char>(size + 5)) +
                 std::string(4, '\0') + size + bytes;
    }
    seeds.add(raw);
    seeds.add(socket + "\211" + '\0');
    seeds.add(http2 + http2_frame(6, 0, 0, 8) + http2_frame(1, 5, 1, 1));
    seeds.add("\3" + http2.substr(1) + http2_frame(7, 0, 0, 8));
}

}  // namespace

}  // namespace jostle::fuzz

int main(int count, char** arguments) {
    if (count != 2) {
        std::cerr << "usage: fuzz-seeds FOLDER\n";
        return 2;
    }
    using namespace jostle::fuzz;
    const fs::path folder = arguments[1];
    for (const auto write :
         {write_play, write_frames, write_scenes, write_geometry, write_predictor, write_skeletons,
          write_text, write_requests, write_http2, write_passive_client_streams, write_datagrams,
          write_persisted})
        write(folder);
    write_dictionaries(folder / "dictionaries");
}
