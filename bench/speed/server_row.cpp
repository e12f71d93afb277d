// SPDX-License-Identifier: MIT
#include "bench/speed/server_row.h"

#include "bench/speed/field_json.h"

namespace jostle::bench {
namespace {

void write_identity(const ServerRow& row, const FieldWriter& field) {
    field("scene", row.scene);
    field("name", row.name);
    field("threads", row.threads);
    field("clients", row.clients);
    field("seconds", row.seconds);
    field("failed", row.failed);
}

void write_figures(const ServerRow& row, const FieldWriter& field) {
    field("bodies", row.bodies);
    field("hz", row.hz);
    field("ticks", row.ticks);
    field("late_ticks", row.late_ticks);
    field("late_share", row.late_share);
    field("ticks_over_period", row.ticks_over_period);
    field("ms_mean", row.ms_mean);
    field("ms_p99", row.ms_p99);
    field("ms_worst", row.ms_worst);
    field("begun_late_ms_worst", row.begun_late_ms_worst);
    field("verdict", row.verdict);
    field("connected", row.connected);
    field("snapshots_per_second_per_client", row.snapshots_per_second_per_client);
    field("kbit_per_second_per_client", row.kbit_per_second_per_client);
    field("age_ms_p50", row.age_ms_p50);
    field("age_ms_p99", row.age_ms_p99);
    field("errors", row.errors);
    field("server_cpu_percent", row.server_cpu_percent);
}

}  // namespace

const char* verdict_of(const ServerRow& row) {
    if (row.late_ticks > 0) return "late";
    return row.ticks_over_period > 0 ? "catches up" : "holds";
}

nlohmann::ordered_json to_json(const ServerRow& row) {
    nlohmann::ordered_json json;
    write_identity(row, FieldWriter{json});
    if (!row.failed) write_figures(row, FieldWriter{json});
    return json;
}

}  // namespace jostle::bench
