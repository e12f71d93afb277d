// SPDX-License-Identifier: MIT
//
// Rows of jostle-bench contact-models: penalty forces, velocity constraints and position
// corrections on one contact scene.
#pragma once

#include <nlohmann/json.hpp>

#include "bench/contact_models/contact_model.h"

namespace jostle::bench::contact_models {

struct ContactModelRow {
    std::string model;
    double rate_hz = 0;
    SceneErrors errors;
    double cpu_us_per_second = 0;  // CPU time per simulated second
};
ContactModelRow contact_model_row(const ContactModelKind& kind, double rate_hz);
nlohmann::ordered_json to_json(const ContactModelRow& row);

}  // namespace jostle::bench::contact_models
