// SPDX-License-Identifier: MIT
//
// Quantization with a guaranteed precision. A decoded pose may differ from the true pose by the
// precision, so the encoder may choose among many integers. It chooses the predicted ones while
// they are precise enough: a body that moves evenly then costs a fraction of a bit per number.
// Decoders do not depend on the choice. Any thread.
#pragma once

#include "jostle/base/result.h"
#include "jostle/snapshot/predict.h"
#include "jostle/snapshot/quantize.h"

namespace jostle::snapshot {

/// The greatest error of a decoded pose. Both 0: no guarantee; every pose is rounded to the nearest
/// integers of the default QuantSpec.
struct Precision {
    double position_m = 0;    ///< distance between the decoded and the true position
    double rotation_rad = 0;  ///< angle between the decoded and the true rotation

    bool is_set() const { return position_m != 0 || rotation_rad != 0; }
    auto operator<=>(const Precision&) const = default;
};

inline constexpr double position_precision_min = 1e-4, position_precision_max = 1;    // m
inline constexpr double rotation_precision_min = 2e-4, rotation_precision_max = 0.5;  // rad

/// Checks both values; `prefix` precedes their names in the error, such as "hello.". Either both
/// are 0 or both are in range. Errors: invalid_argument with the name, the value and the range.
Status check(const Precision& precision, const char* prefix);

/// Rounds each value down to 1, 2 or 5 times a power of ten, so that clients with similar settings
/// share encodings.
Precision rounded_down(const Precision& precision);

/// The quantization in which every pose can be sent with this precision.
QuantSpec quant_spec_for(const Precision& precision);

/// Whether a state, decoded, is the pose within the precision.
bool is_within(const Precision& precision, const EntityState& state, const Pose& pose,
               const QuantSpec& spec);

/// The earlier motion of a body as clients know it: its states in the last two quantized frames,
/// and its true pose in the last one. Null: it was not in that frame.
struct SentMotion {
    const EntityState* last = nullptr;
    const EntityState* before_last = nullptr;
    const Pose* last_pose = nullptr;
    Spacing spacing;
};

/// Quantizes a pose so that is_within() holds. `spec` is the QuantSpec of the same or of a finer
/// precision. A body whose pose has not changed keeps its state. Positions beyond the int32 range
/// are clamped as by quantize(), without a guarantee.
EntityState quantize_within(const Precision& precision, std::uint32_t id, const Pose& pose,
                            bool at_rest, const SentMotion& sent, const QuantSpec& spec);

}  // namespace jostle::snapshot
