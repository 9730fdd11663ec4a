#include "channel_map.h"
#include <stdio.h>
#include <string.h>

static const char *const CORNERS[4] = {"L1", "R1", "L2", "R2"};
static const char PLACE[] = "{corner}";

/* The names that a map may contain. The first DASHPOT_CHANNELS are channels, in the order of enum dashpot_channel. */
enum key {
    MOTION_POSITIVE = DASHPOT_CHANNELS,
    FORCE_POSITIVE,
    LENGTH_UNIT,
    FORCE_UNIT,
    MOTION_RATIO_1,
    MOTION_RATIO_2,
    MOTION_RATIO_L1, /* then R1, L2, R2 */
    MOTION_RATIO_R2 = MOTION_RATIO_L1 + 3,
    POSITION_OFFSET,
    POSITION_OFFSET_1,
    POSITION_OFFSET_2,
    POSITION_OFFSET_L1, /* then R1, L2, R2 */
    POSITION_OFFSET_R2 = POSITION_OFFSET_L1 + 3,
    FORMAT,
    KEYS
};
static const char *const NAMES[KEYS] = {
    "jounce",          "jounce_rate",    "jounce_acceleration", "side_force", "temperature",    "setting", "force",
    "motion_positive", "force_positive", "length_unit",         "force_unit", "motion_ratio_1", "motion_ratio_2",
    "motion_ratio_L1", "motion_ratio_R1", "motion_ratio_L2",     "motion_ratio_R2", "position_offset", "position_offset_1",
    "position_offset_2", "position_offset_L1", "position_offset_R1", "position_offset_L2", "position_offset_R2", "format"};

struct found {
    int seen[KEYS];
    double number[KEYS];
    char text[KEYS][DASHPOT_CHANNEL_NAME];
};

static int refuse(dashpot_channel_map_fault *fault, uint32_t line, const char *what, const char *name)
{
    fault->line = line;
    snprintf(fault->text, sizeof fault->text, what, name);
    return -1;
}

void dashpot_channel_map_default(dashpot_channel_map *map)
{
    int corner;

    memset(map, 0, sizeof *map);
    for (corner = 0; corner < 4; corner++)
        map->motion_scale[corner] = map->force_scale[corner] = -1.0;
    map->side_force_scale = 1.0;
    strcpy(map->name[DASHPOT_CHANNEL_JOUNCE], "jounce_{corner}");
    strcpy(map->name[DASHPOT_CHANNEL_JOUNCE_RATE], "jounce_rate_{corner}");
    strcpy(map->name[DASHPOT_CHANNEL_FORCE], "force_{corner}");
}

/* Reads a decimal number with optional sign and exponent, independent of the locale. Returns 0 if the text is no number,
 * has more than 15 digits, or needs a power of ten beyond 10^22. */
static int number(const char *text, size_t length, double *value)
{
    double mantissa = 0.0, sign = 1.0, power = 1.0;
    int digits = 0, exponent = 0, exponent_sign = 1, shift = 0;
    size_t i = 0;

    if (i < length && (text[i] == '-' || text[i] == '+'))
        sign = text[i++] == '-' ? -1.0 : 1.0;
    for (; i < length && text[i] >= '0' && text[i] <= '9'; i++, digits++)
        mantissa = 10.0 * mantissa + (text[i] - '0');
    if (i < length && text[i] == '.')
        for (i++; i < length && text[i] >= '0' && text[i] <= '9'; i++, digits++, shift--)
            mantissa = 10.0 * mantissa + (text[i] - '0');
    if (!digits || digits > 15)
        return 0;
    if (i < length && (text[i] == 'e' || text[i] == 'E')) {
        int any = 0;
        i++;
        if (i < length && (text[i] == '-' || text[i] == '+'))
            exponent_sign = text[i++] == '-' ? -1 : 1;
        for (; i < length && text[i] >= '0' && text[i] <= '9' && exponent < 100; i++, any = 1)
            exponent = 10 * exponent + (text[i] - '0');
        if (!any)
            return 0;
    }
    if (i != length)
        return 0;
    exponent = exponent_sign * exponent + shift;
    if (exponent < -22 || exponent > 22)
        return 0;
    /* Powers of ten up to 10^22 and mantissas of 15 digits are exact, so that the result is rounded only once. */
    for (i = 0; i < (size_t)(exponent < 0 ? -exponent : exponent); i++)
        power *= 10.0;
    *value = sign * (exponent < 0 ? mantissa / power : mantissa * power);
    return 1;
}

