"""Figures 5, 6 and 22: a bar that vibrates along itself in its first mode."""

import numpy as np

from validation import plots

TITLE = "Axial vibration of a bar"
SOURCE = "section 4.1.3, figures 5 and 6, section 4.2.5, figure 22"
RESOLUTION = "10 × 1, 20 × 2 and 20 × 4 points, cells not stated"

LENGTH, MODULUS, DENSITY, SPEED = 10.0, 1e4, 1.0, 0.1
BETA = np.pi / (2 * LENGTH)
OMEGA = BETA * np.sqrt(MODULUS / DENSITY)
PERIOD = 2 * np.pi / OMEGA
PERIODS = 20
SAMPLES_OF_A_PERIOD = 80
SHOWN = 10  # periods
# Columns of points along the bar: cell and points along a side of it. Rows across change nothing, as nu is 0.
RESOLUTIONS = {
    "10 × 1 points": (1, 1),
    "20 × 2 points": (1, 2),
    "40 × 4 points": (1 / 2, 2),
    "160 × 16 points": (1 / 8, 2),
}
FINEST = "160 × 16 points"
SCHEMES = ("MUSL", "USL", "TLMPM")
TRANSFERS = {"FLIP": 'transfer: "FLIP"', "FMPM": 'transfer: "FMPM" transfer_order: 4'}
SOURCE_OF_TRUTH = "closed form, dissertation eq. 4.3 and 4.4"


def vibrate(section, scheme, points, shapes="linear", transfer="FLIP"):
    """The result, and by name times, values and exact values of the last particle's displacement and velocity."""
    cell, particles = RESOLUTIONS[points]
    result = section.run(
        f"{scheme}_{shapes}_{transfer}_{points.split()[0]}", "axial_bar", cell=cell, particles=particles, scheme=scheme,
        shapes=shapes, transfer=TRANSFERS[transfer], end_time=PERIODS * PERIOD, samples=PERIODS * SAMPLES_OF_A_PERIOD,
    )
    time, displacement = result.history("end", "displacement")
    _, velocity = result.history("end", "velocity")
    place = result.history("end", "position")[1][0, 0] - displacement[0, 0]
    amplitude = SPEED * np.sin(BETA * place)
    return result, {
        "displacement": (time, displacement[:, 0], amplitude / OMEGA * np.sin(OMEGA * time)),
        "velocity": (time, velocity[:, 0], amplitude * np.cos(OMEGA * time)),
    }


def run(section):
    section.remark(f"""L 10, h 1, E 10000, v0 0.1; rho 1 and nu 0 are our choice. The histories are those of the point
        next to the free end, over {PERIODS} periods of {PERIOD:.3g}; errors are the largest distance from the exact history
        in amplitudes. The dissertation prints no numbers here; that few points fall behind as time goes on is seen here
        too. Explicit steps lump the mass, which slows waves in wide shape functions: B-splines are no gain here.""")
    histories = {}
    schemes = ("TLMPM",) if section.quick else SCHEMES
    for scheme in schemes:
        for points in RESOLUTIONS:
            result, moved = vibrate(section, scheme, points)
            histories[scheme, points] = moved
            settings = f"{scheme}, linear functions, {points}"
            rows(section, settings, result, moved, points == FINEST)
    if not section.quick:
        for shapes, transfer in (("quadratic_bspline", "FLIP"), ("quadratic_bspline", "FMPM"), ("linear", "FMPM")):
            result, moved = vibrate(section, "TLMPM", "20 × 2 points", shapes, transfer)
            rows(section, f"TLMPM, {shapes}, {transfer}, 20 × 2 points", result, moved, False)
        for scheme, figure in (("MUSL", "Figures 5 and 6"), ("TLMPM", "Figure 22")):
            draw(section, scheme, figure, histories)
        draw_spectrum(section, histories)


def rows(section, settings, result, moved, fine):
    for name, (time, value, exact) in moved.items():
        for periods in (SHOWN, PERIODS):
            early = time <= periods * PERIOD * (1 + 1e-9)
            worst = np.abs(value - exact)[early].max() / np.abs(exact).max()
            section.row(
                f"{name} of the end, worst of {periods} periods in amplitudes", 0.0, SOURCE_OF_TRUTH, worst, settings,
                result.core_seconds, goal=0.01 if fine else None, scale=1.0, own=not fine,
            )
    section.row(
        "frequency", OMEGA / (2 * np.pi), SOURCE_OF_TRUTH, result.measures["frequency"], settings, result.core_seconds,
        goal=1e-3 if fine else None, own=not fine,
    )


def draw(section, scheme, name, histories):
    figure, drawn = plots.axes(2, width=6, height=3.6)
    for axes, quantity in zip(drawn, ("displacement", "velocity")):
        for points, colour in zip(("10 × 1 points", "20 × 2 points", FINEST), plots.COLOURS[2::-1]):
            time, value, exact = histories[scheme, points][quantity]
            shown = time <= SHOWN * PERIOD
            axes.plot(time[shown], value[shown], color=colour, linewidth=1.2, label=points)
        axes.plot(time[shown], exact[shown], label="exact", **plots.REFERENCE, linestyle="--")
        axes.set(xlabel="t", ylabel=f"{quantity} of the end", ylim=1.4 * np.array([exact.min(), exact.max()]))
        axes.legend(fontsize=8, loc="upper center", ncol=4)
    section.picture(f"{scheme.lower()}", figure, f"{name}: displacement and velocity of the bar's end by {scheme}")


def draw_spectrum(section, histories):
    figure, axes = plots.axes()
    for scheme, colour in zip(SCHEMES, plots.COLOURS):
        time, velocity, _ = histories[scheme, FINEST]["velocity"]
        spectrum = np.abs(np.fft.rfft(velocity * np.hanning(len(time)))) * 4 / len(time)
        axes.semilogy(np.fft.rfftfreq(len(time), time[1]), spectrum, color=colour, linewidth=1, label=scheme)
    for n in range(1, 6):
        axes.axvline((2 * n - 1) * OMEGA / (2 * np.pi), color="black", linewidth=0.8, linestyle=":")
    axes.set(xlabel="frequency", ylabel="amplitude of the velocity", xlim=(0, 25), ylim=(1e-8, 1))
    axes.legend()
    section.picture("spectrum", figure, "Spectrum of the end's velocity; dotted: the bar's natural frequencies")
