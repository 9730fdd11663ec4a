#include "dataset.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *file_name;
static int line_number;

static void fail(const char *what)
{
    fprintf(stderr, "%s, line %d: %s\n", file_name, line_number, what);
    exit(1);
}

/* Reads the next statement or command of a file with its continuation lines, without comments. Returns 0 at the end of the file. */
static int statement(FILE *file, char *text, size_t size)
{
    char line[LONGEST_TEXT];
    long before;
    text[0] = 0;
    for (;;) {
        size_t n;
        before = ftell(file);
        if (!fgets(line, sizeof line, file))
            return text[0] != 0;
        n = strcspn(line, "!\r\n");
        if (!strpbrk(line, "\n"))
            fail("a line that is too long, or has no end");
        if (line[0] == '!' || (n == 0 && text[0])) {
            line_number++;
            continue;
        }
        line[n] = 0;
        if (text[0] && line[0] != ',') {
            fseek(file, before, SEEK_SET);
            return 1;
        }
        line_number++;
        if (strlen(text) + n + 1 >= size)
            fail("a statement that is too long");
        strcat(text, line);
    }
}

/* Reads at most `most` numbers after KEY = in a statement. Returns how many it read, or -1 if the key is missing. */
static int numbers(const char *text, const char *key, double *values, int most)
{
    size_t length = strlen(key);
    const char *at = text;
    int count = 0;
    for (;; at++) {
        const char *after;
        at = strstr(at, key);
        if (!at)
            return -1;
        after = at + length;
        while (*after == ' ')
            after++;
        if (*after == '=' && (at[-1] == ' ' || at[-1] == ',' || at[-1] == '/')) {
            at = after + 1;
            break;
        }
    }
    while (count < most) {
        char *end;
        double value = strtod(at, &end);
        if (end == at)
            break;
        values[count++] = value;
        at = end + strspn(end, " ");
        if (*at != ',')
            break;
        at++;
    }
    return count;
}

static double number(const char *text, const char *key)
{
    double value;
    if (numbers(text, key, &value, 1) != 1)
        fail(key);
    return value;
}

static int id_of(const char *text) { return atoi(strchr(text, '/') + 1); }

