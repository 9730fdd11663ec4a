/* The run that a dataset (.adm) and its command file (.acf) describe, as far as a damper test rig needs: parts on the global
 * z axis, translational joints along it, a motion, bushings, one SFORCE with a routine. Whatever else stands there, or
 * names what is not there, ends the program with the line. */
#ifndef DATASET_H
#define DATASET_H

enum { MOST_ELEMENTS = 64, MOST_COMMANDS = 256, LONGEST_TEXT = 512 };

typedef struct { int id, is_ground, free; double mass, z, v; } part;
typedef struct { int id, part; double z; } marker;
typedef struct { int id, i, j; } joint;
typedef struct { int id, i, j; double k, c; } bushing;
typedef struct { int id, joint; } motion;
typedef struct { int id; char text[LONGEST_TEXT]; } text_element;
typedef struct { int i, j, npar; double par[8]; char routine[64]; } force_element;

typedef struct {
    int is_static, steps;
    double end;
    char motion[LONGEST_TEXT];
} simulation;

typedef struct {
    int is_read, parts, markers, joints, bushings, motions, strings, free_parts, commands;
    part part[MOST_ELEMENTS];
    marker marker[MOST_ELEMENTS];
    joint joint[MOST_ELEMENTS];
    bushing bushing[MOST_ELEMENTS];
    motion motion[4];
    text_element string[4];
    force_element sforce;
    double error;
    simulation command[MOST_COMMANDS];
    char moving[LONGEST_TEXT];
} dataset;

/* Reads FILE.acf and the dataset that its first line names, beside it. */
void dataset_read(dataset *d, const char *acf);
const char *dataset_string(const dataset *d, int id);

/* From now on the motion is this function of TIME. */
void dataset_move(dataset *d, const char *function);

/* Puts all parts where time and unknowns (z and speed of every free part) say; `is_static` holds time at 0. */
void dataset_place(dataset *d, double t, int is_static, const double *unknowns);

/* Distance of the SFORCE's markers, and its rate. */
double dataset_distance(const dataset *d);
double dataset_speed(const dataset *d);

/* Rates of the unknowns where the SFORCE has this value, N. */
void dataset_rates(const dataset *d, double sforce, double *rates);

/* A function expression at a time, and its rate. */
typedef struct { double value, rate; } dual;
dual expression(const char *text, double time);

#endif
