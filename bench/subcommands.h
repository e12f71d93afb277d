// SPDX-License-Identifier: MIT
//
// The subcommands of jostle-bench, one source each. A function adds its subcommand to the program;
// running it sets the exit status.
#pragma once

namespace CLI {
class App;
}

namespace jostle::bench {

// CPU time against error, scene by scene, for Jostle and other engines (accuracy/accuracy.cpp).
void add_accuracy(CLI::App& app, int& status);

// The same workload on all broad phases (broadphase.cpp).
void add_broadphase(CLI::App& app, int& status);

// Penalty forces, velocity constraints and position corrections on one contact scene
// (contact_models/contact_models.cpp).
void add_contact_models(CLI::App& app, int& status);

// The cost of a feature in a world that does not use it (feature_cost.cpp).
void add_features(CLI::App& app, int& status);

// Error, order and energy drift of methods that step a particle through a field
// (integrators/integrators.cpp).
void add_integrators(CLI::App& app, int& status);

// The cost of a step with many objects of a module (modules.cpp).
void add_modules(CLI::App& app, int& status);

// Bytes and time of snapshots of the scene katamari by codec, compared with the model that Fabian
// Giesen published for a similar data set of cubes (network/network.cpp).
void add_network(CLI::App& app, int& status);

// The cost of storing a world outside its process and loading it (persistence_cost.cpp).
void add_persistence(CLI::App& app, int& status);

// The cost of capturing the state of a world and restoring it (rollback.cpp).
void add_rollback(CLI::App& app, int& status);

// Time and error of Jostle and other engines on the same scenes (speed/speed.cpp).
void add_speed(CLI::App& app, int& status);

// Stress tests of Jostle and other engines (accuracy/stability.cpp).
void add_stability(CLI::App& app, int& status);

// The cost of a message to a client in jostle-server, compared with minimal servers that only send
// (stream/stream.cpp).
void add_stream(CLI::App& app, int& status);

// The effect of more threads on the step times of the scenes of `speed` (thread_scaling.cpp).
void add_threads(CLI::App& app, int& status);

}  // namespace jostle::bench
