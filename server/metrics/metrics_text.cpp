// SPDX-License-Identifier: MIT
#include "server/metrics/metrics_text.h"

#include <prometheus/text_serializer.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

#include "server/metrics/metrics.h"

namespace jostle::server {

std::string metrics_text(Metrics& metrics) {
    read_process_metrics(metrics);
    std::ostringstream out;
    prometheus::TextSerializer().Serialize(out, metrics.registry.Collect());
    return std::move(out).str();
}

namespace fs = std::filesystem;

namespace {

// From /proc/self/stat; field numbers as in proc(5).
struct ProcessStat {
    double user_ticks = 0, system_ticks = 0;       // 14, 15
    double start_ticks = 0;                        // 22: since boot
    double virtual_bytes = 0, resident_pages = 0;  // 23, 24
};

std::optional<ProcessStat> read_stat() {
    std::ifstream in("/proc/self/stat");
    std::string line;
    if (!std::getline(in, line)) return std::nullopt;
    // The name in parentheses may contain any character; field 3 follows the last parenthesis.
    std::istringstream fields(line.substr(line.rfind(')') + 1));
    std::array<std::string, 25> field;
    for (std::size_t i = 3; i < field.size(); i++)
        if (!(fields >> field[i])) return std::nullopt;
    const auto number = [&](std::size_t i) { return std::strtod(field[i].c_str(), nullptr); };
    return ProcessStat{.user_ticks = number(14),
                       .system_ticks = number(15),
                       .start_ticks = number(22),
                       .virtual_bytes = number(23),
                       .resident_pages = number(24)};
}

// Unix time of the boot.
std::optional<double> boot_time() {
    std::ifstream in("/proc/stat");
    for (std::string word; in >> word;)
        if (double seconds = 0; word == "btime" && in >> seconds) return seconds;
    return std::nullopt;
}

std::optional<double> count_open_fds() {
    std::error_code error;
    double count = 0;
    for (fs::directory_iterator at("/proc/self/fd", error), end; !error && at != end;
         at.increment(error))
        count++;
    if (error) return std::nullopt;
    return count - 1;  // minus the descriptor that reads the directory
}

}  // namespace

void read_process_metrics(Metrics& metrics) {
    if (const auto stat = read_stat()) {
        const auto ticks_per_second = static_cast<double>(sysconf(_SC_CLK_TCK));
        metrics.virtual_bytes.Set(stat->virtual_bytes);
        metrics.resident_bytes.Set(stat->resident_pages *
                                   static_cast<double>(sysconf(_SC_PAGESIZE)));
        raise_to(metrics.cpu_seconds, (stat->user_ticks + stat->system_ticks) / ticks_per_second);
        if (const auto boot = boot_time())
            metrics.start_time.Set(*boot + stat->start_ticks / ticks_per_second);
    }
    if (const auto open = count_open_fds()) metrics.open_fds.Set(*open);
    if (rlimit limit{}; getrlimit(RLIMIT_NOFILE, &limit) == 0)
        metrics.max_fds.Set(static_cast<double>(limit.rlim_cur));
}

}  // namespace jostle::server
