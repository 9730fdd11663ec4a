/* The public part of the VehicleSim API that the CarSim shim calls, in our own declarations after ../../vi-crt-bridge/FACTS.md. They are
 * function pointers, which vs_get_api() sets. */
#ifndef VS_DECLARATIONS_H
#define VS_DECLARATIONS_H

typedef double vs_real;
typedef enum { VS_EXT_AFTER_READ, VS_EXT_EQ_PRE_INIT, VS_EXT_EQ_INIT, VS_EXT_EQ_IN, VS_EXT_EQ_OUT, VS_EXT_EQ_END } vs_ext_loc;
extern void (*vs_install_calc_function)(void (*calc)(vs_real time, vs_ext_loc where));
extern vs_real *(*vs_get_var_ptr)(char *keyword);
extern int (*vs_statement)(const char *key, const char *buffer, int stop_error);
extern void (*vs_printf_error)(const char *format, ...);
extern void (*vs_set_stop_run)(vs_real stop_gt_0, const char *format, ...);

#endif
