/* The damper as a GFORCE, with the side force of the rod guide in its friction:
 *
 *     GFORCE/1, I=11, JFLOAT=13, RM=14
 *     , FUNCTION=USER(j marker, joint's i marker, joint's j marker, string, length at zero displacement
 *                     [, temperature [, length unit, force unit, time unit] [, id of a VARIABLE with the setting]])\
 *     , ROUTINE=dashpot_adams::Dashpot_gfosub
 *
 * The j marker is at the damper's other end, on the part of JFLOAT. The joint's markers are those of the joint or bushing
 * that guides the rod; 0, 0 if there is none. The component of the joint's force across the damper's axis is the side
 * force. The result is the force on I in the axes of RM. It acts along the line through both ends, so that it needs no
 * moment. The reaction that the solver applies to JFLOAT, at the position of I, acts along the same line.
 *
 * The partial derivatives are matrices of 6 rows and 3 columns, stored by columns: one for each of the functions TDISP,
 * TVEL and TFORCE, on whose values the force depends. */
#include "axial.h"
#include "entry.h"
#include "messages.h"

#include <math.h>
#include <string.h>

enum { OWN_VALUES = 3 };

static int id_of(double value) { return fabs(value) < 2e9 && value == floor(value) && value >= 0 ? (int)value : -1; }

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* Gets the three components of a solver function. Returns 0, or -1 if the solver gives no three numbers. */
static int ask(const char *name, const int *markers, int count, double values[3])
{
    int number = 0, failed = 0;
    memset(values, 0, 3 * sizeof(double));
    solver()->sysary(name, markers, count, values, &number, &failed);
    return failed || number != 3 ? -1 : 0;
}

/* Geometry, motion, side force and result of the line force, in model units. `force` acts on marker I along the axis from
 * marker J to marker I; as in an SFORCE it is positive if it pushes the markers apart. */
typedef struct {
    double axis[3], length, velocity[3], speed, guide[3], along, side;
    double force, by_length, by_speed, by_side;
} line_force;

/* Passes the partial derivatives of the force vector to the solver. Its magnitude depends on length, speed and side
 * force; its direction turns with the axis. */
static void give_partials(const line_force *f, const int *ends, const int *joint)
{
    double by_place[18], by_velocity[18], by_guide[18];
    int row, column, failed = 0;
    memset(by_place, 0, sizeof by_place);
    memset(by_velocity, 0, sizeof by_velocity);
    memset(by_guide, 0, sizeof by_guide);
    for (column = 0; column < 3; column++) {
        double a = f->axis[column];
        /* Direction of the side force, which is the component of the guide's force across the axis. At zero side force there
         * is no direction, and its derivative is set to 0. */
        double across = f->side > 0.0 ? (f->guide[column] - f->along * a) / f->side : 0.0;
        double change = f->by_length * a + f->by_speed * (f->velocity[column] - f->speed * a) / f->length -
                        f->by_side * f->along * across / f->length;
        for (row = 0; row < 3; row++) {
            double b = f->axis[row], turn = ((row == column ? 1.0 : 0.0) - a * b) / f->length;
            by_place[row + 6 * column] = b * change + f->force * turn;
            by_velocity[row + 6 * column] = b * f->by_speed * a;
            by_guide[row + 6 * column] = b * f->by_side * across;
        }
    }
    solver()->syspar("TDISP", ends, 3, by_place, 18, &failed);
    solver()->syspar("TVEL", ends, 4, by_velocity, 18, &failed);
    if (joint[0])
        solver()->syspar("TFORCE", joint, 3, by_guide, 18, &failed);
}

/* Passes d(result)/d(setting) to the solver: three force components along the axis, then three moments of 0. */
static void give_setting_partial(const line_force *f, int variable, double by_setting)
{
    double partial[6];
    int row, failed = 0;
    memset(partial, 0, sizeof partial);
    for (row = 0; row < 3; row++)
        partial[row] = by_setting * f->axis[row];
    solver()->syspar("VARVAL", &variable, 1, partial, 6, &failed);
}

