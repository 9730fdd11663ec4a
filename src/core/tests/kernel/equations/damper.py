"""The damper model of docs/book/src/equations.md, in the order of that page: force, state derivatives and steady state.

A test compares this program with the kernel (src/core/tests/kernel/equations/mod.rs) and thus checks the page. Therefore nothing here may be taken from
the kernel, and the constants come from the tables of the page.
"""

import math
import re
from bisect import bisect_right


def constants(page):
    """Returns the constants of the page by section: {section: {name: value}}."""
    found, section = {}, ""
    for line in page.splitlines():
        if line.startswith("#"):
            section = line.lstrip("#").strip().strip("`")
        row = re.match(r"\| `([A-Z_]+)` \| ([-+0-9.e]+) \|", line)
        if row:
            found.setdefault(section, {})[row[1]] = float(row[2])
    return found


def sgn(a):
    return (a > 0) - (a < 0)


def root_of(rises, guess):
    """Finds the zero of the non-decreasing function `rises` near a guess, by bisection to the last digit."""
    width = 1e-3
    low, high = guess - width, guess + width
    while rises(low) > 0:
        width *= 4
        low -= width
    width = 1e-3
    while rises(high) < 0:
        width *= 4
        high += width
    while True:
        middle = 0.5 * (low + high)
        if not low < middle < high:
            return middle
        if rises(middle) > 0:
            high = middle
        else:
            low = middle


def one_sided(h, delta):
    """Returns the derivative at zero of one side of a curve. h and delta are the widths and mean slopes of its pieces, outward from zero."""
    if len(h) == 1:
        return delta[0]
    return max(0.0, delta[0] + (delta[0] - delta[1]) * h[0] / (h[0] + h[1]))


class Curve:
    """A piecewise linear or cubic curve through points."""

    def __init__(self, u, f, interpolation):
        self.u, self.f = u, f
        n = len(u) - 1
        h = [u[i + 1] - u[i] for i in range(n)]
        delta = [(f[i + 1] - f[i]) / h[i] for i in range(n)]
        self.first, self.last = delta[0], delta[-1]
        self.pieces = []
        if interpolation == "linear":
            self.pieces = [(d, 0.0, 0.0) for d in delta]
            return
        m = [delta[0]]
        kink = {}
        for i in range(1, n):
            if interpolation == "cubic_each_side" and u[i] == 0.0:
                kink[i] = (one_sided(h[:i][::-1], delta[:i][::-1]), one_sided(h[i:], delta[i:]))
                m.append(None)
            elif delta[i - 1] * delta[i] <= 0:
                m.append(0.0)
            else:
                a, b = 2 * h[i] + h[i - 1], h[i] + 2 * h[i - 1]
                m.append((a + b) / (a / delta[i - 1] + b / delta[i]))
        m.append(delta[-1])
        for i in range(n):
            left, right = kink[i][1] if i in kink else m[i], kink[i + 1][0] if i + 1 in kink else m[i + 1]
            second = (3 * delta[i] - 2 * left - right) / h[i]
            third = (left + right - 2 * delta[i]) / h[i] ** 2
            self.pieces.append((left, second, third))

    def piece(self, u):
        i = bisect_right(self.u, u) - 1
        if i < 0:
            return u - self.u[0], self.f[0], (self.first, 0.0, 0.0)
        if i >= len(self.pieces):
            return u - self.u[-1], self.f[-1], (self.last, 0.0, 0.0)
        return u - self.u[i], self.f[i], self.pieces[i]

    def __call__(self, u):
        t, f, (c1, c2, c3) = self.piece(u)
        return f + t * (c1 + t * (c2 + t * c3))

    def slope(self, u):
        t, _, (c1, c2, c3) = self.piece(u)
        return c1 + t * (2 * c2 + 3 * t * c3)


def through_gap(k, g, softness, d):
    """Solves d = F/k + g F/(|F| + softness) for the force F, N, with stiffness k, N/m, half gap g, m, and deflection d, m."""
    h = 0.5 * (softness + k * g - k * abs(d))
    product = k * abs(d) * softness
    root = math.sqrt(h * h + product)
    size = product / (h + root) if h > 0 else root - h
    return -size if d < 0 else size


def soft(a, width):
    if a <= 0:
        return 0.0
    return a * a / (2 * width) if a < width else a - width / 2


