// SPDX-License-Identifier: MIT
//
// jostle-bot: scripted players.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <string>
#include <thread>

#include "base/command_line/command_line.h"
#include "clients/bot/bot.h"
#include "clients/cpp/cli/security_flags.h"

namespace {

using jostle::client::Clock;

std::atomic<bool> stop{false};

constexpr const char* footer = R"(
A script has one behaviour per line: NAME weight=N key=value ... ; # starts a comment.
  wander   rolls a ball                               period=2 strength=4
  push     pushes bodies towards the centre           period=1 strength=3
  throw    throws balls across the yard               period=2 speed=12 max_bodies=5
  builder  stacks boxes                               period=1 max_bodies=8 size=0.3
  drag     grabs and carries bodies                   period=3
  drive    drives controllable entities               period=0.2 change=20
  walk     walks and jumps as a character             period=0.5 change=20
  race     drives around the centre and counts laps   period=0.1 radius=45 speed=16
  idle     sends no inputs
Without --script the bots wander, push, throw, build and drag.

Exit status: 0 success, 1 a bot received no snapshots, 2 invalid flags or script.)";

struct Flags {
    jostle::client::SecurityFiles files;
    std::string target = "localhost:50051", world, script;
    int count = 5;
    double seconds = 0;
    bool events = false, datagrams = false;
};

std::string number(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", x);
    return text;
}

std::string pair(std::uint32_t a, const char* verb, std::uint32_t b) {
    return std::to_string(a) + " " + verb + " " + std::to_string(b);
}

// Formats one line per event: "tick 71: 5 hits 1 at 4.42 m/s".
std::string to_lines(const jostle::v1::Events& events) {
    std::string lines;
    const auto add = [&](const std::string& what) {
        lines += "tick " + std::to_string(events.tick()) + ": " + what + "\n";
    };
    if (events.missed() > 0) add("missed " + std::to_string(events.missed()) + " ticks");
    for (const auto& c : events.contacts_began())
        add(pair(c.entity_a(), "touches", c.entity_b()) + " at " + number(c.speed()) + " m/s");
    for (const auto& c : events.contacts_ended())
        add(pair(c.entity_a(), "separates from", c.entity_b()));
    for (const auto& c : events.contacts())
        add(pair(c.entity_a(), "presses on", c.entity_b()) + " with " + number(c.impulse()) +
            " N s");
    for (const auto& c : events.hits())
        add(pair(c.entity_a(), "hits", c.entity_b()) + " at " + number(c.speed()) + " m/s");
    for (const auto& t : events.triggers_entered()) add(pair(t.entity(), "enters", t.trigger()));
    for (const auto& t : events.triggers_stayed()) add(pair(t.entity(), "is in", t.trigger()));
    for (const auto& t : events.triggers_left()) add(pair(t.entity(), "leaves", t.trigger()));
    for (const auto& j : events.joints_broke())
        add(pair(j.entity_a(), "broke from", j.entity_b()) + " at " + number(j.force()) +
            " N and " + number(j.torque()) + " N m");
    for (const std::uint32_t entity : events.fell_asleep())
        add(std::to_string(entity) + " fell asleep");
    for (const std::uint32_t entity : events.woke()) add(std::to_string(entity) + " woke");
    return lines;
}

// Formats one line per lap: "bot 1: lap 2 in 17.9 s, 44.2 to 46.0 m from the centre".
class LapReport {
public:
    std::string new_lines(const std::vector<std::unique_ptr<jostle::bot::Bot>>& bots) {
        reported_.resize(bots.size());
        std::string lines;
        for (std::size_t i = 0; i < bots.size(); i++)
            for (const auto& laps = bots[i]->laps(); reported_[i] < laps.size(); reported_[i]++) {
                const jostle::bot::Lap& lap = laps[reported_[i]];
                lines += "bot " + std::to_string(i + 1) + ": lap " +
                         std::to_string(reported_[i] + 1) + " in " + number(lap.seconds) + " s, " +
                         number(lap.nearest) + " to " + number(lap.furthest) +
                         " m from the centre\n";
            }
        return lines;
    }

private:
    std::vector<std::size_t> reported_;  // per bot
};

// A client without TLS at a port with TLS, or the reverse, fails with errors of the transport.
std::string tls_hint(const jostle::client::Security& security) {
    return security.tls
               ? "\n  Check that the server uses TLS and that --ca contains its CA; without "
                 "TLS, omit --tls, --ca and --cert."
               : "\n  Check that jostle-server is running and that --server is its gRPC "
                 "address. If the server uses TLS, use --tls or --ca FILE.";
}

