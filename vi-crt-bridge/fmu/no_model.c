/* In place of model_data.c in the runtime that serves every FMU: contents and models lie in the FMU's resources. */
#include "contents.h"

const char *const EMBEDDED_CONTENTS = NULL;
const char *const EMBEDDED_MODEL[MAX_CORNERS] = {NULL, NULL, NULL, NULL};
