// SPDX-License-Identifier: MIT
#include "jostle/snapshot/predict.h"

#include <algorithm>
#include <cmath>

namespace jostle::snapshot {
namespace {

using Four = std::array<std::int64_t, 4>;

std::int64_t magnitude(std::int64_t v) {
    return v < 0 ? -v : v;
}

// floor(sqrt(x)); 0 for negative x. The argument is below 2^53, so the error of the double's square
// root is less than one.
std::int64_t root(std::int64_t x) {
    if (x <= 0) return 0;
    auto r = static_cast<std::int64_t>(std::sqrt(static_cast<double>(x)));
    while (r * r > x) r--;
    while ((r + 1) * (r + 1) <= x) r++;
    return r;
}

Four unpack(const EntityState& state, std::int64_t n) {
    Four q{};
    std::int64_t sum = 0;
    for (std::size_t k = 0; k < 3; k++) {
        const std::int64_t c = state.rotation[k];
        q[others[state.largest][k]] = c;
        sum += c * c;
    }
    q[state.largest] = root(n - sum);
    return q;
}

std::int64_t dot(const Four& a, const Four& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

void face(Four& q, const Four& towards) {
    if (dot(q, towards) < 0)
        for (std::int64_t& c : q) c = -c;
}

void predict_position(Prediction& p, const EntityState& baseline, const EntityState* baseline2,
                      const EntityState* baseline3, const Spacing& t) {
    for (std::size_t k = 0; k < 3; k++) {
        const std::int64_t b1 = baseline.position[k];
        const std::int64_t d = baseline2 ? b1 - baseline2->position[k] : 0;
        const std::int64_t before =
            baseline3 ? scaled(std::int64_t{baseline2->position[k]} - baseline3->position[k], t.dt2,
                               t.dt3)
                      : d;
        p.position_step[k] = d;
        p.position_acceleration[k] = d - before;
        // Clamped to int32, so that a residual needs at most 33 bits.
        p.position[k] =
            std::clamp<std::int64_t>(b1 + scaled(d, t.dt1, t.dt2), -2147483648ll, 2147483647ll);
        p.position_change += magnitude(d - before);
    }
}

void predict_rotation(Prediction& p, const EntityState& baseline, const EntityState* baseline2,
                      const EntityState* baseline3, const Spacing& t, std::int64_t m) {
    const std::int64_t n = 2 * m * m;
    const Four q1 = unpack(baseline, n);
    p.rotation = q1;
    Four& change = p.rotation_acceleration;
    const bool turned = baseline2 && !(same_rotation(baseline, *baseline2) &&
                                       (!baseline3 || same_rotation(*baseline2, *baseline3)));
    if (turned) {
        Four q2 = unpack(*baseline2, n);
        face(q2, q1);
        Four step{};
        std::int64_t step2 = 0;
        for (std::size_t k = 0; k < 4; k++) {
            step[k] = q1[k] - q2[k];
            step2 += step[k] * step[k];
        }
        if (baseline3) {
            Four q3 = unpack(*baseline3, n);
            face(q3, q2);
            for (std::size_t k = 0; k < 4; k++)
                change[k] = step[k] - scaled(q2[k] - q3[k], t.dt2, t.dt3);
        }
        // Above 41 degrees per step the difference of two quaternions is meaningless; predict no
        // rotation.
        if (step2 <= n / 2) {
            // The curvature term keeps the prediction on the unit sphere.
            const std::int64_t acceleration =
                t.dt1 == t.dt2 ? step2
                               : divide_rounded(step2 * t.dt1 * (t.dt1 + t.dt2), 2 * t.dt2 * t.dt2);
            const bool bends = acceleration * m >= n / 4;
            p.rotation_step = step;
            for (std::size_t k = 0; k < 4; k++)
                p.rotation[k] = q1[k] + scaled(step[k], t.dt1, t.dt2) -
                                (bends ? divide_rounded(q1[k] * acceleration, n) : 0);
        }
    }
    std::size_t largest = 0;
    for (std::size_t k = 1; k < 4; k++)
        if (magnitude(p.rotation[k]) > magnitude(p.rotation[largest])) largest = k;
    p.largest = static_cast<std::uint8_t>(largest);
    const std::int64_t sign = p.rotation[largest] < 0 ? -1 : 1;
    for (std::size_t k = 0; k < 3; k++) {
        const std::size_t from = others[largest][k];
        p.components[k] = sign * p.rotation[from];
        p.rotation_change += magnitude(change[from]);
    }
}

}  // namespace

Prediction predict(const EntityState& baseline, const EntityState* baseline2,
                   const EntityState* baseline3, const Spacing& spacing, const QuantSpec& spec) {
    if (baseline.at_rest || !baseline2) baseline2 = baseline3 = nullptr;
    Prediction p;
    predict_position(p, baseline, baseline2, baseline3, spacing);
    predict_rotation(p, baseline, baseline2, baseline3, spacing, spec.rotation_component);
    return p;
}

}  // namespace jostle::snapshot
