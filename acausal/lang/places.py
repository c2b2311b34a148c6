"""Finds where a model declares its components, for messages."""

from __future__ import annotations

from acausal.errors import Span
from acausal.lang.flat import Places
from acausal.lang.instance import Instance
from acausal.lang.links import components


def places_of(root: Instance) -> Places:
    """One pass over the components."""
    found: dict[str, Span] = {}
    for instance in components(root):
        if instance is not root and not instance.is_connector and not instance.is_record:
            found[instance.path] = instance.span
    return Places(found)
