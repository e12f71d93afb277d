// SPDX-License-Identifier: MIT
//
// All Prometheus metrics of the server in one table: name, help, labels, unit. The app creates the
// table and passes it by reference to the code that counts. Counting works from any thread without
// a lock, except for the tick histogram, whose lock belongs to one world.
//
// A series with a fixed label set exists from the start with the value 0. The series of a world
// exist as long as the world (world_metrics.h); the series of a call appear with its first response
// (rpc_metrics.h).
#pragma once

#include <prometheus/counter.h>
#include <prometheus/family.h>
#include <prometheus/gauge.h>
#include <prometheus/histogram.h>
#include <prometheus/registry.h>
#include <array>
#include <cstddef>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "jostle/base/result.h"

namespace jostle::server {

// The values of metric labels, each set as an enumeration with its names. Sets are small and
// closed: nothing that a client sends becomes a label.
//
// The result of an input, like InputCode in play.proto.
enum class InputOutcome { applied, invalid, not_found, not_allowed, limit };
constexpr auto names_of(InputOutcome) {
    return std::to_array<std::string_view>(
        {"applied", "invalid", "not_found", "not_allowed", "limit"});
}

enum class SkipReason { window, pending, rate, encodings };
constexpr auto names_of(SkipReason) {
    return std::to_array<std::string_view>({"window", "pending", "rate", "encodings"});
}

// Kinds of content of the bytes that the server sends to clients.
enum class TrafficKind {
    entities,  // entity updates and large shapes
    poses,     // with the cells of an area of interest
    channels,  // of modules
    points,    // point objects
    events,
    statistics,
    results,     // of inputs, and the rest of the client update
    replies,     // welcomes, pongs and notices
    attributes,  // with the list of players
    messages,    // of users
};
constexpr auto names_of(TrafficKind) {
    return std::to_array<std::string_view>({"entities", "poses", "channels", "points", "events",
                                            "statistics", "results", "replies", "attributes",
                                            "messages"});
}
inline constexpr std::size_t traffic_kinds = names_of(TrafficKind{}).size();

// Why a world was paused.
enum class PauseCause {
    request,   // by an operator
    overload,  // a tick took too long
};
constexpr auto names_of(PauseCause) {
    return std::to_array<std::string_view>({"request", "overload"});
}

enum class Listener { grpc, http, admin };
constexpr auto names_of(Listener) {
    return std::to_array<std::string_view>({"grpc", "http", "admin"});
}

// Why a connection was closed, in most cases right after it was accepted.
enum class ConnectionRefusal {
    limit,          // the listener has its maximum of connections
    address_limit,  // the address has its maximum of connections
    handshake,      // the TLS handshake failed
    busy,           // too many requests wait for a thread
    penalty,        // the address attacked the server recently
    attack,         // it sent frames that no regular client sends
    proxy_header,   // a trusted proxy sent no valid PROXY header
};
constexpr auto names_of(ConnectionRefusal) {
    return std::to_array<std::string_view>(
        {"limit", "address_limit", "handshake", "busy", "penalty", "attack", "proxy_header"});
}

// In the order of ErrorCode.
constexpr auto names_of(ErrorCode) {
    return std::to_array<std::string_view>(
        {"invalid_argument", "not_found", "failed_precondition", "corrupt_data", "already_exists",
         "permission_denied", "unauthenticated", "resource_exhausted", "deadline_exceeded",
         "aborted", "unavailable", "internal"});
}
static_assert(names_of(ErrorCode{}).size() == static_cast<std::size_t>(ErrorCode::internal) + 1);

// One counter for each value of a label with few values.
template <class Label>
class CountersBy {
public:
    CountersBy(prometheus::Family<prometheus::Counter>& family, const std::string& label) {
        for (std::size_t i = 0; i < counters_.size(); i++)
            counters_[i] = &family.Add({{label, std::string(names_of(Label{})[i])}});
    }
    prometheus::Counter& operator[](Label value) const {
        return *counters_[static_cast<std::size_t>(value)];
    }

private:
    std::array<prometheus::Counter*, names_of(Label{}).size()> counters_{};
};

// Counters of a listener: open connections, and refused connections by reason.
struct ListenerMetrics {
    prometheus::Gauge& open;
    std::array<prometheus::Counter*, names_of(ConnectionRefusal{}).size()> refused_by;

