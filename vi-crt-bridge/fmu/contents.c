#include "contents.h"
#include "dashpot.h"
#include "resources.h"
#include "veil.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const KIND_NAME[] = {
#define ONE(name) #name,
    KINDS(ONE)
#undef ONE
};

/* A double as the sixteen hexadecimal digits of its bits: strtod() would read it by the host's locale. */
static double of_bits(const char *text)
{
    unsigned long long bits = strtoull(text, NULL, 16);
    double value;

    memcpy(&value, &bits, sizeof value);
    return value;
}

static int kind_named(const char *name)
{
    int k;

    for (k = 0; k < KIND_COUNT; k++)
        if (!strcmp(KIND_NAME[k], name))
            return k;
    return -1;
}

/* Bounds of every parameter; the rows of a list lie side by side and share one look-up. */
static void find_bounds(struct contents *contents)
{
    dashpot_parameter row;
    uint32_t i, r;

    for (i = 0; i < contents->variables; i++) {
        struct variable *v = &contents->variable[i];

        if (v->kind != PARAMETER)
            continue;
        if (i && v[-1].kind == PARAMETER && !strcmp(v[-1].name, v->name)) {
            v->low = v[-1].low;
            v->high = v[-1].high;
            continue;
        }
        for (r = 0; r < dashpot_parameter_count(); r++) {
            row.struct_size = sizeof row;
            if (dashpot_parameter_info(r, &row) >= 0 && !strcmp(row.name, v->name)) {
                v->low = row.low;
                v->high = row.high;
                break;
            }
        }
    }
}

/* One line; 0 where it cannot be. */
static int read_line(struct contents *contents, const char *line)
{
    char word[32], kind[32], name[48], motion[24], force[24], offset[24], start[24];
    struct variable *v;
    int corner, index, known;

    if (sscanf(line, "%31s", word) != 1)
        return 1;
    if (!strcmp(word, "guid"))
        return sscanf(line, "guid %63s", contents->guid) == 1;
    /* Once: what was read before it has its place among them. */
    if (!strcmp(word, "corners"))
        return !contents->corners && sscanf(line, "corners %d", &contents->corners) == 1 && contents->corners >= 1 &&
               contents->corners <= MAX_CORNERS;
    if (!strcmp(word, "scales")) {
        if (sscanf(line, "scales %23s %23s %23s %23s", motion, force, offset, start) != 4)
            return 0;
        contents->motion_scale = of_bits(motion);
        contents->force_scale = of_bits(force);
        contents->position_offset = of_bits(offset);
        contents->displacement = of_bits(start);
        return 1;
    }
    if (!strcmp(word, "solver")) {
        if (sscanf(line, "solver %23s %23s", motion, force) != 2)
            return 0;
        contents->between_points = of_bits(motion);
        contents->explicit_step = of_bits(force);
        return contents->between_points >= 0.0 && contents->between_points <= 2.0;
    }
    if (!strcmp(word, "nominal")) {
        if (sscanf(line, "nominal %d %d %23s", &corner, &index, motion) != 3 || corner < 0 || corner >= MAX_CORNERS ||
            index < 0 || index >= MAX_STATES)
            return 0;
        contents->nominal[corner][index] = of_bits(motion);
        return 1;
    }
    if (strcmp(word, "variable") || sscanf(line, "variable %31s %d %d %47s", kind, &corner, &index, name) != 4)
        return 0;
    known = kind_named(kind);
    /* Every place that is looked up by them later: a corner for all but what is of the whole FMU, a state, a number of a list. */
    if (known < 0 || (known == TIME || known == BETWEEN_POINTS ? corner != -1 : corner < 0 || corner >= contents->corners) ||
        ((known == STATE || known == RATE) && (index < 0 || index >= MAX_STATES)) ||
        (known == PARAMETER && (index < -1 || index >= LONGEST_LIST)))
        return 0;
    v = &contents->variable[contents->variables];
    memset(v, 0, sizeof *v);
    v->kind = (enum kind)known;
    v->corner = corner;
    v->index = index;
    strcpy(v->name, name);
    contents->states += v->kind == STATE;
    if (v->kind == SETTING)
        contents->setting[corner] = contents->variables;
    if (v->kind == BETWEEN_POINTS)
        contents->between = contents->variables;
    contents->variables++;
    return 1;
}

