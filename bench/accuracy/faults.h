// SPDX-License-Identifier: MIT
//
// Rules for the rows of Jostle: an error must not grow with the rate, and the members of families
// have limits. Known violations are listed in a file with their cause.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "bench/accuracy/run_row.h"

namespace jostle::bench::accuracy {

// Ratio above which an error is worse than another one: a third.
inline constexpr double worse_ratio = 4.0 / 3;

// The rules:
// - finer: the error at a rate is at most 4/3 of the larger of the least error at any coarser rate
//   of the same scene and mode, and the floor of the scene, which is a tenth of its finest
//   tolerance. A failed run is worse than any other. Second errors are not compared, and neither
//   are modes with an error tolerance, which take fewer sub-steps at finer rates.
// - limit, second limit: in the default mode, both errors are at most the limits of the scene at
//   its limit rate (60 Hz by default) and finer.
struct Fault {
    std::string scene, mode, rule;
    double ratio = 0;   // of the error to the allowed one without the third; 1e9: failed
    std::string words;  // such as "error 0.002 at 120 Hz, 0.001 at 60 Hz"
};
// At most one per scene, mode and rule: the worst.
std::vector<Fault> faults_of(const std::vector<Row>& rows,
                             const std::vector<const Experiment*>& experiments);

struct KnownFault {
    std::string scene;  // or the name of a family, for all of its members
    std::string mode, rule;
    double ratio = 0;
    std::string cause;
};
// Throws nlohmann::json::exception.
std::vector<KnownFault> known_faults_from(std::istream& in);
nlohmann::ordered_json to_json(const std::vector<KnownFault>& known);
// With the present ratios of scenes, and without obsolete ones. Adds none: a person states the
// cause.
std::vector<KnownFault> updated(const std::vector<KnownFault>& known,
                                const std::vector<Fault>& faults,
                                const std::vector<const Experiment*>& experiments);

// A known fault is no failure unless its ratio is more than a third larger than in the file.
struct JudgedFaults {
    struct Explained {
        Fault fault;
        std::string cause;
    };
    std::vector<Fault> failures;
    std::vector<Explained> explained;
    std::vector<KnownFault> obsolete;  // of the scenes that ran
};
JudgedFaults judge(const std::vector<Fault>& faults, const std::vector<KnownFault>& known,
                   const std::vector<const Experiment*>& experiments);
std::string to_text(const JudgedFaults& judged);

}  // namespace jostle::bench::accuracy
