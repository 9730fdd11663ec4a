#include "complain.h"
#include <stdarg.h>
#include <stdio.h>

int instance_complain(struct instance *instance, const char *format, ...)
{
    char text[400];
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    instance->log(instance, 1, text);
    return -1;
}
