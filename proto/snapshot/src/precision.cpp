// SPDX-License-Identifier: MIT
#include "jostle/snapshot/precision.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

#include "jostle/snapshot/entity_diff.h"

namespace jostle::snapshot {
namespace {

// Units per precision. Finer units follow a velocity longer before a correction is due, and make
// each correction larger.
constexpr double units_per_precision = 16;
constexpr double root_2 = 1.4142135623730951;

std::string text(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%g", value);
    return buffer;
}

Status check_value(const char* prefix, const char* name, double value, double low, double high,
                   const char* unit) {
    if (value >= low && value <= high) return {};
    return Error{ErrorCode::invalid_argument, std::string(prefix) + name + " is " + text(value) +
                                                  "; it must be from " + text(low) + " to " +
                                                  text(high) + " " + unit};
}

double rounded_down(double value) {
    if (value <= 0) return 0;
    const double power = std::pow(10, std::floor(std::log10(value) + 1e-9));
    // The tolerance keeps 0.01, which has no exact representation, at 0.01.
    const double mantissa = value / power * (1 + 1e-9);
    return power * (mantissa >= 5 ? 5 : mantissa >= 2 ? 2 : 1);
}

using Quaternion = std::array<double, 4>;

Quaternion normalized(const Quaternion& q) {
    double sum = 0;
    for (const double c : q) sum += c * c;
    if (!(sum > 0)) return {0, 0, 0, 1};
    Quaternion unit = q;
    for (double& c : unit) c /= std::sqrt(sum);
    return unit;
}

// The square of the distance between two unit quaternions, of which -q is the same rotation as q.
double squared_chord(const Quaternion& a, const Quaternion& b) {
    double same = 0, opposite = 0;
    for (std::size_t k = 0; k < 4; k++) {
        same += (a[k] - b[k]) * (a[k] - b[k]);
        opposite += (a[k] + b[k]) * (a[k] + b[k]);
    }
    return std::min(same, opposite);
}

// The distance of two quaternions between which a rotation has this angle.
double chord_of(double angle_rad) {
    return 2 * std::sin(angle_rad / 4);
}

bool position_is_within(double most, const EntityState& state, const Pose& pose,
                        const QuantSpec& spec) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; k++) {
        const double off =
            state.position[k] / static_cast<double>(spec.units_per_meter) - pose.position[k];
        sum += off * off;
    }
    return sum <= most * most;
}

// `chord`: the greatest distance between the quaternions; `truth` has unit length.
bool rotation_is_within(double chord, const EntityState& state, const Quaternion& truth,
                        const QuantSpec& spec) {
    return squared_chord(dequantize(state, spec).rotation, truth) <= chord * chord;
}

// A prediction that is not precise enough, in units of the spec. Its corrections are integers.
struct Miss {
    std::array<double, 3> error{};       // predicted minus true numbers
    std::array<double, 3> step_error{};  // predicted minus true step since the last frame
    // An error e is within the precision if e . e + (e . slope)^2 <= most^2.
    std::array<double, 3> slope{};
    double most = 0;
};
using Correction = std::array<std::int64_t, 3>;

