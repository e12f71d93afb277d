// SPDX-License-Identifier: MIT
#include "bench/subcommands.h"

#include <CLI/CLI.hpp>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <map>
#include <memory>

#include "bench/measure.h"
#include "bench/processes/server_process.h"
#include "bench/result_file.h"
#include "bench/stream/minimal_server.h"
#include "bench/stream/stream_row.h"
#include "jostle/base/format_text.h"
#include "tools/load/load_run.h"

namespace jostle::bench {
namespace {

constexpr const char* footer = R"(
Each row is a server process that sends 60 messages per second over loopback to each passive client
(as in jostle-load --passive). The cost of a message is the CPU time of the process with all clients
minus that with one client, divided by the number of received snapshots: it excludes physics and
encoding, and includes reading acks. A server that does not reach 60 messages per second in three
attempts is not compared: other load uses the CPU, or the server is at its limit. The minimal
servers send the same bytes to all clients and do nothing else: raw over plain sockets, grpc-floor
with a gRPC completion queue, websocket-floor with Beast. grpc and websocket are jostle-server with
a scene of rotating bodies whose snapshots have about --bytes bytes; the minimal servers then send
as many bytes. Rows are measured in turn. The table contains the median of the rounds; ratios are
the median of the ratios of each round.

Examples:
  jostle-bench stream
  jostle-bench stream --clients 300 --seconds 10 --rounds 5 --json stream.json

Exit status: 0 success, 1 a measurement failed or the file could not be written, 2 invalid flags.)";

constexpr std::array kinds = {StreamKind::raw, StreamKind::grpc_minimal, StreamKind::grpc,
                              StreamKind::websocket_minimal, StreamKind::websocket};
constexpr int fit_attempts = 3;
constexpr double bytes_tolerance = 0.03;  // relative deviation from the requested bytes
constexpr double tick_rate_share_min = 0.97;
constexpr int rate_attempts = 3;

struct Flags {
    StreamRequest request;
    int rounds = 3;
    std::string json, serve, port_file, admin;
};

std::atomic<bool> stop_minimal_server{false};

int serve(const Flags& flags) {
    std::signal(SIGTERM, [](int) { stop_minimal_server = true; });
    std::signal(SIGINT, [](int) { stop_minimal_server = true; });
    const MinimalServerOptions options{.bytes = flags.request.bytes, .port_file = flags.port_file};
    const Status status = flags.serve == name_of(StreamKind::raw)
                              ? serve_minimal_raw(options, stop_minimal_server)
                          : flags.serve == name_of(StreamKind::grpc_minimal)
                              ? serve_minimal_grpc(options, stop_minimal_server)
                              : serve_minimal_websocket(options, stop_minimal_server);
    if (status.ok()) return 0;
    std::fprintf(stderr, "jostle-bench: %s\n", status.error().message.c_str());
    return 1;
}

// Finds the number of bodies that makes snapshots of the requested size. Writes the scene and
// returns the size of its snapshots.
Result<int> fit_scene(StreamRequest request, const std::string& path) {
    double bodies = request.bytes / 4.0, bytes = 0;
    request.scene = path;
    request.clients = 2;
    request.seconds = 1;
    for (int k = 0; k < fit_attempts; k++) {
        show_progress("fitting a scene with snapshots of " + std::to_string(request.bytes) +
                      " bytes");
        if (Status written = write_turning_scene(path, static_cast<int>(bodies)); !written.ok())
            return written.error();
        const auto cost = measure_stream(StreamKind::websocket, request);
        if (!cost.ok()) return cost.error();
        bytes = cost->snapshot_bytes;
        if (std::abs(bytes / request.bytes - 1) < bytes_tolerance) break;
        if (k + 1 < fit_attempts) bodies *= request.bytes / std::max(1.0, bytes);
    }
    return static_cast<int>(bytes + 0.5);
}

using Costs = std::map<StreamKind, std::vector<StreamCost>>;

bool held_tick_rate(const StreamCost& cost) {
    return cost.snapshots_per_second >= tick_rate_share_min * 60;
}

double median_of(const std::vector<StreamCost>& costs, double StreamCost::*field) {
    std::vector<double> values;
    for (const StreamCost& cost : costs) values.push_back(cost.*field);
    return spread_of(values).median;
}

// Over the rounds in which both servers sent at the full rate; nothing if there was none.
std::optional<Spread> ratio_of(const Costs& costs, StreamKind kind) {
    const auto floor = minimal_server_of(kind);
    if (!floor) return std::nullopt;
    std::vector<double> ratios;
    for (std::size_t k = 0; k < costs.at(kind).size(); k++) {
        const StreamCost &ours = costs.at(kind)[k], &least = costs.at(*floor)[k];
        if (held_tick_rate(ours) && held_tick_rate(least))
            ratios.push_back(ours.us_per_message / least.us_per_message);
    }
    return ratios.empty() ? std::nullopt : std::optional(spread_of(ratios));
}

std::string us_text(const std::vector<StreamCost>& rows) {
    std::vector<double> us;
    for (const StreamCost& row : rows)
        if (held_tick_rate(row)) us.push_back(row.us_per_message);
    if (us.empty()) return format_text("%27s", "not at full rate");
    const Spread spread = spread_of(us);
    return format_text("%8.2f %8.2f to %6.2f", spread.median, spread.low, spread.high);
}

void print(const Costs& costs) {
    std::printf("%-16s %8s %18s %14s %7s %6s %9s %7s %7s %8s\n", "", "us", "(low to high)",
                "/ minimal", "rate", "bytes", "messages", "age p50", "p99", "kB");
    for (const StreamKind kind : kinds) {
        const auto& rows = costs.at(kind);
        const auto ratio = ratio_of(costs, kind);
        const std::string floor =
            ratio ? format_text("%.2f (%.2f)", ratio->median, ratio->high) : "";
        std::printf("%-16s %s %14s %7.1f %6.0f %9.1f %7.2f %7.2f %8.1f\n", name_of(kind),
                    us_text(rows).c_str(), floor.c_str(),
                    median_of(rows, &StreamCost::snapshots_per_second),
                    median_of(rows, &StreamCost::snapshot_bytes),
                    median_of(rows, &StreamCost::messages_per_second),
                    median_of(rows, &StreamCost::age_ms_p50),
                    median_of(rows, &StreamCost::age_ms_p99),
                    median_of(rows, &StreamCost::memory_kb_per_client));
    }
}

nlohmann::ordered_json rows_json(const Costs& costs) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const StreamKind kind : kinds) {
        nlohmann::ordered_json row = {{"stream", name_of(kind)}};
        if (const auto ratio = ratio_of(costs, kind))
            row["to_the_floor"] = {{"median", rounded(ratio->median)},
                                   {"low", rounded(ratio->low)},
                                   {"high", rounded(ratio->high)}};
        row["rounds"] = nlohmann::ordered_json::array();
        for (const StreamCost& cost : costs.at(kind)) row["rounds"].push_back(to_json(cost));
        rows.push_back(row);
    }
    return rows;
}