/* The fixed part lies where it is looked for without a search. */
static int in_order(const struct contents *contents)
{
    int c, k;

    if (!contents->guid[0] || !contents->corners || !contents->between ||
        contents->variables < 1 + (uint32_t)(contents->corners * BLOCK) || contents->variable[0].kind != TIME)
        return 0;
    for (c = 0; c < contents->corners; c++)
        for (k = 0; k < BLOCK; k++) {
            const struct variable *v = &contents->variable[1 + c * BLOCK + k];

            if ((int)v->kind != DISPLACEMENT + k || v->corner != c)
                return 0;
        }
    return 1;
}

/* The next line, closed by a zero, and past it; null at the end. strtok() would be shared between threads. */
static char *next_line(char **text)
{
    char *line = *text, *end = line;

    if (!*line)
        return NULL;
    while (*end && *end != '\n')
        end++;
    *text = *end ? end + 1 : end;
    if (end > line && end[-1] == '\r')
        end--;
    *end = 0;
    return line;
}

static int read_table(struct contents *contents, char *text)
{
    size_t lines = 1, i;
    char *line;

    for (i = 0; text[i]; i++)
        lines += text[i] == '\n';
    contents->variable = malloc(lines * sizeof *contents->variable);
    if (!contents->variable)
        return 0;
    line = next_line(&text);
    /* The first line names the format: a runtime refuses what a later command has written. */
    if (!line || strcmp(line, "dashpot-fmu 3"))
        return 0;
    while ((line = next_line(&text)))
        if (!read_line(contents, line))
            return 0;
    return in_order(contents);
}

static char *copied(const char *text)
{
    char *copy = malloc(strlen(text) + 1);

    return copy ? strcpy(copy, text) : NULL;
}

struct contents *contents_read(const char *resources, char *why, size_t room)
{
    struct contents *contents = calloc(1, sizeof *contents);
    char *table, name[32];
    size_t length = 0, start[MAX_CORNERS] = {0};
    int c, read;

    if (!contents)
        return NULL;
    table = EMBEDDED_CONTENTS ? copied(EMBEDDED_CONTENTS) : resource(resources, "contents.txt", why, room);
    read = table && read_table(contents, table);
    if (table && !read)
        snprintf(why, room, "resources/contents.txt is not of this version of dashpot; export the FMU again");
    free(table);
    for (c = 0; read && c < contents->corners; c++) {
        char *text, *more;
        size_t size;

        snprintf(name, sizeof name, contents->corners == 1 ? "model.toml" : "model_%s.toml",
                 c == 0 ? "L1" : c == 1 ? "R1" : c == 2 ? "L2" : "R2");
        text = EMBEDDED_CONTENTS ? copied(EMBEDDED_MODEL[c]) : resource(resources, name, why, room);
        if (text)
            unveil(text, contents->guid);
        size = text ? strlen(text) + 1 : 0;
        more = text ? realloc(contents->text, length + size) : NULL;
        if (more) {
            contents->text = more;
            memcpy(more + length, text, size);
            /* The block may move: pointers come when it is whole. */
            start[c] = length;
            length += size;
        }
        free(text);
        read = more != NULL;
    }
    if (!read) {
        contents_free(contents);
        return NULL;
    }
    for (c = 0; c < contents->corners; c++)
        contents->model[c] = contents->text + start[c];
    find_bounds(contents);
    return contents;
}

void contents_free(struct contents *contents)
{
    if (!contents)
        return;
    free(contents->variable);
    free(contents->text);
    free(contents);
}
