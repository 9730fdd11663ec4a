/* Messages to the user, through the solver. Without a solver, errors go to standard error and information is dropped. */
#ifndef MESSAGES_H
#define MESSAGES_H

#if defined(__GNUC__)
#define MESSAGES_PRINTF __attribute__((format(printf, 2, 3)))
#else
#define MESSAGES_PRINTF
#endif

/* Reports an error and stops the run; `element` is the id of the Adams element. */
void message_stop(int element, const char *format, ...) MESSAGES_PRINTF;

/* Reports information; the run continues. */
void message_info(int element, const char *format, ...) MESSAGES_PRINTF;

#endif