// Other load on the machine may keep a server from its full rate, which increases the cost per
// message, so the measurement is repeated. A server that never reaches the rate is reported, but
// not compared.
Result<StreamCost> measure_at_full_rate(StreamKind kind, const StreamRequest& request) {
    for (int attempt = 1;; attempt++) {
        auto cost = measure_stream(kind, request);
        if (!cost.ok() || held_tick_rate(*cost)) return cost;
        show_progress("");
        std::fprintf(stderr, "jostle-bench: %s sent %.1f messages/s instead of 60%s\n",
                     name_of(kind), cost->snapshots_per_second,
                     attempt < rate_attempts ? "; measuring again" : "");
        if (attempt == rate_attempts) return cost;
    }
}

Result<Costs> measure_all(const Flags& flags, StreamRequest request) {
    Costs costs;
    for (int round = 1; round <= flags.rounds; round++)
        for (const StreamKind kind : kinds) {
            show_progress("round " + std::to_string(round) + " of " + std::to_string(flags.rounds) +
                          ": " + name_of(kind));
            const auto cost = measure_at_full_rate(kind, request);
            if (!cost.ok()) return cost.error();
            costs[kind].push_back(*cost);
        }
    show_progress("");
    return costs;
}

int measure(const Flags& flags) {
    if (!flags.json.empty() && !can_write(flags.json)) return 1;
    load::raise_socket_limit(flags.request.clients);
    const TemporaryFolder folder;
    StreamRequest request = flags.request;
    request.scene = folder.path + "/turning.json";
    const auto print_error = [](const Error& error) {
        show_progress("");
        std::fprintf(stderr, "jostle-bench: %s\n", error.message.c_str());
        return 1;
    };
    const auto bytes = fit_scene(request, request.scene);
    if (!bytes.ok()) return print_error(bytes.error());
    request.bytes = *bytes;
    const auto costs = measure_all(flags, request);
    if (!costs.ok()) return print_error(costs.error());
    print(*costs);
    if (flags.json.empty()) return 0;
    const nlohmann::ordered_json head = {{"benchmark", "stream"},
                                         {"cpu", cpu_model()},
                                         {"compiler", compiler()},
                                         {"clients", request.clients},
                                         {"seconds", request.seconds},
                                         {"ack_every", request.ack_every},
                                         {"server_settings", request.server_settings}};
    return write_result(flags.json, head, rows_json(*costs)) ? 0 : 1;
}

}  // namespace