void Dashpot_gfosub(const adams_gforce *gforce, double time, int dflag, int iflag, double *result)
{
    const char *lacks = solver_lacks(SOLVER_FOR_SPACE);
    const unit_scales *u;
    int ends[4], joint[3], j, what, analysis, is_static, wanted, variable, k;
    double from_j[3], accepted, setting = 0.0;
    line_force f;
    axial_damper damper;
    force_answer answer;
    request asked;

    for (k = 0; k < 6; k++)
        result[k] = 0.0;
    if (lacks) {
        message_stop(gforce->id, "the solver has no function %s, which a force needs", lacks);
        return;
    }
    what = axial_begin(KIND_GFORCE, gforce->id, iflag);
    if (what == AXIAL_DONE)
        return;
    if (gforce->npar < OWN_VALUES + 2) {
        message_stop(gforce->id, "%d USER values; a GFORCE takes j marker, joint's i marker, joint's j marker, string, "
                                 "length at zero displacement [, temperature [, length unit, force unit, time unit]]",
                     gforce->npar);
        return;
    }
    j = id_of(gforce->par[0]);
    joint[0] = id_of(gforce->par[1]);
    joint[1] = id_of(gforce->par[2]);
    joint[2] = gforce->rm;
    if (j <= 0 || joint[0] < 0 || joint[1] < 0 || (joint[0] == 0) != (joint[1] == 0)) {
        message_stop(gforce->id, "the first three USER values must be marker ids: the damper's other end, then both of the "
                                 "guiding joint, or 0, 0");
        return;
    }
    ends[0] = gforce->i;
    ends[1] = j;
    ends[2] = gforce->rm;
    ends[3] = 0;
    memset(&f, 0, sizeof f);
    if (ask("TDISP", ends, 3, from_j) || ask("TVEL", ends, 4, f.velocity) ||
        (joint[0] && ask("TFORCE", joint, 3, f.guide))) {
        message_stop(gforce->id, "the solver gives no motion between markers %d and %d%s", gforce->i, j,
                     joint[0] ? ", or no force of the guiding joint" : "");
        return;
    }
    variable = axial_variable(gforce->npar - OWN_VALUES, gforce->par + OWN_VALUES);
    if (variable && axial_setting(gforce->id, variable, &setting))
        return;
    if (axial_parameters(gforce->id, gforce->npar - OWN_VALUES, gforce->par + OWN_VALUES, iflag, &damper) ||
        what == AXIAL_ASK_ONLY)
        return;
    f.length = sqrt(dot(from_j, from_j));
    if (!(f.length > 0.0)) {
        message_stop(gforce->id, "the damper's ends, markers %d and %d, lie in one point: it has no direction", gforce->i,
                     j);
        return;
    }
    u = &damper.damper->units;
    analysis = axial_progress(&damper, &accepted);
    is_static = analysis == ANALYSIS_STATIC;
    for (k = 0; k < 3; k++) {
        f.axis[k] = from_j[k] / f.length;
        if (is_static)
            f.velocity[k] = 0.0;
    }
    f.speed = dot(f.axis, f.velocity);
    f.along = dot(f.axis, f.guide);
    f.side = sqrt(fmax(0.0, dot(f.guide, f.guide) - f.along * f.along));
    asked.time = is_static ? accepted : units_time(u, time);
    asked.input = dashpot_input_motion(units_displacement(u, f.length) - damper.zero_length, units_velocity(u, f.speed));
    asked.input.known |= DASHPOT_KNOWS_SIDE_FORCE | DASHPOT_KNOWS_TEMPERATURE;
    asked.input.side_force = units_force(u, f.side);
    asked.input.temperature = damper.temperature;
    if (variable)
        asked.input = dashpot_input_with_setting(asked.input, setting);
    wanted = axial_wants_partials();
    if (committed_force(KIND_GFORCE, gforce->id, damper.damper, &asked, accepted, analysis, dflag != 0, wanted, &answer))
        return;
    /* Tension pulls marker I toward marker J. */
    f.force = units_sforce(u, answer.force);
    for (k = 0; k < 3; k++)
        result[k] = f.force * f.axis[k];
    if (wanted) {
        f.by_length = units_sforce(u, answer.by_displacement) * u->length;
        f.by_speed = is_static ? 0.0 : units_sforce(u, answer.by_velocity) * u->length / u->time;
        f.by_side = units_sforce(u, answer.by_side_force) * u->force;
        give_partials(&f, ends, joint);
        if (variable)
            give_setting_partial(&f, variable, units_sforce(u, answer.by_setting));
    }
}
