/* The simulation that a dataset (.adm) and its command file (.acf) describe, as far as a damper test rig needs. The dataset may have parts
 * on the global z axis, translational joints along it, a motion, bushings, and one SFORCE with a user subroutine. Any other statement, and
 * any reference to a missing element, ends the program with a message that names the line. */
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

/* Reads the command file `acf` and the dataset in the same folder that its first line names. */
void dataset_read(dataset *d, const char *acf);
const char *dataset_string(const dataset *d, int id);

/* Sets the function of TIME, mm, that the motion follows from now on. */
void dataset_move(dataset *d, const char *function);

/* Sets positions and speeds of all parts from the time and the unknowns (z and speed of every free part). If `is_static`, the speed of the
 * driven part is 0. */
void dataset_place(dataset *d, double t, int is_static, const double *unknowns);

/* Return the distance of the SFORCE's markers, mm, and its rate, mm/s. */
double dataset_distance(const dataset *d);
double dataset_speed(const dataset *d);

/* Computes the rates of the unknowns at this value of the SFORCE, N. */
void dataset_rates(const dataset *d, double sforce, double *rates);

/* Value and time derivative of a function expression at a time, s. */
typedef struct { double value, rate; } dual;
dual expression(const char *text, double time);

#endif
