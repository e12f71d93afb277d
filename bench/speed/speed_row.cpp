// SPDX-License-Identifier: MIT
#include "bench/speed/speed_row.h"

#include <algorithm>

#include "bench/speed/field_json.h"

namespace jostle::bench {
namespace {

// The list of fields, written and read in this order.
template <class Row, class Field>
void visit_identity(Row& row, Field&& field) {
    field("scene", row.scene);
    field("name", row.name);
    field("engine", row.engine);
    field("threads", row.threads);
    field("steps", row.steps);
    field("failed", row.failed);
}

template <class Row, class Field>
void visit_figures(Row& row, Field&& field) {
    field("bodies", row.bodies);
    field("ms_mean", row.ms_mean);
    field("ms_p99", row.ms_p99);
    field("ms_worst", row.ms_worst);
    field("worst_stage", row.worst_stage);
    field("ms_first", row.ms_first);
    field("ms_moving_mean", row.ms_moving_mean);
    field("ms_rest_mean", row.ms_rest_mean);
    field("clock", row.clock);
    field("max_penetration_m", row.max_penetration_m);
    field("peak_penetration_m", row.peak_penetration_m);
    field("mean_penetration_m", row.mean_penetration_m);
    field("contacts_over_1cm", row.contacts_over_1cm);
    field("joint_drift_m", row.joint_drift_m);
    field("peak_joint_drift_m", row.peak_joint_drift_m);
    field("bodies_lost", row.bodies_lost);
    field("repeats", row.repeats);
    field("asleep_at_step", row.asleep_at_step);
    field("awake_at_end", row.awake_at_end);
    field("moving_at_end", row.moving_at_end);
    field("top_m", row.top_m);
    field("tunnelled", row.tunnelled);
    field("rss_mib", row.rss_mib);
}

}  // namespace

std::optional<double> SpeedRow::error_m() const {
    if (!max_penetration_m) return std::nullopt;
    return std::max(*max_penetration_m, joint_drift_m.value_or(0));
}

nlohmann::ordered_json to_json(const SpeedRow& row) {
    nlohmann::ordered_json json;
    visit_identity(row, FieldWriter{json});
    if (!row.failed) visit_figures(row, FieldWriter{json});
    return json;
}

SpeedRow speed_row_from(const nlohmann::ordered_json& json) {
    SpeedRow row;
    visit_identity(row, FieldReader{json});
    if (!row.failed) visit_figures(row, FieldReader{json});
    return row;
}

}  // namespace jostle::bench
