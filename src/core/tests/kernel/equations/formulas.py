"""Compares every formula of the page of equations, as printed, with the program `damper.py`: `formulas.py PAGE`.

Prints the number of compared formulas to standard output. Prints the formulas that differ or were not compared to standard error."""

import math
import random
import sys

import damper
import sheet

# Sections with sums and lists of the results of other formulas, and with equations to solve. The comparison of whole dampers with the kernel checks them.
STRUCTURE = {"The frame", "The hydraulic path", "The equilibrium"}
# Left sides of formulas that are words or node numbers, or whose sum has no stated end. They are not compared.
PROSE = {"elsewhere A_1", "elsewhere b", "i", "m_k", "h_k", "Y(v)", "lagged_polynomial", "F_h"}


class Drawn(dict):
    """Parameters that are drawn at random when they are first read. The words that select forms are given."""

    def __missing__(self, name):
        self[name] = random.uniform(0.3, 2.0)
        return self[name]


def dampers(page, elements, **forms):
    """Returns a damper with random parameters, the page with the same parameters, and the parameters."""
    words = {
        "series_load": "hydraulic", "cavitation_side": "rebound", "cavitation_form": "cap", "spring_displacement": [], "bypass_strokes": "both",
        "fv_form": "table", "fv_interpolation": "monotone_cubic", "fv_velocity": [-2.0, -1.0, 0.5, 1.0, 1.7], "fv_force": [-9.0, -5.0, 1.0, 3.0, 8.0],
    }  # fmt: skip
    parameters = Drawn(words, **forms)
    return damper.Damper(elements, parameters, damper.constants(page)), sheet.Sheet(page, parameters), parameters


def one():
    """Draws a number of either sign."""
    return random.choice((-1, 1)) * random.uniform(0.1, 2.0)


def curves(page):
    model, book, _ = dampers(page, ["fv_curve"])
    section = "Curves through points"
    u, f = [-2.0, -1.3, 0.1, 0.9, 2.0], [-3.0, -1.0, -0.5, 4.0, 5.0]
    h = [book.value(section, "h_i", **{"u_(i+1)": u[i + 1], "u_i": u[i]}) for i in range(4)]
    delta = [book.value(section, "δ_i", **{"f_(i+1)": f[i + 1], "f_i": f[i], "h_i": h[i]}) for i in range(4)]
    m = [book.value(section, "m_0", **{"δ_0": delta[0]})]
    m += [book.value(section, "m_i", 1, **{"δ_(i-1)": delta[i - 1], "δ_i": delta[i], "h_(i-1)": h[i - 1], "h_i": h[i]}) for i in (1, 2, 3)]
    m += [book.value(section, "m_n", **{"δ_(n-1)": delta[3]})]
    level = damper.Curve([0.0, 1.0, 2.0, 3.0], [0.0, 1.0, 1.0, 2.0], "monotone_cubic")
    yield level.slope(1.0), book.value(section, "m_i", 0)
    for i in range(4):
        at = random.uniform(u[i], u[i + 1])
        known = {"u": at, "u_i": u[i], "f_i": f[i], "δ_i": delta[i], "h_i": h[i], "m_i": m[i], "m_(i+1)": m[i + 1]}
        yield damper.Curve(u, f, "linear")(at), book.value(section, "f(u)", 0, **known)
        yield damper.Curve(u, f, "monotone_cubic")(at), book.value(section, "f(u)", 1, **known)
    u, f = [-1.1, -0.4, 0.0, 0.3, 1.2], [-3.0, -2.0, 0.0, 4.0, 5.0]
    h, delta = [b - a for a, b in zip(u, u[1:])], []
    for i in range(4):
        delta.append((f[i + 1] - f[i]) / h[i])
    around = {"δ_i": delta[2], "δ_(i+1)": delta[3], "h_i": h[2], "h_(i+1)": h[3]}
    around |= {"δ_(i-1)": delta[1], "δ_(i-2)": delta[0], "h_(i-1)": h[1], "h_(i-2)": h[0]}
    each = damper.Curve(u, f, "cubic_each_side")
    yield each.slope(0.0), book.value(section, "m_right", **around)
    yield each.slope(-1e-12), book.value(section, "m_left", **around)


