// SPDX-License-Identifier: MIT
//
// jostle-bench contact_models: penalty forces, velocity constraints and positions on one contact
// scene.
#pragma once

#include <nlohmann/json.hpp>

#include "bench/contact_models/contact_model.h"

namespace CLI {
class App;
}

namespace jostle::bench {

namespace contact_models {

struct ContactModelRow {
    std::string model;
    double rate_hz = 0;
    SceneErrors errors;
    double cpu_us_per_second = 0;  // per simulated second
};
ContactModelRow contact_model_row(const ContactModelKind& kind, double rate_hz);
nlohmann::ordered_json to_json(const ContactModelRow& row);

}  // namespace contact_models

void add_contact_models(CLI::App& app, int& status);  // the exit status is left in `status`

}  // namespace jostle::bench
