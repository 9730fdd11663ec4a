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

/* Reads a double from the sixteen hexadecimal digits of its bits, because strtod() depends on the host's locale. */
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

/* Sets the bounds of every parameter. The numbers of a list are adjacent and need only one look-up. */
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

/* Reads one line of contents.txt. Returns 0 if the line is invalid. */
static int read_line(struct contents *contents, const char *line)
{
    char word[32], kind[32], name[48], motion[24], force[24], offset[24], start[24];
    struct variable *v;
    int corner, index, known;

    if (sscanf(line, "%31s", word) != 1)
        return 1;
    if (!strcmp(word, "guid"))
        return sscanf(line, "guid %63s", contents->guid) == 1;
    /* Only once, because the lines after it are checked against the number of corners. */
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
    /* Corner and index are later used as array indices, so they must be within the arrays. */
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

/* Checks that time and the block of each corner are at their fixed positions, where other files access them by index. */
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

/* Returns the next line, terminated by a zero, and advances *text past it; null at the end. strtok() is not used, because
 * all threads share its state. */
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
    /* The first line names the format, so that this code rejects a file that another version wrote. */
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
            /* realloc() may move the block, so the pointers are set after the last model. */
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
