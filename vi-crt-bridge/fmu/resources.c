#if defined(__linux__) && !defined(_GNU_SOURCE)
#define _GNU_SOURCE /* dl_iterate_phdr() */
#endif
#include "resources.h"
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#if defined(_WIN32)
#include <windows.h>
#elif defined(__linux__)
#include <link.h>
#endif

/* Longest file, bytes: far above the length of any model file. */
#define LONGEST ((size_t)1 << 22)

static int digit(char c)
{
    return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/* Converts a URI to a path: file:/x, file:///x or file://localhost/x, with escapes such as %20. Any other text is copied as a
 * path. */
static void path_of(const char *uri, char *path)
{
    const char *from = uri;

    if (strncmp(uri, "file:", 5)) {
        strcpy(path, uri);
        return;
    }
    from += 5;
    if (!strncmp(from, "//", 2)) {
        from += 2;
        if (!strncmp(from, "localhost/", 10))
            from += 9;
#if defined(_WIN32)
        /* file://server/share is a network path. */
        else if (*from != '/')
            from -= 2;
#endif
    }
#if defined(_WIN32)
    if (from[0] == '/' && from[1] && from[2] == ':')
        from++;
#endif
    while (*from) {
        int high = *from == '%' ? digit(from[1]) : -1, low = high >= 0 ? digit(from[2]) : -1;

        if (low >= 0) {
            *path++ = (char)(16 * high + low);
            from += 3;
        } else {
            *path++ = *from++;
        }
    }
    *path = 0;
}

#if defined(_WIN32)
/* Opens a path in UTF-8, independent of the code page. Windows does not convert slashes in a path that begins with \\?\, so
 * they are converted here. */
static FILE *open_path(char *path)
{
    wchar_t *wide;
    FILE *file = NULL;
    int length = MultiByteToWideChar(CP_UTF8, 0, path, -1, NULL, 0);
    char *c;

    for (c = path; *c; c++)
        if (*c == '/')
            *c = '\\';
    wide = malloc((size_t)(length > 0 ? length : 1) * sizeof *wide);
    if (wide && length > 0 && MultiByteToWideChar(CP_UTF8, 0, path, -1, wide, length))
        file = _wfopen(wide, L"rb");
    free(wide);
    return file;
}
#else
static FILE *open_path(char *path)
{
    return fopen(path, "rb");
}
#endif

/* An object whose address identifies this library. */
static const char here = 0;

#if defined(_WIN32)
/* Returns the path of this library, to be freed by the caller. */
static char *own_path(void)
{
    enum { ROOM = 32768 };
    wchar_t *wide = malloc(ROOM * sizeof *wide);
    HMODULE library = NULL;
    char *path = NULL;
    DWORD length = 0;
    int bytes;

    if (wide && GetModuleHandleExW(GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT,
                                   (LPCWSTR)&here, &library))
        length = GetModuleFileNameW(library, wide, ROOM);
    if (length > 0 && length < ROOM) {
        bytes = WideCharToMultiByte(CP_UTF8, 0, wide, -1, NULL, 0, NULL, NULL);
        path = bytes > 0 ? malloc((size_t)bytes) : NULL;
        if (path)
            WideCharToMultiByte(CP_UTF8, 0, wide, -1, path, bytes, NULL, NULL);
    }
    free(wide);
    return path;
}
#elif defined(__linux__)
static int is_own(struct dl_phdr_info *info, size_t size, void *path)
{
    uintptr_t at = (uintptr_t)&here;
    int i;

    (void)size;
    for (i = 0; i < info->dlpi_phnum; i++) {
        uintptr_t begin = (uintptr_t)info->dlpi_addr + (uintptr_t)info->dlpi_phdr[i].p_vaddr;

        if (info->dlpi_phdr[i].p_type == PT_LOAD && at >= begin && at - begin < info->dlpi_phdr[i].p_memsz) {
            char *copy = malloc(strlen(info->dlpi_name) + 1);

            if (copy)
                strcpy(copy, info->dlpi_name);
            *(char **)path = copy;
            return 1;
        }
    }
    return 0;
}

static char *own_path(void)
{
    char *path = NULL;

    dl_iterate_phdr(is_own, &path);
    return path;
}
#else
static char *own_path(void)
{
    (void)here;
    return NULL;
}
#endif

/* Returns the resources folder of the FMU that contains this library as FMU/binaries/PLATFORM/LIBRARY, to be freed by the
 * caller. Null if it is not known. */
static char *own_resources(void)
{
    char *path = own_path(), *whole;
    size_t end = path ? strlen(path) : 0;
    int level;

    for (level = 0; level < 3; level++) {
        while (end && path[end - 1] != '/' && path[end - 1] != '\\')
            end--;
        if (!end && level < 2)
            break;
        /* The last iteration keeps the separator. A relative path of three parts becomes empty. */
        end -= level < 2;
    }
    whole = path && level == 3 ? malloc(end + sizeof "resources") : NULL;
    if (whole) {
        memcpy(whole, path, end);
        strcpy(whole + end, "resources");
    }
    free(path);
    return whole;
}

/* Opens a file of a folder. *path becomes its path, to be freed by the caller even if the file cannot be opened. */
static FILE *open_in(const char *folder, const char *name, char **path)
{
    size_t end;

    *path = malloc(strlen(folder) + strlen(name) + 2);
    if (!*path)
        return NULL;
    path_of(folder, *path);
    end = strlen(*path);
    if (end && (*path)[end - 1] != '/' && (*path)[end - 1] != '\\')
        (*path)[end++] = '/';
    strcpy(*path + end, name);
    return open_path(*path);
}

char *resource(const char *folder, const char *name, char *why, size_t room)
{
    char *path = NULL, *text = malloc(LONGEST + 1);
    FILE *file = text && folder ? open_in(folder, name, &path) : NULL;
    size_t length = 0;

    if (!folder)
        snprintf(why, room, "the importer names no resources folder, where this FMU keeps its model");
    else if (!file)
        snprintf(why, room, "the FMU's resources lack %.200s", path ? path : name);
    /* Some importers name no folder, or one that does not exist. */
    if (text && !file) {
        char *own = own_resources(), *own_name = NULL;

        file = own ? open_in(own, name, &own_name) : NULL;
        free(own);
        free(own_name);
    }
    if (file) {
        length = fread(text, 1, LONGEST + 1, file);
        if (length > LONGEST || ferror(file))
            snprintf(why, room, "%.200s cannot be read", path ? path : name);
        fclose(file);
    }
    if (!file || length > LONGEST) {
        free(text);
        text = NULL;
    } else {
        text[length] = 0;
    }
    free(path);
    return text;
}
