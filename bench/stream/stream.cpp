// SPDX-License-Identifier: MIT
#include "bench/stream/stream.h"

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
Each row is a process that sends to sinks (jostle-load --passive) over loopback, sixty messages a second to each. A message costs
what the process takes with all clients, less what it takes with one, for each snapshot that arrived: physics and encoding are
not in it, acks that are read are. What did not send sixty a second, in three attempts, is not compared: something else
has the processor, or that is the limit. The floors send the same bytes to all and do nothing else: raw over bare sockets, grpc-floor
from a completion queue of gRPC, websocket-floor with Beast. grpc and websocket are jostle-server with a scene of bodies that only
turn, as many as make a snapshot of --bytes; then the floors send as many bytes as it did. Rows are measured in turns; the
median of the rounds is shown, and for ratios the median of each round's ratio.

Examples:
  jostle-bench stream
  jostle-bench stream --clients 300 --seconds 10 --rounds 5 --json stream.json)";

constexpr std::array kinds = {StreamKind::raw, StreamKind::grpc_minimal, StreamKind::grpc,
                              StreamKind::websocket_minimal, StreamKind::websocket};
constexpr int fit_attempts = 3;
constexpr double fits = 0.03;  // of the bytes that were asked for
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

// As many bodies as make snapshots of the bytes that were asked for; leaves the scene behind and
// tells the bytes.
Result<int> fit_scene(StreamRequest request, const std::string& path) {
    double bodies = request.bytes / 4.0, bytes = 0;
    request.scene = path;
    request.clients = 2;
    request.seconds = 1;
    for (int k = 0; k < fit_attempts; k++) {
        show_progress("a scene with snapshots of " + std::to_string(request.bytes) + " bytes");
        if (Status written = write_turning_scene(path, static_cast<int>(bodies)); !written.ok())
            return written.error();
        const auto cost = measure_stream(StreamKind::websocket, request);
        if (!cost.ok()) return cost.error();
        bytes = cost->snapshot_bytes;
        if (std::abs(bytes / request.bytes - 1) < fits) break;
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

// Of the rounds in which both held their rate; nothing: there was none.
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
                "to the floor", "rate", "bytes", "messages", "age p50", "p99", "kB");
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

// A machine that does something else as well may keep a server from its rate, and what it sends
// then costs more each: so it is asked again. What never held it is reported, and not compared.
Result<StreamCost> measure_at_full_rate(StreamKind kind, const StreamRequest& request) {
    for (int attempt = 1;; attempt++) {
        auto cost = measure_stream(kind, request);
        if (!cost.ok() || held_tick_rate(*cost)) return cost;
        show_progress("");
        std::fprintf(stderr, "jostle-bench: %s sent %.1f a second, not 60%s\n", name_of(kind),
                     cost->snapshots_per_second, attempt < rate_attempts ? ": once more" : "");
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
        "stream",
        "Times what a message to a client costs the server, beside servers that only send.");
    const auto flags = std::make_shared<Flags>();
    StreamRequest& request = flags->request;
    command->add_option("--clients", request.clients, "How many sinks")
        ->capture_default_str()
        ->check(CLI::Range(2, 5000));
    command->add_option("--seconds", request.seconds, "For how long each row is measured")
        ->capture_default_str()
        ->check(CLI::Range(0.5, 600.0));
    command->add_option("--rounds", flags->rounds, "How often")
        ->capture_default_str()
        ->check(CLI::Range(1, 100));
    command->add_option("--bytes", request.bytes, "Of a snapshot")
        ->capture_default_str()
        ->check(CLI::Range(100, 100'000));
    command
        ->add_option("--ack-every", request.ack_every,
                     "Snapshots that a sink acknowledges together; 0: as the server asks")
        ->capture_default_str()
        ->check(CLI::Range(0, 1000));
    command->add_option("--set", request.server_settings,
                        "KEY=VALUE: a setting of jostle-server; may be repeated");
    command->add_option("--json", flags->json, "Writes the figures here as JSON");
    // How it starts its floors; --admin is what a server is told besides.
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
