// SPDX-License-Identifier: MIT
//
// Reads fields of untrusted messages and stores the errors with the paths of their fields. Reading
// continues after an error, but the results are discarded.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "jostle/physics/result.h"
#include "jostle/physics/transform.h"
#include "jostle/v1/common.pb.h"

namespace jostle::scenes {

struct FieldError {
    std::string path, what;
};

// Lines of an error message, limited so that it fits into the trailers of a gRPC call.
class ErrorLines {
public:
    void add(const std::string& line) {
        if (full()) return;
        text_ += (text_.empty() ? "" : "\n") + line;
        if (++count_ == lines_max || text_.size() > bytes_max) {
            text_ += "\nmore errors may follow";
            count_ = lines_max;
        }
    }
    bool full() const { return count_ >= lines_max; }
    const std::string& text() const { return text_; }

private:
    static constexpr int lines_max = 20;
    static constexpr std::size_t bytes_max = 3000;
    std::string text_;
    int count_ = 0;
};

class FieldReader {
public:
    const std::vector<FieldError>& errors() const { return errors_; }
    // Whether the current item, such as a body, has an error. Items are independent of each other.
    bool failed() const { return errors_.size() > item_begin_; }
    void begin_item() { begin_item_at(errors_.size()); }
    // Returns to an outer item, which began when there were `errors` errors.
    void begin_item_at(std::size_t errors) { item_begin_ = errors; }
    bool full() const { return errors_.size() >= errors_max; }
    void report_error(const std::string& path, std::string what);

    // The result is always in range, so it can be converted to an integer; after an error it is
    // `low`.
    double number(const std::string& path, double x, double low, double high);
    physics::Vec3 vector(const std::string& path, const v1::Vec3& v, double limit);
    physics::Quat rotation(const std::string& path, bool given, const v1::Quat& q);
    // A length of a shape.
    double size(const std::string& path, double x);

private:
    static constexpr std::size_t errors_max = 20;
    std::vector<FieldError> errors_;
    std::size_t item_begin_ = 0;
};

void set(v1::Vec3& to, physics::Vec3 from);
void set(v1::Quat& to, physics::Quat from);

}  // namespace jostle::scenes
