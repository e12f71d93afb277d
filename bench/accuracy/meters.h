// SPDX-License-Identifier: MIT
//
// Measurements shared by several experiments.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "bench/accuracy/experiment.h"
#include "jostle/analysis/work_error.h"

namespace jostle::bench::accuracy {

using analysis::Rms;

// Distance between the ends of joints at the anchors; sliders, springs and the joints of
// Jostle alone are ignored.
class GapMeter {
public:
    explicit GapMeter(const Scene& scene);
    void sample(const Engine& engine);
    double most() const { return most_; }  // m, so far

private:
    struct End {
        int body;
        Vec3 local;
    };
    struct Pair {
        End a, b;
        double distance;  // target
    };
    static Vec3 place(const Engine& engine, const End& end);

    std::vector<Pair> pairs_;
    double most_ = 0;
};

using PointInTime = std::function<Vec3(double t)>;

// Primary: RMS distance of a body's centre from its true position. Second: widest joint gap. Each
// divided by a length.
std::unique_ptr<Meter> track_meter(const Scene& scene, int body, PointInTime truth, double length,
                                   double gap_length);

// Primary: distance of the body from its true position at the end, divided by a length. Second:
// computed from the last state.
using LastError = std::function<Errors(double t, const Engine& engine)>;
std::unique_ptr<Meter> last_meter(LastError error);

// For scenes at rest: the primary error is the largest displacement of any body, the second one the
// same in the horizontal plane. At the end, or at any time.
enum class When { at_end, ever };
std::unique_ptr<Meter> rest_meter(const Scene& scene, When when = When::at_end);

// Kinetic and potential energy.
double energy(const Scene& scene, const Engine& engine);

}  // namespace jostle::bench::accuracy
