/* Replaces model_data.c in the precompiled binary for every FMU, which reads contents and models from the FMU's resources. */
#include "contents.h"

const char *const EMBEDDED_CONTENTS = NULL;
const char *const EMBEDDED_MODEL[MAX_CORNERS] = {NULL, NULL, NULL, NULL};
