/* Calls the CarMaker shim as the simulator does. Arguments: model file, model file of a damper over a setting. */
#include "carmaker_declarations.h"
#include "check.h"
#include "corner.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

int dashpot_carmaker_register(void);

static tModelClassDescr one, four;
static const char *file, *family;
static int errors;

int Model_Register(int kind, const char *name, tModelClassDescr *description)
{
    CHECK(!strcmp(name, "dashpot"));
    *(kind == ModelClass_Susp_Damper ? &one : &four) = *description;
    return 0;
}

const char *iGetStrOpt(struct tInfos *inf, const char *key, const char *otherwise)
{
    (void)inf;
    return strstr(key, "Missing") ? otherwise : strstr(key, "Family") ? family : file;
}

double iGetDblOpt(struct tInfos *inf, const char *key, double otherwise)
{
    (void)inf;
    if (strstr(key, "DashpotCtrlIn"))
        return strstr(key, "FamilyCtrl") || strstr(key, "FamilyBoth") ? 0.5 : otherwise;
    if (strstr(key, "DashpotSetting"))
        return strstr(key, "FamilyConst") || strstr(key, "FamilyBoth") ? 1.2 : otherwise;
    return strstr(key, "Length") ? 0.45 : strstr(key, "Far.position_offset") ? 12.0 : strstr(key, "Off.position_offset") ? -0.01 : otherwise;
}

static int asked, told;

const char *SimCore_GetKindInfo(struct tInfos *inf, int model_class, const char *kind_key, int unused, int this_version, int *version)
{
    (void)inf;
    (void)unused;
    CHECK(model_class == ModelClass_Susp_Damper || model_class == ModelClass_Susp_DamperSystem);
    *version = 1;
    asked++;
    return this_version == 1 && !strstr(kind_key, "Newer") ? "dashpot" : NULL;
}

int Susp_Damper_GetCfgOutIF(struct tInfos *inf, struct tSusp_DamperCfgIF *config, const char *kind)
{
    (void)inf;
    told += config && !strcmp(kind, "dashpot");
    return 0;
}

int Susp_DamperSystem_GetCfgOutIF(struct tInfos *inf, struct tSusp_DamperSystemCfgIF *config, const char *kind)
{
    (void)inf;
    told += config && !strcmp(kind, "dashpot");
    return 0;
}

void LogErrF(int where, const char *format, ...)
{
    (void)where;
    (void)format;
    errors++;
}

#if DASHPOT_CARMAKER_API == 13
#define NEW(class, config, kind) class.New(NULL, config, kind)
#define CALC(class, model, io, dt) class.Calc(model, io, dt)
#define DELETE(class, model) class.Delete(model)
#else
#define NEW(class, config, kind) class.New(NULL, config, kind, "id")
#define CALC(class, model, io, dt) class.Calc(model, io, NULL, dt)
#define DELETE(class, model) class.Delete(model, "id")
#endif

/* Checks a damper that depends on a setting. The setting is CtrlIn times a factor, a constant, or the start setting of
 * the model file. The keys for factor and constant exclude each other. */
static void over_a_setting(void)
{
    struct tSusp_DamperCfgIF config = {0};
    struct tSusp_DamperSystemCfgIF system_config = {0, 4};
    static const char *const kinds[3] = {"FamilyCtrl", "FamilyConst", "FamilyStart"};
    static dashpot_corner kernel;
    dashpot_fault fault;
    int which, k, before = errors;

    for (which = 0; which < 3; which++) {
        tSusp_DamperIF io = {0};
        void *model = NEW(one.Susp_Damper, &config, kinds[which]);

        CHECK(model && dashpot_corner_load(&kernel, family, &fault) == 0);
        for (k = 0; k <= 500; k++) {
            double t = k * 1e-3, w = 12.566370614359172, setting;
            dashpot_input input;

            io.length = 0.45 + 0.02 * sin(w * t);
            io.vel = k ? 0.02 * w * cos(w * t) : 0.0;
            io.CtrlIn = k < 250 ? 0.4 : 2.8;
            setting = which == 0 ? 0.5 * io.CtrlIn : 1.2;
            CALC(one.Susp_Damper, model, &io, k ? 1e-3 : 0.0);
            input = dashpot_input_motion(io.length - 0.45, io.vel);
            if (which < 2)
                input = dashpot_input_with_setting(input, setting);
            if (k == 0)
                dashpot_corner_rest_at(&kernel, 0.0, which < 2 ? &setting : NULL);
            dashpot_corner_step(&kernel, &input, k ? 1e-3 : 0.0);
            CHECK(io.Force == -kernel.now.output.force);
        }
        DELETE(one.Susp_Damper, model);
    }
    CHECK(!NEW(one.Susp_Damper, &config, "FamilyBoth") && errors == before + 1);
    {
        /* Four corners, each at its own setting. */
        tSusp_DamperSystemIF all = {{0.45, 0.45, 0.45, 0.45}, {0}, {0.0, 0.8, 1.6, 3.2}, {0}};
        void *car = NEW(four.Susp_DamperSystem, &system_config, "FamilyCtrl");
        int i;

        CALC(four.Susp_DamperSystem, car, &all, 0.0);
        for (i = 0; i < 4; i++)
            all.vel[i] = 0.4;
        for (k = 0; k < 50; k++) {
            for (i = 0; i < 4; i++)
                all.length[i] += 0.4e-3;
            CALC(four.Susp_DamperSystem, car, &all, 1e-3);
        }
        for (i = 1; i < 4; i++)
            CHECK(all.Force[i] < all.Force[i - 1] - 50.0);
        DELETE(four.Susp_DamperSystem, car);
    }
}

