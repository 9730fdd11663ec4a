/* Evaluates function expressions of TIME with their time derivatives: numbers, + - * /, parentheses, SIN, COS, STEP. */
#include "dataset.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct { const char *at, *whole; double time; } reader;

static dual sum(reader *r);

static void fail(const reader *r, const char *what)
{
    fprintf(stderr, "function \"%s\": %s at \"%s\"\n", r->whole, what, r->at);
    exit(1);
}

static int next(reader *r, char c)
{
    while (*r->at == ' ')
        r->at++;
    if (*r->at != c)
        return 0;
    r->at++;
    return 1;
}

/* Evaluates STEP(x, x0, h0, x1, h1): a cubic from h0 at x0 to h1 at x1, constant outside. */
static dual step(const dual *a)
{
    double s = (a[0].value - a[1].value) / (a[3].value - a[1].value), rise = a[4].value - a[2].value;
    dual d = {a[2].value, 0};
    if (s >= 1)
        d.value = a[4].value;
    else if (s > 0) {
        d.value += rise * s * s * (3 - 2 * s);
        d.rate = rise * 6 * s * (1 - s) * a[0].rate / (a[3].value - a[1].value);
    }
    return d;
}

static dual primary(reader *r)
{
    dual d = {0, 0};
    if (next(r, '(')) {
        d = sum(r);
        if (!next(r, ')'))
            fail(r, "no )");
        return d;
    }
    if (isdigit((unsigned char)*r->at) || *r->at == '.') {
        char *end;
        d.value = strtod(r->at, &end);
        r->at = end;
        return d;
    }
    {
        char name[16];
        size_t n = 0;
        dual a[5];
        int count = 0;
        while (isalpha((unsigned char)*r->at) && n < sizeof name - 1)
            name[n++] = (char)toupper((unsigned char)*r->at++);
        name[n] = 0;
        if (strcmp(name, "TIME") == 0) {
            d.value = r->time;
            d.rate = 1;
            return d;
        }
        if (!next(r, '('))
            fail(r, "no such name, or no (");
        do
            a[count++] = sum(r);
        while (count < 5 && next(r, ','));
        if (!next(r, ')'))
            fail(r, "no )");
        if (strcmp(name, "SIN") == 0 && count == 1) {
            d.value = sin(a[0].value);
            d.rate = cos(a[0].value) * a[0].rate;
        } else if (strcmp(name, "COS") == 0 && count == 1) {
            d.value = cos(a[0].value);
            d.rate = -sin(a[0].value) * a[0].rate;
        } else if (strcmp(name, "STEP") == 0 && count == 5) {
            d = step(a);
        } else {
            fail(r, "no such function");
        }
    }
    return d;
}

static dual factor(reader *r)
{
    if (next(r, '-')) {
        dual d = primary(r);
        d.value = -d.value;
        d.rate = -d.rate;
        return d;
    }
    return primary(r);
}

static dual product(reader *r)
{
    dual d = factor(r);
    for (;;) {
        if (next(r, '*')) {
            dual b = factor(r);
            d.rate = d.rate * b.value + d.value * b.rate;
            d.value *= b.value;
        } else if (next(r, '/')) {
            dual b = factor(r);
            d.rate = (d.rate * b.value - d.value * b.rate) / (b.value * b.value);
            d.value /= b.value;
        } else {
            return d;
        }
    }
}

static dual sum(reader *r)
{
    dual d = product(r);
    for (;;) {
        int sign = next(r, '+') ? 1 : next(r, '-') ? -1 : 0;
        dual b;
        if (!sign)
            return d;
        b = product(r);
        d.value += sign * b.value;
        d.rate += sign * b.rate;
    }
}

dual expression(const char *text, double time)
{
    reader r = {text, text, time};
    dual d = sum(&r);
    while (*r.at == ' ')
        r.at++;
    if (*r.at)
        fail(&r, "more than a function");
    return d;
}
