// SPDX-License-Identifier: MIT
//
// jostle-load: many scripted clients against one server, a report, and a verdict.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <thread>

#include "bot/player.h"
#include "flags/security_flags.h"
#include "load/report.h"
#include "load/server_cpu.h"

namespace {

using jostle::client::Clock;
using jostle::load::Report;
using Players = std::vector<std::unique_ptr<jostle::bots::Player>>;

std::atomic<bool> stop{false};

constexpr const char* footer = R"(
The report: clients, connected (to the end), inputs_sent, inputs_accepted (applied by the server), snapshots (decoded, CRC
checked), kbit_per_second_per_client, snapshots_per_second_per_client, age_ms_p50 and age_ms_p99 (from the moment a tick was due
on the server to its decoding here), errors (streams that ended, snapshots that did not decode, inputs of good form that were
refused), server_cpu_percent (of one core; when the server is on this machine). Figures are taken after the ramp.

Exit status: 0 plan kept, 1 plan missed, 2 wrong flags or script.)";

struct Flags {
    jostle::client::SecurityFiles files;
    std::string target = "localhost:50051", world, script, json;
    int clients = 10;
    double seconds = 10, ramp = 1;
    int server_pid = 0;
    jostle::load::Plan plan;
};

struct Totals {
    int connected = 0;
    std::uint64_t sent = 0, applied = 0, snapshots = 0, bytes = 0, failures = 0, decode = 0;
    std::string last_error;
};

Totals totals_of(const Players& players) {
    Totals t;
    for (const auto& player : players) {
        const auto s = player->client().stats();
        t.connected += s.connected ? 1 : 0;
        t.sent += s.inputs_sent;
        t.applied += s.inputs_applied;
        t.snapshots += s.snapshots;
        t.bytes += s.bytes_received;
        t.failures += s.stream_failures;
        t.decode += s.decode_errors;
        if (!s.last_error.empty()) t.last_error = s.last_error;
    }
    return t;
}

// Refusals that a good client may meet are no errors: a body that somebody took away meanwhile, a
// full world.
std::uint64_t count_bad_refusals(jostle::bots::Player& player, std::string& last_error) {
    std::uint64_t bad = 0;
    for (const auto& result : player.client().take_results())
        if (result.code() == jostle::v1::INPUT_CODE_INVALID ||
            result.code() == jostle::v1::INPUT_CODE_NOT_ALLOWED) {
            bad++;
            last_error = result.message();
        }
    return bad;
}

Report run(const Flags& flags, const jostle::client::Security& security,
           const jostle::bots::Script& script) {
    jostle::client::Loop loop;
    Players players;
    Report report{.clients = flags.clients};
    std::vector<float> ages;
    std::uint64_t refusals = 0;
    std::optional<int> pid;
    if (flags.server_pid > 0)
        pid = flags.server_pid;
    else
        pid = jostle::load::find_listener(flags.target);

    const auto began = Clock::now();
    const auto seconds_since = [](Clock::time_point t) {
        return std::chrono::duration<double>(Clock::now() - t).count();
    };
    std::optional<Clock::time_point> measured;
    Totals at_ramp;
    std::optional<double> cpu_at_ramp;
    auto next_line = began;
    const bool live = isatty(STDERR_FILENO) != 0;
    while (!stop && seconds_since(began) < flags.ramp + flags.seconds) {
        const double t = seconds_since(began);
        const double share = flags.ramp > 0 ? std::min(1.0, t / flags.ramp) : 1;
        const int wanted = std::max(1, static_cast<int>(share * flags.clients + 0.5));
        while (static_cast<int>(players.size()) < wanted) {
            const int i = static_cast<int>(players.size());
            players.push_back(std::make_unique<jostle::bots::Player>(
                loop,
                jostle::client::ClientOptions{.target = flags.target,
                                              .security = security,
                                              .world = flags.world,
                                              .name = "load " + std::to_string(i + 1)},
                line_for(script, i), static_cast<std::uint32_t>(i + 1)));
        }
        const auto now = Clock::now();
        for (const auto& player : players) {
            player->think(now);
            refusals += count_bad_refusals(*player, report.last_error);
            const auto fresh = player->client().take_ages_ms();
            if (measured) ages.insert(ages.end(), fresh.begin(), fresh.end());
        }
        if (!measured && t >= flags.ramp) {
            measured = now;
            at_ramp = totals_of(players);
            if (pid) cpu_at_ramp = jostle::load::cpu_seconds(*pid);
        }
        if (live && now >= next_line) {
            next_line = now + std::chrono::milliseconds(500);
            const Totals totals = totals_of(players);
            std::fprintf(stderr, "\r%5.1f s  %d of %d connected  %llu snapshots  %llu inputs ", t,
                         totals.connected, flags.clients,
                         static_cast<unsigned long long>(totals.snapshots),
                         static_cast<unsigned long long>(totals.sent));
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(33));
    }
    if (live) std::fprintf(stderr, "\n");

    const Totals end = totals_of(players);
    const double duration = std::max(1e-3, measured ? seconds_since(*measured) : 0.0);
    report.connected = end.connected;
    report.inputs_sent = end.sent;
    report.inputs_accepted = end.applied;
    report.snapshots = end.snapshots;
    if (measured) {
        const double client_seconds = duration * std::max(1, flags.clients);
        report.kbit_per_second_per_client =
            static_cast<double>(end.bytes - at_ramp.bytes) * 8 / 1000 / client_seconds;
        report.snapshots_per_second_per_client =
            static_cast<double>(end.snapshots - at_ramp.snapshots) / client_seconds;
    }
    report.ages_measured = ages.size();
    report.age_ms_p50 = jostle::load::percentile(ages, 50);
    report.age_ms_p99 = jostle::load::percentile(ages, 99);
    report.errors = end.failures + end.decode + refusals;
    if (!end.last_error.empty()) report.last_error = end.last_error;
    if (pid && cpu_at_ramp)
        if (const auto cpu = jostle::load::cpu_seconds(*pid))
            report.server_cpu_percent = 100 * (*cpu - *cpu_at_ramp) / duration;
    for (const auto& player : players) player->client().leave();
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    return report;
}