#define FIND(name, list, count)                                                                                                \
    static int name(const dataset *d, int id)                                                                                  \
    {                                                                                                                          \
        int k;                                                                                                                 \
        for (k = 0; k < d->count; k++)                                                                                         \
            if (d->list[k].id == id)                                                                                           \
                return k;                                                                                                      \
        fail("names an element of " #list " that is not there");                                                              \
        return -1;                                                                                                             \
    }
FIND(marker_of, marker, markers)
FIND(part_of, part, parts)
FIND(joint_of, joint, joints)

static void read_part(dataset *d, const char *text)
{
    part *p = &d->part[d->parts++];
    memset(p, 0, sizeof *p);
    p->id = id_of(text);
    p->is_ground = strstr(text, "GROUND") != NULL;
    p->free = -1;
    if (!p->is_ground)
        p->mass = number(text, "MASS");
}

static void read_marker(dataset *d, const char *text)
{
    marker *m = &d->marker[d->markers++];
    double place[3] = {0, 0, 0};
    m->id = id_of(text);
    m->part = part_of(d, (int)number(text, "PART"));
    if (numbers(text, "QP", place, 3) != 3 || place[0] != 0 || place[1] != 0 || strstr(text, "REULER"))
        fail("a marker that is not on the z axis");
    m->z = place[2];
}

static void read_bushing(dataset *d, const char *text)
{
    bushing *b = &d->bushing[d->bushings++];
    double k[3], c[3], turning[3];
    b->id = id_of(text);
    b->i = marker_of(d, (int)number(text, "I"));
    b->j = marker_of(d, (int)number(text, "J"));
    if (numbers(text, "K", k, 3) != 3 || numbers(text, "C", c, 3) != 3 || numbers(text, "KT", turning, 3) != 3 ||
        numbers(text, "CT", turning, 3) != 3)
        fail("a bushing needs K, C, KT and CT, three each");
    b->k = k[2];
    b->c = c[2];
}

static void read_sforce(dataset *d, char *text)
{
    char *user = strstr(text, "USER("), *end, *routine = strstr(text, "ROUTINE =");
    if (!strstr(text, "TRANSLATIONAL") || !user || !routine || !strchr(text, '\\') || d->sforce.npar)
        fail("one translational SFORCE with USER(...)\\ and ROUTINE = is wanted");
    d->sforce.i = (int)number(text, "I");
    d->sforce.j = (int)number(text, "J");
    marker_of(d, d->sforce.i);
    marker_of(d, d->sforce.j);
    user += 5;
    do {
        d->sforce.par[d->sforce.npar++] = strtod(user, &end);
        user = end + 1;
    } while (*end == ',' && d->sforce.npar < 8);
    if (*end != ')')
        fail("USER( without its end");
    sscanf(routine + 9, " %63s", d->sforce.routine);
    if (strcmp(d->sforce.routine, "dashpot_adams::Dashpot_sfosub") != 0)
        fail("another routine");
}

static void read_statement(dataset *d, char *text)
{
    const char *name = text;
    if (d->parts >= MOST_ELEMENTS || d->markers >= MOST_ELEMENTS || d->bushings >= MOST_ELEMENTS)
        fail("more elements than there is place for");
    if (strncmp(name, "PART/", 5) == 0) {
        read_part(d, text);
    } else if (strncmp(name, "MARKER/", 7) == 0) {
        read_marker(d, text);
    } else if (strncmp(name, "JOINT/", 6) == 0) {
        joint *j = &d->joint[d->joints++];
        if (!strstr(text, "TRANSLATIONAL"))
            fail("a joint that is not translational");
        j->id = id_of(text);
        j->i = marker_of(d, (int)number(text, "I"));
        j->j = marker_of(d, (int)number(text, "J"));
    } else if (strncmp(name, "MOTION/", 7) == 0) {
        motion *m = &d->motion[d->motions++];
        if (!strstr(text, "TRANSLATION") || strstr(text, "VELOCITY"))
            fail("a motion that is no displacement");
        m->id = id_of(text);
        m->joint = joint_of(d, (int)number(text, "JOINT"));
        dataset_move(d, strchr(strstr(text, "FUNCTION"), '=') + 1);
    } else if (strncmp(name, "BUSHING/", 8) == 0) {
        read_bushing(d, text);
    } else if (strncmp(name, "SFORCE/", 7) == 0) {
        read_sforce(d, text);
    } else if (strncmp(name, "STRING/", 7) == 0) {
        text_element *s = &d->string[d->strings++];
        s->id = id_of(text);
        snprintf(s->text, sizeof s->text, "%s", strchr(strstr(text, "STRING ="), '=') + 2);
    } else if (strncmp(name, "UNITS/", 6) == 0) {
        if (!strstr(text, "NEWTON") || !strstr(text, "MILLIMETER") || !strstr(text, "KILOGRAM") || !strstr(text, "SECOND"))
            fail("units that are not mm, N, kg, s");
    } else if (strncmp(name, "REQUEST/", 8) != 0 && strncmp(name, "RESULTS/", 8) != 0 && strcmp(name, "END") != 0) {
        fail("a statement that this run does not know");
    }
}

static void read_command(dataset *d, char *text, char *function)
{
    if (strncmp(text, "INTEGRATOR/", 11) == 0) {
        d->error = number(text, "ERROR");
    } else if (strncmp(text, "MOTION/", 7) == 0) {
        if (d->motions != 1 || id_of(text) != d->motion[0].id)
            fail("a motion that is not in the dataset");
        snprintf(function, LONGEST_TEXT, "%s", strchr(strstr(text, "FUNCTION"), '=') + 1);
    } else if (strncmp(text, "SIMULATE/", 9) == 0) {
        simulation *c = &d->command[d->commands++];
        c->is_static = strncmp(text + 9, "STATICS", 7) == 0;
        snprintf(c->motion, sizeof c->motion, "%s", function);
        if (!c->is_static) {
            c->end = number(text, "END");
            c->steps = (int)number(text, "STEPS");
        }
        if (d->commands == MOST_COMMANDS)
            fail("more simulations than there is place for");
    } else if (strcmp(text, "STOP") != 0) {
        fail("a command that this run does not know");
    }
}

/* Numbers the free parts: those that are neither the ground nor driven against the ground by the motion. */
static void find_free_parts(dataset *d)
{
    int k, driven;
    if (d->motions != 1 || !d->sforce.npar)
        fail("a run needs one motion and one SFORCE");
    driven = d->marker[d->joint[d->motion[0].joint].i].part;
    if (!d->part[d->marker[d->joint[d->motion[0].joint].j].part].is_ground)
        fail("the motion is not against the ground");
    for (k = 0; k < d->parts; k++)
        if (!d->part[k].is_ground && k != driven)
            d->part[k].free = d->free_parts++;
}

void dataset_read(dataset *d, const char *acf)
{
    char text[4096], path[LONGEST_TEXT], function[LONGEST_TEXT] = "0", model[LONGEST_TEXT];
    FILE *commands = fopen(acf, "r"), *file;
    const char *slash = strrchr(acf, '/');
    file_name = acf;
    if (!commands || !statement(commands, model, sizeof model) || !statement(commands, text, sizeof text))
        fail("names no model and no output");
    snprintf(path, sizeof path, "%.*s%.100s.adm", (int)(slash ? slash + 1 - acf : 0), acf, model);
    file = fopen(path, "r");
    file_name = path;
    line_number = 0;
    /* The first line is the title. */
    if (!file || !fgets(text, sizeof text, file))
        fail("cannot be read");
    line_number = 1;
    while (statement(file, text, sizeof text))
        read_statement(d, text);
    fclose(file);
    find_free_parts(d);
    file_name = acf;
    line_number = 2;
    while (statement(commands, text, sizeof text))
        read_command(d, text, function);
    fclose(commands);
    d->is_read = 1;
}

const char *dataset_string(const dataset *d, int id)
{
    int k;
    for (k = 0; k < d->strings; k++)
        if (d->string[k].id == id)
            return d->string[k].text;
    fail("the SFORCE names a STRING that is not there");
    return NULL;
}

void dataset_move(dataset *d, const char *function) { snprintf(d->moving, sizeof d->moving, "%s", function); }

void dataset_place(dataset *d, double t, int is_static, const double *unknowns)
{
    dual moved = expression(d->moving, t);
    int k;
    for (k = 0; k < d->parts; k++) {
        part *p = &d->part[k];
        p->z = p->free >= 0 ? unknowns[2 * p->free] : 0;
        p->v = p->free >= 0 ? unknowns[2 * p->free + 1] : 0;
    }
    k = d->marker[d->joint[d->motion[0].joint].i].part;
    d->part[k].z = moved.value;
    d->part[k].v = is_static ? 0 : moved.rate;
}

static double z_of(const dataset *d, int m) { return d->marker[m].z + d->part[d->marker[m].part].z; }
static double v_of(const dataset *d, int m) { return d->part[d->marker[m].part].v; }

double dataset_distance(const dataset *d)
{
    double apart = z_of(d, marker_of(d, d->sforce.i)) - z_of(d, marker_of(d, d->sforce.j));
    if (apart <= 0) {
        fprintf(stderr, "the damper's ends have met\n");
        exit(1);
    }
    return apart;
}

double dataset_speed(const dataset *d) { return v_of(d, marker_of(d, d->sforce.i)) - v_of(d, marker_of(d, d->sforce.j)); }

static void push(const dataset *d, int m, double force, double *on_part) { on_part[d->marker[m].part] += force; }

void dataset_rates(const dataset *d, double sforce, double *rates)
{
    double on_part[MOST_ELEMENTS] = {0};
    int k;
    for (k = 0; k < d->bushings; k++) {
        const bushing *b = &d->bushing[k];
        double apart = z_of(d, b->i) - z_of(d, b->j), force = -b->k * apart - b->c * (v_of(d, b->i) - v_of(d, b->j));
        push(d, b->i, force, on_part);
        push(d, b->j, -force, on_part);
    }
    /* A positive SFORCE pushes the markers apart; I is above J. */
    push(d, marker_of(d, d->sforce.i), sforce, on_part);
    push(d, marker_of(d, d->sforce.j), -sforce, on_part);
    for (k = 0; k < d->parts; k++)
        if (d->part[k].free >= 0) {
            rates[2 * d->part[k].free] = d->part[k].v;
            rates[2 * d->part[k].free + 1] = 1000.0 * on_part[k] / d->part[k].mass;
        }
}