def knees(page):
    model, book, p = dampers(page, ["fv_curve"], fv_form="piecewise", fv_rebound_v1=0.2, fv_rebound_v2=0.7)
    text = page.partition("(w, F)\n")[2].partition("```")[0].splitlines()
    assert len(text) == 6
    for line in text:
        place, force = (book.expression("fv_curve", part.strip()) for part in line.strip()[1:-1].split(",  "))
        yield model.curve(place), force
    yield model.curve(place + 1) - force, p["fv_rebound_c3"]


def series(page):
    model, book, p = dampers(page, ["series_compliance", "free_play", "bushing"])
    d, rate, states = one(), one(), {"bushing": one(), "bushing_slow": one()}
    phi, chi = model.elastic(d)
    k_s = p["series_stiffness"]
    yield d, book.value("free_play", "d", φ=phi, k_s=k_s)
    yield abs(phi - p["free_play_load"]), book.value("free_play", "|G|", d=d, k_s=k_s)
    yield chi, book.value("free_play", "χ", φ=phi, k_s=k_s)
    yield model.hardened(phi), book.value("bushing", "H(φ)", φ=phi, k_s=k_s)
    shares = {"κ_1": p["bushing_loss_stiffness"], "κ_2": p["bushing_slow_stiffness"], "z": states["bushing"], "y": states["bushing_slow"]}
    known = {"φ": phi, "χ": chi, "k_s": k_s, "c_s": p["series_damping"], "d'": rate, "H": model.hardened, **shares}
    yield model.series_force(d, rate, states), book.value("The series path", "F_s", **known)
    rates = model.bushing_rates(rate, states)
    yield rates["bushing"], book.value("bushing", "dz/dt", **{"d'": rate}, z=states["bushing"])
    yield rates["bushing_slow"], book.value("bushing", "dy/dt", **{"d'": rate}, y=states["bushing_slow"])


def column(page):
    for chambers in ("rebound", "both"):
        for side in (-1, 1):
            model, book, p = dampers(page, ["oil_compressibility", "aeration"], oil_chambers=chambers)
            x, force = random.uniform(-1.0, 1.0) / p["oil_shortening"], side * random.uniform(0.5, 200.0)
            k = book.value("oil_compressibility", "k(F)", int(side < 0), F=force)
            g = book.value("aeration", "g", int(side < 0))
            q = book.value("aeration", "q(F)", F=force, k=lambda _: k, g=g)
            yield abs(force), book.value("aeration", "|F|", q=q, k=k, g=g)
            slope = p["oil_shortening"]
            lengths = {"x": x, "ℓ_r": book.value("oil_compressibility", "ℓ_r", x=x)}
            if chambers == "rebound":
                s = book.value("oil_compressibility", "s", 1, q=q)
                yield model.column_state(force, x), s
                length = book.value("oil_compressibility", "ℓ", 1, **lengths)
                yield model.column(s, x), (force, book.value("oil_compressibility", "∂s/∂x", 1), length)
            else:
                lengths["ℓ_c"] = book.value("oil_compressibility", "ℓ_c", **lengths)
                held = [length == 0.1 for length in (lengths["ℓ_r"], lengths["ℓ_c"])]
                lengths["ℓ_r'"] = 0.0 if held[0] else -slope
                lengths["ℓ_c'"] = 0.0 if held[1] else slope
                s = book.value("oil_compressibility", "s", 2, q=q, **lengths)
                yield model.column_state(force, x), s
                yield q, book.value("oil_compressibility", "q", s=s, **lengths)
                by_x = book.value("oil_compressibility", "∂s/∂x", 2, q=q, **lengths)
                yield model.column(s, x), (force, by_x, book.value("oil_compressibility", "ℓ", 2))
            # The column without air, whose stiffness does not depend on the displacement.
            model, book, p = dampers(page, ["oil_compressibility"], oil_shortening=0.0)
            stiffness = book.value("oil_compressibility", "k(F)", int(side < 0))
            q = book.value("oil_compressibility", "q(F)", F=force, k=lambda _: stiffness)
            yield model.column_state(force, x), book.value("oil_compressibility", "s", 0, q=q)
            by_x, length = (book.value("oil_compressibility", what, 0) for what in ("∂s/∂x", "ℓ"))
            yield model.column(q, x), (force, by_x, length)


