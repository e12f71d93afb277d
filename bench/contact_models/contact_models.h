// SPDX-License-Identifier: MIT
//
// Rows of jostle-bench contact-models: penalty forces, velocity constraints and position
// corrections on one contact scene.
#pragma once
#include <nlohmann/json.hpp>

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "bench/contact_models/contact_scene.h"

namespace jostle::bench::contact_models {

// The three contact models. Each is one file that can be read on its own:
//   penalty_model.cpp   springs: a force that grows with the overlap
//   impulse_model.cpp   velocity constraints: impulses that prevent approach (sequential impulses)
//   xpbd_model.cpp      positions: separates overlapping bodies and derives the velocities
class ContactModel {
public:
    virtual ~ContactModel() = default;
    virtual void step(std::vector<Ball>& balls, double dt) = 0;
};

struct ContactModelKind {
    const char* name;
    const char* about;
    std::unique_ptr<ContactModel> (*make)();
};
std::span<const ContactModelKind> contact_model_kinds();
const ContactModelKind* find_contact_model(std::string_view name);  // null: there is none

std::unique_ptr<ContactModel> make_penalty_model();
std::unique_ptr<ContactModel> make_impulse_model();
std::unique_ptr<ContactModel> make_xpbd_model();

struct ContactModelRow {
    std::string model;
    double rate_hz = 0;
    SceneErrors errors;
    double cpu_us_per_second = 0;  // CPU time per simulated second
};
ContactModelRow contact_model_row(const ContactModelKind& kind, double rate_hz);
nlohmann::ordered_json to_json(const ContactModelRow& row);

}  // namespace jostle::bench::contact_models
