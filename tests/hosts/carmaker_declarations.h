/* The public layout of CarMaker's damper classes, in our own declarations after ../../vi-crt-bridge/FACTS.md. The tests compile the shim
 * with them. */
#ifndef CARMAKER_DECLARATIONS_H
#define CARMAKER_DECLARATIONS_H

struct tInfos;
const char *iGetStrOpt(struct tInfos *inf, const char *key, const char *otherwise);
double iGetDblOpt(struct tInfos *inf, const char *key, double otherwise);
enum { EC_Init = 3 };
void LogErrF(int where, const char *format, ...);

struct tSusp_DamperCfgIF { int SuspModID; };
struct tSusp_DamperSystemCfgIF { int VehicleClassId, nWheels; };
typedef struct tSusp_DamperIF { double length, vel, CtrlIn, Force; } tSusp_DamperIF;
typedef struct tSusp_DamperSystemIF { double length[4], vel[4], CtrlIn[4], Force[4]; } tSusp_DamperSystemIF;

const char *SimCore_GetKindInfo(struct tInfos *inf, int model_class, const char *kind_key, int unused, int this_version, int *version);
int Susp_Damper_GetCfgOutIF(struct tInfos *inf, struct tSusp_DamperCfgIF *config, const char *kind);
int Susp_DamperSystem_GetCfgOutIF(struct tInfos *inf, struct tSusp_DamperSystemCfgIF *config, const char *kind);

#if DASHPOT_CARMAKER_API == 13
#define CLASS(Name, Quantities)                                                                                        \
    struct {                                                                                                           \
        int VersionId;                                                                                                 \
        void Quantities;                                                                                               \
        int (*ParamsChanged)(struct tInfos *, const char *);                                                           \
        void *(*New)(struct tInfos *, struct t##Name##CfgIF *, const char *kind);                                      \
        int (*Calc)(void *model, t##Name##IF *io, double dt);                                                          \
        void (*Delete)(void *model);                                                                                   \
    } Name
#else
#define CLASS(Name, Quantities)                                                                                        \
    struct {                                                                                                           \
        int VersionId;                                                                                                 \
        void Quantities;                                                                                               \
        int (*ParamsChanged)(struct tInfos *, const char *);                                                           \
        void *(*New)(struct tInfos *, void *config, char const *kind, char const *id);                                 \
        int (*Calc)(void *model, void *first, void *second, double dt);                                                \
        void (*Delete)(void *model, char const *ident);                                                                \
    } Name
#endif

typedef union {
#if DASHPOT_CARMAKER_API == 13
    CLASS(Susp_Damper, (*DeclQuants)(void *model, int suspension));
    CLASS(Susp_DamperSystem, (*DeclQuants)(void *model));
#else
    CLASS(Susp_Damper, (*DeclQuants)(void *model, char const *ident));
    CLASS(Susp_DamperSystem, (*DeclQuants)(void *model, char const *ident));
#endif
} tModelClassDescr;

enum { ModelClass_Susp_Damper = 1, ModelClass_Susp_DamperSystem = 2 };
int Model_Register(int kind, const char *name, tModelClassDescr *description);

#endif