static int blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

/* Reads `line` (without its newline) into *found. Returns 0, or -1 with the reason in *fault. */
static int read_line(struct found *found, const char *line, size_t length, uint32_t count,
                     dashpot_channel_map_fault *fault)
{
    size_t i = 0, end = 0, key_end, value;
    int quoted = 0, key;

    while (i < length && blank(line[i]))
        i++;
    /* A # outside quotes ends the line. */
    for (end = i; end < length && (quoted || line[end] != '#'); end++)
        quoted ^= line[end] == '"';
    while (end > i && blank(line[end - 1]))
        end--;
    if (end == i)
        return 0;
    for (key_end = i; key_end < end && !blank(line[key_end]) && line[key_end] != '='; key_end++)
        ;
    for (value = key_end; value < end && blank(line[value]); value++)
        ;
    if (value == end || line[value] != '=')
        return refuse(fault, count, "the line is not of the form name = value%s", "");
    for (value++; value < end && blank(line[value]); value++)
        ;
    for (key = 0; key < KEYS; key++)
        if (strlen(NAMES[key]) == key_end - i && !memcmp(NAMES[key], line + i, key_end - i))
            break;
    if (key == KEYS)
        return refuse(fault, count, "a channel map has no such name; the names are in channel_map.h%s", "");
    if (found->seen[key]++)
        return refuse(fault, count, "%s appears twice", NAMES[key]);
    if (key >= MOTION_RATIO_1) {
        if (!number(line + value, end - value, &found->number[key]))
            return refuse(fault, count, "%s is not a number", NAMES[key]);
        return 0;
    }
    if (end - value < 2 || line[value] != '"' || line[end - 1] != '"' || memchr(line + value + 1, '"', end - value - 2))
        return refuse(fault, count, "%s is not a word in double quotes", NAMES[key]);
    if (end - value - 2 >= DASHPOT_CHANNEL_NAME)
        return refuse(fault, count, "%s is too long", NAMES[key]);
    memcpy(found->text[key], line + value + 1, end - value - 2);
    return 0;
}

/* Returns 0 if the value of `key` is the first word or missing, 1 if it is the second word, otherwise -1. */
static int word(const struct found *found, enum key key, const char *first, const char *second)
{
    if (!found->seen[key] || !strcmp(found->text[key], first))
        return 0;
    return strcmp(found->text[key], second) ? -1 : 1;
}