def void(page):
    for side, sigma in (("rebound", 1.0), ("compression", -1.0)):
        for form in ("cap", "foot_valve"):
            alpha = {"cavitation_onset": random.uniform(0.1, 0.9), "cavitation_return": random.uniform(0.0, 1.0)}
            model, book, p = dampers(page, ["cavitation"], cavitation_side=side, cavitation_form=form, **alpha)
            v, force, e = one() * 0.01, random.choice((1.0, 0.3, 1e-3)) * one(), random.uniform(0.0, 1e-4)
            is_foot, states = form == "foot_valve", {"cavitation_void": e}
            known = {"σ": sigma, "F_h": force, "v": v, "e": e, "soft": damper.soft}
            flow = book.value("cavitation", "c", int(is_foot), **known)
            yield model.into_void(force, v, states), flow
            lags = book.value("cavitation", "a_f", int(is_foot), **{**known, "v": 40 * v})
            yield model.lags(40 * v), lags
            yield flow + lags, book.value("cavitation", "de/dt", c=flow, a_f=lags)
            share = random.uniform(p["cavitation_onset"], 1.0)
            carried = sigma * share * p["cavitation_force"]
            if not is_foot:
                yield model.resting_void(carried), book.value("cavitation", "e", σ=sigma, N=carried)
    for which, a in enumerate((-0.3, 0.3, 1.3)):
        yield damper.soft(a, 0.7), book.value("cavitation", "soft(a; width)", which, a=a, width=0.7)


def position(page):
    element = "position_dependent_damping"
    model, book, p = dampers(page, ["fv_curve", element], bypass_form="factor")
    x, w = one(), one()
    above = model.curve(w) - model.standing
    yield model.valves(w, x, 20.0, {})[0], book.value(element, "A_1", A_0=above, x=x)
    model, book, p = dampers(page, [element], bypass_form="groove")
    force = 30 * one()
    yield model.beside(force, x, {}), book.value(element, "b(F_h)", F_h=force, x=x)


def fade(page):
    element = "temperature_fade"
    for coefficient in (0.01, 10.0, -10.0):
        # The exponent of the fade is inside its limits with the first coefficient, and outside with the others.
        forms = {"fade_coefficient": coefficient, "fade_reference": 20.0, "fade_slackening": 0.01}
        model, book, p = dampers(page, [element], **forms)
        a_1, host, rise = one(), random.uniform(-100.0, 100.0), random.uniform(0.0, 50.0)
        known = {"A_1": a_1, "T_host": host, "ϑ": rise}
        yield model.faded(a_1, host, rise), book.value(element, "A_2", 0, **known)
        p["fade_laminar_force"] = 1e9
        yield model.faded(a_1, host, rise), book.value(element, "A_2", 1, **known)
    model, book, p = dampers(page, ["fv_curve", element, "position_dependent_damping"], bypass_form="groove")
    v, x, rise = one(), one(), one()
    parts, rates = model.instant(x, v, 0.0, 20.0, {"oil_temperature_rise": rise})
    force = parts["primary_force"]
    b = model.beside(force, x, {})
    yield rates["oil_temperature_rise"], book.value(element, "dϑ/dt", F_h=force, w=v - b, b=lambda _: b, **{"ϑ": rise})


def selective(page):
    element = "frequency_selective_damping"
    for which, form in enumerate(("filter", "stroke", "bypass")):
        model, book, p = dampers(page, ["fv_curve", element], fsd_form=form)
        w, z = one(), one()
        states = {element: z}
        a_3, a_4 = model.valves(w, 0.0, 20.0, states)[1:3]
        force = 5 * one()
        t = book.value(element, "t", int(form == "bypass"), w=w, F_h=force)
        opposite = t * z < 0
        E = book.value(element, "E", int(not opposite), F_h=force)
        yield model.selective_rate(w, force, a_3, z), book.value(element, "dz/dt", which, A_3=a_3, z=z, t=t, E=E)
        if form != "bypass":
            yield a_4, book.value(element, "A_4", which, A_3=a_3, z=z, t=t)
            continue
        full = book.value(element, "full", int(force < 0), z=z)
        yield model.beside(force, 0.0, states), book.value(element, "b(F_h)", F_h=force, full=full)
        resting = book.value(element, "E", 1, F_h=force)
        yield model.resting_selective(w, force, a_3), book.value(element, "z", t=t, E=resting)


