// SPDX-License-Identifier: MIT
//
// jostle-replay: what is in a recording, and where everything was in any of its ticks.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <optional>
#include <string>

#include "replay/report.h"

namespace {

using jostle::client::Playback;
using jostle::client::RecordingReader;
namespace replay = jostle::replay;

constexpr const char* footer = R"(
Examples:
  jostle-replay yard.rec                    # the world, how long, how many bytes
  jostle-replay yard.rec --at 1234          # where everything was in that tick
  jostle-replay yard.rec --at 1234 --json
  jostle-replay yard.rec --verify           # decodes all and checks every CRC

jostle-record makes recordings. One that was cut off, by a crash or because it still grows, is read as far as it goes; the
summary says so. --at begins at the keyframe before the tick, so it takes as long for any tick. Positions are in m, rotations
are quaternions; a body that rests sleeps. A tick in which nothing was sent shows what was last told before it.

Exit status: 0 in order, 1 when --verify found a fault or the tick is not in the recording, 2 wrong flags or no recording.)";

struct Flags {
    std::string file;
    std::optional<std::uint32_t> at;
    bool verify = false, json = false;
};

int fail(int status, const std::string& message) {
    std::fprintf(stderr, "jostle-replay: %s\n", message.c_str());
    return status;
}

int show(const std::string& text) {
    std::fputs(text.c_str(), stdout);
    return 0;
}

int run(const Flags& flags) {
    auto recording = RecordingReader::open(flags.file);
    if (!recording.ok()) return fail(2, recording.error().message);
    if (!flags.at && !flags.verify) {
        const auto summary = summarize(*recording);
        return show(flags.json ? replay::to_json(*recording, summary)
                               : replay::to_text(*recording, summary));
    }
    Playback playback(*std::move(recording));
    if (flags.verify) {
        const auto check = jostle::client::check(playback);
        show(flags.json ? replay::to_json(check) : replay::to_text(check));
        return check.faults.empty() ? 0 : 1;
    }
    if (const auto s = playback.seek(*flags.at); !s.ok())
        return fail(1, flags.file + ": " + s.error().message);
    return show(flags.json ? replay::state_json(playback, *flags.at)
                           : replay::state_text(playback, *flags.at));
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{
        "Plays a recording of a Jostle world: tells what is in it, shows any of its ticks, or "
        "checks all of it."};
    Flags flags;
    app.add_option("file", flags.file, "The recording")->required();
    auto* at = app.add_option("--at", flags.at, "Shows the world as it was in this tick");
    app.add_flag("--verify", flags.verify, "Decodes everything and lists what is damaged")
        ->excludes(at);
    app.add_flag("--json", flags.json, "Says it as JSON");
    app.footer(footer);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    return run(flags);
}
