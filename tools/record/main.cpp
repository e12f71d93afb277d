// SPDX-License-Identifier: MIT
//
// jostle-record: joins a world as a spectator and records its stream.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <string>
#include <thread>

#include "base/command_line/command_line.h"
#include "clients/cpp/cli/security_flags.h"
#include "jostle/client/client.h"
#include "tools/record/recorder.h"

namespace {

using jostle::client::Clock;
using jostle::record::Recorder;

std::atomic<bool> stop{false};

constexpr const char* footer = R"(
Examples:
  jostle-record yard.rec --world yard                 # record until Ctrl-C
  jostle-record yard.rec --world yard --seconds 60
  jostle-replay yard.rec                              # summarize the recording
  jostle-replay yard.rec --at 1234                    # print the poses in a tick

The program joins as a spectator and records what any spectator receives: bodies, channels, events,
players, attributes and the user messages to all.
Every --keyframe-seconds it requests a keyframe, at which playback can start. A recording can be
played while it is written, and after a crash except for at most the last second. It ends when the
server, the world or the connection ends.

Exit status: 0 success, 1 the stream ended early, nothing was received or the file cannot be written
(the recorded part remains), 2 invalid flags.)";

struct Flags {
    jostle::client::SecurityFiles files;
    std::string target = "localhost:50051", world, ticket, file;
    double seconds = 0, keyframe_seconds = 5;
    std::uint32_t snapshot_hz = 0;
    bool replace = false, no_events = false, no_data = false;
};

void add_flags(CLI::App& app, Flags& flags) {
    app.add_option("FILE", flags.file, "Recording to write")->type_name("")->required();
    app.add_option("--server", flags.target,
                   "Connect to this gRPC server [default: localhost:50051]")
        ->type_name("HOST:PORT");
    jostle::client::add_security_flags(app, flags.files);
    app.add_option("--world", flags.world, "Join a world by name or id [default: the first]")
        ->type_name("WORLD");
    app.add_option("--ticket", flags.ticket, "Join with this ticket, if the server requires one")
        ->type_name("TICKET");
    app.add_option("--seconds", flags.seconds,
                   "Record for this time; 0 records until Ctrl-C [default: 0; 0 to 1e9]")
        ->type_name("SECONDS")
        ->check(CLI::Range(0.0, 1e9).description(""));
    app.add_option("--keyframe-seconds", flags.keyframe_seconds,
                   "Interval of keyframes; shorter means faster seeking and larger files\n"
                   "[default: 5; 0.25 to 3600]")
        ->type_name("SECONDS")
        ->check(CLI::Range(0.25, 3600.0).description(""));
    app.add_option("--snapshot-hz", flags.snapshot_hz,
                   "Request HZ snapshots per second; 0 is the tick rate [default: 0]")
        ->type_name("HZ");
    app.add_flag("--no-events", flags.no_events, "Do not record events");
    app.add_flag("--no-data", flags.no_data, "Do not record players, attributes and user messages");
    app.add_flag("--replace", flags.replace, "Overwrite an existing file");
    app.footer(footer);
}

std::vector<std::string> topics_of(const Flags& flags) {
    if (flags.no_data) return {};
    return {"*"};
}

jostle::client::ClientOptions options_of(const Flags& flags, Recorder& recorder) {
    return {.target = flags.target,
            .world = flags.world,
            .ticket = flags.ticket,
            .name = "recorder",
            .snapshot_hz = flags.snapshot_hz,
            .spectator = true,
            .events = !flags.no_events,
            .channels = {"*"},
            .players = !flags.no_data,
            .attributes = !flags.no_data,
            .topics = topics_of(flags),
            // Earlier versions of jostle-replay read the recording.
            .packed_entities = false,
            .reconnect = false,
            .on_message = [&recorder](const std::string& bytes, Clock::time_point now) {
                recorder.on_message(bytes, now);
            }};
}

std::string status_line(const jostle::client::RecordingWriter::Counts& counts) {
    char text[160];
    std::snprintf(text, sizeof text, "%.1f s, ticks %u to %u, %llu keyframes, %.2f MB",
                  static_cast<double>(counts.arrived_us) / 1e6, counts.first_tick, counts.last_tick,
                  static_cast<unsigned long long>(counts.keyframes),
                  static_cast<double>(counts.bytes) / 1e6);
    return text;
}

// Records for the requested time. Returns why it ended early, if it did.
std::string record(const Flags& flags, jostle::client::Client& client, Recorder& recorder) {
    const auto period = std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(flags.keyframe_seconds));
    const auto began = Clock::now();
    auto next_keyframe = began + period, next_line = began;
    const bool live = isatty(STDERR_FILENO) != 0;
    while (!stop && (flags.seconds <= 0 ||
                     Clock::now() - began < std::chrono::duration<double>(flags.seconds))) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        const auto now = Clock::now();
        if (std::string error_message = recorder.error_message(); !error_message.empty())
            return error_message;
        const auto stats = client.stats();
        if (stats.stream_failures > 0) return stats.last_error;
        if (now >= next_keyframe) {
            next_keyframe += period;
            client.request_keyframe();
        }
        if (now < next_line) continue;
        next_line = now + std::chrono::milliseconds(500);
        recorder.flush();
        if (live) std::fprintf(stderr, "\r%s ", status_line(recorder.counts()).c_str());
    }
    if (live) std::fprintf(stderr, "\n");
    return {};
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Record the stream of a world of a Jostle server."};
    Flags flags;
    add_flags(app, flags);
    if (const auto status =
            jostle::parse_command_line(app, {"jostle-record", JOSTLE_VERSION}, argc, argv))
        return *status;
    const auto fail = [](int status, const std::string& message) {
        std::fprintf(stderr, "jostle-record: %s\n", message.c_str());
        return status;
    };
    const auto security = jostle::client::read_security(flags.files, flags.target);
    if (!security.ok()) return fail(2, security.error().message);
    Recorder recorder;
    if (const auto s = recorder.open(flags.file, flags.replace); !s.ok())
        return fail(2, s.error().message);
    std::signal(SIGINT, [](int) { stop = true; });
    std::signal(SIGTERM, [](int) { stop = true; });
    std::string ended;
    {
        jostle::client::Loop loop;
        jostle::client::ClientOptions options = options_of(flags, recorder);
        options.security = *security;
        const auto client = jostle::client::Client::connect(loop, std::move(options));
        ended = record(flags, *client, recorder);
        client->leave();
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    const auto counts = recorder.counts();
    const auto finished = recorder.finish();
    if (counts.records == 0)
        return fail(1, ended.empty() ? "no response from " + flags.target : ended);
    std::printf("%s: %s\n", flags.file.c_str(), status_line(counts).c_str());
    if (!ended.empty()) return fail(1, ended);
    if (!finished.ok()) return fail(1, finished.error().message);
    return 0;
}
