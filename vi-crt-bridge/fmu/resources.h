/* Files of an FMU's resources folder. */
#ifndef DASHPOT_FMU_RESOURCES_H
#define DASHPOT_FMU_RESOURCES_H

#include <stddef.h>

/* The text of a file, to free(), or null with the reason in `why`. `folder` is what the importer gave: a URI (FMI 2.0) or a path
 * (FMI 3.0), with or without a separator at its end. Where it lacks the file, the folder beside this library's own binaries is looked into. */
char *resource(const char *folder, const char *name, char *why, size_t room);

#endif
