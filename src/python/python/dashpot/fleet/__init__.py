"""Evaluation of thousands of campaigns: fit of each damper, check against limits, and diagnosis against a reference damper.

Each campaign is a job. Dask runs the jobs on this computer, on a Dask cluster at a given address, or as Slurm jobs. Finished results are
written atomically in parts, so that a killed run continues at the next start. A campaign that cannot be read or fitted gives a row with the
reason. ``python -m dashpot.fleet --help`` describes the usage.

| file | content |
|---|---|
| ``jobs`` | list of campaigns with serial number, batch and date |
| ``files`` | files of a campaign with size and time of change |
| ``checks`` | checks of a plan |
| ``examine`` | evaluation of one campaign, which gives one row |
| ``settings`` | dampers that depend on a setting, and the settings of a fleet |
| ``store`` | parts on disk, and the table that is made from them |
| ``cluster`` | Dask client and workers |
| ``schedule`` | distribution of the jobs, retries, progress |
| ``statistics``, ``report`` | statistics of the fleet, and the report as one HTML file |
"""

from ..limits import Limit, read_limits
from .cluster import Place
from .examine import Plan
from .jobs import Job, find_jobs
from .report import write_report
from .schedule import Outcome, run

__all__ = ["Job", "Limit", "Outcome", "Place", "Plan", "find_jobs", "read_limits", "run", "write_report"]
