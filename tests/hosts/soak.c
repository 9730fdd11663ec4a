/* A long drive: four quarter cars on a rough road at 1 ms with the bridge's dampers. Arguments: model file, simulated seconds, and for dampers
 * that depend on a setting the soft and the firm one, between which a skyhook controller switches.
 *
 *   cc -O2 -I include -I vi-crt-bridge/bridge -o soak tests/hosts/soak.c BRIDGE_SOURCES target/lib/libdashpot.a -lm
 *   ./soak damper.toml 1800
 *
 * The loop runs under a seccomp filter: the kernel ends the process at any system call but read, write and exit, so a run that reaches its
 * end has made none (reading the clock needs none). Page faults are read from a file opened before. */
#define _GNU_SOURCE
#include "dashpot_bridge.h"
#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#define TAU 6.283185307179586476925286766559
#define DT 1e-3
#define WAVES 16
/* Number of bins for the times of steps, of 10 ns each, up to 1 ms. */
#define BINS 100000

static unsigned bins[BINS + 1];
static double amplitude[WAVES], rate[WAVES], phase[4][WAVES];

static double road(int corner, double t)
{
    double z = 0.0;
    int k;
    for (k = 0; k < WAVES; k++)
        z += amplitude[k] * sin(rate[k] * t + phase[corner][k]);
    return z;
}

static long faults(int file)
{
    static char text[1024];
    long minor, major;
    ssize_t n = read(file, text, sizeof text - 1);
    char *at;

    text[n > 0 ? n : 0] = '\0';
    at = strrchr(text, ')');
    if (!at || sscanf(at + 1, " %*c %*d %*d %*d %*d %*d %*u %ld %*u %ld", &minor, &major) != 2)
        return -1;
    return minor + major;
}

/* From now on, any system call but read, write and exit ends the process. The strict mode of seccomp would also forbid the clock. */
static int no_more_calls(void)
{
    struct sock_filter filter[] = {
        {BPF_LD | BPF_W | BPF_ABS, 0, 0, 0}, /* the number of the call */
        {BPF_JMP | BPF_JEQ | BPF_K, 3, 0, SYS_read},
        {BPF_JMP | BPF_JEQ | BPF_K, 2, 0, SYS_write},
        {BPF_JMP | BPF_JEQ | BPF_K, 1, 0, SYS_exit},
        {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_KILL},
        {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ALLOW},
    };
    struct sock_fprog program = {sizeof filter / sizeof *filter, filter};

    return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) || prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program);
}

