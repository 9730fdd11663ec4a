#include "messages.h"
#include "solver.h"

#include <stdarg.h>
#include <stdio.h>

/* Longest message. The solver accepts up to 1024 characters. */
enum { LONGEST = 1000 };

void message_stop(int element, const char *format, ...)
{
    char text[LONGEST];
    va_list arguments;
    int length = snprintf(text, sizeof text, "dashpot: ");
    va_start(arguments, format);
    vsnprintf(text + length, sizeof text - (size_t)length, format, arguments);
    va_end(arguments);
    if (solver()->errmes)
        solver()->errmes(1, text, element, "STOP");
    else
        fprintf(stderr, "%s (element %d)\n", text, element);
}

void message_info(int element, const char *format, ...)
{
    char text[LONGEST];
    va_list arguments;
    int length = snprintf(text, sizeof text, "dashpot: ");
    va_start(arguments, format);
    vsnprintf(text + length, sizeof text - (size_t)length, format, arguments);
    va_end(arguments);
    if (solver()->usrmes)
        solver()->usrmes(1, text, element, "INFO");
}
