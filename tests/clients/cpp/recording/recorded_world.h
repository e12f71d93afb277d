// SPDX-License-Identifier: MIT
//
// A recording of a real world and a real session, generated in one thread without waiting: a player
// throws balls, so that bodies are spawned and deleted, changes its name and its attributes, and
// requests keyframes.
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <utility>

#include "clients/bot/behaviour.h"
#include "clients/cpp/core/src/play_protocol.h"
#include "jostle/client/playback.h"
#include "jostle/client/recording_writer.h"
#include "server/session/client_session.h"
#include "tests/support/small_scene.h"

namespace jostle::client {

struct RecordedWorld {
    std::string file;                                         // complete, with an index
    std::map<std::uint32_t, snapshot::QuantizedFrame> truth;  // of each sent tick
    std::map<std::uint32_t, std::size_t> listed;              // number of entities after that tick
    RecordingWriter::Counts counts;
};

inline RecordedWorld record_world(int ticks, int ticks_between_keyframes) {
    using namespace std::chrono_literals;
    server::Config config;
    config.auth.anonymous_role = "player";
    config.auth.audit_log = "/dev/null";
    const std::unique_ptr<server::Authorizer> authorizer = server::Authorizer::open(config).value();
    server::SessionDirectory sessions{2};
    server::WorldDirectory worlds{
        {.limits = {.scene = {.first_step_seconds_max = 100}}, .own_ticks = false}, 1};
    server::PlayContext context{
        .config = config, .worlds = worlds, .sessions = sessions, .authorizer = *authorizer};
    const std::shared_ptr<server::WorldHost> world =
        worlds.create("yard", test::small_scene()).value();

    Clock::time_point now = Clock::time_point() + 1000s;
    server::ClientSession link(context,
                               {.name = "test",
                                .address = "127.0.0.1",
                                .call = "jostle.v1.PlayService/Play",
                                .who = authorizer->identify({.address = "127.0.0.1"})},
                               now);
    RecordedWorld made;
    std::ostringstream out;
    RecordingWriter writer(out, 1'700'000'000'000'000);
    const Clock::time_point began = now;
    PlayProtocol protocol(
        ClientOptions{.name = "recorder",
                      .events = true,
                      .channels = {"*"},
                      .players = true,
                      .attributes = true,
                      .topics = {"*"},
                      .on_message = [&](const std::string& bytes, Clock::time_point when) {
                          writer.add(bytes, to_us(when) - to_us(began)).expect();
                      }});
    bot::Behaviour thrower(
        bot::parse_script("throw weight=1 period=0.2 speed=5 max_bodies=3", "script")
            .value()
            .front(),
        7);
    protocol.begin(now);
    for (int tick = 1; tick <= ticks; tick++) {
        now += 16'667us;
        world->tick(now);
        const double seconds = std::chrono::duration<double>(now - began).count();
        for (v1::Input& input : thrower.act(seconds, protocol.view(), protocol.stats().client_id))
            protocol.send(std::move(input));
        if (tick % 20 == 5) {
            v1::Attribute score;
            score.set_key("score." + std::to_string(tick / 20 % 7));
            if (tick % 60 != 5) score.set_integer(tick);
            protocol.send(
                attributes_input(AttributeTarget::player(protocol.stats().client_id), {score}));
            protocol.send(rename_input("recorder " + std::to_string(tick)));
            protocol.send(message_input("chat", std::to_string(tick)));
        }
        if (tick % ticks_between_keyframes == 0) protocol.request_keyframe();
        while (const auto said = protocol.take_message(now)) link.receive(*said, now);
        const std::uint64_t before = protocol.stats().snapshots;
        while (const auto heard = link.take_message(now))
            protocol.receive(heard->concatenated(), now);
        if (protocol.stats().snapshots == before) continue;
        const snapshot::QuantizedFrame& frame = protocol.view().frame();
        made.truth[frame.frame] = frame;
        made.listed[frame.frame] = protocol.view().entities().size();
    }
    writer.finish().expect();
    made.file = out.str();
    made.counts = writer.counts();
    return made;
}

inline Result<RecordingReader> opened(const std::string& file) {
    return RecordingReader::open(std::make_unique<std::istringstream>(file));
}

}  // namespace jostle::client
