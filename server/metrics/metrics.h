// SPDX-License-Identifier: MIT
//
// Every number that the server shows to Prometheus, in one table: name, help, labels, unit. The app
// makes one and hands it by reference to those who count; nobody asks for it by name. Counting
// takes any thread and no lock, but for the histogram of ticks, whose lock is a world's own.
//
// A series with a fixed set of labels is there from the start, at 0. Those of a world come with it
// and go with it (world_metrics.h), those of a call come with its first answer (rpc_metrics.h).
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
#include <vector>

#include "jostle/base/result.h"
#include "server/metrics/labels.h"

namespace jostle::server {

// One counter for each value of a label that has few.
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

// What a door of the server counts: how many are inside, and who was sent away.
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

    // `stages`: the names of the parts of a step.
    Metrics(const std::string& version, const std::vector<std::string>& stages);
    Metrics(const Metrics&) = delete;
    Metrics& operator=(const Metrics&) = delete;

    prometheus::Registry registry;  // first: it owns the families below

    // --- worlds: label world, the name ---
    Histograms tick_seconds =
        histograms("jostle_tick_duration_seconds",
                   "Time that one tick of a world took: inputs, step, frame and answers.");
    Counters late_ticks =
        counters("jostle_late_ticks_total",
                 "Ticks of a world that were given up because it was late by more than it may "
                 "catch up.");
    Gauges bodies = gauges("jostle_world_bodies", "Bodies of a world after its last tick.");
    Gauges awake_bodies = gauges("jostle_world_awake_bodies",
                                 "Dynamic bodies of a world that were awake in its last tick.");
    Gauges queue_depth = gauges("jostle_world_queue_depth",
                                "Inputs that waited for a world when its last tick began; "
                                "world.command_queue_max is the most.");
    Gauges paused = gauges("jostle_world_paused",
                           "1 while a world takes no steps: it is paused, or they are refused.");
    Gauges clients = gauges("jostle_clients", "Clients that play in a world or watch it.");

    // --- the solver, all worlds together: label stage ---
    Counters stage_seconds = counters("jostle_step_stage_seconds_total",
                                      "Time spent in a stage of the step, of all worlds.");
    std::vector<Counter*> stages;  // by number

    // --- what clients send and get ---
    CountersBy<InputOutcome> inputs = {
        counters("jostle_inputs_total", "Inputs of clients that were answered, by the answer."),
        "code"};
    Counter& snapshot_bytes =
        one(counters("jostle_snapshot_bytes_total", "Bytes of the snapshots that were sent."));
    Counter& snapshots_sent =
        one(counters("jostle_snapshots_sent_total", "Snapshots that were sent to clients."));
    CountersBy<SkipReason> snapshots_skipped = {
        counters("jostle_snapshots_skipped_total",
                 "Snapshots that a client was not sent. window: too many unacknowledged. pending: "
                 "the last write was not taken yet. rate: it kept hitting its window."),
        "reason"};
    Counter& datagrams_received =
        one(counters("jostle_datagrams_received_total", "Datagrams that were authentic."));
    Counter& datagrams_refused =
        one(counters("jostle_datagrams_refused_total",
                     "Datagrams without a ticket, changed, sent twice or of no known form."));
    Counter& datagrams_sent =
        one(counters("jostle_datagrams_sent_total", "Datagrams that were sent to clients."));
    CountersBy<ErrorCode> refusals = {
        counters("jostle_refusals_total",
                 "Conversations that the server ended because of what the client did or asked."),
        "reason"};

    Gauge& clients_max = one(gauges("jostle_clients_max", "Most clients that may be connected."));

    // --- the doors: label listener ---
    Gauges connections = gauges("jostle_connections", "Open connections of a listener.");
    Counters connections_refused = counters("jostle_connections_refused_total",
                                            "Connections that were closed instead of served.");
    std::array<ListenerMetrics, names_of(Listener{}).size()> listeners;

    // --- the process ---
    // Unix time in seconds; a series appears when a certificate is loaded. Label listener.
    Gauges certificate_expiry =
        gauges("jostle_tls_certificate_expiry_timestamp_seconds",
               "When the certificate of a listener ends to be valid, as Unix time.");
    Counter& log_dropped =
        one(counters("jostle_log_dropped_total",
                     "Lines that the log left out because they came faster than they were "
                     "written."));
    Counter& world_restarts =
        one(counters("jostle_world_restarts_total",
                     "Worlds that ended by an error and were begun anew from their scenes."));
    Gauges build_info = gauges("jostle_build_info", "1; the label says which version runs.");

    // --- gRPC calls: labels grpc_service, grpc_method, grpc_code ---
    Counters rpcs_handled =
        counters("grpc_server_handled_total", "Calls that were answered, whatever the answer.");
    Histograms rpc_seconds = histograms("grpc_server_handling_seconds",
                                        "Time from the arrival of a unary call to its answer.");

    // --- the operating system's view, read when asked for (process_metrics.h) ---
    Gauge& resident_bytes =
        one(gauges("process_resident_memory_bytes", "Memory of the process that is in RAM."));
    Gauge& virtual_bytes =
        one(gauges("process_virtual_memory_bytes", "Address space of the process."));
    Gauge& open_fds = one(gauges("process_open_fds", "Open file descriptors."));
    Gauge& max_fds = one(gauges("process_max_fds", "Most file descriptors that may be open."));
    Gauge& start_time =
        one(gauges("process_start_time_seconds", "When the process began, as Unix time."));
    Counter& cpu_seconds =
        one(counters("process_cpu_seconds_total", "Processor time of the process."));

    const ListenerMetrics& listener(Listener which) const {
        return listeners[static_cast<std::size_t>(which)];
    }

    // How many hold the series of a world's name: world_metrics.h.
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

// For what is counted elsewhere: brings a counter up to a total, which never falls.
void raise_to(prometheus::Counter& counter, double total);

}  // namespace jostle::server
