/* dashpot as an IPG CarMaker damper model: class Susp_Damper (one corner, CarMaker 10 and later) and Susp_DamperSystem
 * (four corners).
 *
 * It compiles with the headers of your CarMaker installation; this repository contains none. Define
 * DASHPOT_CARMAKER_HEADER as the header that declares the two model classes, and DASHPOT_CARMAKER_API as the generation of
 * the plug-in interface:
 *
 *   gcc -O2 -c -DDASHPOT_CARMAKER_HEADER='"dashpot_carmaker.h"' -DDASHPOT_CARMAKER_API=13 susp_damper.c
 *
 * 13: CarMaker 9 to 13, 15: CarMaker 15. You write dashpot_carmaker.h; it includes CarMaker.h, InfoUtils and the header of
 * the suspension classes. Register both classes from User_Register() with dashpot_carmaker_register(). ../FACTS.md lists the
 * parts of the interface that this file uses, with public sources.
 *
 * Keys of the model, after its kind key; for the system each key ends in .FL, .FR, .RL or .RR:
 *
 *   DashpotModel     model file
 *   DashpotLength    length of the damper at its design position, m; without it, the length of the first call
 *   position_offset  extension of the damper at its design position, from the rig's zero, m; without it, 0
 *   DashpotCtrlIn    setting per unit of CtrlIn, CarMaker's input for controlled dampers, in the unit of the model file:
 *                    1 if a controller writes amperes into CtrlIn and the setting is a current in A
 *   DashpotSetting   constant setting, instead of DashpotCtrlIn
 *
 * The last two are for dampers that depend on a setting (current, clicks). Without both the damper has the start setting of
 * its model file.
 *
 * CarMaker's length and velocity are positive in extension, and its force is positive if the damper pushes. A call with
 * dt = 0 (preparation, model check) puts the damper at rest at its length and returns the static force. */
#include DASHPOT_CARMAKER_HEADER
#include "corner.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#if !defined(DASHPOT_CARMAKER_API) || (DASHPOT_CARMAKER_API != 13 && DASHPOT_CARMAKER_API != 15)
#error "define DASHPOT_CARMAKER_API as 13 (CarMaker 9 to 13) or 15 (CarMaker 15)"
#endif

/* Version of the two models in this file, as the samples of CarMaker define it. */
static const int ThisVersionId = 1;

/* Factor from dashpot's force (tension positive) to CarMaker's (push positive). */
#define PUSH (-1.0)

struct damper {
    dashpot_corner corner;
    double design_length; /* NaN: not given; the first call sets it */
    double position_offset;
    double per_control; /* setting per unit of CtrlIn; NaN: CtrlIn is not used */
    double setting;     /* NaN: the start setting of the model file */
    int running; /* 1 after a call has put the damper at rest */
};

static int load(struct damper *damper, struct tInfos *inf, const char *kind, const char *corner)
{
    char key[256];
    const char *path;
    dashpot_fault fault;
    int32_t status;

    snprintf(key, sizeof key, "%s.DashpotModel%s", kind, corner);
    path = iGetStrOpt(inf, key, "");
    status = dashpot_corner_load(&damper->corner, path, &fault);
    if (status < 0) {
        LogErrF(EC_Init, "dashpot: %s = '%s', line %u: %s %s", key, path, (unsigned)fault.line, fault.parameter,
                status <= DASHPOT_CORNER_NO_FILE ? "the file cannot be read" : dashpot_status_text(status));
        return -1;
    }
    snprintf(key, sizeof key, "%s.DashpotLength%s", kind, corner);
    damper->design_length = iGetDblOpt(inf, key, NAN);
    snprintf(key, sizeof key, "%s.position_offset%s", kind, corner);
    damper->position_offset = iGetDblOpt(inf, key, 0.0);
    if (!(fabs(damper->position_offset) <= 1.0)) {
        LogErrF(EC_Init, "dashpot: %s is in m and lies between -1 and 1", key);
        return -1;
    }
    snprintf(key, sizeof key, "%s.DashpotCtrlIn%s", kind, corner);
    damper->per_control = iGetDblOpt(inf, key, NAN);
    snprintf(key, sizeof key, "%s.DashpotSetting%s", kind, corner);
    damper->setting = iGetDblOpt(inf, key, NAN);
    if (!isnan(damper->per_control) && !isnan(damper->setting)) {
        LogErrF(EC_Init, "dashpot: %s is a constant setting, and DashpotCtrlIn takes it from CtrlIn; give one of the two", key);
        return -1;
    }
    damper->running = 0;
    return 0;
}

static double force(struct damper *damper, double length, double velocity, double control, double dt)
{
    double setting = isnan(damper->per_control) ? damper->setting : damper->per_control * control;
    dashpot_input input;

    if (isnan(damper->design_length))
        damper->design_length = length;
    input = dashpot_input_motion(length - damper->design_length + damper->position_offset, velocity);
    if (!isnan(setting))
        input = dashpot_input_with_setting(input, setting);
    if (!damper->running || dt == 0.0) {
        /* Every static call puts the damper at rest, so that the run starts from the equilibrium that CarMaker found. */
        dashpot_corner_rest_at(&damper->corner, input.displacement, isnan(setting) ? NULL : &setting);
        damper->running = 1;
    }
    dashpot_corner_step(&damper->corner, &input, dt);
    return PUSH * damper->corner.now.output.force;
}

