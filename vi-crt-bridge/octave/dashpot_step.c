/* dashpot as a MEX function, for GNU Octave and MATLAB.
 *
 *   mkoctfile --mex -Iinclude -Ivi-crt-bridge/bridge vi-crt-bridge/octave/dashpot_step.c vi-crt-bridge/bridge/corner.c target/lib/libdashpot.a
 *
 *   force = dashpot_step('damper.toml', displacement, velocity, dt [, setting])
 *
 * runs a damper from rest at displacement(1) through equally spaced samples (m, m/s, extension positive) and returns the
 * force at each (N, tension positive). `setting` is for a damper that depends on one, in the unit of its model file. It is one
 * number, or one per sample; the value of a sample applies to the step that ends there. */
#include "corner.h"
#include "mex.h"
#include <string.h>

void mexFunction(int outputs, mxArray *output[], int inputs, const mxArray *input[])
{
    static dashpot_corner corner;
    static char path[4096];
    dashpot_fault fault;
    const double *displacement, *velocity, *setting = NULL;
    double *force, dt;
    size_t n, i, settings = 0;
    int32_t status;

    if (inputs < 4 || inputs > 5 || outputs > 1)
        mexErrMsgTxt("force = dashpot_step(MODEL_FILE, displacement, velocity, dt [, setting])");
    if (mxGetString(input[0], path, sizeof path))
        mexErrMsgTxt("the model file is a text");
    for (i = 1; i < (size_t)inputs; i++)
        if (!mxIsDouble(input[i]) || mxIsComplex(input[i]))
            mexErrMsgTxt("displacement, velocity, dt and setting are real numbers");
    n = mxGetNumberOfElements(input[1]);
    if (n == 0 || mxGetNumberOfElements(input[2]) != n || mxGetNumberOfElements(input[3]) != 1)
        mexErrMsgTxt("displacement and velocity have equal lengths, and dt is one number");
    if (inputs == 5) {
        settings = mxGetNumberOfElements(input[4]);
        if (settings != 1 && settings != n)
            mexErrMsgTxt("the setting is one number, or one for every sample");
        setting = mxGetPr(input[4]);
    }
    displacement = mxGetPr(input[1]);
    velocity = mxGetPr(input[2]);
    dt = mxGetScalar(input[3]);
    status = dashpot_corner_load(&corner, path, &fault);
    if (status < 0)
        mexErrMsgIdAndTxt("dashpot:model", "%s, line %u: %s %s", path, (unsigned)fault.line, fault.parameter,
                          status <= DASHPOT_CORNER_NO_FILE ? "cannot be read" : dashpot_status_text(status));
    status = dashpot_corner_rest_at(&corner, displacement[0], setting);
    if (status < 0)
        mexErrMsgIdAndTxt("dashpot:start", "the first displacement: %s", dashpot_status_text(status));
    output[0] = mxCreateDoubleMatrix(mxGetM(input[1]), mxGetN(input[1]), mxREAL);
    force = mxGetPr(output[0]);
    force[0] = corner.now.output.force;
    for (i = 1; i < n; i++) {
        dashpot_input to = dashpot_input_motion(displacement[i], velocity[i]);

        if (setting)
            to = dashpot_input_with_setting(to, setting[settings == 1 ? 0 : i]);
        if (dashpot_corner_step(&corner, &to, dt) & DASHPOT_BRIDGE_LAST_FORCE)
            mexErrMsgIdAndTxt("dashpot:input", "sample %u or the step is not finite", (unsigned)(i + 1));
        force[i] = corner.now.output.force;
    }
}
