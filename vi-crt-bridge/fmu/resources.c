#include "resources.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#if defined(_WIN32)
#include <windows.h>
#endif

/* Far above any model file. */
#define LONGEST ((size_t)1 << 22)

static int digit(char c)
{
    return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/* The path that a URI means: file:/x, file:///x, file://localhost/x, with %20 and the like. Anything else is a path already. */
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
/* Paths are UTF-8, whatever the code page; one that begins with \\?\ is taken by Windows as it stands, so that it must have no
 * slash. */
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

char *resource(const char *folder, const char *name, char *why, size_t room)
{
    char *path = malloc((folder ? strlen(folder) : 0) + strlen(name) + 2), *text = malloc(LONGEST + 1);
    FILE *file = NULL;
    size_t length = 0, end;

    if (path && text && folder) {
        path_of(folder, path);
        end = strlen(path);
        if (end && path[end - 1] != '/' && path[end - 1] != '\\')
            path[end++] = '/';
        strcpy(path + end, name);
        file = open_path(path);
    }
    if (!folder) {
        snprintf(why, room, "the importer names no resources folder, where this FMU keeps its model");
    } else if (!file) {
        snprintf(why, room, "the FMU's resources lack %.200s", path ? path : name);
    } else {
        length = fread(text, 1, LONGEST + 1, file);
        if (length > LONGEST || ferror(file))
            snprintf(why, room, "%.200s cannot be read", path);
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
