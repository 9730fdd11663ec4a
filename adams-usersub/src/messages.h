/* What the user is told: through the solver where there is one, on standard error otherwise. */
#ifndef MESSAGES_H
#define MESSAGES_H

#if defined(__GNUC__)
#define MESSAGES_PRINTF __attribute__((format(printf, 2, 3)))
#else
#define MESSAGES_PRINTF
#endif

/* Something that the run cannot go on with; `element` is the id of the Adams element. */
void message_stop(int element, const char *format, ...) MESSAGES_PRINTF;

/* Something worth knowing, once. */
void message_info(int element, const char *format, ...) MESSAGES_PRINTF;

#endif
