/* Finds the solver's utility functions in the process. The library links to none of them, so that it loads outside
 * Adams, works with every release, and can report a missing function. */
#if !defined(_WIN32) && !defined(_GNU_SOURCE)
#define _GNU_SOURCE /* RTLD_DEFAULT */
#endif
#include "solver.h"
#include "lock.h"

#include <string.h>

#if defined(_WIN32)
#include <windows.h>
#else
#include <dlfcn.h>
#include <link.h>
#if defined(__GNUC__) && defined(__x86_64__) && defined(__GLIBC__)
/* Binds to the oldest version of the symbols, so that a library built on a new system loads on older systems that Adams
 * supports. */
__asm__(".symver dlsym, dlsym@GLIBC_2.2.5");
__asm__(".symver dlopen, dlopen@GLIBC_2.2.5");
__asm__(".symver dlclose, dlclose@GLIBC_2.2.5");
#endif
#endif

typedef struct {
    const char *name;
    size_t offset;
    int needed_for;
} entry;

enum {
    SOLVER_FOR_FORCES = SOLVER_FOR_LINE | SOLVER_FOR_SPACE,
    SOLVER_FOR_ALL = SOLVER_FOR_FORCES | SOLVER_FOR_GSE | SOLVER_FOR_REQUESTS
};

#define ENTRY(member, name, needed_for) {name, offsetof(solver_functions, member), needed_for}

static const entry ENTRIES[] = {
    ENTRY(sysary, "c_sysary", SOLVER_FOR_SPACE),
    ENTRY(sysfnc, "c_sysfnc", SOLVER_FOR_LINE),
    ENTRY(syspar, "c_syspar", 0),
    ENTRY(errmes, "c_errmes", SOLVER_FOR_ALL),
    ENTRY(usrmes, "c_usrmes", 0),
    ENTRY(timget, "c_timget", SOLVER_FOR_FORCES),
    ENTRY(getmod, "c_getmod", SOLVER_FOR_FORCES | SOLVER_FOR_GSE),
    ENTRY(gtstrg, "c_gtstrg", SOLVER_FOR_FORCES | SOLVER_FOR_GSE),
    ENTRY(gtunts, "c_gtunts", 0),
    ENTRY(needs_partials, "c_adams_needs_partials", 0),
    ENTRY(declare_threadsafe, "c_adams_declare_threadsafe", 0),
    ENTRY(serialize_integers, "c_adams_serialize_integers", SOLVER_FOR_SAVING),
    ENTRY(serialize_doubles, "c_adams_serialize_doubles", SOLVER_FOR_SAVING),
    ENTRY(unserialize_integers, "c_adams_unserialize_integers", SOLVER_FOR_SAVING),
    ENTRY(unserialize_doubles, "c_adams_unserialize_doubles", SOLVER_FOR_SAVING),
    ENTRY(gse_ns, "c_gse_ns", SOLVER_FOR_GSE),
    ENTRY(gse_ni, "c_gse_ni", SOLVER_FOR_GSE),
    ENTRY(gse_no, "c_gse_no", SOLVER_FOR_GSE),
    ENTRY(gse_x, "c_gse_x", SOLVER_FOR_GSE),
    ENTRY(gse_u, "c_gse_u", SOLVER_FOR_GSE),
    ENTRY(gsepar_x, "c_gsepar_x", 0),
    ENTRY(gsepar_u, "c_gsepar_u", 0),
};

typedef void (*any_function)(void);

#if !defined(_WIN32)
typedef struct {
    const char *name;
    void *address;
} search;

/* Searches one library of the process, for dl_iterate_phdr(). Returns 1 if it has the function. */
static int look_into(struct dl_phdr_info *info, size_t size, void *looked_for)
{
    search *for_it = (search *)looked_for;
    void *library = info->dlpi_name && *info->dlpi_name ? dlopen(info->dlpi_name, RTLD_LAZY | RTLD_NOLOAD) : NULL;
    (void)size;
    if (!library)
        return 0;
    for_it->address = dlsym(library, for_it->name);
    dlclose(library); /* the library stays loaded, because the process loaded it before */
    return for_it->address != NULL;
}
#endif

static any_function find(const char *name)
{
    any_function function = NULL;
#if defined(_WIN32)
    HMODULE utilities = GetModuleHandleA("AsUtility.dll");
    if (utilities)
        function = (any_function)GetProcAddress(utilities, name);
#else
    search for_it = {name, dlsym(RTLD_DEFAULT, name)};
    /* If the host loaded the solver with RTLD_LOCAL, its functions are not in the global scope: search each library. */
    if (!for_it.address)
        dl_iterate_phdr(look_into, &for_it);
    memcpy(&function, &for_it.address, sizeof function);
#endif
    return function;
}

/* The table of functions, filled by the first thread that calls solver(). */
static solver_functions functions;
static volatile long found, finding;

const solver_functions *solver(void)
{
    if (!load(&found)) {
        size_t i;
        lock(&finding);
        /* A thread that waited for the lock finds the table filled. It must not write, because other threads may read it. */
        for (i = 0; !load(&found) && i < sizeof ENTRIES / sizeof ENTRIES[0]; i++) {
            any_function function = find(ENTRIES[i].name);
            memcpy((char *)&functions + ENTRIES[i].offset, &function, sizeof function);
        }
        store(&found, 1);
        unlock(&finding);
    }
    return &functions;
}

const char *solver_lacks(int needs)
{
    const solver_functions *s = solver();
    size_t i;
    for (i = 0; i < sizeof ENTRIES / sizeof ENTRIES[0]; i++) {
        any_function function;
        memcpy(&function, (const char *)s + ENTRIES[i].offset, sizeof function);
        if ((ENTRIES[i].needed_for & needs) && !function)
            return ENTRIES[i].name;
    }
    return NULL;
}
