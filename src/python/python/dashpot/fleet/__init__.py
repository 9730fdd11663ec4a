"""Thousands of campaigns: each fitted, judged against limits, and diagnosed against a reference damper.

A campaign is a job; Dask runs the jobs, on this computer, on any Dask cluster by its address, or as Slurm jobs. Results are
written in parts as they come, each part whole or not at all: a run that was killed goes on where it was when it is started
again. A campaign that cannot be read or fitted is a row with its reason. ``python -m dashpot.fleet --help`` says how.

| file | what |
|---|---|
| ``jobs`` | which campaigns, with serial number, batch and date |
| ``files`` | which files a campaign is made of, and when they changed |
| ``checks`` | what a plan may say |
| ``examine`` | one campaign becomes one row |
| ``store`` | parts on the disk, and the one table made of them |
| ``cluster`` | where the work runs |
| ``schedule`` | hands out the work, retries, tells progress |
| ``statistics``, ``report`` | the fleet in one HTML file |
"""

from ..limits import Limit, read_limits
from .cluster import Place
from .examine import Plan
from .jobs import Job, find_jobs
from .report import write_report
from .schedule import Outcome, run

__all__ = ["Job", "Limit", "Outcome", "Place", "Plan", "find_jobs", "read_limits", "run", "write_report"]
