# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Random blobs as masks, from a seed: lumpy stars, thresholded noise, holes at times, spikes one to three pixels wide.
# The same seed and size give the same blob everywhere (integers from PCG64 only, then plain arithmetic).
import numpy as np


def blob(seed, size=64):
    """A mask (size, size) of bool with solid ground in it, and an empty pixel on every side."""
    random = np.random.Generator(np.random.PCG64(seed))
    kinds = (star, noise, star, ragged)
    mask = kinds[seed % len(kinds)](random, size)
    if seed % 3 == 0:
        mask &= ~disc(size, size / 2 + uniform(random, -4, 4), size / 2, size * uniform(random, 0.05, 0.15))
    if seed % 5 == 0:
        mask |= spike(random, size)
    mask[[0, -1], :] = False
    mask[:, [0, -1]] = False
    return mask


def uniform(random, low, high):
    return low + (high - low) * int(random.integers(0, 1 << 30)) / (1 << 30)


def centers(size):
    """x and y of the pixels' centers."""
    along = np.arange(size) + 0.5
    return np.meshgrid(along, along)


def disc(size, x, y, radius):
    across, down = centers(size)
    return (across - x) ** 2 + (down - y) ** 2 < radius * radius


def star(random, size, harmonics=7, roughness=0.5):
    """A radius for each angle: a circle and a few waves round it."""
    across, down = centers(size)
    angle = np.arctan2(down - size / 2, across - size / 2)
    wave = sum(uniform(random, -1, 1) * np.cos(k * angle + uniform(random, 0, 6.28)) / k for k in range(1, harmonics + 1))
    return np.hypot(across - size / 2, down - size / 2) < size * 0.28 * (1 + roughness * wave)


def ragged(random, size):
    """A star whose waves go on to the single pixel."""
    return star(random, size, harmonics=40, roughness=0.7)


def noise(random, size):
    """Smooth noise above a threshold, fading to nothing at the rim; often several islands and holes."""
    across, down = centers(size)
    field = np.zeros((size, size))
    for _ in range(24):
        x, y = uniform(random, 0.15, 0.85) * size, uniform(random, 0.15, 0.85) * size
        width = size * uniform(random, 0.05, 0.16)
        field += uniform(random, -0.7, 1) * np.exp(-((across - x) ** 2 + (down - y) ** 2) / (2 * width * width))
    mask = field > 0.35
    return mask if mask.sum() > size else mask | disc(size, size / 2, size / 2, size / 6)


def spike(random, size):
    """A needle from the middle outward, one to three pixels wide at its root."""
    across, down = centers(size)
    angle = uniform(random, 0, 6.28)
    x, y = across - size / 2, down - size / 2
    along = x * np.cos(angle) + y * np.sin(angle)
    aside = np.abs(y * np.cos(angle) - x * np.sin(angle))
    length = size * uniform(random, 0.35, 0.48)
    return (along > 0) & (along < length) & (aside < 0.5 + uniform(random, 0, 1) * (1 - along / length))
