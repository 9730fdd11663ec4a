"""The motion of a sine test."""
import math


def motion(amplitude, frequency, t):
    """Returns displacement, m, and velocity, m/s, of a sine that begins at the shortest length."""
    w = 2 * math.pi * frequency
    return [-amplitude * math.cos(w * t), amplitude * w * math.sin(w * t)]