int main(int argc, char **argv)
{
    struct tSusp_DamperCfgIF config = {0};
    struct tSusp_DamperSystemCfgIF system_config = {0, 4};
    static dashpot_corner kernel;
    dashpot_fault fault;
    tSusp_DamperIF io = {0};
    tSusp_DamperSystemIF all = {{0}, {0}, {0}, {0}};
    void *model, *car;
    double energy = 0.0, rest;
    int k, i;

    if (argc != 3)
        return 2;
    file = argv[1];
    family = argv[2];
    CHECK(dashpot_carmaker_register() == 0);
    CHECK(!NEW(one.Susp_Damper, &config, "Missing") && errors == 1);
    model = NEW(one.Susp_Damper, &config, "SuspF.Damp");
    car = NEW(four.Susp_DamperSystem, &system_config, "Damp");
    CHECK(model && car && asked == 3 && told == 2);
    CHECK(one.Susp_Damper.DeclQuants && four.Susp_DamperSystem.DeclQuants);
    /* The model must reject a newer version of its kind, and an offset in mm. */
    CHECK(!NEW(one.Susp_Damper, &config, "Newer") && !NEW(one.Susp_Damper, &config, "Far") && told == 2);
    if (!model || !car)
        return 1;
    CHECK(dashpot_corner_load(&kernel, file, &fault) == 0);

    /* Any number of calls with dt = 0 prepares the run, which starts from the last position. */
    io.length = 0.44;
    CALC(one.Susp_Damper, model, &io, 0.0);
    io.length = 0.45;
    CALC(one.Susp_Damper, model, &io, 0.0);
    rest = io.Force;
    CHECK(dashpot_corner_rest(&kernel, 0.0) == 0);
    CHECK(rest == -kernel.now.output.force && rest > 0.0); /* gas pushes */
    for (k = 1; k <= 2000; k++) {
        double t = k * 1e-3, w = 12.566370614359172;
        dashpot_input input;

        io.length = 0.45 + 0.02 * sin(w * t);
        io.vel = 0.02 * w * cos(w * t);
        CALC(one.Susp_Damper, model, &io, 1e-3);
        input = dashpot_input_motion(io.length - 0.45, io.vel);
        dashpot_corner_step(&kernel, &input, 1e-3);
        CHECK(io.Force == -kernel.now.output.force);
        /* Force is positive in compression, so it supplies energy to the vehicle while the damper extends. */
        energy += io.Force * io.vel * 1e-3;
        for (i = 0; i < 4; i++) {
            all.length[i] = io.length;
            all.vel[i] = io.vel;
        }
        if (k == 1) {
            double length[4] = {0.45, 0.45, 0.45, 0.45};
            tSusp_DamperSystemIF before = all;
            memcpy(before.length, length, sizeof length);
            memset(before.vel, 0, sizeof before.vel);
            CALC(four.Susp_DamperSystem, car, &before, 0.0);
        }
        CALC(four.Susp_DamperSystem, car, &all, 1e-3);
        for (i = 0; i < 4; i++)
            CHECK(all.Force[i] == io.Force);
    }
    CHECK(energy < -10.0);
    /* With position_offset = -0.01, the damper is at -10 mm at the vehicle's zero. */
    DELETE(one.Susp_Damper, model);
    model = NEW(one.Susp_Damper, &config, "Off");
    io.length = 0.45;
    io.vel = 0.0;
    CALC(one.Susp_Damper, model, &io, 0.0);
    CHECK(dashpot_corner_rest(&kernel, -0.01) == 0 && io.Force == -kernel.now.output.force && io.Force != rest);
    DELETE(one.Susp_Damper, model);
    DELETE(four.Susp_DamperSystem, car);
    over_a_setting();
    return failures != 0;
}
