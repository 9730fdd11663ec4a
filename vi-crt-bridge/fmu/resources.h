/* Files of an FMU's resources folder. */
#ifndef DASHPOT_FMU_RESOURCES_H
#define DASHPOT_FMU_RESOURCES_H

#include <stddef.h>

/* Returns the text of a file, to be freed by the caller, or null with the reason in `why`. `folder` is the URI (FMI 2.0) or path
 * (FMI 3.0) that the importer gave, with or without a separator at its end. If the file is not there, the resources folder of
 * the FMU that contains this library is tried. */
char *resource(const char *folder, const char *name, char *why, size_t room);

#endif
