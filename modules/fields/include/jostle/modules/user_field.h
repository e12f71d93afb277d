// SPDX-License-Identifier: MIT
//
// Force laws of a program's own, by name. The name and the parameters are state; the law is code,
// and a program that loads a world must have registered it.
//
//     register_user_field("spring_to_origin", [](const UserFieldInput& at) {
//         return at.position * -at.parameters[0];   // N
//     });
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "jostle/physics/result.h"
#include "jostle/physics/vec3.h"

namespace jostle::modules {

struct UserFieldInput {
    physics::Vec3 position = {};  // m, of the centre of mass
    physics::Vec3 velocity = {};  // m/s
    double mass = 0;              // kg
    double time = 0;              // s, in the middle of the sub-step
    double h = 0;                 // s, of the sub-step: for laws that are stiff
    std::span<const double> parameters = {};
};
// N, at the centre of mass; what is not finite pushes nothing. Depends on nothing but its input,
// so that all machines agree: no mathematics but jostle/physics/scalar.h. Called from several
// threads at once.
using UserForce = std::function<physics::Vec3(const UserFieldInput&)>;

struct UserField {
    std::string law;                      // as registered: 1 to 32 of a-z, 0-9 and _
    std::vector<double> parameters = {};  // at most 16, each within 1e12
    bool per_mass = false;                // the law gives m/s^2
    bool steady = false;                  // does not depend on time: leaves sleepers asleep

    bool operator==(const UserField&) const = default;
};
inline constexpr std::size_t user_parameters_max = 16;

// Any thread. A name that is known already is refused (already_exists).
physics::Status register_user_field(std::string law, UserForce force);
// Null: none of that name.
std::shared_ptr<const UserForce> find_user_field(std::string_view law);
std::vector<std::string> user_fields();  // sorted

}  // namespace jostle::modules
