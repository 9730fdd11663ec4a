/* A host for the library on Windows. Compiled with -DUTILITIES it is AsUtility.dll, with the few functions that an SFOSUB calls. Otherwise
 * it is a program that loads the library and AsUtility.dll, and prints the results of the self-test and of an SFORCE:
 *
 *     host AsUtility.dll dashpot_adams.dll model-file */
#if defined(UTILITIES)
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define UTILITY __declspec(dllexport)
static char path[1024];
UTILITY void stand_in_model(const char *model) { strcpy(path, model); }
UTILITY void c_sysfnc(const char *name, const int *ids, int n, double *value, int *failed)
{
    (void)ids;
    *failed = n != 2;
    *value = strcmp(name, "DM") == 0 ? 410.0 : 150.0;
}
UTILITY void c_errmes(int flag, const char *text, int id, const char *end)
{
    (void)end;
    if (flag) {
        printf("errmes %d %s\n", id, text);
        exit(3);
    }
}
UTILITY void c_usrmes(int flag, const char *text, int id, const char *type) { (void)flag; printf("usrmes %d %s %s\n", id, type, text); }
UTILITY void c_timget(double *time) { *time = 0; }
UTILITY void c_getmod(int *mode) { *mode = 4; }
UTILITY void c_gtstrg(int id, char *text, int *length, int *status)
{
    *status = id != 7;
    *length = (int)strlen(path);
    memcpy(text, path, (size_t)*length);
}
UTILITY void c_gtunts(int *exists, double *scales, char *names)
{
    *exists = 1;
    scales[0] = scales[2] = scales[3] = 1;
    scales[1] = 1e-3;
    names[0] = 0;
}
#else
#include "../../adams-usersub/src/solver.h"

#include <stdio.h>
#include <windows.h>

static FARPROC entry(HMODULE library, const char *name)
{
    FARPROC address = library ? GetProcAddress(library, name) : NULL;
    if (!address) {
        printf("no %s: %lu\n", name, GetLastError());
        ExitProcess(1);
    }
    return address;
}

int main(int count, char **words)
{
    static const double par[2] = {7, 400};
    adams_sforce s = {1, 2, par, 11, 12, 0, "TRANSLATIONAL"};
    double force = 0;
    HMODULE library, utilities;
    int (*selftest)(void);
    void (*sfosub)(const adams_sforce *, double, int, int, double *);
    if (count != 4)
        return 1;
    library = LoadLibraryA(words[2]);
    selftest = (int (*)(void))(void *)entry(library, "dashpot_adams_selftest");
    sfosub = (void (*)(const adams_sforce *, double, int, int, double *))(void *)entry(library, "Dashpot_sfosub");
    /* The library is loaded before AsUtility.dll, as outside a run, and must find the utilities later. */
    utilities = LoadLibraryA(words[1]);
    ((void (*)(const char *))(void *)entry(utilities, "stand_in_model"))(words[3]);
    printf("selftest %d\n", selftest());
    sfosub(&s, 0, 0, 1, &force);
    sfosub(&s, 0, 0, 0, &force);
    printf("sforce %.17g\n", force);
    return 0;
}
#endif
