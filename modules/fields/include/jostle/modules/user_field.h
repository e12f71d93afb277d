// SPDX-License-Identifier: MIT
//
// User-defined force laws, identified by name. The name and the parameters are saved state; the law
// is code, so a program must register it before it loads a world that uses it.
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

/// Input of a force law: one body in one sub-step.
struct UserFieldInput {
    physics::Vec3 position = {};  ///< m, centre of mass
    physics::Vec3 velocity = {};  ///< m/s
    double mass = 0;              ///< kg
    double time = 0;              ///< s, world time at the middle of the sub-step
    double h = 0;                 ///< s, length of the sub-step, for stiff laws
    /// Parameters of the UserField.
    std::span<const double> parameters = {};
};
/// A force law: returns the force at the centre of mass, N. A result that is not finite has no
/// effect. For deterministic results on all machines, it must depend on its input only and use only
/// the mathematics of jostle/physics/scalar.h. It is called from several threads concurrently.
using UserForce = std::function<physics::Vec3(const UserFieldInput&)>;

/// A user-defined field law.
struct UserField {
    std::string law;                      ///< registered name: 1 to 32 of a-z, 0-9 and _
    std::vector<double> parameters = {};  ///< at most 16, each within 1e12
    bool per_mass = false;                ///< if true, the law returns an acceleration, m/s^2
    /// if true, the law does not depend on time, so it does not keep bodies awake
    bool steady = false;

    bool operator==(const UserField&) const = default;
};
/// Maximum number of parameters.
inline constexpr std::size_t user_parameters_max = 16;

/// Registers a law. Thread-safe. Returns already_exists if the name is registered already.
physics::Status register_user_field(std::string law, UserForce force);
/// Returns a registered law; null if there is none with this name. Thread-safe.
std::shared_ptr<const UserForce> find_user_field(std::string_view law);
/// Names of all registered laws, sorted. Thread-safe.
std::vector<std::string> user_fields();

}  // namespace jostle::modules
