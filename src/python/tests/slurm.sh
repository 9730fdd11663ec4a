#!/bin/sh
# Starts Slurm with one node on this computer, for tests/test_slurm.py. Requires root, and Debian's slurmctld, slurmd, slurm-client and munge.
#   apt-get install --no-install-recommends slurmctld slurmd slurm-client munge
set -eu
state=${1:-/tmp/slurm-of-one}
mkdir -p "$state/state" "$state/spool" /run/munge
[ -f /etc/munge/munge.key ] || mungekey
chown -R munge: /etc/munge /run/munge /var/lib/munge /var/log/munge
pgrep -x munged > /dev/null || su munge -s /bin/sh -c /usr/sbin/munged
cat > /etc/slurm/slurm.conf <<END
ClusterName=one
SlurmctldHost=$(hostname)
AuthType=auth/munge
SlurmUser=root
StateSaveLocation=$state/state
SlurmdSpoolDir=$state/spool
SlurmctldPidFile=$state/slurmctld.pid
SlurmdPidFile=$state/slurmd.pid
SlurmctldLogFile=$state/slurmctld.log
SlurmdLogFile=$state/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
NodeName=$(hostname) NodeAddr=127.0.0.1 CPUs=2 RealMemory=4000 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
pgrep -x slurmctld > /dev/null || slurmctld
pgrep -x slurmd > /dev/null || slurmd
for _ in 1 2 3 4 5 6 7 8 9 10; do
    if [ "$(sinfo -h -o %T 2> /dev/null)" = idle ]; then sinfo; exit 0; fi
    sleep 1
done
echo "slurm.sh: no idle node after 10 s; see $state/slurmctld.log" >&2
exit 1
