"""`event.h` and `cruise.h` for `ctypes`, as `binding` has it for `acausal_runtime.h`."""

from __future__ import annotations

from ctypes import CDLL, POINTER, Structure, c_double, c_int, c_longlong, c_void_p

from acausal.runtime.binding import FunctionStructure, pointers, typed

CROWDED = 6
RECENT, SHRINKING = 100, 24
"""Stops that are remembered, and how many of them may shrink to an accumulation: `cruise.h`."""


class EventStructure(Structure):
    """`ac_event`."""

    model: int
    modes: int
    frozen: int
    unknowns: int
    memory: int
    samples: int
    resets: int
    checks: int
    stops: int
    located: int
    instants: int
    brief: int
    located_at: int
    above: int
    at_zero: int
    judged: int
    whole: int
    reset_state: int
    m: int
    d: int
    update: FunctionStructure
    recall: FunctionStructure
    actions: FunctionStructure
    ahead_of: FunctionStructure
    new_d: int
    new_memory: int
    action: int
    instant: int
    kept_z: int
    shift: int
    band: int
    sample_start: int
    sample_interval: int
    sample_count: int
    ahead: float
    _fields_ = [
        *pointers("model"),
        *typed("modes frozen unknowns memory samples resets checks stops located instants brief", c_int),
        *pointers("located_at above at_zero judged whole reset_state m d"),
        *((name, FunctionStructure) for name in ("update", "recall", "actions", "ahead_of")),
        *pointers("new_d new_memory action instant solve owner kept_z shift band"),
        *pointers("sample_start sample_interval sample_count"),
        *typed("ahead time", c_double),
        *pointers("x at_roots fired crossed met released disputed reached"),
        *typed("anchored undecided which", c_int),
        *pointers("later roots wanted start_m start_d old_m old_d seen_m seen_d past reach side slack"),
    ]


class CruiseStructure(Structure):
    """`ac_cruise`."""

    solver: int
    event: int
    held: float
    next: float
    last_row: float
    shortest: float
    resolved: float
    times: int
    rows: int
    room: int
    filled: int
    recent: int
    involved: int
    tally: int
    stops: int
    events: int
    _fields_ = [
        *pointers("solver event"),
        *typed("held next last_row shortest resolved", c_double),
        *pointers("times rows"),
        *typed("room filled", c_int),
        *pointers("x before_x before_m before_d before_count before_guess recent involved tally"),
        *typed("stops events", c_longlong),
    ]


class EventRunTime:
    """The run-time's functions for events."""

    def __init__(self, library: CDLL) -> None:
        event, cruise = POINTER(EventStructure), POINTER(CruiseStructure)
        self.doubles, self.ints = library.ac_event_doubles, library.ac_event_ints
        self.doubles.argtypes, self.doubles.restype = [event], c_int
        self.ints.argtypes, self.ints.restype = [event], c_int
        self.init = library.ac_event_init
        self.init.argtypes, self.init.restype = [event, c_void_p, c_void_p], None
        self.cruise_doubles = library.ac_cruise_doubles
        self.cruise_doubles.argtypes, self.cruise_doubles.restype = [event], c_int
        self.cruise_init = library.ac_cruise_init
        self.cruise_init.argtypes, self.cruise_init.restype = [cruise, c_void_p], None
        self.go = library.ac_cruise_on
        self.go.argtypes = [cruise, c_void_p, c_int, c_double, c_longlong, c_void_p]
        self.go.restype = c_int
        self.sizes = library.ac_cruise_sizes
        self.sizes.argtypes, self.sizes.restype = [c_void_p], None
