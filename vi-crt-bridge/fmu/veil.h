/* Veiled models of FMUs exported with --hide-parameters: their numbers cannot be read directly in the archive. This is no
 * encryption, because the archive contains all that is needed to decode them, and veil.c shows how. */
#ifndef DASHPOT_FMU_VEIL_H
#define DASHPOT_FMU_VEIL_H

/* Decodes a veiled text in place; any other text does not change. */
void unveil(char *text, const char *guid);

#endif
