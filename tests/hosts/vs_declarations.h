/* The public part of the VehicleSim API that the CarSim shim calls, in declarations of our own. */
#ifndef VS_DECLARATIONS_H
#define VS_DECLARATIONS_H

typedef double vs_real;
typedef enum { VS_EXT_AFTER_READ, VS_EXT_EQ_PRE_INIT, VS_EXT_EQ_INIT, VS_EXT_EQ_IN, VS_EXT_EQ_OUT, VS_EXT_EQ_END } vs_ext_loc;
void vs_install_calc_function(void (*calculate)(vs_real time, vs_ext_loc where));
vs_real *vs_get_var_ptr(const char *name);
int vs_statement(const char *keyword, const char *line, int stop_on_error);
void vs_set_error_message(const char *text);

#endif