int main(int argc, char **argv)
{
    const char *models[4];
    dashpot_bridge_fault fault;
    dashpot_bridge *car;
    dashpot_bridge_state state;
    dashpot_corner_input in[4];
    dashpot_corner_output out[4], trial[2][4];
    double soft = 0.0, firm = 0.0;
    long switches = 0;
    double body[4] = {0}, body_v[4] = {0}, wheel[4] = {0}, wheel_v[4] = {0}, rest[4], early = 0.0, late = 0.0;
    long steps, k, before, after, total = 0, longest = 0, percentile = 0, median = 0, held = 0;
    double worst_drift = 0.0;
    static char line[512];
    int warm, first, second, c, length;

    if (argc != 3 && argc != 5)
        return 2;
    if (argc == 5) {
        soft = atof(argv[3]);
        firm = atof(argv[4]);
    }
    for (c = 0; c < 4; c++)
        models[c] = argv[1];
    car = dashpot_bridge_create(4, models, NULL, &fault);
    if (!car) {
        fprintf(stderr, "%s\n", fault.text);
        return 1;
    }
    steps = (long)(atof(argv[2]) / DT);
    srand(7);
    for (k = 0; k < WAVES; k++) {
        /* The frequencies are incommensurate, so that the road does not repeat. */
        double hertz = 0.4 * pow(60.0, (k + 0.37) / WAVES) * (1.0 + 1e-3 * (rand() % 997));
        rate[k] = TAU * hertz;
        amplitude[k] = 0.006 / (1.0 + hertz);
        for (c = 0; c < 4; c++)
            phase[c][k] = TAU * (rand() % 1000) / 1000.0;
    }
    memset(in, 0, sizeof in);
    memset(out, 0, sizeof out);
    memset(bins, 0, sizeof bins);
    for (c = 0; c < 4; c++)
        in[c].known = (c == 3 ? 0 : DASHPOT_CORNER_KNOWS_JOUNCE) /* R2 integrates its displacement */
                      | (argc == 5 ? DASHPOT_CORNER_KNOWS_SETTING : 0);
    for (c = 0; c < 4; c++)
        in[c].setting = soft;
    dashpot_bridge_init(car, in, out);
    for (c = 0; c < 4; c++)
        rest[c] = out[c].force;
    /* One step loads the pages of the code, as a real-time host does with mlockall(). */
    dashpot_bridge_save(car, &state);
    dashpot_bridge_step(car, DT, in, out);
    dashpot_bridge_restore(car, &state);
    dashpot_bridge_step(car, 0.0, in, out);
    /* Lock all pages in memory, as real-time hosts do. If the system rejects this, the step above has loaded most pages. */
    if (mlockall(MCL_CURRENT | MCL_FUTURE))
        fprintf(stderr, "note: mlockall is refused\n");
    warm = open("/proc/self/stat", O_RDONLY);
    first = open("/proc/self/stat", O_RDONLY);
    second = open("/proc/self/stat", O_RDONLY);
    {
        struct timespec now;
        clock_gettime(CLOCK_MONOTONIC, &now);
        (void)road(0, 1e4);
    }
    /* The first call loads the pages of the code that reads page faults. */
    (void)faults(warm);
    if (first < 0 || second < 0 || no_more_calls()) {
        fprintf(stderr, "this kernel has no seccomp or /proc\n");
        return 3;
    }
    before = faults(first);
    for (k = 0; k < steps; k++) {
        struct timespec a, b;
        long ns;

        for (c = 0; c < 4; c++) {
            double jounce, push = out[c].force - rest[c];
            /* Body 350 kg on 24 kN/m, wheel 40 kg on 220 kN/m. */
            double spring = 24e3 * (wheel[c] - body[c]);
            body_v[c] += DT * (spring + push) / 350.0;
            wheel_v[c] += DT * (220e3 * (road(c, k * DT) * (k < 2000 ? k / 2000.0 : 1.0) - wheel[c]) - spring - push) / 40.0;
            body[c] += DT * body_v[c];
            wheel[c] += DT * wheel_v[c];
            jounce = wheel[c] - body[c];
            in[c].jounce = jounce;
            in[c].jounce_rate = wheel_v[c] - body_v[c];
            {
                double setting = body_v[c] * (body_v[c] - wheel_v[c]) > 0.0 ? firm : soft;
                switches += setting != in[c].setting;
                in[c].setting = setting;
            }
        }
        clock_gettime(CLOCK_MONOTONIC, &a);
        held += (dashpot_bridge_step(car, DT, in, out) & DASHPOT_BRIDGE_LAST_FORCE) != 0;
        clock_gettime(CLOCK_MONOTONIC, &b);
        ns = (b.tv_sec - a.tv_sec) * 1000000000L + (b.tv_nsec - a.tv_nsec);
        bins[ns / 10 < BINS ? ns / 10 : BINS]++;
        longest = ns > longest ? ns : longest;
        if (k % 1000 == 999) {
            double drift;
            dashpot_bridge_save(car, &state);
            /* Two steps from the saved state are equal, and the drive goes on from it. */
            dashpot_bridge_step(car, DT, in, trial[0]);
            dashpot_bridge_restore(car, &state);
            dashpot_bridge_step(car, DT, in, trial[1]);
            dashpot_bridge_restore(car, &state);
            held += memcmp(trial[0], trial[1], sizeof trial[0]) != 0;
            drift = fabs(state.corner[3].state.displacement + in[3].jounce);
            worst_drift = drift > worst_drift ? drift : worst_drift;
            for (c = 0; c < 4; c++)
                held += !(fabs(state.corner[c].state.displacement) < 1.0);
        }
        for (c = 0; c < 4; c++) {
            if (k >= 2000 && k < 2000 + steps / 6)
                early += (out[c].force - rest[c]) * (out[c].force - rest[c]);
            if (k >= steps - steps / 6)
                late += (out[c].force - rest[c]) * (out[c].force - rest[c]);
        }
    }
    after = faults(second);
    for (k = 0; k <= BINS && total < (long)(0.9999 * steps); k++) {
        total += bins[k];
        percentile = 10 * (k + 1);
        if (total <= steps / 2)
            median = percentile;
    }
    early = sqrt(early / (4.0 * (steps / 6)));
    late = sqrt(late / (4.0 * (steps / 6)));
    length = snprintf(line, sizeof line,
                      "steps %ld\nmissed %ld\ndrift_mm %.6f\nrms_early_n %.3f\nrms_late_n %.3f\npage_faults %ld\n"
                      "median_ns %ld\npercentile_9999_ns %ld\nlongest_ns %ld\nswitches %ld\n",
                      steps, held, 1e3 * worst_drift, early, late, before < 0 ? -1 : after - before, median, percentile, longest,
                      switches);
    if (write(1, line, (size_t)length) != length)
        syscall(SYS_exit, 1);
    /* exit() would make system calls that are no longer allowed. */
    syscall(SYS_exit, 0);
    return 0;
}