int dashpot_channel_map_read(dashpot_channel_map *map, const char *text, size_t length,
                             dashpot_channel_map_fault *fault)
{
    struct found found;
    size_t start, end;
    uint32_t count = 0;
    int motion, force, length_unit, force_unit, i, corner;
    double metre, newton;

    memset(&found, 0, sizeof found);
    for (start = 0; start < length; start = end + 1) {
        for (end = start; end < length && text[end] != '\n'; end++)
            ;
        if (read_line(&found, text + start, end - start, ++count, fault))
            return -1;
    }
    motion = word(&found, MOTION_POSITIVE, "compression", "extension");
    force = word(&found, FORCE_POSITIVE, "compression", "tension");
    length_unit = word(&found, LENGTH_UNIT, "m", "mm");
    force_unit = word(&found, FORCE_UNIT, "N", "kN");
    if (!found.seen[FORMAT] || found.number[FORMAT] != 1.0)
        return refuse(fault, 0, "the map does not say format = 1%s", "");
    if (!found.seen[MOTION_POSITIVE] || motion < 0)
        return refuse(fault, 0, "%s must be \"compression\" or \"extension\": which way the host counts jounce",
                      NAMES[MOTION_POSITIVE]);
    if (!found.seen[FORCE_POSITIVE] || force < 0)
        return refuse(fault, 0, "%s must be \"compression\" (the damper pushes) or \"tension\" (it pulls)",
                      NAMES[FORCE_POSITIVE]);
    if (length_unit < 0)
        return refuse(fault, 0, "%s must be \"m\" or \"mm\"", NAMES[LENGTH_UNIT]);
    if (force_unit < 0)
        return refuse(fault, 0, "%s must be \"N\" or \"kN\"", NAMES[FORCE_UNIT]);
    if (!found.text[DASHPOT_CHANNEL_JOUNCE_RATE][0])
        return refuse(fault, 0, "%s must name a channel", NAMES[DASHPOT_CHANNEL_JOUNCE_RATE]);
    if (!found.text[DASHPOT_CHANNEL_FORCE][0])
        return refuse(fault, 0, "%s must name the host's input channel for an external damper force; take it from your release's own channel list",
                      NAMES[DASHPOT_CHANNEL_FORCE]);
    for (i = 0; i < DASHPOT_CHANNELS; i++)
        if (found.text[i][0] && !strstr(found.text[i], PLACE))
            return refuse(fault, 0, "%s must hold {corner}, which stands for L1, R1, L2 and R2", NAMES[i]);
    for (i = MOTION_RATIO_1; i <= MOTION_RATIO_R2; i++) {
        int key = i;
        if (!found.seen[key])
            found.number[key] =
                key < MOTION_RATIO_L1 ? 1.0 : found.number[MOTION_RATIO_1 + (key - MOTION_RATIO_L1) / 2];
        if (!(found.number[key] >= 0.05 && found.number[key] <= 20.0))
            return refuse(fault, 0, "%s must be from 0.05 to 20; signs belong into motion_positive and force_positive",
                          NAMES[key]);
    }
    for (i = POSITION_OFFSET; i <= POSITION_OFFSET_R2; i++) {
        int key = i;
        if (!found.seen[key])
            found.number[key] = key == POSITION_OFFSET    ? 0.0
                                : key < POSITION_OFFSET_L1 ? found.number[POSITION_OFFSET]
                                                           : found.number[POSITION_OFFSET_1 + (key - POSITION_OFFSET_L1) / 2];
        /* One meter is longer than any damper's stroke, so a larger number is probably in mm. */
        if (!(found.number[key] >= -1.0 && found.number[key] <= 1.0))
            return refuse(fault, 0, "%s is in m and lies between -1 and 1", NAMES[key]);
    }
    metre = length_unit ? 1e-3 : 1.0;
    newton = force_unit ? 1e-3 : 1.0;
    for (corner = 0; corner < 4; corner++) {
        double ratio = found.number[MOTION_RATIO_L1 + corner];
        map->position_offset[corner] = found.number[POSITION_OFFSET_L1 + corner];
        map->motion_scale[corner] = (motion ? 1.0 : -1.0) * metre * ratio;
        /* The power is equal on both sides of the lever, so the motion ratio scales the force too. */
        map->force_scale[corner] = (force ? 1.0 : -1.0) * newton * ratio;
    }
    map->side_force_scale = 1.0 / newton;
    for (i = 0; i < DASHPOT_CHANNELS; i++)
        memcpy(map->name[i], found.text[i], DASHPOT_CHANNEL_NAME);
    return 0;
}

int dashpot_channel_map_name(const dashpot_channel_map *map, enum dashpot_channel channel, uint32_t corner, char *name,
                             size_t room)
{
    const char *pattern = map->name[channel], *place = strstr(pattern, PLACE);
    int written;

    if (!place || corner > 3)
        return -1;
    written = snprintf(name, room, "%.*s%s%s", (int)(place - pattern), pattern, CORNERS[corner],
                       place + sizeof PLACE - 1);
    return written < 0 || (size_t)written >= room ? -1 : 0;
}
