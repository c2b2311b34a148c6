"""Pseudo-random numbers: the xorshift generators of MSL's ModelicaRandom (Vigna 2014, public domain).

States are pairs of signed 32-bit Integers, low half first, for each 64-bit word; numbers are `word * 2^-64 +
0.5` with the word as a signed Integer, hence in (0, 1].
"""

from __future__ import annotations

import struct
from collections.abc import Sequence

from acausal.externals.arguments import Argument, Changed, Routine, Tensor, number, whole, wholes

GLOBAL_SEED = 1
"""What `automaticGlobalSeed` gives here: runs are reproducible, so it is not taken from the clock."""
_MASK = (1 << 64) - 1


def _words(state: Sequence[int]) -> list[int]:
    return [
        (low & 0xFFFFFFFF) | (high & 0xFFFFFFFF) << 32
        for low, high in zip(state[::2], state[1::2], strict=True)
    ]


def _halves(words: Sequence[int]) -> Tensor:
    halves = struct.unpack(f"<{2 * len(words)}i", struct.pack(f"<{len(words)}Q", *words))
    return Tensor((len(halves),), halves)


def _unit(word: int) -> float:
    signed = word - (1 << 64) if word >> 63 else word
    return signed * 2.0**-64 + 0.5


def xorshift64star(args: Sequence[Argument]) -> Changed:
    """(state, new state, number)."""
    (x,) = _words(wholes(args[0])[:2])
    x = _scramble(x)
    return {1: _halves([x]), 2: _unit(x)}


def _scramble(x: int) -> int:
    x ^= x >> 12
    x ^= (x << 25) & _MASK
    x ^= x >> 27
    return (x * 2685821657736338717) & _MASK


def xorshift128plus(args: Sequence[Argument]) -> Changed:
    """(state, new state, number)."""
    a, b = _words(wholes(args[0])[:4])
    a ^= (a << 23) & _MASK
    new = ((a ^ b ^ (a >> 17) ^ (b >> 26)) + b) & _MASK
    return {1: _halves([b, new]), 2: _unit(new)}


def xorshift1024star(args: Sequence[Argument]) -> Changed:
    """(state, new state, number); the 33rd Integer is the position among the 16 words."""
    state = wholes(args[0])
    words, at = _words(state[:32]), state[32]
    old = words[at & 15]
    at = (at + 1) & 15
    new = words[at]
    new ^= (new << 31) & _MASK
    new ^= new >> 11
    old ^= old >> 30
    words[at] = old ^ new
    halves = _halves(words).items
    result = _unit((words[at] * 1181783497276652981) & _MASK)
    return {1: Tensor((33,), (*halves, at)), 2: result}


def automatic_global_seed(args: Sequence[Argument]) -> Changed:
    """A fixed number: see `GLOBAL_SEED`."""
    return {-1: GLOBAL_SEED}


def set_internal_state(args: Sequence[Argument]) -> Changed:
    """Nothing: `impure_random` has no memory (see there)."""
    return {}


def impure_random(args: Sequence[Argument]) -> Changed:
    """(id, place of the call, time): a number in (0, 1].

    The C function draws from one hidden state, so that its numbers depend on how often and in which order it
    is called. Here every place in the model has a stream of its own, by time: the bits of both, scrambled.
    """
    bits = struct.unpack("<Q", struct.pack("<d", number(args[2]) + 0.0))[0]
    word = (whole(args[0]) & 0xFFFFFFFF) | (whole(args[1]) << 32)
    word = _scramble((word ^ 0x9E3779B97F4A7C15) & _MASK)
    for part in (bits & 0xFFFFFFFF, bits >> 32, 0x85EBCA6B):
        word = _scramble(((word ^ (part * 0xC2B2AE3D27D4EB4F)) & _MASK) or 1)
    return {-1: _unit(word)}


def convert_real_to_integers(args: Sequence[Argument]) -> Changed:
    """(number, two Integers): the bits of a Real."""
    return {1: Tensor((2,), struct.unpack("<2i", struct.pack("<d", number(args[0]))))}


RANDOM: dict[str, Routine] = {
    "ModelicaRandom_xorshift64star": xorshift64star,
    "ModelicaRandom_xorshift128plus": xorshift128plus,
    "ModelicaRandom_xorshift1024star": xorshift1024star,
    "ModelicaRandom_automaticGlobalSeed": automatic_global_seed,
    "ModelicaRandom_setInternalState_xorshift1024star": set_internal_state,
    "ModelicaRandom_convertRealToIntegers": convert_real_to_integers,
}
