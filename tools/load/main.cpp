// SPDX-License-Identifier: MIT
//
// jostle-load: many scripted clients against one server, a report, and a verdict.
#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <fstream>

#include "clients/cpp/cli/security_flags.h"
#include "tools/load/library_client_pool.h"
#include "tools/load/load_run.h"
#include "tools/load/passive_client_pool.h"
#include "tools/load/server_cpu.h"

namespace {

using namespace jostle::load;

std::atomic<bool> stop{false};

constexpr const char* footer = R"(
Clients are those of the C++ library: each decodes all that it gets. With --passive they are sockets that speak the transport by
hand, a few microseconds a message: thousands fit into one process, and the server is what is measured. Sinks only watch,
unless a script is given; --server is then the gRPC port, or with --websocket that of HTTP. Without TLS.

The report, taken when all have joined and --settle has passed: clients, connected (to the end), inputs_sent, inputs_accepted
(applied by the server), snapshots, kbit_per_second_per_client, snapshots_per_second_per_client, decoded_share (of the snapshots:
decoded, and their CRC compared), age_ms (from the moment a tick was due on the server to when its snapshot was read here; the
library's is decoded then), gap_ms (between a client's snapshots), result_delay_ms (from an input that was sent to its result),
effect_delay_ms (likewise, to the first snapshot of a tick that had applied it); the last three of sinks only. Errors are
streams that ended, snapshots that did not decode, inputs of good form that were refused. server_cpu_percent is of one core, when
the server is on this machine. Runs of more than 10 s show the age in pieces of 10 s, too.

Examples:
  jostle-load --clients 100 --seconds 20 --max-age-p99-ms 50
  jostle-load --passive --clients 1000 --ramp 5 --seconds 30
  jostle-load --passive --websocket --server localhost:8080 --clients 500
  jostle-load --passive --clients 4 --read-rate 20 --seconds 120

Exit status: 0 plan kept, 1 plan missed, 2 wrong flags or script.)";

struct Flags {
    jostle::client::SecurityFiles files;
    LoadOptions load{.target = "localhost:50051"};
    std::string script, json;
    bool passive = false, websocket = false;
    int server_pid = 0;
    LoadThresholds plan;
};

void add_flags(CLI::App& app, Flags& flags) {
    LoadOptions& load = flags.load;
    app.add_option("--server", load.target, "Server, HOST:PORT")->capture_default_str();
    jostle::client::add_security_flags(app, flags.files);
    app.add_option("--world", load.world, "World by name or id; the first when not given");
    app.add_option("--clients", load.clients, "How many clients")
        ->capture_default_str()
        ->check(CLI::Range(1, 20000));
    app.add_option("--threads", load.threads, "Over which they are spread")
        ->capture_default_str()
        ->check(CLI::Range(1, 256));
    app.add_option("--seconds", load.seconds, "How long to measure")
        ->capture_default_str()
        ->check(CLI::Range(0.1, 86400.0));
    app.add_option("--ramp", load.ramp, "Seconds over which clients join")
        ->capture_default_str()
        ->check(CLI::Range(0.0, 3600.0));
    app.add_option("--settle", load.settle, "Seconds from when all have joined to the measurement")
        ->capture_default_str()
        ->check(CLI::Range(0.0, 3600.0));
    app.add_option("--script", flags.script, "What clients do (jostle-bot --help has the format)");
    CLI::Option* datagrams = app.add_flag("--datagrams", load.datagrams,
                                          "Clients take snapshots as datagrams where offered");
    CLI::Option* passive =
        app.add_flag("--passive", flags.passive, "Clients that only count: see below");
    passive->excludes(datagrams);
    app.add_flag("--websocket", flags.websocket, "Sinks join as browsers do")->needs(passive);
    app.add_option("--ack-every", load.ack_every,
                   "Snapshots that a sink acknowledges together; as the server asks when not given")
        ->needs(passive)
        ->check(CLI::Range(1, 1000));
    app.add_option("--read-rate", load.read_rate,
                   "Messages a second that each sink reads; as they come when not given")
        ->needs(passive)
        ->check(CLI::Range(0.1, 1000.0));
    app.add_option("--decode-ratio", load.decode_ratio, "Share of the sinks that decode")
        ->needs(passive)
        ->capture_default_str()
        ->check(CLI::Range(0.0, 1.0));
    app.add_option(
           "--interest-radius", load.interest_radius,
           "Metres that each client sees about a point of its own; all of the world when not given")
        ->check(CLI::Range(1.0, 1e6));
    app.add_option("--max-kbps", load.max_kbps,
                   "Kilobits a second that the server may send to each client")
        ->check(CLI::Range(16, 1000000));
    app.add_option("--json", flags.json, "Writes the report here as JSON");
    app.add_option("--server-pid", flags.server_pid, "Process whose CPU time to read");
    app.add_option("--max-age-p99-ms", flags.plan.age_ms_p99_max, "Plan: largest p99 of age_ms");
    app.add_option("--max-errors", flags.plan.errors_max, "Plan: most errors")
        ->capture_default_str();
    app.add_option("--min-connected", flags.plan.connected_min,
                   "Plan: fewest connected; default all");
    app.footer(footer);
}

// Files are read, and what does not fit together is refused.
jostle::Status finish(Flags& flags) {
    LoadOptions& load = flags.load;
    if (!flags.passive || !flags.script.empty()) {
        auto script = jostle::bots::script_or_default(flags.script);
        if (!script.ok()) return script.error();
        load.script = std::move(*script);
    }
    auto security = jostle::client::read_security(flags.files, load.target);
    if (!security.ok()) return security.error();
    load.security = std::move(*security);
    if (flags.passive && load.security.tls)
        return jostle::invalid_argument("--passive does not speak TLS; leave one of the two out");
    if (flags.websocket) load.transport = Transport::websocket;
    if (!raise_socket_limit(load.clients))
        return jostle::invalid_argument(
            std::to_string(load.clients) +
            " clients need as many sockets, and this process may not have them: raise ulimit -n");
    return {};
}

jostle::Result<std::unique_ptr<ClientPool>> make_client_pool(const Flags& flags) {
    if (!flags.passive)
        return std::unique_ptr<ClientPool>(std::make_unique<LibraryClientPool>(flags.load));
    const auto address = resolve(flags.load.target);
    if (!address.ok()) return address.error();
    return std::unique_ptr<ClientPool>(std::make_unique<PassiveClientPool>(flags.load, *address));
}

int fail(const std::string& what) {
    std::fprintf(stderr, "jostle-load: %s\n", what.c_str());
    return 2;
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
    if (const auto status = finish(flags); !status.ok()) return fail(status.error().message);
    std::signal(SIGINT, [](int) { stop = true; });
    std::signal(SIGTERM, [](int) { stop = true; });
    const auto server =
        flags.server_pid > 0 ? std::optional(flags.server_pid) : find_listener(flags.load.target);
    auto pool = make_client_pool(flags);
    if (!pool.ok()) return fail(pool.error().message);
    const Report report = run_load(flags.load, **pool, server, stop);
    std::fputs(to_text(report).c_str(), stdout);
    if (!flags.json.empty()) {
        std::ofstream out(flags.json);
        out << to_json(report);
        if (!out) return fail("cannot write " + flags.json);
    }
    const auto lines = violated_thresholds(report, flags.plan);
    for (const std::string& line : lines) std::fprintf(stderr, "plan missed: %s\n", line.c_str());
    return lines.empty() ? 0 : 1;
}
