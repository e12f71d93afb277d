// SPDX-License-Identifier: MIT
//
// What was wrong, of a call that a test expects to fail.
#pragma once

#include <gtest/gtest.h>

#include "jostle/base/result.h"

namespace jostle::test {

inline Error error_of(const Status& status) {
    EXPECT_FALSE(status.ok()) << "an error was expected";
    return status.ok() ? Error{} : status.error();
}

}  // namespace jostle::test
