// SPDX-License-Identifier: MIT
//
// Reads fields of untrusted messages and stores the first error with the path of its field. Reading
// continues after an error, but the results are discarded.
#pragma once

#include <optional>
#include <string>

#include "jostle/physics/result.h"
#include "jostle/physics/transform.h"
#include "jostle/v1/common.pb.h"

namespace jostle::scenes {

struct FieldError {
    std::string path, what;
};

class FieldReader {
public:
    const std::optional<FieldError>& error() const { return error_; }
    bool failed() const { return error_.has_value(); }
    void report_error(const std::string& path, std::string what);

    // The result is always in range, so it can be converted to an integer; after an error it is
    // `low`.
    double number(const std::string& path, double x, double low, double high);
    physics::Vec3 vector(const std::string& path, const v1::Vec3& v, double limit);
    physics::Quat rotation(const std::string& path, bool given, const v1::Quat& q);
    // A length of a shape.
    double size(const std::string& path, double x);

private:
    std::optional<FieldError> error_;
};

void set(v1::Vec3& to, physics::Vec3 from);
void set(v1::Quat& to, physics::Quat from);

}  // namespace jostle::scenes