class Conductance:
    """Conductance g(h) of a lagging valve on one stroke, with the nodes of the kernel's table. Nodes are computed when they are needed."""

    def __init__(self, c, curve, stroke, opens):
        self.c, self.curve, self.stroke = c, curve, stroke
        self.standing = curve(0.0)
        self.per = int(c["PER_OCTAVE"])
        self.octave = math.floor(math.log2(opens))
        if 2.0**self.octave > opens:
            self.octave -= 1
        self.begin = math.floor((opens / 2.0**self.octave - 1) * self.per)
        self.count = int(c["OCTAVES"]) * self.per
        self.kept, self.limited = {}, {}

    def place(self, k):
        octaves, i = divmod(self.begin + k, self.per)
        return 2.0 ** (self.octave + octaves) * (1 + i / self.per)

    def itself(self, h):
        c = self.c
        force = self.stroke * h
        # The velocity at which the FV curve, plus LEVEL w, has the force h.
        w = root_of(lambda w: c["LEVEL"] * w + self.curve(w) - self.standing - force, 0.0)
        g = (w * w + c["LEAST"]) / h
        return g, (2 * abs(w) / (c["LEVEL"] + self.curve.slope(w)) - g) / h

    def at_place(self, k):
        if k not in self.kept:
            self.kept[k] = self.itself(self.place(k))
        return self.kept[k]

    def slope(self, k):
        if k not in self.limited:
            g, m = self.at_place(k)
            for first, second in ((k - 1, k), (k, k + 1)):
                if first < 0 or second > self.count:
                    continue
                rise = self.at_place(second)[0] - self.at_place(first)[0]
                steepest = 3 * rise / (self.place(second) - self.place(first))
                if m * steepest <= 0:
                    m = 0.0
                elif abs(m) > abs(steepest) and k != self.count:
                    m = steepest
            self.limited[k] = m
        return self.limited[k]

    def __call__(self, h):
        octave = math.floor(math.log2(h))
        if 2.0**octave > h:
            octave -= 1
        k = (octave - self.octave) * self.per + math.floor((h / 2.0**octave - 1) * self.per) - self.begin
        if k < 0 or k >= self.count:
            return self.itself(h)[0]
        from_, to = self.place(k), self.place(k + 1)
        width = to - from_
        t = (h - from_) / width
        g0, g1 = self.at_place(k)[0], self.at_place(k + 1)[0]
        a, c, rise = self.slope(k) * width, self.slope(k + 1) * width, g1 - g0
        return g0 + a * t + (3 * rise - 2 * a - c) * t**2 + (a + c - 2 * rise) * t**3


