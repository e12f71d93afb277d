// SPDX-License-Identifier: MIT
#include "tools/ctl/outcome.h"

namespace jostle::ctl {

Error in_file(const std::string& path, const Error& error) {
    std::string message = path + ": ";
    for (const char c : error.message) {
        message += c;
        if (c == '\n') message += path + ": ";
    }
    return {error.code, message};
}

}  // namespace jostle::ctl