void add_stream(CLI::App& app, int& status) {
    CLI::App* command = app.add_subcommand(
        "stream", "Measure the cost of a message, compared with minimal servers");
    const auto flags = std::make_shared<Flags>();
    StreamRequest& request = flags->request;
    command
        ->add_option("--clients", request.clients,
                     "Connect N passive clients [default: 100; 2 to 5000]")
        ->type_name("N")
        ->check(CLI::Range(2, 5000).description(""));
    command
        ->add_option("--seconds", request.seconds,
                     "Measure each row for this time [default: 5; 0.5 to 600]")
        ->type_name("SECONDS")
        ->check(CLI::Range(0.5, 600.0).description(""));
    command
        ->add_option("--rounds", flags->rounds, "Measure all rows N times [default: 3; 1 to 100]")
        ->type_name("N")
        ->check(CLI::Range(1, 100).description(""));
    command
        ->add_option("--bytes", request.bytes, "Size of a snapshot [default: 1000; 100 to 100000]")
        ->type_name("BYTES")
        ->check(CLI::Range(100, 100'000).description(""));
    command
        ->add_option("--ack-every", request.ack_every,
                     "Acknowledge every N snapshots; 0: the server's interval\n"
                     "[default: 6; 0 to 1000]")
        ->type_name("N")
        ->check(CLI::Range(0, 1000).description(""));
    command
        ->add_option("--set", request.server_settings,
                     "Set a configuration value of jostle-server; repeatable")
        ->type_name("KEY=VALUE");
    command->add_option("--json", flags->json, "Write the results as JSON")->type_name("FILE");
    // The parent starts its minimal servers with these flags. ServerProcess passes --admin to each
    // server.
    command->add_option("--serve", flags->serve)
        ->group("")
        ->check(CLI::IsMember({"raw", "grpc-floor", "websocket-floor"}));
    command->add_option("--port-file", flags->port_file)->group("");
    command->add_option("--admin", flags->admin)->group("");
    command->footer(footer);
    command->callback(
        [flags, &status] { status = flags->serve.empty() ? measure(*flags) : serve(*flags); });
}

}  // namespace jostle::bench