int play(const Flags& flags, const jostle::client::Security& security,
         const jostle::bot::Script& script) {
    jostle::client::Loop loop;
    std::vector<std::unique_ptr<jostle::bot::Bot>> bots;
    for (int i = 0; i < flags.count; i++)
        bots.push_back(std::make_unique<jostle::bot::Bot>(
            loop,
            jostle::client::ClientOptions{.target = flags.target,
                                          .security = security,
                                          .world = flags.world,
                                          .name = "bot " + std::to_string(i + 1),
                                          // All bots receive the same events; only the first one
                                          // subscribes.
                                          .events = flags.events && i == 0,
                                          .datagrams = flags.datagrams},
            line_for(script, i), static_cast<std::uint32_t>(i + 1)));
    const auto began = Clock::now();
    auto next_line = began + std::chrono::seconds(1);
    const bool live = isatty(STDOUT_FILENO) != 0 && !flags.events;
    std::string last_error;
    LapReport laps;
    while (!stop && (flags.seconds <= 0 ||
                     Clock::now() - began < std::chrono::duration<double>(flags.seconds))) {
        const auto now = Clock::now();
        for (const auto& bot : bots) bot->think(now);
        for (const auto& events : bots.front()->client().take_events())
            std::fputs(to_lines(events).c_str(), stdout);
        std::fputs(laps.new_lines(bots).c_str(), stdout);
        if (now >= next_line) {
            next_line = now + std::chrono::seconds(1);
            int connected = 0;
            std::uint64_t applied = 0, rejected = 0;
            for (const auto& bot : bots) {
                const auto stats = bot->client().stats();
                connected += stats.connected ? 1 : 0;
                applied += stats.inputs_applied;
                rejected += stats.inputs_refused;
                if (!stats.connected && stats.last_error != last_error) {
                    last_error = stats.last_error;
                    if (!last_error.empty())
                        std::fprintf(stderr, "\njostle-bot: %s%s\n", last_error.c_str(),
                                     stats.snapshots == 0 ? tls_hint(security).c_str() : "");
                }
            }
            if (live)
                std::printf("\r%d of %d connected, %llu inputs applied, %llu rejected ", connected,
                            flags.count, static_cast<unsigned long long>(applied),
                            static_cast<unsigned long long>(rejected));
            std::fflush(stdout);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(33));
    }
    bool all_played = true;
    for (const auto& bot : bots) {
        all_played = all_played && bot->client().stats().snapshots > 0;
        bot->client().leave();
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    if (live) std::printf("\n");
    return all_played ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Connect scripted players to a Jostle server."};
    Flags flags;
    app.add_option("--server", flags.target,
                   "Connect to this gRPC server [default: localhost:50051]")
        ->type_name("HOST:PORT");
    jostle::client::add_security_flags(app, flags.files);
    app.add_option("--world", flags.world, "Join a world by name or id [default: the first]")
        ->type_name("WORLD");
    app.add_option("--count", flags.count, "Connect N bots [default: 5; 1 to 10000]")
        ->type_name("N")
        ->check(CLI::Range(1, 10000).description(""));
    app.add_option("--script", flags.script, "Read the behaviours of the bots from FILE")
        ->type_name("FILE");
    app.add_option("--seconds", flags.seconds,
                   "Run for this time; 0 runs until Ctrl-C [default: 0]")
        ->type_name("SECONDS");
    app.add_flag("--events", flags.events, "Print the events of the world");
    app.add_flag("--datagrams", flags.datagrams,
                 "Receive snapshots as datagrams if the server supports them");
    app.footer(footer);
    if (const auto status =
            jostle::parse_command_line(app, {"jostle-bot", JOSTLE_VERSION}, argc, argv))
        return *status;
    const auto script = jostle::bot::script_or_default(flags.script);
    if (!script.ok()) {
        std::fprintf(stderr, "jostle-bot: %s\n", script.error().message.c_str());
        return 2;
    }
    const auto security = jostle::client::read_security(flags.files, flags.target);
    if (!security.ok()) {
        std::fprintf(stderr, "jostle-bot: %s\n", security.error().message.c_str());
        return 2;
    }
    std::signal(SIGINT, [](int) { stop = true; });
    std::signal(SIGTERM, [](int) { stop = true; });
    return play(flags, *security, *script);
}
