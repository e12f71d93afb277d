// SPDX-License-Identifier: MIT
#include "bench/result_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <vector>

namespace jostle::bench {
namespace {

bool print_error(const std::string& path) {
    std::fprintf(stderr, "jostle-bench: cannot write %s: %s\n", path.c_str(), std::strerror(errno));
    return false;
}

// Quotes text that contains a separator (RFC 4180).
std::string csv_field(const nlohmann::ordered_json& value) {
    if (value.is_null()) return "";
    if (!value.is_string()) return value.dump();
    const auto text = value.get<std::string>();
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
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

std::string csv_text(const nlohmann::ordered_json& rows) {
    std::vector<std::string> columns;
    for (const auto& row : rows)
        for (const auto& [name, value] : row.items())
            if (std::find(columns.begin(), columns.end(), name) == columns.end())
                columns.push_back(name);
    std::string text;
    for (const std::string& column : columns) text += (text.empty() ? "" : ",") + column;
    text += "\n";
    for (const auto& row : rows) {
        for (std::size_t k = 0; k < columns.size(); k++)
            text +=
                (k == 0 ? "" : ",") + csv_field(row.value(columns[k], nlohmann::ordered_json()));
        text += "\n";
    }
    return text;
}

}  // namespace jostle::bench
