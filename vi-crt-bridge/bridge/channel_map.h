/* Channel map: the names of a host's channels, its signs and its units, read from a channel map file.
 *
 * A channel map is text with lines `name = value`, like a model file; # begins a comment. It may contain these names:
 *
 *   format = 1
 *   motion_positive = "compression"    direction in which the host's jounce and jounce rate grow, or "extension"
 *   force_positive = "compression"     the host's positive force pushes wheel and body apart; "tension" pulls them together
 *   length_unit = "m"                  of jounce, its rate (per s) and acceleration (per s^2): "m" or "mm"
 *   force_unit = "N"                   "N" or "kN"
 *   motion_ratio_1 = 1.0               damper stroke per unit of the host's stroke, axle 1; 1 if the host gives damper motion
 *   motion_ratio_2 = 1.0               motion ratio of axle 2
 *   motion_ratio_L1 = 1.0              motion ratio of one corner that differs from its axle; also R1, L2, R2
 *   position_offset = 0.0              damper extension, in m from the rig's zero, at the host's jounce 0; all corners
 *   position_offset_1 = 0.0            position offset of axle 1; also position_offset_2, and _L1, _R1, _L2, _R2 for one corner
 *   jounce = "Damper.Jounce.{corner}"  names of the channels; {corner} stands for L1, R1, L2, R2
 *   jounce_rate = "..."                always needed
 *   jounce_acceleration = ""           empty: the host has no such channel (as in the lines below)
 *   side_force = ""
 *   temperature = ""
 *   setting = ""                       setting (current, clicks) of dampers that depend on one, in the model file's unit
 *   force = ""                         the host's input channel that receives the damper force: always needed
 */
#ifndef DASHPOT_CHANNEL_MAP_H
#define DASHPOT_CHANNEL_MAP_H

#include <stddef.h>
#include <stdint.h>

#define DASHPOT_CHANNEL_NAME 128

/* Channels of a corner. Those before DASHPOT_CHANNEL_INPUTS are the host's outputs, in the order of a flat input vector.
 * DASHPOT_CHANNEL_FORCE is the host's input. */
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
    /* Damper extension in m per unit of the host's motion, for each corner. */
    double motion_scale[4];
    /* Damper extension in m, from the rig's zero, at the host's jounce 0, for each corner. */
    double position_offset[4];
    /* The host's force, at the point and in the unit of the host, per N of damper tension, for each corner. */
    double force_scale[4];
    /* Side force in N per unit of the host's force. */
    double side_force_scale;
    /* Names that contain {corner}; empty if the host has no such channel. */
    char name[DASHPOT_CHANNELS][DASHPOT_CHANNEL_NAME];
} dashpot_channel_map;

/* Error in a channel map. */
typedef struct dashpot_channel_map_fault {
    uint32_t line; /* from 1; 0 if the error belongs to no line, for example if a name is missing */
    char text[200];
} dashpot_channel_map_fault;

/* Sets the map for hosts without a channel map: SI, compression positive for motion and force, motion ratio 1. */
void dashpot_channel_map_default(dashpot_channel_map *map);

/* Reads a map from `length` characters of text. Returns 0, or -1 with the reason in *fault and *map unchanged. */
int dashpot_channel_map_read(dashpot_channel_map *map, const char *text, size_t length,
                             dashpot_channel_map_fault *fault);

/* Writes the name of a channel at a corner (0 L1, 1 R1, 2 L2, 3 R2) to `name`. Returns 0. Returns -1 if the name does not
 * fit, or if there is no such channel or corner. */
int dashpot_channel_map_name(const dashpot_channel_map *map, enum dashpot_channel channel, uint32_t corner, char *name,
                             size_t room);

#endif
