// SPDX-License-Identifier: MIT
//
// Error reporting for all libraries and programs of Jostle. Result<T> holds a value or an Error;
// Status holds success or an Error. No function throws. A call that returns an Error has changed
// nothing, unless its documentation states otherwise.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace jostle {

/// Error categories. Each has the meaning of the gRPC status code of the same name. gRPC has no
/// corrupt_data; it is sent as INVALID_ARGUMENT
/// (proto/grpc_status/include/jostle/grpc_status/grpc_status.h).
enum class ErrorCode {
    invalid_argument,     ///< a value is not finite, out of range, or contradicts another value
    not_found,            ///< no such object, or it has been destroyed
    failed_precondition,  ///< the object or the world is in the wrong state for this call
    corrupt_data,         ///< malformed bytes, such as those of a damaged saved world
    already_exists,       ///< the name is in use
    permission_denied,    ///< the caller is authenticated but not authorized
    unauthenticated,      ///< no credentials, or invalid or expired ones
    resource_exhausted,   ///< a limit or quota is reached: retry later or request less
    deadline_exceeded,    ///< the peer did not respond in time
    aborted,              ///< the peer ended the operation, for example by closing a world
    unavailable,          ///< the service is not reachable or is shutting down: retry later
    internal,             ///< a defect in Jostle
};

/// An error: its category and a message for people.
struct Error {
    ErrorCode code = ErrorCode::invalid_argument;  ///< category
    std::string message;  ///< the failed operation, the offending value, the accepted values
    /// Time after which the caller can retry, in ms. Set for resource_exhausted and unavailable
    /// only; 0 if unknown.
    int retry_after_ms = 0;
};
/// Returns an Error with the code invalid_argument.
inline Error invalid_argument(std::string message) {
    return {ErrorCode::invalid_argument, std::move(message)};
}

/// Prints the error to stderr and aborts. Result and Status call it when a caller accesses the
/// value of a failed result.
[[noreturn]] inline void end_without_value(const Error& error) {
    std::fprintf(stderr, "jostle: %s\n", error.message.c_str());
    std::abort();
}

/// A value of type T, or an Error.
///
///     World world = World::create(def).value();   // moves the value out of a temporary
///     if (const auto body = world.create_body(def)) use(*body);
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : content_(std::move(value)) {}
    Result(Error error) : content_(std::move(error)) {}

    bool ok() const { return content_.index() == 0; }  ///< true if this holds a value
    explicit operator bool() const { return ok(); }

    /// Return the value. If ok() is false, they print the error and abort.
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

    /// Returns the error. Precondition: ok() is false.
    const Error& error() const { return *std::get_if<1>(&content_); }

private:
    std::variant<T, Error> content_;
};

/// Success, or an Error. A default-constructed Status is success.
class [[nodiscard]] Status {
public:
    Status() = default;
    Status(Error error) : error_(std::move(error)) {}

    bool ok() const { return !error_; }  ///< true on success
    explicit operator bool() const { return ok(); }
    const Error& error() const { return *error_; }  ///< precondition: ok() is false
    /// Does nothing on success. On failure prints the error and aborts. For programs that cannot
    /// continue after the failure.
    void expect() const {
        if (!ok()) end_without_value(*error_);
    }

private:
    std::optional<Error> error_;
};

}  // namespace jostle
