"""Makes the files in this folder with third-party writers.

    python3 -m venv v && v/bin/pip install asammdf npTDMS h5py numpy && v/bin/python make.py

Every file holds the same test: a damper of 1500 N s/m in rebound and 800 N s/m in compression with 40 N of friction, on
a sine with an amplitude of 20 mm and a frequency of 2 Hz, three cycles at 400 samples per second. The files in this
folder were written with asammdf 8, npTDMS 1 and h5py 3.
"""

from pathlib import Path

import h5py
import numpy as np
from asammdf import MDF, Signal
from asammdf.blocks.conversion_utils import from_dict
from nptdms import ChannelObject, GroupObject, RootObject, TdmsWriter

HERE = Path(__file__).parent
RATE, CYCLES, FREQUENCY, AMPLITUDE = 400.0, 3, 2.0, 0.020
t = np.arange(int(RATE * CYCLES / FREQUENCY) + 1) / RATE
w = 2 * np.pi * FREQUENCY
x = AMPLITUDE * np.sin(w * t)
v = AMPLITUDE * w * np.cos(w * t)
force = np.where(v > 0, 1500.0, 800.0) * v + 40.0 * np.tanh(v / 0.002)


def mdf(name, signals, version="4.10", compression=0, together=True):
    file = MDF(version=version)
    if together:
        file.append(signals, common_timebase=True)
    else:
        for signal in signals:
            file.append([signal])
    file.save(HERE / name, overwrite=True, compression=compression)
    file.close()


plain = [
    Signal(x * 1e3, t, unit="mm", name="Damper displacement"),
    Signal(force, t, unit="N", name="Damper force"),
]
# Counts of 16 bits with a linear conversion, as a logger stores them.
counts = [
    Signal(np.round(x * 1e3 / 0.001).astype("<i2"), t, unit="mm", name="Weg",
           conversion=from_dict({"a": 0.001, "b": 0.0})),
    Signal(np.round(force / 0.02).astype("<i2"), t, unit="N", name="Kraft",
           conversion=from_dict({"a": 0.02, "b": 0.0})),
]
mdf("plain.mf4", plain)
mdf("plain.mdf", plain, version="3.30")
mdf("counts.mdf", counts, version="3.00", together=False)
mdf("deflated.mf4", plain, compression=1)
mdf("transposed.mf4", counts, compression=2)
mdf("apart.mf4", plain, together=False, compression=2)

unit = lambda name: {"unit_string": name}
wave = {"wf_increment": 1 / RATE, "wf_start_offset": 0.0, "wf_samples": len(t)}
wave["wf_start_time"] = np.datetime64("2026-11-25T10:03:22.5")
with TdmsWriter(HERE / "time.tdms") as file:
    file.write_segment([
        RootObject(properties={"Operator": "nobody"}),
        GroupObject("run 1"),
        ChannelObject("run 1", "Time", t, unit("s")),
        ChannelObject("run 1", "Stroke", x * 1e3, unit("mm")),
        ChannelObject("run 1", "Load", (force * 1e-3).astype("f4"), unit("kN")),
    ])
half = len(t) // 2
with TdmsWriter(HERE / "waves.tdms") as file:
    # Two segments without a time channel. The properties of the channels state the time step.
    for part in (slice(0, half), slice(half, None)):
        file.write_segment([
            ChannelObject("run 1", "Displacement", x[part] * 1e3, {**unit("mm"), **wave}),
            ChannelObject("run 1", "Force", force[part], {**unit("N"), **wave}),
        ])

# The form of MATLAB's option -v7.3: a MATLAB header of 512 bytes, then HDF5. Vectors are columns, compressed in chunks.
name = HERE / "matlab73.mat"
with h5py.File(name, "w", userblock_size=512, libver=("earliest", "v108")) as file:
    for key, values in {"time_s": t, "displacement_mm": x * 1e3, "force_N": force}.items():
        data = file.create_dataset(key, data=values[np.newaxis, :], chunks=(1, 200), compression="gzip")
        data.attrs["MATLAB_class"] = np.bytes_("double")
text = b"MATLAB 7.3 MAT-file, Platform: GLNXA64, Created on: Mon Jan 01 00:00:00 2024 HDF5 schema 1.00 ."
with open(name, "r+b") as file:
    file.write(text.ljust(116) + bytes(8) + b"\x00\x02IM")
