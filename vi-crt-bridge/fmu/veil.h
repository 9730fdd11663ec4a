/* The model of an FMU exported with --hide-parameters: veiled, so that its numbers cannot be read off the archive. No lock: what opens
 * it lies in the same archive, and this file says how. */
#ifndef DASHPOT_FMU_VEIL_H
#define DASHPOT_FMU_VEIL_H

/* Opens a veiled text in place; any other text stays as it is. */
void unveil(char *text, const char *guid);

#endif
