"""All attacks, in the order in which they are run. Importing a group registers what is in it."""

from . import worlds, connections, calls, http2_floods, logs, crowds, garbage  # noqa: F401
