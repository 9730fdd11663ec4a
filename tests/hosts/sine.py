"""The motion of a sine test."""
import math


def motion(amplitude, frequency, t):
    """Displacement and velocity, from the shortest length on."""
    w = 2 * math.pi * frequency
    return [-amplitude * math.cos(w * t), amplitude * w * math.sin(w * t)]
