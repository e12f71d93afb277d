// SPDX-License-Identifier: MIT
//
// jostle-bench: one program with one file per subcommand. A subcommand adds its flags and a
// callback that sets the exit status.
#include <CLI/CLI.hpp>

#include "base/command_line/command_line.h"
#include "bench/subcommands.h"

namespace {

constexpr const char* footer = R"(
Examples:
  jostle-bench accuracy --scene j1,c8 --peers none
  jostle-bench broadphase --help
  jostle-bench broadphase --bodies 1000 --moving all
  jostle-bench features --max-percent 1
  jostle-bench integrators --field kepler
  jostle-bench persistence --bodies 5000
  jostle-bench modules
  jostle-bench network
  jostle-bench contact-models --help
  jostle-bench rollback --bodies 5000
  jostle-bench speed --help
  jostle-bench speed --scene a,c --threads 1,2
  jostle-bench stability --peers none
  jostle-bench stream --clients 300
  jostle-bench threads --max-ratio 1.01

Measure a release build (cmake --preset release): other builds are several times slower.
Exit status: 0 success, 1 a measurement failed or results are inconsistent, 2 invalid flags.)";

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Measure parts of Jostle and print tables; --json writes the results to a file"};
    int status = 0;
    app.require_subcommand(1);
    jostle::bench::add_accuracy(app, status);
    jostle::bench::add_broadphase(app, status);
    jostle::bench::add_features(app, status);
    jostle::bench::add_persistence(app, status);
    jostle::bench::add_integrators(app, status);
    jostle::bench::add_modules(app, status);
    jostle::bench::add_network(app, status);
    jostle::bench::add_contact_models(app, status);
    jostle::bench::add_rollback(app, status);
    jostle::bench::add_speed(app, status);
    jostle::bench::add_stability(app, status);
    jostle::bench::add_stream(app, status);
    jostle::bench::add_threads(app, status);
    app.footer(footer);
    if (const auto parsed =
            jostle::parse_command_line(app, {"jostle-bench", JOSTLE_VERSION}, argc, argv))
        return *parsed;
    return status;
}