/* ---- one corner ------------------------------------------------------------------------------------------------- */

#if DASHPOT_CARMAKER_API == 13
static void *one_new(struct tInfos *inf, struct tSusp_DamperCfgIF *config, const char *kind)
#else
static void *one_new(struct tInfos *inf, void *config, char const *kind, char const *id)
#endif
{
    struct damper *damper = NULL;
    int version = 0;
    const char *name = SimCore_GetKindInfo(inf, ModelClass_Susp_Damper, kind, 0, ThisVersionId, &version);

#if DASHPOT_CARMAKER_API == 15
    (void)id;
#endif
    if (!name)
        return NULL;
    damper = calloc(1, sizeof *damper);
    if (damper && load(damper, inf, kind, "")) {
        free(damper);
        return NULL;
    }
    Susp_Damper_GetCfgOutIF(inf, config, name);
    return damper;
}

#if DASHPOT_CARMAKER_API == 13
static int one_calc(void *model, tSusp_DamperIF *io, double dt)
{
#else
static int one_calc(void *model, void *first, void *second, double dt)
{
    tSusp_DamperIF *io = first;

    (void)second;
#endif
    io->Force = force(model, io->length, io->vel, io->CtrlIn, dt);
    return 0;
}

/* ---- four corners: FL, FR, RL, RR -------------------------------------------------------------------------------- */

#if DASHPOT_CARMAKER_API == 13
static void *four_new(struct tInfos *inf, struct tSusp_DamperSystemCfgIF *config, const char *kind)
#else
static void *four_new(struct tInfos *inf, void *config, char const *kind, char const *id)
#endif
{
    static const char *const corner[4] = {".FL", ".FR", ".RL", ".RR"};
    struct damper *damper = NULL;
    int version = 0;
    const char *name = SimCore_GetKindInfo(inf, ModelClass_Susp_DamperSystem, kind, 0, ThisVersionId, &version);
    int i;

#if DASHPOT_CARMAKER_API == 15
    (void)id;
#endif
    if (!name)
        return NULL;
    damper = calloc(4, sizeof *damper);
    for (i = 0; damper && i < 4; i++)
        if (load(&damper[i], inf, kind, corner[i])) {
            free(damper);
            return NULL;
        }
    Susp_DamperSystem_GetCfgOutIF(inf, config, name);
    return damper;
}

#if DASHPOT_CARMAKER_API == 13
static int four_calc(void *model, tSusp_DamperSystemIF *io, double dt)
{
#else
static int four_calc(void *model, void *first, void *second, double dt)
{
    tSusp_DamperSystemIF *io = first;
#endif
    struct damper *damper = model;
    int i;

#if DASHPOT_CARMAKER_API == 15
    (void)second;
#endif
    for (i = 0; i < 4; i++)
        io->Force[i] = force(&damper[i], io->length[i], io->vel[i], io->CtrlIn[i], dt);
    return 0;
}

/* ---- both -------------------------------------------------------------------------------------------------------- */

#if DASHPOT_CARMAKER_API == 13
static void model_delete(void *model)
{
    free(model);
}
#else
static void model_delete(void *model, char const *ident)
{
    (void)ident;
    free(model);
}
#endif

/* CarMaker calls these before the first instance and for each one. They declare no quantities in its dictionary. */
#if DASHPOT_CARMAKER_API == 13
static void one_quantities(void *model, int suspension)
{
    (void)model;
    (void)suspension;
}

static void four_quantities(void *model)
{
    (void)model;
}
#else
static void one_quantities(void *model, char const *ident)
{
    (void)model;
    (void)ident;
}

static void four_quantities(void *model, char const *ident)
{
    (void)model;
    (void)ident;
}
#endif

int dashpot_carmaker_register(void)
{
    tModelClassDescr description;

    memset(&description, 0, sizeof description);
    description.Susp_Damper.VersionId = ThisVersionId;
    description.Susp_Damper.New = one_new;
    description.Susp_Damper.Calc = one_calc;
    description.Susp_Damper.Delete = model_delete;
    description.Susp_Damper.DeclQuants = one_quantities;
    /* ParamsChanged stays empty: ParamsChanged_IgnoreCheck is only for models that read no files of their own. */
    if (Model_Register(ModelClass_Susp_Damper, "dashpot", &description) < 0)
        return -1;
    memset(&description, 0, sizeof description);
    description.Susp_DamperSystem.VersionId = ThisVersionId;
    description.Susp_DamperSystem.New = four_new;
    description.Susp_DamperSystem.Calc = four_calc;
    description.Susp_DamperSystem.Delete = model_delete;
    description.Susp_DamperSystem.DeclQuants = four_quantities;
    return Model_Register(ModelClass_Susp_DamperSystem, "dashpot", &description);
}