    prometheus::Counter& refused(ConnectionRefusal why) const {
        return *refused_by[static_cast<std::size_t>(why)];
    }
};

struct Metrics {
    using Counter = prometheus::Counter;
    using Gauge = prometheus::Gauge;
    using Counters = prometheus::Family<prometheus::Counter>&;
    using Gauges = prometheus::Family<prometheus::Gauge>&;
    using Histograms = prometheus::Family<prometheus::Histogram>&;

    // `stages`: the names of the stages of a step.
    Metrics(const std::string& version, const std::vector<std::string>& stages);
    Metrics(const Metrics&) = delete;
    Metrics& operator=(const Metrics&) = delete;

    prometheus::Registry registry;  // must be first: it owns the families below

    // --- worlds: label world (the name) ---
    Histograms tick_seconds =
        histograms("jostle_tick_duration_seconds",
                   "Duration of one tick of a world: inputs, step, frame and responses.");
    Histograms tick_lateness = histograms(
        "jostle_tick_lateness_seconds", "Time from when a tick of a world was due until it began.");
    Counters late_ticks =
        counters("jostle_late_ticks_total",
                 "Ticks of a world that were skipped because it was later than the catch-up "
                 "limit.");
    Gauges bodies = gauges("jostle_world_bodies", "Bodies in a world after its last tick.");
    Gauges awake_bodies =
        gauges("jostle_world_awake_bodies", "Awake dynamic bodies in a world in its last tick.");
    Gauges queue_depth = gauges("jostle_world_queue_depth",
                                "Inputs queued for a world when its last tick began; "
                                "world.command_queue_max is the maximum.");
    Gauges paused =
        gauges("jostle_world_paused",
               "1 while a world takes no steps: it is paused, or its steps are rejected.");
    Gauges hung = gauges("jostle_world_hung", "1 while a tick of a world does not end.");
    Gauges time_scale =
        gauges("jostle_world_time_scale",
               "Simulated by elapsed time of a world over the last 5 s: 1 if it keeps its rate, "
               "less if it skips ticks, 0 while it is paused.");
    Counters pauses = counters("jostle_world_pauses_total",
                               "Pauses of a world. cause: request of an operator, or overload.");
    Gauges clients = gauges("jostle_clients", "Connected players and spectators of a world.");

    // --- the solver, total of all worlds: label stage ---
    Counters stage_seconds = counters("jostle_step_stage_seconds_total",
                                      "Time spent in a stage of the step, total of all worlds.");
    std::vector<Counter*> stages;  // by number

    // --- client traffic ---
    CountersBy<InputOutcome> inputs = {
        counters("jostle_inputs_total", "Client inputs with a result, by result code."), "code"};
    CountersBy<TrafficKind> sent_bytes = {
        counters("jostle_sent_bytes_total",
                 "Bytes of messages sent to clients, before transport overhead, by content. poses "
                 "include the headers of snapshots."),
        "kind"};
    Counter& snapshot_bytes =
        one(counters("jostle_snapshot_bytes_total", "Bytes of snapshots sent."));
    Counter& snapshots_sent =
        one(counters("jostle_snapshots_sent_total", "Snapshots sent to clients."));
    Counter& snapshot_encodings =
        one(counters("jostle_snapshot_encodings_total",
                     "Encodings of the poses of a frame. Clients with equal baselines share one."));
    Gauges cadence_clients =
        gauges("jostle_cadence_clients",
               "Clients by cadence class. divisor: they are sent every n-th of the snapshots that "
               "they requested.");
    CountersBy<SkipReason> snapshots_skipped = {
        counters("jostle_snapshots_skipped_total",
                 "Snapshots not sent to a client. window: too many are unacknowledged. pending: "
                 "the last write is not complete. rate: the client is served in a slower cadence "
                 "class. encodings: the frame had its maximum of encodings."),
        "reason"};
    Counter& datagrams_received =
        one(counters("jostle_datagrams_received_total", "Authentic datagrams received."));
    Counter& datagrams_refused =
        one(counters("jostle_datagrams_refused_total",
                     "Datagrams refused: unknown session, altered, duplicated or malformed."));
    Counter& datagrams_sent =
        one(counters("jostle_datagrams_sent_total", "Datagrams sent to clients."));
    CountersBy<ErrorCode> refusals = {
        counters("jostle_refusals_total",
                 "Streams and calls that the server ended because of a client fault."),
        "reason"};