double product(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Whether the corrected numbers are within the precision, and remain so for `frames` frames in
// which the body keeps its step.
bool holds(const Miss& miss, const Correction& correction, double frames) {
    std::array<double, 3> error = miss.error;
    for (std::size_t k = 0; k < 3; k++) {
        const auto corrected = static_cast<double>(correction[k]);
        error[k] += corrected + frames * (miss.step_error[k] + corrected);
    }
    const double slope = product(error, miss.slope);
    return product(error, error) + slope * slope <= miss.most * miss.most;
}

// The correction of number k alone: the nearest one to its true step that is precise enough. It
// lets the number drift through the whole tolerance before the next correction is due.
std::optional<Correction> correct_one(const Miss& miss, std::size_t k) {
    // a x^2 + b x + c <= 0 for a correction x.
    const double slope = product(miss.error, miss.slope);
    const double a = 1 + miss.slope[k] * miss.slope[k];
    const double b = 2 * (miss.error[k] + slope * miss.slope[k]);
    const double c = product(miss.error, miss.error) + slope * slope - miss.most * miss.most;
    const double root = b * b - 4 * a * c;
    if (!(root >= 0)) return std::nullopt;
    const double low = std::ceil((-b - std::sqrt(root)) / (2 * a));
    const double high = std::floor((-b + std::sqrt(root)) / (2 * a));
    if (!(low <= high) || std::abs(low) > 1e9 || std::abs(high) > 1e9) return std::nullopt;
    Correction correction{};
    correction[k] = std::llround(std::clamp(std::round(-miss.step_error[k]), low, high));
    return correction;
}

// The correction that leaves the fewest for later frames.
Correction correction_of(const Miss& miss) {
    constexpr double outlook = 4;  // frames
    std::optional<Correction> best;
    std::int64_t least = 0;
    for (std::size_t k = 0; k < 3; k++) {
        const auto one = correct_one(miss, k);
        if (!one || !holds(miss, *one, 0) || !holds(miss, *one, outlook)) continue;
        const std::int64_t size = std::abs((*one)[k]);
        if (!best || size < least) best = one, least = size;
    }
    if (best) return *best;
    Correction to_step{}, to_truth{};
    for (std::size_t k = 0; k < 3; k++) {
        to_step[k] = std::llround(-miss.step_error[k]);
        to_truth[k] = std::llround(-miss.error[k]);
    }
    return holds(miss, to_step, 0) ? to_step : to_truth;
}

void correct_position(EntityState& state, const Prediction& p, double most_units, const Pose& pose,
                      const SentMotion& sent, const QuantSpec& spec) {
    const double units = spec.units_per_meter;
    Miss miss{.most = most_units};
    for (std::size_t k = 0; k < 3; k++) {
        const auto predicted = static_cast<double>(p.position[k]);
        const double truth = pose.position[k] * units;
        miss.error[k] = predicted - truth;
        miss.step_error[k] =
            predicted - sent.last->position[k] - (truth - sent.last_pose->position[k] * units);
    }
    const Correction correction = correction_of(miss);
    for (std::size_t k = 0; k < 3; k++)
        state.position[k] = static_cast<std::int32_t>(
            std::clamp<std::int64_t>(p.position[k] + correction[k], INT32_MIN, INT32_MAX));
}

// The components of a rotation besides component `omitted`, in units of the spec; nothing if it
// cannot be sent with that component omitted.
std::optional<std::array<double, 3>> components_of(const Quaternion& q, std::size_t omitted,
                                                   double m) {
    const double scale = (q[omitted] < 0 ? -1 : 1) * m * root_2;
    std::array<double, 3> c{};
    for (std::size_t k = 0; k < 3; k++) {
        c[k] = q[others[omitted][k]] * scale;
        if (std::abs(c[k]) > m) return std::nullopt;
    }
    return c;
}

bool set_rotation(EntityState& state, std::uint8_t largest, const std::array<std::int64_t, 3>& r,
                  const QuantSpec& spec) {
    if (!is_rotation(r, spec)) return false;
    state.largest = largest;
    for (std::size_t k = 0; k < 3; k++) state.rotation[k] = static_cast<std::int16_t>(r[k]);
    return true;
}

// The true rotations of a body as unit quaternions.
struct Turn {
    Quaternion before{}, now{};
};

// Returns false if the rotation must be rounded instead.
bool correct_rotation(EntityState& state, const Prediction& p, double chord, const Turn& turn,
                      const SentMotion& sent, const QuantSpec& spec) {
    const double m = spec.rotation_component;
    const auto truth = components_of(turn.now, p.largest, m);
    const auto before = components_of(turn.before, p.largest, m);
    const auto last = components_of(dequantize(*sent.last, spec).rotation, p.largest, m);
    if (!truth || !before || !last) return false;
    // An error e of the components changes the omitted one by -e . c / c_omitted.
    double squares = 0;
    for (const double c : *truth) squares += c * c;
    const double omitted = std::sqrt(std::max(1.0, 2 * m * m - squares));
    Miss miss{.most = chord * m * root_2};
    for (std::size_t k = 0; k < 3; k++) {
        const auto predicted = static_cast<double>(p.components[k]);
        miss.slope[k] = (*truth)[k] / omitted;
        miss.error[k] = predicted - (*truth)[k];
        miss.step_error[k] = predicted - (*last)[k] - ((*truth)[k] - (*before)[k]);
    }
    const Correction correction = correction_of(miss);
    std::array<std::int64_t, 3> r = p.components;
    for (std::size_t k = 0; k < 3; k++) r[k] += correction[k];
    return set_rotation(state, p.largest, r, spec) &&
           rotation_is_within(chord, state, turn.now, spec);
}

void keep_rotation(EntityState& state, const EntityState& of) {
    state.largest = of.largest;
    state.rotation = of.rotation;
}

// Whether the body stands still in the units of the spec; prediction would let it creep to and fro.
bool moves_less_than_half_a_unit(const Pose& pose, const Pose& before, const QuantSpec& spec) {
    for (std::size_t k = 0; k < 3; k++)
        if (std::abs(pose.position[k] - before.position[k]) * spec.units_per_meter >= 0.5)
            return false;
    return true;
}
bool turns_less_than_half_a_unit(const Turn& turn, const QuantSpec& spec) {
    const double unit = 1 / (spec.rotation_component * root_2);
    return squared_chord(turn.now, turn.before) < 0.25 * unit * unit;
}

}  // namespace

