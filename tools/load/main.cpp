// SPDX-License-Identifier: MIT
//
// jostle-load: connects many scripted clients to a server, reports measurements and checks
// thresholds.
#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <fstream>

#include "base/command_line/command_line.h"
#include "clients/cpp/cli/security_flags.h"
#include "tools/load/library_client_pool.h"
#include "tools/load/load_metrics.h"
#include "tools/load/load_run.h"
#include "tools/load/passive_client_pool.h"

namespace {

using namespace jostle::load;

std::atomic<bool> stop{false};

constexpr const char* footer = R"(
By default the clients use the C++ client library, and each one decodes every snapshot. With
--passive they are bare sockets that cost a few microseconds per message: one process runs thousands
of them, and the server is the bottleneck. Passive clients send no inputs unless --script is given.
With --passive, --server is the gRPC port, or the HTTP port with --websocket; TLS is not supported.

The measurement starts when all clients have joined and --settle has passed. The report contains:
  clients, connected                requested clients, and those connected at the end
  inputs_sent, inputs_accepted      inputs sent, and inputs applied by the server
  snapshots                         received snapshots
  kbit_per_second_per_client        received data
  snapshots_per_second_per_client   received snapshots
  decoded_share                     share of the snapshots that were decoded and verified by CRC
  age_ms                            from the due time of a tick until its snapshot was read
                                    (library clients: decoded)
  frozen_share                      share of the rendered frames that showed nothing new, or jumped,
                                    because snapshots were late (decoding passive clients)
  gap_ms                            between successive snapshots of a client (passive clients)
  result_delay_ms                   from an input until its result (passive clients)
  message_delay_ms                  from a user message until a client received it (--chat)
  effect_delay_ms                   from an input until the first snapshot of the tick that applied
                                    it (passive clients)
  errors                            streams that ended, snapshots that did not decode, and rejected
                                    valid inputs
  server_cpu_percent                of one core, if the server is on this machine
Runs longer than 10 s also list age_ms in intervals of 10 s.

Examples:
  jostle-load --clients 100 --seconds 20 --max-age-p99-ms 50
  jostle-load --passive --clients 1000 --ramp 5 --seconds 30
  jostle-load --passive --websocket --server localhost:8080 --clients 500
  jostle-load --passive --clients 4 --read-rate 20 --seconds 120

Exit status: 0 success, 1 a threshold was violated, 2 invalid flags or script.)";

struct Flags {
    jostle::client::SecurityFiles files;
    LoadOptions load{.target = "localhost:50051"};
    std::string script, json;
    bool passive = false, websocket = false;
    int server_pid = 0;
    std::vector<double> precision;  // metres, radians and the factor of distant cells
    LoadThresholds plan;
};

