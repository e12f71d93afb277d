// SPDX-License-Identifier: MIT
#include "server/metrics/metrics_text.h"

#include <prometheus/text_serializer.h>

#include <sstream>

#include "server/metrics/metrics.h"

namespace jostle::server {

std::string metrics_text(Metrics& metrics) {
    read_process_metrics(metrics);
    std::ostringstream out;
    prometheus::TextSerializer().Serialize(out, metrics.registry.Collect());
    return std::move(out).str();
}

}  // namespace jostle::server
