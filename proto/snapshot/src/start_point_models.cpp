// SPDX-License-Identifier: MIT
//
// Written by bench/points_bench.cpp; part of the format.
#include "jostle/snapshot/point_models.h"

namespace jostle::snapshot {

const std::string_view start_point_model_letters =
    "HZ>>bdh#xt1eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee"
    "ee>RdJZXTRPbZVbPTVZbRNTbbNPRfbPLRfbZPVhdbTXjddZZjdfdbldhfbldhfdldjhdndljdndlldnd"
    "lldndlndndnndndnpdldlnbjdllbndnpbrdrvbndprbXUeeeeeeeeeePeeeeeeeeeeeeZbSeeeeeeeee"
    "ZZSeeeeeeeeeeTTZWeeeeeeeeXZSkeeeeeeeeeRVTeeeeeeeeeXTTeeeeeeeeeeVVXPeeeeeeeeXXThe"
    "eeeeeeeeRVTTeeeeeeeeVXVZeeeeeeeeeVZbJUeeeeeeeVZVPUeeeeeeeeVZfFhjSeeeeeXXXZUWoeee"
    "eeeVTVXZReeeeeeZVXXXheeeeeeeXTZfZvBeeeeeZXVVTZ*eeeeeebVVbd9eeeeeebXVZZNeeeeeeedX"
    "VVVZrrReeebZXXVZeereeeefZXTVZdReeeedbXVZZPheeeeehbXVbbt*BeeedbZXVNbe*eeeejfZXZdl"
    "BeeeeddbVXXXHeeeeejhbVVVXfrrReddbXXXVjeereeljfXVRXVWeeedddbXTXdWeeeenlhbVXjd**Be"
    "dddbZTXvee*eenljfXRZPaWeeddddbRhLekeeenllhbPTThTeedddddVVNepeeellljfXTLpTeebbddd"
    "bTNepeeepppnjdTTtBeebdddddZTP*eeextrplfXPbFeeddddddbPxFeeetrrpnjdXjT*BdbdddddVfV"
    "e*e";

}  // namespace jostle::snapshot