class Damper:
    def __init__(self, elements, parameters, constants):
        self.on = set(elements)
        self.p = parameters
        self.c = constants
        p = parameters
        self.curve = self.fv_curve() if "fv_curve" in self.on else Curve([0.0, 1.0], [0.0, 0.0], "linear")
        self.standing = self.curve(0.0)
        self.has_series = "series_compliance" in self.on
        self.has_column = bool(self.on & {"oil_compressibility", "aeration"})
        self.is_whole = self.has_series and p["series_load"] == "whole"
        self.sigma = 1.0 if p["cavitation_side"] == "rebound" else -1.0
        if "parallel_spring" in self.on and p["spring_displacement"]:
            self.table = Curve(p["spring_displacement"], p["spring_force"], "monotone_cubic")
        else:
            self.table = lambda x: 0.0
        self.conductance = {}

    def fv_curve(self):
        p = self.p
        if p["fv_form"] == "table":
            return Curve(p["fv_velocity"], p["fv_force"], p["fv_interpolation"])
        c_r1, c_r2, c_r3 = (p[f"fv_rebound_c{i}"] for i in (1, 2, 3))
        v_r1, v_r2 = p["fv_rebound_v1"], p["fv_rebound_v2"]
        c_c1, c_c2, v_c1 = p["fv_compression_c1"], p["fv_compression_c2"], p["fv_compression_v1"]
        knee = c_r1 * v_r1 + c_r2 * (v_r2 - v_r1)
        return Curve(
            [-2 * v_c1, -v_c1, 0.0, v_r1, v_r2, 2 * v_r2],
            [-c_c1 * v_c1 - c_c2 * v_c1, -c_c1 * v_c1, 0.0, c_r1 * v_r1, knee, knee + c_r3 * v_r2],
            "linear",
        )

    # The series path.

    def elastic(self, d):
        """Returns the elastic force φ of the series path, N, and the closed fraction χ of the free play, at the deflection d, m."""
        p = self.p
        k_s = p["series_stiffness"]
        if "free_play" not in self.on:
            return k_s * d, 1.0
        g, f_0, f_1 = 0.5 * p["free_play_gap"], p["free_play_force"], p["free_play_load"]
        beyond = through_gap(k_s, g, f_0, d - f_1 / k_s - g * f_1 / (abs(f_1) + f_0))
        return f_1 + beyond, 1 / (1 + k_s * g * f_0 / (abs(beyond) + f_0) ** 2)

    def hardened(self, phi):
        """Returns the hardened force H(φ) of a bushing, N, from the force φ of the linear series spring, N."""
        p = self.p
        if "bushing" not in self.on:
            return phi
        k_s = p["series_stiffness"]
        e = phi / k_s
        hard = phi * (1 + (e / p["bushing_hardening"]) ** 2)
        if p["bushing_stop_stiffness"] > 0:
            stop = p["bushing_stop"]
            fourth = (e / stop) ** 4
            r = (1 + fourth) ** 0.25
            beyond = stop * fourth / ((r + 1) * (r * r + 1))
            hard += k_s * p["bushing_stop_stiffness"] * sgn(e) * beyond
        return hard

    def series_force(self, d, rate, states):
        p = self.p
        phi, chi = self.elastic(d)
        force = self.hardened(phi) + p["series_damping"] * chi * rate
        if "bushing" in self.on:
            relaxing = p["bushing_loss_stiffness"] * states["bushing"]
            relaxing += p["bushing_slow_stiffness"] * states.get("bushing_slow", 0.0)
            force += p["series_stiffness"] * relaxing
        return force

    def bushing_rates(self, rate, states):
        p, c = self.p, self.c["bushing"]
        slips = rate * rate / (abs(rate) + c["TURNING"]) / p["bushing_slip"]
        rates = {"bushing": rate - states["bushing"] * (1 / p["bushing_loss_time"] + slips)}
        if "bushing_slow" in states:
            rates["bushing_slow"] = rate - states["bushing_slow"] / p["bushing_slow_time"]
        return rates

    # The hydraulic path.

    def zone(self, x):
        p = self.p
        from_, w_z, b_z = x - p["bypass_centre"], p["bypass_half_width"], p["bypass_blend"]
        return 0.5 * (math.tanh((from_ + w_z) / b_z) - math.tanh((from_ - w_z) / b_z))

    def acts_on(self, rebound):
        strokes = self.p["bypass_strokes"]
        return strokes == "both" or strokes == ("rebound" if rebound else "compression")

    def faded(self, a_1, temperature, rise):
        p, c = self.p, self.c["temperature_fade"]
        above = temperature + rise - p["fade_reference"]
        exponent = -p["fade_coefficient"] * above / max(1 + p["fade_slackening"] * above, c["STIFFEST"])
        f = math.exp(min(max(exponent, -c["LARGEST"]), c["LARGEST"]))
        laminar = p["fade_laminar_force"]
        if laminar == c["ALL"]:
            return f * a_1
        return a_1 * (1 + (f - 1) / (1 + abs(a_1) / laminar))

    def opening(self, a_2, y):
        """Returns two values for the force a_2 before a valve: the target of its opening y, and the steady opening that the FV curve includes."""
        p = self.p
        middle = 0.5 * p["valve_opening_force"] * (1 + p["valve_closing_ratio"])
        delta = 0.5 * p["valve_opening_force"] * (1 - p["valve_closing_ratio"])
        s = lambda a: 0.5 * (1 + math.tanh(a))
        over = abs(a_2) - middle
        return s((over + delta * (2 * y - 1)) / p["valve_width"]), s(over / p["valve_width"])

    def conducts(self, stroke, a):
        p = self.p
        if stroke not in self.conductance:
            self.conductance[stroke] = Conductance(self.c["valve_hysteresis"], self.curve, stroke, p["valve_opening_force"])
        over = a - p["valve_opening_force"]
        h = p["valve_opening_force"] + 0.5 * (over + math.sqrt(over * over + p["valve_width"] ** 2))
        return self.conductance[stroke](h)

    def late(self, a_2, stands):
        """Returns A_3 of the page: the force after the lagging valve, N. a_2 is the force before it, and `stands` the state of the valve."""
        p, c = self.p, self.c["valve_hysteresis"]
        if p["valve_form"] == "opening":
            return a_2 * (1 + p["valve_hysteresis_share"] * (self.opening(a_2, stands)[1] - stands))
        if abs(a_2 - stands) <= c["STEADY"] * abs(a_2):
            return a_2
        stroke = -1.0 if a_2 < 0 else 1.0
        r = self.conducts(stroke, stroke * a_2) / self.conducts(stroke, stroke * stands)
        if (r > 1) != (a_2 * (a_2 - stands) > 0):
            return a_2
        return a_2 * r * (1 + c["LEAKS"]) / (1 + c["LEAKS"] * r)

    def valve_rates(self, a_2, a_3, states):
        p, c = self.p, self.c["valve_hysteresis"]
        stands, tau = states["valve_hysteresis"], p["valve_time"]
        if p["valve_form"] == "opening":
            return {"valve_hysteresis": (self.opening(a_2, stands)[0] - stands) / tau}
        if p["valve_form"] == "spool":
            rate = states["valve_hysteresis_rate"]
            return {
                "valve_hysteresis": rate / tau,
                "valve_hysteresis_rate": (a_3 - stands - 2 * p["valve_damping"] * rate) / tau,
            }
        behind = abs(a_3 - stands)
        if p["valve_play"] > 0:
            behind -= p["valve_play"] * abs(a_3) / (abs(a_3) + p["valve_play"])
        moves = behind**2 / (behind + c["SOFT"]) if behind > 0 else 0.0
        return {"valve_hysteresis": sgn(a_3 - stands) * moves / tau}

    def valves(self, w, x, temperature, states):
        """Returns A_2, A_3, A_4 and N of the page, N: the force after fade, lagging valve and frequency-selective damping, and their result."""
        p = self.p
        a_2 = self.curve(w) - self.standing
        if "position_dependent_damping" in self.on and p["bypass_form"] == "factor" and self.acts_on(a_2 >= 0):
            a_2 *= 1 - p["bypass_share"] * self.zone(x)
        if "temperature_fade" in self.on:
            a_2 = self.faded(a_2, temperature, states.get("oil_temperature_rise", 0.0))
        a_3 = self.late(a_2, states["valve_hysteresis"]) if "valve_hysteresis" in self.on else a_2
        a_4 = a_3
        if "frequency_selective_damping" in self.on:
            a, z = p["fsd_share"], states["frequency_selective_damping"]
            if p["fsd_form"] == "filter":
                a_4 = (1 - a) * a_3 + a * z
            elif p["fsd_form"] == "stroke":
                g = min(max(z * math.tanh(w / p["fsd_velocity"]), 0.0), 1.0)
                a_4 = a_3 * (1 - a * (1 - g * g * (3 - 2 * g)))
        n = a_4 + self.standing
        if self.has_column:
            n += self.c["The hydraulic path"]["LEAKAGE"] * w
        return a_2, a_3, a_4, n

    def beside(self, f_h, x, states):
        """Returns b of the page: the flow that bypasses the valves, as a piston velocity, m/s."""
        p, flow = self.p, 0.0
        if "position_dependent_damping" in self.on and p["bypass_form"] == "groove" and self.acts_on(f_h >= 0):
            c = self.c["position_dependent_damping"]
            root = (f_h * f_h + c["LAMINAR"] ** 2) ** 0.25
            flow += p["bypass_flow"] * self.zone(x) * f_h / root / math.sqrt(c["STATED"])
        if "frequency_selective_damping" in self.on and p["fsd_form"] == "bypass":
            c, laminar = self.c["frequency_selective_damping"], p["fsd_laminar_force"]
            r = lambda f: f / (f * f + laminar * laminar) ** 0.25
            z = states["frequency_selective_damping"]
            full = max(z, 0.0) if f_h >= 0 else max(-z, 0.0)
            flow += p["fsd_flow"] * r(f_h) / r(c["STATED"]) * (1 - full)
        return flow

    def selective_emptying(self, f_h, t, z):
        c = self.c["frequency_selective_damping"]
        if t * z < 0:
            return c["EMPTIES"]
        return c["EMPTIES"] / (1 + (f_h / (c["IDLE"] * self.p["fsd_force"])) ** 2)

    def selective_rate(self, w, f_h, a_3, z):
        p = self.p
        if p["fsd_form"] == "filter":
            return (a_3 - z) / p["fsd_time"]
        if p["fsd_form"] == "stroke":
            return (math.tanh(w / p["fsd_velocity"]) - z) / p["fsd_time"]
        t = math.tanh(f_h / p["fsd_force"])
        return (t - z * (abs(t) + self.selective_emptying(f_h, t, z))) / p["fsd_time"]

    def into_void(self, f_h, v, states):
        """Returns c of the page: the part of the void's rate that depends on the hydraulic force f_h, m/s."""
        if "cavitation" not in self.on:
            return 0.0
        p, c = self.p, self.c["cavitation"]
        pressure, e = self.sigma * f_h, max(states["cavitation_void"], 0.0)
        open_ = e / (e + c["CLOSED"])
        if p["cavitation_form"] == "foot_valve":
            return -open_ * soft(-pressure, c["ROUNDING_FOOT"]) / c["FREE"]
        cap = p["cavitation_force"]
        gas = 1 - (1 - p["cavitation_onset"]) / (1 + e / p["cavitation_expansion"])
        kept = 1 - 0.5 * (1 - p["cavitation_return"]) * (1 - math.tanh(self.sigma * v / c["TURNING"]))
        width = c["ROUNDING"] * cap
        beyond, short = soft(pressure - gas * cap, width), soft(gas * kept * cap - pressure, width)
        return c["SLACK"] / cap * (beyond - open_ * short)

    def lags(self, v):
        """Returns a_f of the page: the rate at which the refill deficit of a foot valve opens the void, m/s."""
        p = self.p
        if p["cavitation_form"] == "cap":
            return 0.0
        return p["cavitation_unfilled"] * soft(self.sigma * v - p["cavitation_velocity"], self.c["cavitation"]["LAGGING"])

    # The oil column.

    def column_stiffness(self, side):
        p = self.p
        if "oil_compressibility" not in self.on:
            return self.c["aeration"]["ALONE"]
        return p["oil_stiffness"] * (p["oil_compression"] if side < 0 else 1.0)

    def air(self, side):
        p = self.p
        if "aeration" not in self.on:
            return 0.0, 1.0
        return p["aeration_stroke"] * (p["aeration_compression"] if side < 0 else 1.0), p["aeration_force"]

    def lengths(self, x):
        """Returns the relative lengths ℓ_r and ℓ_c of the rebound and compression chamber, each with its derivative with respect to x, 1/m."""
        shortening, shortest = self.p["oil_shortening"], self.c["oil_compressibility"]["SHORTEST"]
        rebound = (1 - shortening * x, -shortening) if 1 - shortening * x > shortest else (shortest, 0.0)
        return rebound, (1 + shortening * x, shortening) if 1 + shortening * x > shortest else (shortest, 0.0)

    def has_length(self):
        return "oil_compressibility" in self.on and self.p["oil_shortening"] != 0

    def counts_stroke(self):
        return self.has_length() and self.p["oil_chambers"] == "both"

    def turning_deflection(self):
        p = self.p
        return self.c["oil_compressibility"]["CHANGES"] / max(p["oil_stiffness"], p["oil_compression"] * p["oil_stiffness"])

    def column(self, s, x):
        """Returns the hydraulic force F_h, N, ∂s/∂x and the relative length ℓ of the oil column in the state s at displacement x, m."""
        q, by_x = s, 0.0
        length = self.lengths(x)[0][0] if self.has_length() and not self.counts_stroke() else 1.0
        if self.counts_stroke():
            (l_r, r_by_x), (l_c, c_by_x) = self.lengths(x)
            q_c = self.turning_deflection()
            mean, half = 0.5 * (l_r + l_c), 0.5 * (l_r - l_c)
            a = s + half * q_c
            q = (a * mean - half * math.sqrt(a * a + l_r * l_c * q_c * q_c)) / (l_r * l_c)
            size = math.sqrt(q * q + q_c * q_c) - q_c
            by_x = 0.5 * ((r_by_x + c_by_x) * q + (r_by_x - c_by_x) * size)
        g, softness = self.air(q)
        return through_gap(self.column_stiffness(q), g, softness, q), by_x, length

    def column_state(self, force, x):
        g, softness = self.air(force)
        q = force / self.column_stiffness(force) + g * force / (abs(force) + softness)
        if not self.counts_stroke():
            return q
        (l_r, _), (l_c, _) = self.lengths(x)
        q_c = self.turning_deflection()
        return 0.5 * ((l_r + l_c) * q + (l_r - l_c) * (math.sqrt(q * q + q_c * q_c) - q_c))

    # Elements on the mass and parallel to the damper.

    def parallel_spring(self, x):
        if "parallel_spring" not in self.on:
            return 0.0
        p, r = self.p, abs(x)
        powers = p["spring_linear"] * x + p["spring_quadratic"] * x * r
        powers += p["spring_cubic"] * x**3 + p["spring_quartic"] * x**3 * r
        return powers + self.table(x)

    def friction(self, v, side_force):
        p, force = self.p, 0.0
        if "coulomb_friction" in self.on:
            force += p["coulomb_force"] * math.tanh(p["coulomb_steepness"] * v)
        if "stribeck_friction" in self.on:
            force += self.stribeck(v)
        if "viscous_friction" in self.on:
            force += p["viscous_coefficient"] * v * abs(v)
        if "side_force_friction" in self.on:
            force += p["side_force_coefficient"] * abs(side_force) * math.tanh(p["side_force_steepness"] * v)
        return force

    def stribeck(self, v):
        p = self.p
        peak, level, v_brk = p["stribeck_breakaway_force"], p["stribeck_coulomb_force"], p["stribeck_breakaway_velocity"]
        if p["stribeck_form"] == "simplified":
            ratio = v / (math.sqrt(2) * v_brk)
            return math.sqrt(2 * math.e) * (peak - level) * math.exp(-ratio * ratio) * ratio + level * math.tanh(
                v / (v_brk / 10)
            )
        falls = math.exp(-((abs(v) / p["stribeck_velocity"]) ** p["stribeck_fall"]))
        rises = math.tanh(p["stribeck_rise"] * (abs(v) / v_brk) ** p["stribeck_rise_power"])
        return sgn(v) * (level + (peak - level) * falls) * rises

    def gas_preload(self):
        return -self.p["gas_force"] if "gas_preload" in self.on else 0.0

    def gas_warming(self, temperature):
        warmer = temperature - self.p["gas_warming_reference"]
        return -self.p["gas_warming_rate"] * warmer if "gas_warming" in self.on else 0.0

    def gas_power(self, x, a):
        xi, smallest = 1 + x / self.p["gas_length"], self.c["gas_spring"]["SMALLEST"]
        if xi > smallest:
            return xi**a
        return smallest**a + a * smallest ** (a - 1) * (xi - smallest)

    def gas_drawn_to(self, x):
        xi = max(1 + x / self.p["gas_length"], self.c["gas_spring"]["SMALLEST"])
        return xi ** (self.p["gas_adiabatic_index"] - 1) - 1

    def polynomial(self, v):
        return sum(a * v**k for k, a in enumerate(self.p["polynomial"]))

    def lag(self, v):
        p, speed = self.p, abs(v)
        slow, fast, v_1, v_2 = p["lag_slow"], p["lag_fast"], p["lag_v1"], p["lag_v2"]
        if speed <= v_1:
            return slow
        return fast if speed >= v_2 else slow + (fast - slow) * (speed - v_1) / (v_2 - v_1)

    def mass_inside(self):
        return "moving_mass" in self.on and self.has_series and self.p["moving_mass_place"] == "inside"

    def with_state(self, x, v, states):
        """Returns forces and state derivatives of the parallel elements with a state, which move with the moving end or with the mass."""
        p, forces, rates = self.p, {}, {}
        if "moving_mass" in self.on:
            behind = (v - states["moving_mass"]) / p["moving_mass_time"]
            forces["moving_mass"] = 0.0 if self.mass_inside() else p["moving_mass"] * behind
            rates["moving_mass"] = behind
        if "lagged_polynomial" in self.on:
            y = states["lagged_polynomial"]
            forces["lagged_polynomial"], rates["lagged_polynomial"] = y, (self.polynomial(v) - y) / self.lag(v)
        if self.is_whole:
            x, v = states["internal_mass"], states["internal_mass_velocity"]
        if "presliding_friction" in self.on:
            z = states["presliding_friction"]
            bent = z / p["presliding_length"]
            slips = math.sqrt(v * v + p["presliding_creep"] ** 2) * bent * abs(bent) ** (p["presliding_power"] - 1)
            if p["presliding_return"] == "elastic" and v * z < 0:
                slips = 0.0
            forces["presliding_friction"], rates["presliding_friction"] = p["presliding_force"] * bent, v - slips
        if "gas_spring" in self.on:
            z, gamma = states["gas_spring"], p["gas_adiabatic_index"]
            push = p["gas_stiffness"] * p["gas_length"]
            forces["gas_spring"] = push * (1 - (1 + z) * self.gas_power(x, -gamma))
            rates["gas_spring"] = (self.gas_drawn_to(x) - z) / p["gas_thermal_time"]
        return forces, rates

    def stop(self, end, depth, s):
        if depth <= 0:
            return 0.0
        c = self.c["bump_stop"]
        k, progression, loss, damping, flow = (
            self.p[f"{end}_{name}"] for name in ("stiffness", "progression", "loss", "damping", "flow")
        )
        d_s = depth * depth / (depth + c["CONTACT"])
        pressed = 0.0
        if s > 0:
            pressed = s * s / (s + c["TURNING"]) if flow == "gap" else s * s / c["ONE"]
        ratio = d_s / progression
        return k * d_s * (1 + ratio) * (1 + loss * math.tanh(s / c["TURNING"])) + 0.5 * damping * ratio * (1 + ratio) * pressed

    def stops(self, x, v):
        force = 0.0
        if "bump_stop" in self.on:
            force -= self.stop("bump_stop", -x - self.p["bump_stop_clearance"], -v)
        if "rebound_stop" in self.on:
            force += self.stop("rebound_stop", x - self.p["rebound_stop_clearance"], v)
        return force

    # One instant.

    def instant(self, x, v, side_force, temperature, states):
        """Returns the force with its components, and the time derivatives of all states."""
        p = self.p
        rates = {}
        x_m, u = (states["internal_mass"], states["internal_mass_velocity"]) if self.has_series else (x, v)
        void = lambda f_h: self.sigma * self.into_void(f_h, v, states)
        n = lambda w: self.valves(w, x, temperature, states)[3]
        if self.has_column:
            f_h, by_x, length = self.column(states["oil_column"], x)
            w = root_of(lambda w: n(w) - f_h, u)
            rates["oil_column"] = (u - w - self.beside(f_h, x, states) - void(f_h)) / length + v * by_x
        else:
            w = u
            if self.flows():
                w = root_of(lambda w: w + self.beside(n(w), x, states) + void(n(w)) - u, u)
            f_h = n(w)
        a_2, a_3 = self.valves(w, x, temperature, states)[:2]
        if "cavitation" in self.on:
            rates["cavitation_void"] = self.into_void(f_h, v, states) + self.lags(v)
        if "frequency_selective_damping" in self.on:
            z = states["frequency_selective_damping"]
            rates["frequency_selective_damping"] = self.selective_rate(w, f_h, a_3, z)
        if "valve_hysteresis" in self.on:
            rates.update(self.valve_rates(a_2, a_3, states))
        if "oil_temperature_rise" in states:
            heat = f_h * (w + self.beside(f_h, x, states)) - p["heat_transfer"] * states["oil_temperature_rise"]
            rates["oil_temperature_rise"] = heat / p["heat_capacity"]
        spring = self.parallel_spring(x_m)
        friction, gas = self.friction(u if self.is_whole else v, side_force), self.gas_preload() + self.gas_warming(temperature)
        forces, more = self.with_state(x, v, states)
        rates.update(more)
        contacts, gases = forces.pop("presliding_friction", 0.0), forces.pop("gas_spring", 0.0)
        friction, gas = friction + contacts, gas + gases
        f_in = spring + friction + gas if self.is_whole else spring
        rates["internal_mass"], rates["internal_mass_velocity"] = 0.0, 0.0
        if self.has_series:
            d, rate = x - x_m, v - u
            through = self.series_force(d, rate, states)
            mass = p["internal_mass"] + (p["moving_mass"] if self.mass_inside() else 0.0)
            rates["internal_mass"] = u
            rates["internal_mass_velocity"] = (through - f_in - f_h) / mass
            if "bushing" in self.on:
                rates.update(self.bushing_rates(rate, states))
        else:
            through = f_h + f_in
        stop = self.stops(x, v)
        f_out = sum(forces.values()) + stop
        if not self.is_whole:
            f_out += friction + gas
        parts = {
            "force": through + f_out,
            "primary_force": f_h,
            "spring_force": spring,
            "friction_force": friction,
            "gas_force": gas,
            "stop_force": stop,
            "series_deflection": x - x_m,
            "oil_temperature": temperature + states.get("oil_temperature_rise", 0.0),
        }
        return parts, rates

    def flows(self):
        """Returns whether the oil velocity at the valves may differ from the piston velocity."""
        p = self.p
        return (
            "cavitation" in self.on
            or ("position_dependent_damping" in self.on and p["bypass_form"] == "groove")
            or ("frequency_selective_damping" in self.on and p["fsd_form"] == "bypass")
        )

    # The steady state.

    def settled(self, x, v, side_force, temperature):
        p, on = self.p, self.on
        states = {"cavitation_void": 0.0, "frequency_selective_damping": 0.0, "valve_hysteresis": 0.0}
        f_h = 0.0
        low, high = -math.inf, math.inf
        for turn in range(200):
            n = lambda w: self.valves(w, x, temperature, states)[3]
            before = (dict(states), f_h)
            without = lambda w: w + self.beside(n(w), x, states) - v
            if "cavitation" in on:
                w = root_of(without, v) if self.flows() else v
                void = self.resting_void(n(w))
                states["cavitation_void"] = void if void < 1.0 else 0.0
            whole = lambda w: without(w) + self.sigma * self.into_void(n(w), v, states)
            w = root_of(whole, v) if self.flows() else v
            a_2, a_3, _, f_h = self.valves(w, x, temperature, states)
            if "frequency_selective_damping" in on:
                held = states["frequency_selective_damping"]
                drawn = self.resting_selective(w, f_h, a_3)
                if turn >= 40 and drawn != held and "valve_hysteresis" not in on:
                    low, high = (held, high) if drawn > held else (low, held)
                    if (not low < drawn < high or turn % 2 == 0) and math.isfinite(low) and math.isfinite(high):
                        drawn = 0.5 * (low + high)
                states["frequency_selective_damping"] = drawn
            if "valve_hysteresis" in on:
                y = states["valve_hysteresis"]
                states["valve_hysteresis"] = self.opening(a_2, y)[0] if p["valve_form"] == "opening" else a_2
            if before == (states, f_h):
                break
        if "cavitation" not in on:
            del states["cavitation_void"]
        if "frequency_selective_damping" not in on:
            del states["frequency_selective_damping"]
        if "valve_hysteresis" not in on:
            del states["valve_hysteresis"]
        elif p["valve_form"] == "spool":
            states["valve_hysteresis_rate"] = 0.0
        if self.has_column:
            states["oil_column"] = self.column_state(f_h, x)
        if "temperature_fade" in on and p["fade_source"] == "self_heating":
            states["oil_temperature_rise"] = 0.0
        if "bushing" in on:
            states["bushing"] = 0.0
            if p["bushing_slow_stiffness"] > 0:
                states["bushing_slow"] = 0.0
        x_m = x
        if self.has_series:
            friction = self.friction(v, side_force) + p["presliding_force"] * self.resting_contact(v) / p["presliding_length"]
            on_mass = lambda x_m: 0.0
            if self.is_whole:
                gas = self.gas_preload() + self.gas_warming(temperature)
                on_mass = lambda x_m: friction + gas + self.resting_gas(x_m)
            x_m = root_of(
                lambda x_m: self.parallel_spring(x_m) + on_mass(x_m) + f_h - self.hardened(self.elastic(x - x_m)[0]), x
            )
        states["internal_mass"], states["internal_mass_velocity"] = x_m, v
        if "lagged_polynomial" in on:
            states["lagged_polynomial"] = self.polynomial(v)
        if "presliding_friction" in on:
            states["presliding_friction"] = self.resting_contact(v)
        if "gas_spring" in on:
            place = x_m if self.is_whole else x
            states["gas_spring"] = self.gas_drawn_to(place)
        if "moving_mass" in on:
            states["moving_mass"] = v
        return states

    def resting_contact(self, v):
        p = self.p
        if "presliding_friction" not in self.on or v == 0:
            return 0.0
        share = abs(v) / math.sqrt(v * v + p["presliding_creep"] ** 2)
        return sgn(v) * p["presliding_length"] * share ** (1 / p["presliding_power"])

    def resting_gas(self, x):
        p = self.p
        if "gas_spring" not in self.on:
            return 0.0
        gamma = p["gas_adiabatic_index"]
        return p["gas_stiffness"] * p["gas_length"] * (1 - (1 + self.gas_drawn_to(x)) * self.gas_power(x, -gamma))

    def resting_void(self, force):
        p = self.p
        share, alpha = self.sigma * force / p["cavitation_force"], p["cavitation_onset"]
        if p["cavitation_form"] == "cap" and alpha < 1 and alpha < share < 1:
            return p["cavitation_expansion"] * ((1 - alpha) / (1 - share) - 1)
        return 0.0

    def resting_selective(self, w, f_h, a_3):
        p = self.p
        if p["fsd_form"] == "filter":
            return a_3
        if p["fsd_form"] == "stroke":
            return math.tanh(w / p["fsd_velocity"])
        t = math.tanh(f_h / p["fsd_force"])
        return t / (abs(t) + self.selective_emptying(f_h, t, 0.0))
