// SPDX-License-Identifier: MIT
#include "bench/result_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>

namespace jostle::bench {
namespace {

bool print_error(const std::string& path) {
    std::fprintf(stderr, "jostle-bench: cannot write %s: %s\n", path.c_str(), std::strerror(errno));
    return false;
}

}  // namespace

double rounded(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return std::stod(text);
}

bool can_write(const std::string& path) {
    return std::ofstream(path, std::ios::app) ? true : print_error(path);
}

bool write_text(const std::string& path, const std::string& text) {
    std::ofstream out(path);
    out << text;
    out.close();
    return out ? true : print_error(path);
}

bool write_result(const std::string& path, const nlohmann::ordered_json& head,
                  const nlohmann::ordered_json& rows) {
    std::ostringstream out;
    out << "{\n";
    for (const auto& [key, value] : head.items()) out << "\"" << key << "\":" << value << ",\n";
    out << "\"rows\":[\n";
    for (std::size_t k = 0; k < rows.size(); k++)
        out << rows[k] << (k + 1 < rows.size() ? ",\n" : "\n");
    out << "]}\n";
    return write_text(path, out.str());
}

}  // namespace jostle::bench
