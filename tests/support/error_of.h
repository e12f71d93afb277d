// SPDX-License-Identifier: MIT
//
// The error of a call that a test expects to fail.
#pragma once

#include <gtest/gtest.h>

#include "jostle/base/result.h"

namespace jostle::test {

inline Error error_of(const Status& status) {
    EXPECT_FALSE(status.ok()) << "expected an error";
    return status.ok() ? Error{} : status.error();
}
template <class T>
Error error_of(const Result<T>& result) {
    EXPECT_FALSE(result.ok()) << "expected an error";
    return result.ok() ? Error{} : result.error();
}

}  // namespace jostle::test
