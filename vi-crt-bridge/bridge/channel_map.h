/* What a host calls its channels, and how its signs and units relate to the damper's: read from a channel map file.
 *
 * A channel map is text with lines `name = value`, like a model file; # begins a comment. Its names:
 *
 *   format = 1
 *   motion_positive = "compression"    direction in which the host's jounce and jounce rate grow, or "extension"
 *   force_positive = "compression"     the host's positive force pushes wheel and body apart; "tension" pulls them together
 *   length_unit = "m"                  of jounce, its rate (per s) and acceleration (per s^2): "m" or "mm"
 *   force_unit = "N"                   "N" or "kN"
 *   motion_ratio_1 = 1.0               damper stroke per unit of the host's stroke, axle 1; 1 where the host gives damper motion
 *   motion_ratio_2 = 1.0               the same, axle 2
 *   motion_ratio_L1 = 1.0              the same, for one corner that differs from its axle; also R1, L2, R2
 *   position_offset = 0.0              damper extension, in m from the rig's zero, where the host's jounce is 0; all corners
 *   position_offset_1 = 0.0            the same, for axle 1; also position_offset_2, and _L1, _R1, _L2, _R2 for one corner
 *   jounce = "Damper.Jounce.{corner}"  names of the channels; {corner} stands for L1, R1, L2, R2
 *   jounce_rate = "..."                always needed
 *   jounce_acceleration = ""           empty: the host has no such channel
 *   side_force = ""
 *   temperature = ""
 *   setting = ""                       of dampers that depend on one (current, clicks), in the unit of their model files
 *   force = ""                         the host's input channel that takes the damper force: always needed
 */
#ifndef DASHPOT_CHANNEL_MAP_H
#define DASHPOT_CHANNEL_MAP_H

#include <stddef.h>
#include <stdint.h>

#define DASHPOT_CHANNEL_NAME 128

/* Channels of a corner that the host gives, in this order in a flat input vector, and those that it takes. */
enum dashpot_channel {
    DASHPOT_CHANNEL_JOUNCE,
    DASHPOT_CHANNEL_JOUNCE_RATE,
    DASHPOT_CHANNEL_JOUNCE_ACCELERATION,
    DASHPOT_CHANNEL_SIDE_FORCE,
    DASHPOT_CHANNEL_TEMPERATURE,
    DASHPOT_CHANNEL_SETTING,
    DASHPOT_CHANNEL_INPUTS,
    DASHPOT_CHANNEL_FORCE = DASHPOT_CHANNEL_INPUTS,
    DASHPOT_CHANNELS
};

typedef struct dashpot_channel_map {
    /* m of damper extension per unit of the host's motion, for each corner. */
    double motion_scale[4];
    /* m of damper extension, from the rig's zero, where the host's jounce is 0. */
    double position_offset[4];
    /* Units of the host's force at its own point per N of damper tension, for each corner. */
    double force_scale[4];
    /* N of side force per unit of the host's. */
    double side_force_scale;
    /* Names with {corner} in them; empty where the host has no such channel. */
    char name[DASHPOT_CHANNELS][DASHPOT_CHANNEL_NAME];
} dashpot_channel_map;

/* What was wrong in a channel map. */
typedef struct dashpot_channel_map_fault {
    uint32_t line; /* from 1; 0 where a line is missing */
    char text[200];
} dashpot_channel_map_fault;

/* A map for hosts without channel names: SI, compression positive for motion and force, motion ratio 1. */
void dashpot_channel_map_default(dashpot_channel_map *map);

/* Reads a map; 0, or -1 with the reason in *fault and *map untouched. Never reads past text + length. */
int dashpot_channel_map_read(dashpot_channel_map *map, const char *text, size_t length,
                             dashpot_channel_map_fault *fault);

/* The name of a channel at a corner (0 L1, 1 R1, 2 L2, 3 R2), to `name`; 0, or -1 where it does not fit. */
int dashpot_channel_map_name(const dashpot_channel_map *map, enum dashpot_channel channel, uint32_t corner, char *name,
                             size_t room);

#endif
