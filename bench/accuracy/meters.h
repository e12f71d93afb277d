// SPDX-License-Identifier: MIT
//
// What several experiments measure alike.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "bench/accuracy/experiment.h"
#include "jostle/analysis/work_error.h"

namespace jostle::bench::accuracy {

using convergence::Rms;

// How far the ends of joints are apart: at the anchors; of sliders and springs nothing is asked.
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
        double distance;  // what it should be
    };
    static Vec3 place(const Engine& engine, const End& end);

    std::vector<Pair> pairs_;
    double most_ = 0;
};

using PointInTime = std::function<Vec3(double t)>;

// Primary: RMS distance of a body's centre from where it should be. Second: widest joint gap. Each
// over a length.
std::unique_ptr<Meter> track_meter(const Scene& scene, int body, PointInTime truth, double length,
                                   double gap_length);

// Primary: how far the body is from where it should be at the end, over a length. Second: what the
// last state says.
using LastError = std::function<Errors(double t, const Engine& engine)>;
std::unique_ptr<Meter> last_meter(LastError error);

// For what should stay: primary is the largest distance of any body from its start, second the same
// in the horizontal plane. At the end, or at any time.
enum class When { at_end, ever };
std::unique_ptr<Meter> rest_meter(const Scene& scene, When when = When::at_end);

// Energy of motion and of height.
double energy(const Scene& scene, const Engine& engine);

}  // namespace jostle::bench::accuracy
