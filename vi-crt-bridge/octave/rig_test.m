% A rig test through the MEX function: 2 mm at 12 Hz. Run in the folder of dashpot_step.mex, with a model file damper.toml.
dt = 1e-3;
t = (0:dt:0.5)';
w = 2 * pi * 12;
displacement = 0.002 * (1 - cos(w * t));
velocity = 0.002 * w * sin(w * t);
force = dashpot_step('damper.toml', displacement, velocity, dt);
printf('%.17g\n', force);