void add_flags(CLI::App& app, Flags& flags) {
    app.add_option("--target", flags.target, "Server, HOST:PORT")->capture_default_str();
    jostle::client::add_security_flags(app, flags.files);
    app.add_option("--world", flags.world, "World by name or id; the first when not given");
    app.add_option("--clients", flags.clients, "How many clients")
        ->capture_default_str()
        ->check(CLI::Range(1, 20000));
    app.add_option("--seconds", flags.seconds, "How long after the ramp")
        ->capture_default_str()
        ->check(CLI::Range(0.1, 86400.0));
    app.add_option("--ramp", flags.ramp, "Seconds over which clients join")
        ->capture_default_str()
        ->check(CLI::Range(0.0, 3600.0));
    app.add_option("--script", flags.script, "What clients do (jostle-bot --help has the format)");
    app.add_option("--json", flags.json, "Writes the report here as JSON");
    app.add_option("--server-pid", flags.server_pid, "Process whose CPU time to read");
    app.add_option("--max-age-p99-ms", flags.plan.age_ms_p99_max, "Plan: largest age_ms_p99");
    app.add_option("--max-errors", flags.plan.errors_max, "Plan: most errors")
        ->capture_default_str();
    app.add_option("--min-connected", flags.plan.connected_min,
                   "Plan: fewest connected; default all");
    app.footer(footer);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Loads a Jostle server with scripted clients and reports what they saw."};
    Flags flags;
    add_flags(app, flags);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    const auto script = jostle::bots::script_or_default(flags.script);
    if (!script.ok()) {
        std::fprintf(stderr, "jostle-load: %s\n", script.error().message.c_str());
        return 2;
    }
    const auto security = jostle::client::read_security(flags.files, flags.target);
    if (!security.ok()) {
        std::fprintf(stderr, "jostle-load: %s\n", security.error().message.c_str());
        return 2;
    }
    std::signal(SIGINT, [](int) { stop = true; });
    std::signal(SIGTERM, [](int) { stop = true; });
    const Report report = run(flags, *security, *script);
    std::fputs(to_text(report).c_str(), stdout);
    if (!flags.json.empty()) {
        std::ofstream out(flags.json);
        out << to_json(report);
        if (!out) {
            std::fprintf(stderr, "jostle-load: cannot write %s\n", flags.json.c_str());
            return 2;
        }
    }
    const auto lines = missed(report, flags.plan);
    for (const std::string& line : lines) std::fprintf(stderr, "plan missed: %s\n", line.c_str());
    return lines.empty() ? 0 : 1;
}
