// Written by bench/points_bench.cpp; part of the format (proto/WIRE.md, "Points").

export const INITIAL_POINT_MODELS = [
  'HZ>>bdh#xt1eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee',
  'ee>RdJZXTRPbZVbPTVZbRNTbbNPRfbPLRfbZPVhdbTXjddZZjdfdbldhfbldhfdldjhdndljdndlldnd',
  'lldndlndndnndndnpdldlnbjdllbndnpbrdrvbndprbXUeeeeeeeeeePeeeeeeeeeeeeZbSeeeeeeeee',
  'ZZSeeeeeeeeeeTTZWeeeeeeeeXZSkeeeeeeeeeRVTeeeeeeeeeXTTeeeeeeeeeeVVXPeeeeeeeeXXThe',
  'eeeeeeeeRVTTeeeeeeeeVXVZeeeeeeeeeVZbJUeeeeeeeVZVPUeeeeeeeeVZfFhjSeeeeeXXXZUWoeee',
  'eeeVTVXZReeeeeeZVXXXheeeeeeeXTZfZvBeeeeeZXVVTZ*eeeeeebVVbd9eeeeeebXVZZNeeeeeeedX',
  'VVVZrrReeebZXXVZeereeeefZXTVZdReeeedbXVZZPheeeeehbXVbbt*BeeedbZXVNbe*eeeejfZXZdl',
  'BeeeeddbVXXXHeeeeejhbVVVXfrrReddbXXXVjeereeljfXVRXVWeeedddbXTXdWeeeenlhbVXjd**Be',
  'dddbZTXvee*eenljfXRZPaWeeddddbRhLekeeenllhbPTThTeedddddVVNepeeellljfXTLpTeebbddd',
  'bTNepeeepppnjdTTtBeebdddddZTP*eeextrplfXPbFeeddddddbPxFeeetrrpnjdXjT*BdbdddddVfV',
  'e*e',
].join('');
