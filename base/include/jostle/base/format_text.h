// SPDX-License-Identifier: MIT
//
// printf-style formatting into a std::string.
#pragma once

#include <cstdarg>
#include <cstdio>
#include <string>

namespace jostle {

/// Formats `pattern` and its arguments as printf does. The result is truncated to 639 characters.
__attribute__((format(printf, 1, 2))) inline std::string format_text(const char* pattern, ...) {
    char text[640];
    va_list arguments;
    va_start(arguments, pattern);
    std::vsnprintf(text, sizeof text, pattern, arguments);
    va_end(arguments);
    return text;
}

}  // namespace jostle