def valve(page):
    element = "valve_hysteresis"
    model, book, p = dampers(page, [element], valve_form="opening", valve_closing_ratio=random.uniform(0.3, 1.0))
    a_2, y, tau = one(), random.uniform(0.0, 1.0), p["valve_time"]
    yield model.late(a_2, y), book.value(element, "A_3", 0, A_2=a_2, y=y)
    yield model.valve_rates(a_2, 0.0, {element: y})[element], book.value(element, "dy/dt", A_2=a_2, y=y)
    # The second list of forces rises faster than the square of the velocity, so no valve lags there.
    forces = random.choice(([-900.0, -500.0, 100.0, 300.0, 800.0], [-5e3, -50.0, 0.5, 50.0, 5e3]))
    model, book, p = dampers(page, ["fv_curve", element], valve_form="spool", fv_force=forces, valve_opening_force=90.0, valve_width=40.0)
    a_2, stands = 300 * one(), 300 * one()
    for stroke in (-1.0, 1.0):
        g = damper.Conductance(model.c[element], model.curve, stroke, p["valve_opening_force"])
        h = random.uniform(90.0, 900.0)
        conducts, slope = g.itself(h)
        w = math.copysign(math.sqrt(conducts * h - 1e-12), stroke)
        known = {"W": w, "h": h, "F_d": model.curve, "F_d'": model.curve.slope, "σ_A": stroke}
        yield stroke * h, book.expression(element, "LEVEL W + F_d(W) - F_d(0)", **known)
        yield stroke * h, book.value(element, "LEVEL W + F_d(W) - F_d(0)", **known)
        yield conducts, book.value(element, "g(h)", **known)
        yield slope, book.value(element, "dg/dh", g=conducts, **known)
        low, high = g.place(40), g.place(41)
        inside = random.uniform(low, high)
        ends = {"g_k": g.at_place(40)[0], "g_(k+1)": g.at_place(41)[0], "m_k": g.slope(40), "m_(k+1)": g.slope(41)}
        yield g(inside), book.value(element, "g", 0, h=inside, **{"h_k": low, "h_(k+1)": high}, **ends)
    stroke = math.copysign(1.0, a_2)
    passage = lambda a: p["valve_opening_force"] + 0.5 * (a - p["valve_opening_force"] + math.hypot(a - p["valve_opening_force"], p["valve_width"]))
    yield passage(a_2), book.value(element, "h(a)", a=a_2)
    conductance = damper.Conductance(model.c[element], model.curve, stroke, p["valve_opening_force"])
    r = book.value(element, "R", A_2=a_2, P=stands, σ_A=stroke, g=conductance)
    is_late = (r > 1) == (a_2 * (a_2 - stands) > 0)
    yield model.late(a_2, stands), book.value(element, "A_3", 1 if is_late else 2, A_2=a_2, R=r)
    states = {element: stands, "valve_hysteresis_rate": 300 * one()}
    rates = model.valve_rates(a_2, a_2, states)
    known = {"A_3": a_2, "P": stands, "Q": states["valve_hysteresis_rate"]}
    yield rates[element], book.value(element, "dP/dt", 2, **known)
    yield rates["valve_hysteresis_rate"], book.value(element, "dQ/dt", **known)
    model, book, p = dampers(page, [element], valve_form="play")
    for stands in (a_2, a_2 + 30.0, a_2 - 30.0):
        behind = book.value(element, "behind", A_3=a_2, P=stands)
        rate = book.value(element, "dP/dt", 1 if behind <= 0 else 0, A_3=a_2, P=stands)
        yield model.valve_rates(0.0, a_2, {element: stands})[element], rate


def springs_and_friction(page):
    model, book, p = dampers(page, ["parallel_spring"])
    x, v, side = one(), one(), one()
    yield model.parallel_spring(x), book.value("parallel_spring", "parallel_spring(x)", x=x, table=lambda _: 0.0)
    for name in ("coulomb_friction", "viscous_friction", "side_force_friction"):
        model, book, p = dampers(page, [name])
        yield model.friction(v, side), book.value(name, f"{name}(v)", v=v, S=side)
    for which, form in enumerate(("simplified", "full")):
        model, book, p = dampers(page, ["stribeck_friction"], stribeck_form=form)
        yield model.friction(v, side), book.value("stribeck_friction", "stribeck_friction(v)", which, v=v, e=math.e)
    model, book, p = dampers(page, ["gas_preload"])
    yield model.gas_preload(), book.value("gas_preload", "gas_preload")
    model, book, p = dampers(page, ["gas_warming"])
    temperature = 50 * one()
    yield model.gas_warming(temperature), book.value("gas_warming", "gas_warming", T_host=temperature)


