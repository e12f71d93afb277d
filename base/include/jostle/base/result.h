// SPDX-License-Identifier: MIT
//
// Result<T>: a value, or an Error that says what was wrong, where, and what to do. Status: success,
// or an Error. Every library and program of Jostle reports so what went wrong: it throws nothing,
// and a call that returns an Error has changed nothing, unless its header says otherwise.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace jostle {

// They mean what gRPC's codes of the same names mean. gRPC has no corrupt_data: it travels as
// INVALID_ARGUMENT (proto/grpc_status/include/jostle/grpc_status/grpc_status.h).
enum class ErrorCode {
    invalid_argument,     // a number is not finite, out of range or contradicts another
    not_found,            // the id names nothing (any more)
    failed_precondition,  // right call, wrong moment or wrong kind of body
    corrupt_data,         // bytes are not what they should be: a saved world, a snapshot
    already_exists,       // the name is taken
    permission_denied,    // the caller is known, but may not do that
    unauthenticated,      // no ticket, or one that is not good (any more)
    resource_exhausted,   // full, or asked too often: ask later, and for less
    deadline_exceeded,    // the other side was silent for too long
    aborted,              // the other side ended it, as when a world is closed
    unavailable,          // not there, or going down: try later
    internal,             // a mistake of Jostle's own
};

struct Error {
    ErrorCode code = ErrorCode::invalid_argument;
    std::string message;
    // Of resource_exhausted and unavailable: when to ask again; 0: not said.
    int retry_after_ms = 0;
};
inline Error invalid_argument(std::string message) {
    return {ErrorCode::invalid_argument, std::move(message)};
}

// A value was taken where there is none: the program ends and says what was wrong.
[[noreturn]] inline void end_without_value(const Error& error) {
    std::fprintf(stderr, "jostle: %s\n", error.message.c_str());
    std::abort();
}

//     World world = World::create(def).value();   // the value moves out of a temporary
//     if (const auto body = world.create_body(def)) use(*body);
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : content_(std::move(value)) {}
    Result(Error error) : content_(std::move(error)) {}

    bool ok() const { return content_.index() == 0; }
    explicit operator bool() const { return ok(); }

    // When not ok(), value(), * and -> end the program.
    T& value() & {
        if (!ok()) end_without_value(error());
        return *std::get_if<0>(&content_);
    }
    const T& value() const& {
        if (!ok()) end_without_value(error());
        return *std::get_if<0>(&content_);
    }
    T value() && { return std::move(value()); }
    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T operator*() && { return std::move(value()); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

    // Only when not ok().
    const Error& error() const { return *std::get_if<1>(&content_); }

private:
    std::variant<T, Error> content_;
};

class [[nodiscard]] Status {
public:
    Status() = default;
    Status(Error error) : error_(std::move(error)) {}

    bool ok() const { return !error_; }
    explicit operator bool() const { return ok(); }
    const Error& error() const { return *error_; }  // only when not ok()
    // For programs that cannot go on after a failure: ends the program and says what was wrong.
    void expect() const {
        if (!ok()) end_without_value(*error_);
    }

private:
    std::optional<Error> error_;
};

}  // namespace jostle
