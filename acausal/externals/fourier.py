"""The fast Fourier transform of MSL's ModelicaFFT."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from acausal.externals.arguments import Argument, Changed, Routine, numbers, tensor, whole


def real_transform(args: Sequence[Argument]) -> Changed:
    """(u, nu, work, nwork, amplitudes, phases): `|U_k| / nf` and `arg U_k` for k = 0 .. nu/2, nf = nu/2 + 1.

    The result is 0, 1 where nu is odd, 2 where the work array is too short.
    """
    u = np.array(numbers(args[0]))
    count = len(u) // 2 + 1
    if len(u) % 2:
        return {-1: 1}
    if whole(args[3]) < 3 * len(u) + 2 * count:
        return {-1: 2}
    spectrum = np.fft.rfft(u)
    return {-1: 0, 4: tensor(np.abs(spectrum) / count), 5: tensor(np.angle(spectrum))}


FOURIER: dict[str, Routine] = {"ModelicaFFT_kiss_fftr": real_transform}