Status check(const Precision& precision, const char* prefix) {
    if (!precision.is_set()) return {};
    if (Status s = check_value(prefix, "position", precision.position_m, position_precision_min,
                               position_precision_max, "m");
        !s.ok())
        return s;
    return check_value(prefix, "rotation", precision.rotation_rad, rotation_precision_min,
                       rotation_precision_max, "rad");
}

Precision rounded_down(const Precision& precision) {
    return {rounded_down(precision.position_m), rounded_down(precision.rotation_rad)};
}

QuantSpec quant_spec_for(const Precision& precision) {
    if (!precision.is_set()) return {};
    const auto limited = [](double value, std::int32_t most) {
        return static_cast<std::int32_t>(std::clamp(std::ceil(value), 1.0, double{1.0 * most}));
    };
    return {
        .units_per_meter = limited(units_per_precision / precision.position_m, max_units_per_meter),
        .rotation_component =
            limited(units_per_precision * root_2 / precision.rotation_rad, max_rotation_component)};
}

bool is_within(const Precision& precision, const EntityState& state, const Pose& pose,
               const QuantSpec& spec) {
    return position_is_within(precision.position_m, state, pose, spec) &&
           rotation_is_within(chord_of(precision.rotation_rad), state, normalized(pose.rotation),
                              spec);
}

EntityState quantize_within(const Precision& precision, std::uint32_t id, const Pose& pose,
                            bool at_rest, const SentMotion& sent, const QuantSpec& spec) {
    EntityState state = quantize(id, pose, at_rest, spec);  // the nearest state
    if (!sent.last || !sent.last_pose) return state;
    const double most_m = precision.position_m, chord = chord_of(precision.rotation_rad);
    const Turn turn{normalized(sent.last_pose->rotation), normalized(pose.rotation)};
    const Prediction p = predict(*sent.last, sent.before_last, nullptr, sent.spacing, spec);

    // Tried in this order: the last state of a body that stands still, the prediction, a corrected
    // prediction.
    EntityState other = state;
    other.position = sent.last->position;
    keep_rotation(other, *sent.last);
    const bool stands = at_rest || moves_less_than_half_a_unit(pose, *sent.last_pose, spec);
    if (!stands || !position_is_within(most_m, other, pose, spec)) {
        for (std::size_t k = 0; k < 3; k++)
            other.position[k] = static_cast<std::int32_t>(p.position[k]);
        if (!position_is_within(most_m, other, pose, spec))
            correct_position(other, p, most_m * spec.units_per_meter, pose, sent, spec);
    }
    if (position_is_within(most_m, other, pose, spec)) state.position = other.position;

    const bool stays = at_rest || turns_less_than_half_a_unit(turn, spec);
    if ((stays && rotation_is_within(chord, other, turn.now, spec)) ||
        (set_rotation(other, p.largest, p.components, spec) &&
         rotation_is_within(chord, other, turn.now, spec)) ||
        correct_rotation(other, p, chord, turn, sent, spec))
        keep_rotation(state, other);
    return state;
}

}  // namespace jostle::snapshot
