/* A solver for model exchange: the classical Runge-Kutta method with fixed steps on several sines at once, one per corner. A Python host
 * loads it as a shared library, and passes the functions of an FMU instance that the host has initialized. */
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#define TAU 6.283185307179586476925286766559
#define MOST 512

struct face {
    void *component;
    int (*set_time)(void *, double);
    int (*set_states)(void *, const double *, size_t);
    int (*get_states)(void *, double *, size_t);
    int (*get_rates)(void *, double *, size_t);
    void (*set)(void); /* functions of FMI 2.0 or 3.0, by `three` */
    void (*get)(void);
};

struct run {
    int32_t three, corners, states, steps, parts;
    double dt, sign;
    const uint32_t *inputs, *outputs; /* displacement and velocity of each corner; forces */
    const double *amplitude, *frequency;
    double *forces; /* steps + 1 for each corner, in turn */
};

typedef int set_two(void *, const uint32_t *, size_t, const double *);
typedef int set_three(void *, const uint32_t *, size_t, const double *, size_t);
typedef int get_two(void *, const uint32_t *, size_t, double *);
typedef int get_three(void *, const uint32_t *, size_t, double *, size_t);

static int failed;

static void rate(const struct face *f, const struct run *r, double t, const double *x, double *to)
{
    double u[8];
    size_t n = 2 * (size_t)r->corners;
    int i;

    for (i = 0; i < r->corners; i++) {
        double w = TAU * r->frequency[i];
        u[2 * i] = -r->sign * r->amplitude[i] * cos(w * t);
        u[2 * i + 1] = r->sign * r->amplitude[i] * w * sin(w * t);
    }
    failed |= f->set_time(f->component, t);
    failed |= r->three ? ((set_three *)f->set)(f->component, r->inputs, n, u, n)
                       : ((set_two *)f->set)(f->component, r->inputs, n, u);
    failed |= f->set_states(f->component, x, (size_t)r->states);
    failed |= f->get_rates(f->component, to, (size_t)r->states);
}

static void note(const struct face *f, const struct run *r, int sample)
{
    double y[4];
    size_t n = (size_t)r->corners, i;

    failed |= r->three ? ((get_three *)f->get)(f->component, r->outputs, n, y, n)
                       : ((get_two *)f->get)(f->component, r->outputs, n, y);
    for (i = 0; i < n; i++)
        r->forces[n * (size_t)sample + i] = r->sign * y[i];
}

/* Returns 0 if every call of the FMU returned OK. */
int exchange(const struct face *f, const struct run *r)
{
    static double x[MOST], k[4][MOST], at[MOST];
    const double place[4] = {0.0, 0.5, 0.5, 1.0}, weight[4] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
    double h = r->dt / r->parts;
    int i, part, s, j;

    failed = r->states > MOST || r->corners > 4;
    if (failed)
        return 1;
    failed |= f->get_states(f->component, x, (size_t)r->states);
    rate(f, r, 0.0, x, k[0]);
    note(f, r, 0);
    for (i = 0; i < r->steps; i++) {
        for (part = 0; part < r->parts; part++) {
            double t = r->dt * i + h * part;

            for (s = 0; s < 4; s++) {
                for (j = 0; j < r->states; j++)
                    at[j] = x[j] + (s ? place[s] * h * k[s - 1][j] : 0.0);
                rate(f, r, t + place[s] * h, at, k[s]);
            }
            for (s = 0; s < 4; s++)
                for (j = 0; j < r->states; j++)
                    x[j] += h * weight[s] * k[s][j];
        }
        rate(f, r, r->dt * (i + 1), x, at);
        note(f, r, i + 1);
    }
    return failed;
}