void add_flags(CLI::App& app, Flags& flags) {
    LoadOptions& load = flags.load;
    app.add_option("--server", load.target, "Connect to this server [default: localhost:50051]")
        ->type_name("HOST:PORT");
    jostle::client::add_security_flags(app, flags.files);
    app.add_option("--world", load.world, "Join a world by name or id [default: the first]")
        ->type_name("WORLD");
    app.add_option("--clients", load.clients, "Connect N clients [default: 10; 1 to 20000]")
        ->type_name("N")
        ->check(CLI::Range(1, 20000).description(""))
        ->group("Clients");
    app.add_option("--threads", load.threads,
                   "Distribute them over N threads [default: 2; 1 to 256]")
        ->type_name("N")
        ->check(CLI::Range(1, 256).description(""))
        ->group("Clients");
    app.add_option("--script", flags.script,
                   "Read the behaviours from FILE (see jostle-bot --help)")
        ->type_name("FILE")
        ->group("Clients");
    app.add_option("--interest-radius", load.interest_radius,
                   "Limit each client to an area of interest with this radius\n"
                   "[default: the whole world; 1 to 1e6]")
        ->type_name("METRES")
        ->check(CLI::Range(1.0, 1e6).description(""))
        ->group("Clients");
    app.add_option("--max-kbps", load.max_kbps,
                   "Limit the data that the server sends to each client\n"
                   "[default: unlimited; 16 to 1000000]")
        ->type_name("KBIT/S")
        ->check(CLI::Range(16, 1000000).description(""))
        ->group("Clients");
    app.add_option("--snapshot-hz", load.snapshot_hz,
                   "Request this snapshot rate [default: the tick rate of the world; 1 to 1000]")
        ->type_name("HZ")
        ->check(CLI::Range(1, 1000).description(""))
        ->group("Clients");
    app.add_option("--precision", flags.precision,
                   "Request poses within METRES and RADIANS, coarser by FACTOR beyond half of the\n"
                   "radius of interest [default: the precision of the world]")
        ->type_name("METRES,RADIANS[,FACTOR]")
        ->delimiter(',')
        ->expected(2, 3)
        ->group("Clients");
    app.add_option("--chat", load.data.messages_per_second,
                   "Send N user messages per second from each client to all clients\n"
                   "[default: 0; 0 to 1000]")
        ->type_name("N")
        ->check(CLI::Range(0.0, 1000.0).description(""))
        ->group("Clients");
    CLI::Option* attributes =
        app.add_option("--attributes", load.data.attributes,
                       "Set N attributes of each player, which all clients receive\n"
                       "[default: 0; 0 to 1000]");
    attributes->type_name("N")->check(CLI::Range(0, 1000).description(""))->group("Clients");
    app.add_option("--attribute-changes", load.data.attribute_changes_per_second,
                   "Change N of them per second [default: 1; 0 to 1000]")
        ->type_name("N")
        ->needs(attributes)
        ->check(CLI::Range(0.0, 1000.0).description(""))
        ->group("Clients");
    CLI::Option* datagrams =
        app.add_flag("--datagrams", load.datagrams,
                     "Receive snapshots as datagrams if the server supports them");
    datagrams->group("Clients");
    CLI::Option* passive =
        app.add_flag("--passive", flags.passive, "Use passive clients, see below");
    passive->excludes(datagrams)->group("Passive clients");
    app.add_flag("--websocket", flags.websocket, "Connect by WebSocket instead of gRPC")
        ->needs(passive)
        ->group("Passive clients");
    app.add_option("--ack-every", load.ack_every,
                   "Acknowledge every N-th snapshot\n"
                   "[default: at the interval that the server requests; 1 to 1000]")
        ->type_name("N")
        ->needs(passive)
        ->check(CLI::Range(1, 1000).description(""))
        ->group("Passive clients");
    app.add_option("--read-rate", load.read_rate,
                   "Read N messages per second [default: unlimited; 0.1 to 1000]")
        ->type_name("N")
        ->needs(passive)
        ->check(CLI::Range(0.1, 1000.0).description(""))
        ->group("Passive clients");
    app.add_option("--read-rate-max", load.read_rate_max,
                   "Spread the read rates of the clients from --read-rate to N\n"
                   "[default: all are equal; 0.1 to 1000]")
        ->type_name("N")
        ->needs(passive)
        ->check(CLI::Range(0.1, 1000.0).description(""))
        ->group("Passive clients");
    app.add_option("--decode-ratio", load.decode_ratio,
                   "Decode snapshots in this share of the clients [default: 0.01; 0 to 1]")
        ->type_name("RATIO")
        ->needs(passive)
        ->check(CLI::Range(0.0, 1.0).description(""))
        ->group("Passive clients");
    app.add_option("--ramp", load.ramp,
                   "Connect the clients over this time [default: 1; 0 to 3600]")
        ->type_name("SECONDS")
        ->check(CLI::Range(0.0, 3600.0).description(""))
        ->group("Measurement");
    app.add_option("--settle", load.settle,
                   "Wait for this time before the measurement [default: 1; 0 to 3600]")
        ->type_name("SECONDS")
        ->check(CLI::Range(0.0, 3600.0).description(""))
        ->group("Measurement");
    app.add_option("--seconds", load.seconds, "Measure for this time [default: 10; 0.1 to 86400]")
        ->type_name("SECONDS")
        ->check(CLI::Range(0.1, 86400.0).description(""))
        ->group("Measurement");
    app.add_option("--json", flags.json, "Write the report to FILE as JSON")
        ->type_name("FILE")
        ->group("Measurement");
    app.add_option("--server-pid", flags.server_pid,
                   "Measure the CPU time of process PID\n"
                   "[default: the process that listens on --server]")
        ->type_name("PID")
        ->group("Measurement");
    app.add_option("--max-age-p99-ms", flags.plan.age_ms_p99_max,
                   "Fail if the 99th percentile of age_ms is above MS")
        ->type_name("MS")
        ->group("Thresholds");
    app.add_option("--max-errors", flags.plan.errors_max,
                   "Fail if there are more than N errors [default: 0]")
        ->type_name("N")
        ->group("Thresholds");
    app.add_option("--min-connected", flags.plan.connected_min,
                   "Fail if fewer than N clients are connected at the end [default: all]")
        ->type_name("N")
        ->group("Thresholds");
    app.footer(footer);
}

// Reads the files and rejects inconsistent flags.
jostle::Status finish(Flags& flags) {
    LoadOptions& load = flags.load;
    if (!flags.passive || !flags.script.empty()) {
        auto script = jostle::bot::script_or_default(flags.script);
        if (!script.ok()) return script.error();
        load.script = std::move(*script);
    }
    auto security = jostle::client::read_security(flags.files, load.target);
    if (!security.ok()) return security.error();
    load.security = std::move(*security);
    if (flags.passive && load.security.tls)
        return jostle::invalid_argument(
            "--passive does not support TLS; omit --tls, --ca and --cert");
    if (load.read_rate_max != 0 && load.read_rate_max < load.read_rate)
        return jostle::invalid_argument("--read-rate-max must not be below --read-rate");
    if (load.read_rate_max != 0 && load.read_rate == 0)
        return jostle::invalid_argument("--read-rate-max requires --read-rate");
    if (flags.precision.size() >= 2)
        load.precision = {flags.precision[0], flags.precision[1],
                          flags.precision.size() > 2 ? flags.precision[2] : 1};
    if (flags.websocket) load.transport = Transport::websocket;
    if (!raise_socket_limit(load.clients))
        return jostle::invalid_argument(
            std::to_string(load.clients) +
            " clients exceed the limit of open files; raise it with ulimit -n");
    return {};
}

jostle::Result<std::unique_ptr<ClientPool>> make_client_pool(const Flags& flags) {
    if (!flags.passive)
        return std::unique_ptr<ClientPool>(std::make_unique<LibraryClientPool>(flags.load));
    const auto address = jostle::common::resolve(flags.load.target);
    if (!address.ok()) return jostle::invalid_argument("--server: " + address.error().message);
    return std::unique_ptr<ClientPool>(std::make_unique<PassiveClientPool>(flags.load, *address));
}

int fail(const std::string& what) {
    std::fprintf(stderr, "jostle-load: %s\n", what.c_str());
    return 2;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Load a Jostle server with many clients and report latency and bandwidth."};
    Flags flags;
    add_flags(app, flags);
    if (const auto status =
            jostle::parse_command_line(app, {"jostle-load", JOSTLE_VERSION}, argc, argv))
        return *status;
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
    for (const std::string& line : lines)
        std::fprintf(stderr, "jostle-load: threshold violated: %s\n", line.c_str());
    return lines.empty() ? 0 : 1;
}