    Gauge& clients_max = one(gauges("jostle_clients_max", "Maximum number of connected clients."));

    // --- listeners: label listener ---
    Gauges connections = gauges("jostle_connections", "Open connections of a listener.");
    Counters connections_refused =
        counters("jostle_connections_refused_total", "Connections closed instead of served.");
    std::array<ListenerMetrics, names_of(Listener{}).size()> listeners;

    // --- the process ---
    // Unix time in seconds; a series appears when a certificate is loaded. Label listener.
    Gauges certificate_expiry =
        gauges("jostle_tls_certificate_expiry_timestamp_seconds",
               "Expiry time of the certificate of a listener, as Unix time.");
    Counter& log_dropped =
        one(counters("jostle_log_dropped_total",
                     "Log lines dropped because they were produced faster than they were "
                     "written."));
    Counter& world_restarts =
        one(counters("jostle_world_restarts_total", "Worlds restarted after an error."));
    // Without a database: healthy, and no bytes.
    Gauge& storage_healthy =
        one(gauges("jostle_storage_healthy",
                   "1: inputs can be persisted and all persisted worlds were resumed; else 0."));
    Counter& storage_failures =
        one(counters("jostle_storage_failures_total", "Times that persisting began to fail."));
    Gauge& storage_bytes = one(gauges("jostle_storage_bytes", "Size of the database files."));
    Gauge& storage_pending_bytes =
        one(gauges("jostle_storage_pending_bytes", "Changes that wait to be persisted."));
    Gauges build_info = gauges("jostle_build_info", "1; the label is the running version.");

    // --- gRPC calls: labels grpc_service, grpc_method, grpc_code ---
    Counters rpcs_handled =
        counters("grpc_server_handled_total", "Completed calls, by status code.");
    Histograms rpc_seconds = histograms("grpc_server_handling_seconds",
                                        "Time from the arrival of a unary call to its response.");

    // --- operating system values, read at each scrape (metrics_text.cpp) ---
    Gauge& resident_bytes =
        one(gauges("process_resident_memory_bytes", "Resident memory of the process."));
    Gauge& virtual_bytes =
        one(gauges("process_virtual_memory_bytes", "Address space of the process."));
    Gauge& open_fds = one(gauges("process_open_fds", "Open file descriptors."));
    Gauge& max_fds = one(gauges("process_max_fds", "Maximum number of open file descriptors."));
    Gauge& start_time =
        one(gauges("process_start_time_seconds", "Start time of the process, as Unix time."));
    Counter& cpu_seconds =
        one(counters("process_cpu_seconds_total", "Processor time of the process."));

    const ListenerMetrics& listener(Listener which) const {
        return listeners[static_cast<std::size_t>(which)];
    }

    // Number of holders of the series of a world name: world_metrics.h.
    struct {
        std::mutex mutex;
        std::map<std::string, int> count;
    } world_holders;

private:
    Counters counters(const char* name, const char* help);
    Gauges gauges(const char* name, const char* help);
    Histograms histograms(const char* name, const char* help);
    template <class Metric>
    static Metric& one(prometheus::Family<Metric>& family) {
        return family.Add({});
    }
    ListenerMetrics make_listener(Listener which);
};

// For values counted elsewhere: raises a counter to a total, which never decreases.
void raise_to(prometheus::Counter& counter, double total);

}  // namespace jostle::server