def with_state(page):
    v, z = one(), one()
    for which, back in ((0, "slips"), (1, "elastic")):
        element = "presliding_friction"
        model, book, p = dampers(page, [element], presliding_return=back)
        forces, rates = model.with_state(0.0, v, {element: z})
        is_free = which if v * z < 0 else 0
        yield forces[element], book.value(element, element, z=z)
        yield rates[element], book.value(element, "dz/dt", is_free, v=v, z=z)
        settled = model.settled(0.0, v, 0.0, 20.0)
        yield settled[element], book.value(element, "z", v=v)
    for which in (0, 1):
        element = "gas_spring"
        model, book, p = dampers(page, [element])
        x = (random.uniform(-0.9, 1.0) if which == 0 else random.uniform(-2.0, -0.96)) * p["gas_length"]
        known = {"x": x, "z": z, "forms": {"pow(ξ; a)": which}}
        forces, rates = model.with_state(x, v, {element: z})
        yield forces[element], book.value(element, element, **known)
        yield rates[element], book.value(element, "dz/dt", **known)
        yield model.settled(x, v, 0.0, 20.0)[element], book.value(element, "z", **known)
    element = "moving_mass"
    model, book, p = dampers(page, [element], moving_mass_place="driven end")
    forces, rates = model.with_state(0.0, v, {element: z})
    yield forces[element], book.value(element, element, v=v, z=z)
    yield rates[element], book.value(element, "dz/dt", v=v, z=z)
    element = "lagged_polynomial"
    speeds = {"lag_v1": 0.5, "lag_v2": 1.0, "polynomial": [one(), one(), one()]}
    model, book, p = dampers(page, [element], **speeds)
    for which, v in enumerate((0.2, -1.5, -0.7)):
        T = book.value(element, "T", which, v=v)
        rates = model.with_state(0.0, v, {element: z})[1]
        yield rates[element], book.value(element, "dy/dt", v=v, y=z, T=T, Y=model.polynomial)


def stops(page):
    for element, sign in (("bump_stop", -1.0), ("rebound_stop", 1.0)):
        for flow in ("gap", "orifice"):
            for pressed, speed in ((-0.1, 0.1), (0.5, -0.3), (0.5, 0.3)):
                model, book, p = dampers(page, [element], **{f"{element}_flow": flow})
                x, v = sign * (p[f"{element}_clearance"] + pressed), sign * speed
                which = {"Stop(D, s)": int(pressed <= 0), "f(s)": 0 if speed <= 0 else 1 if flow == "gap" else 2}
                if element == "rebound_stop":
                    # The page has the law of both stops under `bump_stop`. It is evaluated here with the parameters of the rebound stop.
                    for name in ("stiffness", "progression", "loss", "damping"):
                        p[f"bump_stop_{name}"] = p[f"{element}_{name}"]
                press = lambda depth, s, book=book: book.value("bump_stop", "Stop(D, s)", int(depth <= 0), D=depth, s=s, forms=which)
                yield model.stops(x, v), book.value(element, f"{element}(x, v)", x=x, v=v, Stop=press)


def main(page):
    with open(page, encoding="utf-8") as file:
        page = file.read()
    random.seed(1)
    original, used, apart = sheet.sections(page), {}, []
    # All sheets of this run record the formulas that they used in the same sections.
    sheet.sections = lambda _: original
    for group in (curves, knees, series, column, void, position, fade, selective, valve, springs_and_friction, with_state, stops):
        for _ in range(15):
            for number, (program, book) in enumerate(group(page)):
                pairs = zip(program, book) if isinstance(program, tuple) else [(program, book)]
                if any(abs(a - b) > 1e-9 * max(abs(a), abs(b)) + 1e-12 for a, b in pairs):
                    apart.append(f"{group.__name__}, formula {number}: program {program}, page {book}")
    count = 0
    for title, section in original.items():
        for left, texts in section.formulas.items():
            for which, text in enumerate(texts):
                if (left, which) in section.used:
                    count += 1
                elif title not in STRUCTURE and left not in PROSE:
                    apart.append(f"{title}: {left} = {text} was not compared")
    print(f"{count} formulas compared")
    print("\n".join(apart[:40]), file=sys.stderr)
    sys.exit(bool(apart))


if __name__ == "__main__":
    main(*sys.argv[1:])
