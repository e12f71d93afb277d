// SPDX-License-Identifier: MIT
#include "server/metrics/metrics.h"

#include "jostle/base/check.h"

namespace jostle::server {

Metrics::Metrics(const std::string& version, const std::vector<std::string>& stage_names)
    : listeners{make_listener(Listener::grpc), make_listener(Listener::http),
                make_listener(Listener::admin)} {
    for (const std::string& stage : stage_names)
        stages.push_back(&stage_seconds.Add({{"stage", stage}}));
    build_info.Add({{"version", version}}).Set(1);
}

Metrics::Counters Metrics::counters(const char* name, const char* help) {
    return prometheus::BuildCounter().Name(name).Help(help).Register(registry);
}

Metrics::Gauges Metrics::gauges(const char* name, const char* help) {
    return prometheus::BuildGauge().Name(name).Help(help).Register(registry);
}

Metrics::Histograms Metrics::histograms(const char* name, const char* help) {
    return prometheus::BuildHistogram().Name(name).Help(help).Register(registry);
}

ListenerMetrics Metrics::make_listener(Listener which) {
    ASSERT(static_cast<std::size_t>(which) < names_of(Listener{}).size());
    const std::string name(names_of(Listener{})[static_cast<std::size_t>(which)]);
    ListenerMetrics made{.open = connections.Add({{"listener", name}}), .refused_by = {}};
    for (std::size_t i = 0; i < made.refused_by.size(); i++)
        made.refused_by[i] = &connections_refused.Add(
            {{"listener", name}, {"reason", std::string(names_of(ConnectionRefusal{})[i])}});
    return made;
}

void raise_to(prometheus::Counter& counter, double total) {
    if (const double more = total - counter.Value(); more > 0) counter.Increment(more);
}

}  // namespace jostle::server
