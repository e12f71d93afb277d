"""All attacks, in the order in which they run. Importing a module registers its attacks."""

from . import worlds, connections, calls, http2_floods, logs, many_clients, garbage  # noqa: F401
