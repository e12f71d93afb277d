// SPDX-License-Identifier: MIT
//
// printf's patterns into a string.
#pragma once

#include <cstdarg>
#include <cstdio>
#include <string>

namespace jostle {

// A line: what is longer than 639 characters is cut.
__attribute__((format(printf, 1, 2))) inline std::string format_text(const char* pattern, ...) {
    char text[640];
    va_list arguments;
    va_start(arguments, pattern);
    std::vsnprintf(text, sizeof text, pattern, arguments);
    va_end(arguments);
    return text;
}

}  // namespace jostle
